// SPDX-License-Identifier: GPL-3.0-or-later
// The laws by which fluid and grains act on each other, as a case chose them.

#include "forceModels.H"

namespace
{
    using namespace Foam;

    //- A family of laws, and that of them which acts where a case names none
    struct lawFamily
    {
        word name;

        word defaultModel;

        //- The settings of a case, with the default where no law is named. A law
        //  that is off by default must be named where it has settings
        dictionary settings(const dictionary& dict) const
        {
            dictionary result(keywords::sub(dict, name));

            const bool mustNameModel =
                dict.found(name) && defaultModel == "none"
             && result.getOrDefault<scalar>("strength", 1) > 0;

            if (!result.found("model") && !mustNameModel)
            {
                result.add("model", defaultModel);
            }

            return result;
        }
    };

    namespace families
    {
        const lawFamily drag{"drag", dragModel::defaultModel};
        const lawFamily lift{"lift", "none"};
        const lawFamily virtualMass{"virtualMass", "none"};
        const lawFamily rotationalDrag{"rotationalDrag", "Dennis"};

        //- In the order in which they are printed
        const List<lawFamily> all({drag, lift, virtualMass, rotationalDrag});
    }

    //- The settings of a closure, of strength 0 if the keyword is absent
    dictionary offIfAbsent(const dictionary& dict, const word& name)
    {
        dictionary settings(keywords::sub(dict, name));

        if (!dict.found(name))
        {
            settings.add("strength", scalar(0));
        }

        return settings;
    }

    //- The strength of a force that has no other setting
    scalar strength(const dictionary& dict, const word& name)
    {
        return closure::strength(keywords::sub(dict, name, {"strength"}));
    }

    //- The settings in use of such a force
    dictionary settingsOf(const scalar strength)
    {
        dictionary result;
        result.add("strength", strength);
        return result;
    }
}


Foam::forceModels::forceModels(const fvMesh& mesh, const dictionary& dict)
:
    drag(dragModel::New(families::drag.settings(dict))),
    lift(families::lift.settings(dict)),
    virtualMass(families::virtualMass.settings(dict)),
    rotationalDrag(families::rotationalDrag.settings(dict)),
    lubrication(mesh, offIfAbsent(dict, "lubrication")),
    history(offIfAbsent(dict, "history")),
    shear(mesh, offIfAbsent(dict, "grainShear")),
    pressureGradient(strength(dict, "pressureGradient")),
    excessPressure(strength(dict, "excessPressure")),
    viscousForce
    (
        dict.found("viscousForce") ? strength(dict, "viscousForce") : 0
    )
{
    for (const lawFamily& family : families::all)
    {
        activePhysics.add(family.name, family.settings(dict));
    }
    activePhysics.add("lubrication", lubrication.activePhysics());
    activePhysics.add("history", history.activePhysics());
    activePhysics.add("grainShear", shear.activePhysics());
    activePhysics.add("pressureGradient", settingsOf(pressureGradient));
    activePhysics.add("excessPressure", settingsOf(excessPressure));
    activePhysics.add("viscousForce", settingsOf(viscousForce));

    keywords::check(dict, names());
}


Foam::wordList Foam::forceModels::names()
{
    return
    {
        "drag",
        "excessPressure",
        "grainShear",
        "history",
        "lift",
        "lubrication",
        "pressureGradient",
        "rotationalDrag",
        "viscousForce",
        "virtualMass"
    };
}


void Foam::forceModels::dragCoefficients
(
    const UList<grainState>& states,
    UList<scalar>& K
) const
{
    if (drag.valid())
    {
        drag->K(states, K);
    }
    else
    {
        K = 0;
    }
}


void Foam::forceModels::liftForces
(
    const UList<grainState>& states,
    UList<vector>& forces
) const
{
    if (!lift.isOn())
    {
        forces = vector::zero;
        return;
    }

    lift.law().force(states, forces);
    forAll(states, i)
    {
        forces[i] *= lift.strength();
    }
}


bool Foam::forceModels::carriesFluid() const
{
    return virtualMass.isOn() || history.isOn();
}
