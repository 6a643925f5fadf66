// SPDX-License-Identifier: GPL-3.0-or-later
// No rotational drag.

#include "noRotationalDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(noRotationalDrag, 0);
    addToRunTimeSelectionTable
    (
        rotationalDragModel,
        noRotationalDrag,
        dictionary
    );
}


Foam::noRotationalDrag::noRotationalDrag(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar
Foam::noRotationalDrag::coefficient(const grainState&) const
{
    return 0;
}
