// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity: a grain lies in the cell of its centre.

#include "centre.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace porosityModels
{
    defineTypeName(centre);
    addToRunTimeSelectionTable(porosityModel, centre, dictionary);
}
}
