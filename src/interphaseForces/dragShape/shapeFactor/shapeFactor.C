// SPDX-License-Identifier: GPL-3.0-or-later
// Base of the laws of the drag of grains that are not spheres, chosen by name.

#include "shapeFactor.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(shapeFactor, 0);
    defineRunTimeSelectionTable(shapeFactor, dictionary);
}


Foam::autoPtr<Foam::shapeFactor>
Foam::shapeFactor::New(const dictionary& dict)
{
    return closure::select<shapeFactor>
    (
        dict,
        "model",
        closure::without(dict, {"model"})
    );
}


Foam::scalar Foam::shapeFactor::factor
(
    const scalar Re,
    const scalar sphericity,
    const scalar crosswiseSphericity
) const
{
    if (sphericity == 1 && crosswiseSphericity == 1)
    {
        return 1;
    }

    return
        overStokes(Re, sphericity, crosswiseSphericity)
       /standardDrag::overStokes(Re, standardDrag::finiteLog(Re));
}
