// SPDX-License-Identifier: GPL-3.0-or-later
// Lift of a spinning grain (Magnus lift) of Lun & Liu (1997).

#include "LunLiu.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "mathematicalConstants.H"

namespace Foam
{
    defineTypeNameAndDebug(LunLiu, 0);
    addToRunTimeSelectionTable(liftModel, LunLiu, dictionary);
}


Foam::LunLiu::LunLiu(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::vector Foam::LunLiu::force(const grainState& state) const
{
    const scalar d = state.d;
    const scalar Re = state.rho*d*mag(state.slip)/state.mu;

    // 1 at Re 1, so that the branches meet
    const scalar f =
        0.178 + 0.822*std::pow(min(max(Re, scalar(1)), scalar(1000)), -0.522);

    return
        constant::mathematical::pi/8*state.rho*d*d*d*f
       *(state.relativeSpin ^ state.slip);
}
