// SPDX-License-Identifier: GPL-3.0-or-later
// Virtual mass that grows with the solid fraction, of Zuber (1964).

#include "Zuber.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(Zuber, 0);
    addToRunTimeSelectionTable(virtualMassModel, Zuber, dictionary);
}


Foam::Zuber::Zuber(const dictionary& dict)
:
    single_(coefficientIn(dict))
{}


Foam::scalar Foam::Zuber::coefficient(const grainState& state) const
{
    const scalar e = state.voidFraction;

    return single_*(3 - 2*e)/e;
}
