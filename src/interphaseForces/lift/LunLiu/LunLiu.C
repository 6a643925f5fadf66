// SPDX-License-Identifier: GPL-3.0-or-later
// Lift of a spinning grain (Magnus lift) of Lun & Liu (1997).

#include "LunLiu.H"
#include "addToRunTimeSelectionTable.H"
#include "blockNumbers.H"
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
    vector result;
    UList<vector> one(&result, 1);
    force(UList<grainState>(const_cast<grainState*>(&state), 1), one);

    return result;
}


void Foam::LunLiu::force
(
    const UList<grainState>& states,
    UList<vector>& forces
) const
{
    for (label first = 0; first < states.size(); first += blockOfGrains)
    {
        const label n = min(states.size() - first, blockOfGrains);
        blockNumbers Re(n);

        for (label i = 0; i < n; ++i)
        {
            const grainState& state = states[first + i];
            Re[i] = state.rho*state.d*mag(state.slip)/state.mu;
        }

        // 1 at Re 1, so that the branches meet
        const blockNumbers f
        (
            0.178 + 0.822*(-0.522*Re.max(1).min(1000).log()).exp()
        );

        for (label i = 0; i < n; ++i)
        {
            const grainState& state = states[first + i];
            forces[first + i] =
                constant::mathematical::pi/8*state.rho*pow3(state.d)*f[i]
               *(state.relativeSpin ^ state.slip);
        }
    }
}
