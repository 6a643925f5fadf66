// SPDX-License-Identifier: GPL-3.0-or-later
// Base of the lift laws, chosen by name.

#include "liftModel.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(liftModel, 0);
    defineRunTimeSelectionTable(liftModel, dictionary);
}


Foam::autoPtr<Foam::liftModel>
Foam::liftModel::New(const dictionary& dict)
{
    return closure::select<liftModel>
    (
        dict,
        "model",
        closure::without(dict, {"model"})
    );
}


void Foam::liftModel::force
(
    const UList<grainState>& states,
    UList<vector>& forces
) const
{
    forAll(states, i)
    {
        forces[i] = force(states[i]);
    }
}
