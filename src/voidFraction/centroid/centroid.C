// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction: a grain lies in the cell of its centre.

#include "centroid.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace voidFractionModels
{
    defineTypeName(centroid);
    addToRunTimeSelectionTable(voidFractionModel, centroid, dictionary);
}
}
