// SPDX-License-Identifier: GPL-3.0-or-later
// What is checked of the LIGGGHTS scripts before a run.

#include "liggghtsChecks.H"

#include "liggghtsInstance.H"
#include "periodicity.H"

#include <cstring>

#include <liggghts/atom.h>
#include <liggghts/domain.h>
#include <liggghts/fix.h>
#include <liggghts/force.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neigh_list.h>
#include <liggghts/pair.h>
#include <liggghts/update.h>


namespace
{
    using namespace Foam;

    //- A fix that a script may not have: what it does, why not, what to do
    struct conflictingFix
    {
        const char* style;
        const char* what;
        const char* why;
        const char* remedy;
    };

    const conflictingFix conflictingFixes[] =
    {
        {
            "gravity",
            " sets gravity",
            ".",
            "Grains and water take it from constant/g: take the fix out."
        },
        // LIGGGHTS goes through its fixes in their order, and gravity, walls and
        // water come behind those of the script
        {
            "freeze",
            " freezes grains",
            ", which does not hold them: gravity and water act behind it.",
            "Take the fix out, and the grains out of the group that fix nve/sphere"
            " moves."
        },
        {
            "dt/reset",
            " changes the DEM step while the run goes on",
            ": an exchange is a number of these steps, and grains and water would"
            " part in time.",
            "Take the fix out, and give one step for the whole run with the command"
            " 'timestep'."
        }
    };


    //- How deep two grains overlap
    struct overlap
    {
        //- Over the smaller radius [-]
        scalar share = 0;

        //- Numbers of the grains
        label ids[2] = {0, 0};

        //- Place of the first [m]
        point at = Zero;
    };

    Ostream& operator<<(Ostream& os, const overlap& o)
    {
        return
            os  << o.share << token::SPACE << o.ids[0] << token::SPACE << o.ids[1]
                << token::SPACE << o.at;
    }

    Istream& operator>>(Istream& is, overlap& o)
    {
        return is >> o.share >> o.ids[0] >> o.ids[1] >> o.at;
    }

    //- The deepest of this rank's list of neighbours
    overlap deepestOverlap
    (
        const LAMMPS_NS::Atom& atom,
        const LAMMPS_NS::NeighList& list
    )
    {
        const auto place = [&](const label i)
        {
            return point(atom.x[i][0], atom.x[i][1], atom.x[i][2]);
        };
        overlap deepest;

        for (label ii = 0; ii < list.inum; ++ii)
        {
            const label i = list.ilist[ii];

            for (label jj = 0; jj < list.numneigh[i]; ++jj)
            {
                const label j = list.firstneigh[i][jj] & NEIGHMASK;
                const point p(place(i));
                const scalar share =
                    (atom.radius[i] + atom.radius[j] - mag(p - place(j)))
                   /min(atom.radius[i], atom.radius[j]);

                if (share > deepest.share)
                {
                    deepest = overlap{share, {atom.tag[i], atom.tag[j]}, p};
                }
            }
        }

        return deepest;
    }
}


void Foam::liggghtsChecks::checkUnits
(
    liggghtsInstance& liggghts,
    const fileName& script
)
{
    if (std::strcmp(liggghts->update->unit_style, "si"))
    {
        FatalErrorInFunction
            << "The unit system in " << script << " is "
            << liggghts->update->unit_style << nl
            << "    OpenFOAM computes in SI units. Begin the script with"
            << " 'units si' and give metres, kilograms and seconds."
            << exit(FatalError);
    }
}


