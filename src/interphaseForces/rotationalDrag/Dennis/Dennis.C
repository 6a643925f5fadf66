// SPDX-License-Identifier: GPL-3.0-or-later
// Rotational drag of a sphere, laminar and above: Dennis et al. (1980).

#include "Dennis.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "mathematicalConstants.H"

namespace Foam
{
    defineTypeNameAndDebug(Dennis, 0);
    addToRunTimeSelectionTable(rotationalDragModel, Dennis, dictionary);
}


Foam::Dennis::Dennis(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::Dennis::coefficient(const grainState& state) const
{
    const scalar d = state.d;
    const scalar Re = state.rho*d*d*mag(state.relativeSpin)/state.mu;
    const scalar laminar = 64*constant::mathematical::pi;

    return
        state.mu*d*d*d/64*max(laminar, 12.9*std::sqrt(Re) + 128.4);
}
