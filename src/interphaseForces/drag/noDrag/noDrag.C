// SPDX-License-Identifier: GPL-3.0-or-later
// No drag.

#include "noDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(noDrag, 0);
    addToRunTimeSelectionTable(dragModel, noDrag, dictionary);
}


Foam::noDrag::noDrag(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::noDrag::K(const grainState&) const
{
    return 0;
}
