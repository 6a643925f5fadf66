// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing: none.

#include "noSmoothing.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace smoothingModels
{
    defineTypeName(noSmoothing);
    addToRunTimeSelectionTable(smoothingModel, noSmoothing, dictionary);
}
}
