// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of a single sphere, blind to its neighbours.

#include "SchillerNaumann.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(SchillerNaumann, 0);
    addToRunTimeSelectionTable(dragModel, SchillerNaumann, dictionary);
}

using namespace Foam::standardDrag;


Foam::SchillerNaumann::SchillerNaumann(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::SchillerNaumann::K(const grainState& state) const
{
    const scalar Re = slipReynolds(state);

    return stokes(state)*overStokes(Re, finiteLog(Re));
}
