// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of Di Felice (1994), in the form that model A needs or as a paper
// printed it.

#include "DiFelice.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(DiFelice, 0);
    addToRunTimeSelectionTable(dragModel, DiFelice, dictionary);
}

using namespace Foam::standardDrag;

const Foam::Enum<Foam::DiFelice::formulations>
Foam::DiFelice::formulationNames
({
    {formulations::modelA, "modelA"},
    {formulations::asPrinted, "asPrinted"}
});


Foam::DiFelice::DiFelice(const dictionary& dict)
:
    formulation_
    (
        closure::choose
        (
            dict, "formulation", formulationNames, formulations::modelA
        )
    )
{
    closure::checkKeywords(dict, {"formulation"});
}


Foam::scalar Foam::DiFelice::K(const grainState& state) const
{
    const scalar e = state.voidFraction;
    const scalar slipRe = slipReynolds(state);
    const scalar Re = formulation_ == formulations::modelA ? e*slipRe : slipRe;

    // One logarithm serves both powers of Re
    const scalar logRe = finiteLog(Re);
    const scalar distance = 1.5 - logRe/M_LN10;
    const scalar chi = 3.7 - 0.65*std::exp(-0.5*distance*distance);

    return
        stokes(state)*overStokes(Re, logRe)*std::exp((1 - chi)*std::log(e));
}
