// SPDX-License-Identifier: GPL-3.0-or-later
// Virtual mass of a fixed coefficient.

#include "constantVirtualMass.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "error.H"

namespace Foam
{
    defineTypeNameAndDebug(constantVirtualMass, 0);
    addToRunTimeSelectionTable
    (
        virtualMassModel,
        constantVirtualMass,
        dictionary
    );
}


Foam::constantVirtualMass::constantVirtualMass(const dictionary& dict)
:
    coefficient_(dict.getOrDefault<scalar>("coefficient", 0.5))
{
    closure::checkKeywords(dict, {"coefficient"});

    if (!(coefficient_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "The coefficient of virtual mass is " << coefficient_
            << "; it must not be negative (0.5 for a single sphere)."
            << exit(FatalIOError);
    }
}


Foam::scalar
Foam::constantVirtualMass::coefficient(const grainState&) const
{
    return coefficient_;
}