void Foam::liggghtsChecks::checkBoundary
(
    liggghtsInstance& liggghts,
    const string& boundary,
    const fileName& script
)
{
    const LAMMPS_NS::Domain& domain = *liggghts->domain;
    const bool periodic[] =
        {bool(domain.xperiodic), bool(domain.yperiodic), bool(domain.zperiodic)};

    for (label k = 0; k < 3; ++k)
    {
        // LIGGGHTS knows boundaries that follow the grains as well
        const bool moving = !periodic[k]
         && (domain.boundary[k][0] != 1 || domain.boundary[k][1] != 1);

        if (moving)
        {
            FatalErrorInFunction
                << "The box of the grains changes along " << "xyz"[k] << nl
                << "    Its boundary comes from the patches of the mesh (here: "
                << boundary << "). Take the command 'boundary' out of "
                << script << exit(FatalError);
        }

        if (periodic[k] != (boundary[2*k] == 'p'))
        {
            FatalErrorInFunction
                << "The grains are " << (periodic[k] ? "" : "not ")
                << "periodic along " << "xyz"[k] << ", the mesh is "
                << (periodic[k] ? "not" : "periodic") << nl
                << "    The boundary of the grains comes from the patches of"
                << " the mesh (here: " << boundary << "). Take the command"
                << " 'boundary' out of " << script << exit(FatalError);
        }
    }

    if (!domain.box_exist)
    {
        FatalErrorInFunction
            << "No box for the grains after " << script << nl
            << "    Give one with 'region' and 'create_box'."
            << exit(FatalError);
    }
}


void Foam::liggghtsChecks::checkDomain
(
    liggghtsInstance& liggghts,
    const fvMesh& mesh,
    const fileName& script
)
{
    const LAMMPS_NS::Domain& domain = *liggghts->domain;
    const boundBox grains
    (
        point(domain.boxlo[0], domain.boxlo[1], domain.boxlo[2]),
        point(domain.boxhi[0], domain.boxhi[1], domain.boxhi[2])
    );
    const boundBox& cells = mesh.bounds();

    if (!grains.overlaps(cells))
    {
        FatalErrorInFunction
            << "The box of the grains " << grains << " in " << script
            << " and the mesh " << cells << " do not overlap." << nl
            << "    Give both in metres, in the same coordinates."
            << exit(FatalError);
    }

    const Vector<bool> along(periodicity(mesh).along());
    const scalar tolerance = 1e-6*cells.mag();

    for (direction k = 0; k < 3; ++k)
    {
        const scalar gap =
            max
            (
                mag(grains.min()[k] - cells.min()[k]),
                mag(grains.max()[k] - cells.max()[k])
            );

        if (along[k] && gap > tolerance)
        {
            FatalErrorInFunction
                << "The mesh repeats itself along " << "xyz"[k] << " from "
                << cells.min()[k] << " to " << cells.max()[k]
                << " m, the box of the grains in " << script << " from "
                << grains.min()[k] << " to " << grains.max()[k] << " m." << nl
                << "    Give the box the same ends." << exit(FatalError);
        }
    }
}


void Foam::liggghtsChecks::checkNoConflictingFixes
(
    liggghtsInstance& liggghts,
    const fileName& script
)
{
    LAMMPS_NS::Modify& modify = *liggghts->modify;

    for (label i = 0; i < modify.nfix; ++i)
    {
        for (const conflictingFix& conflict : conflictingFixes)
        {
            if (!std::strcmp(modify.fix[i]->style, conflict.style))
            {
                FatalErrorInFunction
                    << script << conflict.what << " (fix " << modify.fix[i]->id
                    << ")" << conflict.why << nl << "    " << conflict.remedy
                    << exit(FatalError);
            }
        }
    }
}


void Foam::liggghtsChecks::checkOverlaps
(
    liggghtsInstance& liggghts,
    const fileName& script
)
{
    const LAMMPS_NS::Pair* pair = liggghts->force->pair;

    if (!pair || !pair->list)
    {
        return;
    }

    List<overlap> deepest(Pstream::nProcs());
    deepest[Pstream::myProcNo()] = deepestOverlap(*liggghts->atom, *pair->list);
    Pstream::gatherList(deepest);
    overlap worst;
    for (const overlap& there : deepest)
    {
        worst = there.share > worst.share ? there : worst;
    }

    if (Pstream::master() && worst.share > 0.2)
    {
        WarningInFunction
            << "Grains overlap at the start of " << script << ": grains "
            << worst.ids[0] << " and " << worst.ids[1] << " by "
            << worst.share << " of the smaller radius, at "
            << worst.at << " m." << nl
            << "    They will be driven apart at once, and fast. Move them, or"
            << " let preparePacking place them; where they are meant to be"
            << " one heap, settle it first." << nl << endl;
    }
}
