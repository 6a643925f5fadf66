// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of single grains by sphericity, with factors of Stokes's and Newton's drag.

#include "Ganser.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

#include <cmath>

namespace Foam
{
    defineTypeNameAndDebug(Ganser, 0);
    addToRunTimeSelectionTable(shapeFactor, Ganser, dictionary);
}


Foam::Ganser::Ganser(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::Ganser::overStokes
(
    const scalar Re,
    const scalar sphericity,
    const scalar crosswiseSphericity
) const
{
    const scalar flatness = max(-std::log10(sphericity), scalar(0));
    const scalar K1 =
        1/(1/(3*std::sqrt(crosswiseSphericity)) + 2/(3*std::sqrt(sphericity)));
    const scalar K2 = std::pow(10.0, 1.8148*std::pow(flatness, 0.5743));
    const scalar x = Re*K1*K2;

    return
        (1 + 0.1118*std::pow(x, 0.6567))/K1
      + K2*Re/24*0.4305*x/(x + 3305);
}
