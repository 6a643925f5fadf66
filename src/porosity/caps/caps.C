// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity: a grain is cut by the faces of the cells.

#include "caps.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace porosityModels
{
    defineTypeName(caps);
    addToRunTimeSelectionTable(porosityModel, caps, dictionary);
}
}
