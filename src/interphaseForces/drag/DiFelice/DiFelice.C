// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of Di Felice (1994), in the form that model A needs or as a paper
// printed it.

#include "DiFelice.H"
#include "addToRunTimeSelectionTable.H"
#include "blockNumbers.H"
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
    scalar result;
    UList<scalar> one(&result, 1);
    K(UList<grainState>(const_cast<grainState*>(&state), 1), one);

    return result;
}


void Foam::DiFelice::K
(
    const UList<grainState>& states,
    UList<scalar>& K
) const
{
    for (label first = 0; first < states.size(); first += blockOfGrains)
    {
        const label n = min(states.size() - first, blockOfGrains);
        blockNumbers e(n), Re(n), single(n);

        for (label i = 0; i < n; ++i)
        {
            const grainState& state = states[first + i];
            const scalar slipRe = slipReynolds(state);

            e[i] = state.voidFraction;
            Re[i] =
                formulation_ == formulations::modelA ? e[i]*slipRe : slipRe;
            single[i] = stokes(state);
        }

        // One logarithm serves both powers of Re, finite at rest
        const blockNumbers logRe(Re.max(1e-30).log());
        const blockNumbers chi
        (
            3.7 - 0.65*(-0.5*(1.5 - logRe/M_LN10).square()).exp()
        );
        const blockNumbers drag((Re > singleSphere::mostRe).select
        (
            single*singleSphere::perRe*Re,
            single*(1 + singleSphere::factor*(singleSphere::exponent*logRe).exp())
        ));

        const blockNumbers result(drag*((1 - chi)*e.log()).exp());

        for (label i = 0; i < n; ++i)
        {
            K[first + i] = result[i];
        }
    }
}
