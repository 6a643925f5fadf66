// SPDX-License-Identifier: GPL-3.0-or-later
// Drag in a packing after Ergun (1952), its two coefficients free.

#include "Ergun.H"
#include "addToRunTimeSelectionTable.H"
#include "closure.H"
#include "standardDrag.H"

namespace Foam
{
    defineTypeNameAndDebug(Ergun, 0);
    addToRunTimeSelectionTable(dragModel, Ergun, dictionary);
}


Foam::Ergun::Ergun(const dictionary& dict)
:
    viscous_(dict.getOrDefault<scalar>("viscous", 150)),
    inertial_(dict.getOrDefault<scalar>("inertial", 1.75))
{
    closure::checkKeywords(dict, {"viscous", "inertial"});

    if (!(viscous_ >= 0 && inertial_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "viscous " << viscous_ << " and inertial " << inertial_
            << " of the drag law Ergun must not be negative." << nl
            << "    Ergun's own are 150 and 1.75." << exit(FatalIOError);
    }
}


Foam::scalar Foam::Ergun::K(const grainState& state) const
{
    return standardDrag::packed(state, viscous_, inertial_);
}
