// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of Beetstra et al. (2007), from lattice-Boltzmann computations, also
// for grains of several sizes.

#include "Beetstra.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(Beetstra, 0);
    addToRunTimeSelectionTable(dragModel, Beetstra, dictionary);
}

using namespace Foam::standardDrag;

namespace
{

//- Drag at rest over Stokes's
Foam::scalar atRest(const Foam::scalar s, const Foam::scalar e)
{
    return 10*s/(e*e) + e*e*(1 + 1.5*std::sqrt(s));
}


//- What inertia adds
Foam::scalar inertial
(
    const Foam::scalar s,
    const Foam::scalar e,
    const Foam::scalar Re
)
{
    const Foam::scalar logRe = finiteLog(Re);
    const Foam::scalar bracket =
        1/e + 3*e*s + 8.4*std::exp(-0.343*logRe);
    const Foam::scalar damping =
        1 + std::exp(3*M_LN10*s - (0.5 + 2*s)*logRe);

    return 0.413/24*Re/(e*e)*bracket/damping;
}

} // End anonymous namespace


Foam::Beetstra::Beetstra(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::Beetstra::K(const grainState& state) const
{
    const scalar e = state.voidFraction;

    // Round-off may put the void fraction above 1
    const scalar s = max(1 - e, scalar(0));
    const scalar y = state.d/state.dSauter;
    const scalar Re = e*slipReynolds(state)/y;

    return stokes(state)*e*y*(atRest(s, e) + inertial(s, e, Re));
}
