// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of Gidaspow (1994): Ergun in dense packings, Wen & Yu in dilute ones.

#include "Gidaspow.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(Gidaspow, 0);
    addToRunTimeSelectionTable(dragModel, Gidaspow, dictionary);
}

using namespace Foam::standardDrag;

const Foam::Enum<Foam::Gidaspow::transitions>
Foam::Gidaspow::transitionNames
({
    {transitions::sharp, "sharp"},
    {transitions::smooth, "smooth"}
});


Foam::Gidaspow::Gidaspow(const dictionary& dict)
:
    transition_
    (
        closure::choose
        (
            dict, "transition", transitionNames, transitions::sharp
        )
    )
{
    closure::checkKeywords(dict, {"transition"});
}


Foam::scalar Foam::Gidaspow::WenYu(const grainState& state)
{
    const scalar e = state.voidFraction;
    const scalar Re = e*slipReynolds(state);

    return
        stokes(state)*overStokes(Re, finiteLog(Re))
       *std::exp(-2.65*std::log(e));
}


Foam::scalar Foam::Gidaspow::K(const grainState& state) const
{
    const scalar e = state.voidFraction;

    if (transition_ == transitions::sharp)
    {
        return e < 0.8 ? packed(state, 150, 1.75) : WenYu(state);
    }

    const scalar dilute =
        0.5 + std::atan(150*1.75*(e - 0.8))/constant::mathematical::pi;

    return
        dilute*WenYu(state) + (1 - dilute)*packed(state, 150, 1.75);
}
