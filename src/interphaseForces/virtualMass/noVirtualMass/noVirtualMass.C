// SPDX-License-Identifier: GPL-3.0-or-later
// No virtual mass.

#include "noVirtualMass.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(noVirtualMass, 0);
    addToRunTimeSelectionTable(virtualMassModel, noVirtualMass, dictionary);
}


Foam::noVirtualMass::noVirtualMass(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar
Foam::noVirtualMass::coefficient(const grainState&) const
{
    return 0;
}
