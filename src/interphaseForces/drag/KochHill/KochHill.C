// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of Koch & Hill (2001), from lattice-Boltzmann computations.

#include "KochHill.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(KochHill, 0);
    addToRunTimeSelectionTable(dragModel, KochHill, dictionary);
}

using namespace Foam::standardDrag;

namespace
{

//- Drag at rest over Stokes's, at the solid fraction s
Foam::scalar F0(const Foam::scalar s)
{
    const Foam::scalar e = 1 - s;

    if (s >= 0.4)
    {
        return 10*s/(e*e*e);
    }

    const Foam::scalar sLogs = s > 0 ? s*std::log(s) : 0;

    return
        (1 + 3*std::sqrt(s/2) + 135.0/64*sLogs + 16.14*s)
       /(1 + s*(0.681 + s*(-8.48 + s*8.16)));
}


//- Rise of the drag with the Reynolds number of the radius
Foam::scalar F3(const Foam::scalar s)
{
    const Foam::scalar e = 1 - s;

    return 0.0673 + 0.212*s + 0.0232/(e*e*e*e*e);
}

} // End anonymous namespace


Foam::KochHill::KochHill(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::KochHill::K(const grainState& state) const
{
    const scalar e = state.voidFraction;

    // Round-off may put the void fraction above 1
    const scalar s = max(1 - e, scalar(0));
    const scalar Re = 0.5*e*slipReynolds(state);

    return stokes(state)*e*e*(F0(s) + F3(s)*Re);
}
