// SPDX-License-Identifier: GPL-3.0-or-later
// Virtual mass of a fixed coefficient.

#include "constantVirtualMass.H"
#include "addToRunTimeSelectionTable.H"
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
    coefficient_(coefficientIn(dict))
{}


Foam::scalar
Foam::constantVirtualMass::coefficient(const grainState&) const
{
    return coefficient_;
}
