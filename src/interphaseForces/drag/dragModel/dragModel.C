// SPDX-License-Identifier: GPL-3.0-or-later
// Base of the drag laws, chosen by name.

#include "dragModel.H"
#include "blendedDrag.H"
#include "closure.H"
#include "correctedDrag.H"
#include "shapedDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
}


Foam::autoPtr<Foam::dragModel> Foam::dragModel::NewLaw(const dictionary& dict)
{
    autoPtr<dragModel> model
    (
        closure::select<dragModel>
        (
            dict,
            "model",
            closure::without
            (
                dict,
                {
                    "model", "strength", "base", "baseSettings", "shape",
                    "correction"
                }
            )
        )
    );
    const scalar strength = closure::strength(dict);

    if
    (
        strength == 1
     && !dict.found("base")
     && !dict.found("baseSettings")
    )
    {
        return model;
    }

    autoPtr<dragModel> base
    (
        closure::select<dragModel>
        (
            dict, "base", dict.subOrEmptyDict("baseSettings")
        )
    );

    if (strength == 1)
    {
        return model;
    }
    if (strength == 0)
    {
        return base;
    }
    return autoPtr<dragModel>
    (
        new blendedDrag(strength, std::move(base), std::move(model))
    );
}


void Foam::dragModel::K
(
    const UList<grainState>& states,
    UList<scalar>& K
) const
{
    forAll(states, i)
    {
        K[i] = this->K(states[i]);
    }
}


Foam::autoPtr<Foam::dragModel> Foam::dragModel::New(const dictionary& dict)
{
    return correctedDrag::New(shapedDrag::New(NewLaw(dict), dict), dict);
}
