// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction: a grain is cut by the faces of the cells.

#include "sphereCaps.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace voidFractionModels
{
    defineTypeName(sphereCaps);
    addToRunTimeSelectionTable(voidFractionModel, sphereCaps, dictionary);
}
}


Foam::voidFractionModels::sphereCaps::sphereCaps(const dictionary& dict)
:
    enlargement_(dict.getOrDefault<scalar>("enlargement", 1))
{
    if (!(enlargement_ >= 1))
    {
        FatalIOErrorInFunction(dict)
            << "enlargement is " << enlargement_
            << "; a grain is spread over its own volume, 1, or a larger one."
            << exit(FatalIOError);
    }
}
