// SPDX-License-Identifier: GPL-3.0-or-later
// Base of the rotational drag laws, chosen by name.

#include "rotationalDragModel.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(rotationalDragModel, 0);
    defineRunTimeSelectionTable(rotationalDragModel, dictionary);
}


Foam::autoPtr<Foam::rotationalDragModel>
Foam::rotationalDragModel::New(const dictionary& dict)
{
    return closure::select<rotationalDragModel>
    (
        dict,
        "model",
        closure::without(dict, {"model"})
    );
}
