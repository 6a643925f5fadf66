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
