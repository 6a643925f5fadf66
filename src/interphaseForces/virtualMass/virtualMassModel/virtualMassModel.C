// SPDX-License-Identifier: GPL-3.0-or-later
// Base of the virtual mass laws, chosen by name.

#include "virtualMassModel.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(virtualMassModel, 0);
    defineRunTimeSelectionTable(virtualMassModel, dictionary);
}


Foam::autoPtr<Foam::virtualMassModel>
Foam::virtualMassModel::New(const dictionary& dict)
{
    return closure::select<virtualMassModel>
    (
        dict,
        "model",
        closure::without(dict, {"model"})
    );
}
