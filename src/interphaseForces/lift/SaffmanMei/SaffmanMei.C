// SPDX-License-Identifier: GPL-3.0-or-later
// Lift of a grain in a shear flow: Saffman (1965) with Mei's correction.

#include "SaffmanMei.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

namespace Foam
{
    defineTypeNameAndDebug(SaffmanMei, 0);
    addToRunTimeSelectionTable(liftModel, SaffmanMei, dictionary);
}


Foam::SaffmanMei::SaffmanMei(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::vector Foam::SaffmanMei::force(const grainState& state) const
{
    const scalar slip = mag(state.slip);
    const scalar w = mag(state.vorticity);
    const scalar d = state.d;

    // Where there is neither slip nor shear there is no force: small enough a
    // bound to be out of sight, large enough to divide by
    if (slip < 1e-30 || w < 1e-30)
    {
        return vector::zero;
    }

    const scalar Re = state.rho*d*slip/state.mu;
    const scalar rootA = std::sqrt(0.5*d*w/slip);
    const scalar f =
        Re > 40
      ? 0.0524*rootA*std::sqrt(Re)
      : 0.3314*rootA + (1 - 0.3314*rootA)*std::exp(-0.1*Re);

    return
        1.615*d*d*std::sqrt(state.rho*state.mu/w)*f
       *(state.slip ^ state.vorticity);
}
