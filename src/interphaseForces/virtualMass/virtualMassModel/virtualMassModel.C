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


Foam::scalar Foam::virtualMassModel::coefficientIn(const dictionary& dict)
{
    closure::checkKeywords(dict, {"coefficient"});
    const scalar coefficient = dict.getOrDefault<scalar>("coefficient", 0.5);

    if (!(coefficient >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "The coefficient of virtual mass is " << coefficient
            << "; it must not be negative (0.5 for a single sphere)."
            << exit(FatalIOError);
    }
    return coefficient;
}
