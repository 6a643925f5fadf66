// SPDX-License-Identifier: GPL-3.0-or-later
// The laws by which fluid and grains act on each other, as a case chose them.

#include "forceModels.H"

namespace
{
    using namespace Foam;

    //- The settings of a family, with its default law where none is named. One
    //  that is off by default must be named where it has settings
    dictionary family
    (
        const dictionary& dict,
        const word& name,
        const word& defaultModel
    )
    {
        dictionary settings(keywords::sub(dict, name));

        const bool mustTell =
            dict.found(name) && defaultModel == "none"
         && settings.getOrDefault<scalar>("strength", 1) > 0;

        if (!settings.found("model") && !mustTell)
        {
            settings.add("model", defaultModel);
        }

        return settings;
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
    drag(dragModel::New(family(dict, "drag", "DiFelice"))),
    lift(family(dict, "lift", "none")),
    virtualMass(family(dict, "virtualMass", "none")),
    rotationalDrag(family(dict, "rotationalDrag", "Dennis")),
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
    activePhysics.add("drag", family(dict, "drag", "DiFelice"));
    activePhysics.add("lift", family(dict, "lift", "none"));
    activePhysics.add("virtualMass", family(dict, "virtualMass", "none"));
    activePhysics.add("rotationalDrag", family(dict, "rotationalDrag", "Dennis"));
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
