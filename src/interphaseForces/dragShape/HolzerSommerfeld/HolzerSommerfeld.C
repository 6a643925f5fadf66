// SPDX-License-Identifier: GPL-3.0-or-later
// Drag of single grains of any shape, by sphericity and the area across the flow.

#include "HolzerSommerfeld.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"

#include <cmath>

namespace Foam
{
    defineTypeNameAndDebug(HolzerSommerfeld, 0);
    addToRunTimeSelectionTable(shapeFactor, HolzerSommerfeld, dictionary);
}


Foam::HolzerSommerfeld::HolzerSommerfeld(const dictionary& dict)
{
    closure::checkKeywords(dict);
}


Foam::scalar Foam::HolzerSommerfeld::overStokes
(
    const scalar Re,
    const scalar sphericity,
    const scalar crosswiseSphericity
) const
{
    const scalar flatness = max(-std::log10(sphericity), scalar(0));
    const scalar viscous =
        8/std::sqrt(crosswiseSphericity) + 16/std::sqrt(sphericity);
    const scalar boundaryLayer = 3/std::pow(sphericity, 0.75);
    const scalar inertial =
        0.42*std::pow(10.0, 0.4*std::pow(flatness, 0.2))/crosswiseSphericity;

    return (viscous + boundaryLayer*std::sqrt(Re) + inertial*Re)/24;
}
