// SPDX-License-Identifier: GPL-3.0-or-later
// No lift.

#include "noLift.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(noLift, 0);
    addToRunTimeSelectionTable(liftModel, noLift, dictionary);
}


Foam::noLift::noLift(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::vector Foam::noLift::force(const grainState&) const
{
    return vector::zero;
}
