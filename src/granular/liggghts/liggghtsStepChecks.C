// SPDX-License-Identifier: GPL-3.0-or-later
// The DEM step beside the Rayleigh time of the grains.

#include "liggghtsChecks.H"

#include "liggghtsInstance.H"
#include "mathematicalConstants.H"

#include <liggghts/atom.h>
#include <liggghts/fix.h>
#include <liggghts/fix_template_sphere.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/update.h>

namespace
{
    using namespace Foam;

    //- Of the grains that are there and of those that the script may insert
    struct extremes
    {
        //- Shortest Rayleigh time [s]; GREAT for no grains
        scalar rayleighTime = GREAT;

        //- Least density [kg/m3]; GREAT for no grains
        scalar density = GREAT;
    };

    extremes extremesOf
    (
        liggghtsInstance& liggghts,
        LAMMPS_NS::Fix& young,
        LAMMPS_NS::Fix& poisson
    )
    {
        const LAMMPS_NS::Atom& atom = *liggghts->atom;
        const LAMMPS_NS::Modify& modify = *liggghts->modify;
        extremes result;

        const auto look = [&](scalar radius, scalar density, label type)
        {
            result.density = min(result.density, density);
            result.rayleighTime = min
            (
                result.rayleighTime,
                liggghtsChecks::rayleighTime
                (
                    radius,
                    density,
                    young.compute_vector(type - 1),
                    poisson.compute_vector(type - 1)
                )
            );
        };

        for (label i = 0; i < atom.nlocal; ++i)
        {
            look(atom.radius[i], atom.density[i], atom.type[i]);
        }

        for (label i = 0; i < modify.nfix; ++i)
        {
            auto* sizes =
                dynamic_cast<LAMMPS_NS::FixTemplateSphere*>(modify.fix[i]);

            if (sizes)
            {
                look
                (
                    sizes->min_rad(),
                    sizes->massexpect()/sizes->volexpect(),
                    sizes->mintype()
                );
            }
        }

        reduce(result.rayleighTime, minOp<scalar>());
        reduce(result.density, minOp<scalar>());
        return result;
    }


    //- Stop where the step [s] is above the shortest Rayleigh time, warn where it is
    //  near
    void checkRayleigh(const scalar dt, const extremes& grains, const fileName& script)
    {
        const scalar shortest = grains.rayleighTime;
        const scalar fraction = dt/shortest;
        const string units
        (
            grains.density < 100
          ? "\n    A density is " + Foam::name(grains.density)
              + " kg/m3: was it given in g/cm3?"
          : ""
        );

        if (fraction > 1)
        {
            FatalErrorInFunction
                << "The DEM step of " << dt << " s in " << script << " is "
                << fraction << " times the Rayleigh time of " << shortest
                << " s: contacts would be stepped over." << nl
                << "    Set timestep to at most " << 0.2*shortest
                << " s, or lower Young's modulus." << units.c_str()
                << exit(FatalError);
        }

        Info<< "    DEM step " << dt << " s = " << 100*fraction
            << " % of the Rayleigh time" << endl;

        // With a third a bed on a slope eroded up to five times as deep as with a
        // fifth and with a tenth, which agree (validation/papers/erosionStudy)
        if (fraction > 0.25)
        {
            WarningInFunction
                << "The DEM step is " << 100*fraction << " % of the Rayleigh time:"
                << " beds may creep, and erode several times too deep." << nl
                << "    Set timestep to at most " << 0.2*shortest << " s, 20 %"
                << units.c_str() << endl;
        }
    }
}


Foam::scalar Foam::liggghtsChecks::rayleighTime
(
    const scalar radius,
    const scalar density,
    const scalar youngsModulus,
    const scalar poissonsRatio
)
{
    const scalar shearModulus = youngsModulus/(2*(1 + poissonsRatio));

    return
        constant::mathematical::pi*radius*sqrt(density/shearModulus)
       /(0.1631*poissonsRatio + 0.8766);
}


void Foam::liggghtsChecks::checkSizes
(
    liggghtsInstance& liggghts,
    const fileName& script
)
{
    const LAMMPS_NS::Atom& atom = *liggghts->atom;
    label wrong = labelMax;

    for (label i = 0; i < atom.nlocal; ++i)
    {
        if (!(atom.radius[i] > 0 && atom.density[i] > 0))
        {
            wrong = min(wrong, label(atom.tag[i]));
        }
    }

    reduce(wrong, minOp<label>());
    if (wrong < labelMax)
    {
        FatalErrorInFunction
            << "Grain " << wrong << " of " << script << " has no diameter or no"
            << " density." << nl
            << "    Give both above zero, as 'set group all diameter 0.005"
            << " density 2650'." << exit(FatalError);
    }
}


void Foam::liggghtsChecks::checkTimeStep
(
    liggghtsInstance& liggghts,
    const fileName& script
)
{
    const LAMMPS_NS::Update& update = *liggghts->update;

    if (!update.timestep_set)
    {
        FatalErrorInFunction
            << "No DEM step in " << script << nl
            << "    Give one with the command 'timestep', below 20 % of the"
            << " Rayleigh time." << exit(FatalError);
    }

    LAMMPS_NS::Modify& modify = *liggghts->modify;
    const int nTypes = liggghts->atom->ntypes;

    LAMMPS_NS::Fix* young = modify.find_fix_property
    (
        "youngsModulus", "property/global", "peratomtype", nTypes, 0,
        "interDEMFoam", false
    );
    LAMMPS_NS::Fix* poisson = modify.find_fix_property
    (
        "poissonsRatio", "property/global", "peratomtype", nTypes, 0,
        "interDEMFoam", false
    );

    if (!young || !poisson)
    {
        Info<< "    DEM step " << update.dt << " s, not compared with the"
            << " Rayleigh time: " << script << " gives no Young's modulus"
            << " and Poisson's ratio" << endl;
        return;
    }

    const extremes result(extremesOf(liggghts, *young, *poisson));
    if (result.rayleighTime == GREAT)
    {
        Info<< "    DEM step " << update.dt << " s, not compared with the"
            << " Rayleigh time: there is no grain, and none to come" << endl;
        return;
    }

    checkRayleigh(update.dt, result, script);
}
