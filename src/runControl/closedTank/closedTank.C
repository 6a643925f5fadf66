// SPDX-License-Identifier: GPL-3.0-or-later
// The volume of the grains in a tank whose fluid has no way out.

#include "closedTank.H"

namespace
{
    //- Change of the grains' volume in a closed tank that is rounding, as a share of
    //  the tank's volume
    constexpr Foam::scalar roundingOfRoom = 1e-10;
}


void Foam::scaleToGrainVolume
(
    const volScalarField& p_rgh,
    volScalarField& voidFraction,
    const scalarField& solidFraction
)
{
    const scalarField& V = voidFraction.mesh().V();
    const scalar all = gSum(V);
    const scalar read = gSum(V*(1 - voidFraction.primitiveField()));
    const scalar grains = gSum(V*solidFraction);

    if (!p_rgh.needReference() || mag(read - grains) <= roundingOfRoom*all)
    {
        return;
    }

    // More than four digits would leave out
    if (mag(read - grains) > 1e-4*all)
    {
        FatalErrorInFunction
            << "The void fraction in " << voidFraction.objectPath() << " leaves"
            << " room for " << read << " m3 of grains, and those of this time have "
            << grains << " m3; the tank is closed, so no flux makes up for it." << nl
            << "    Go on from another time, whose files are of one run."
            << exit(FatalError);
    }

    voidFraction.primitiveFieldRef() =
        1 - (1 - voidFraction.primitiveField())*(grains/read);
    voidFraction.correctBoundaryConditions();

    Info<< "Void fraction: volume of the grains as read with the digits of its"
        << " file, over that of the grains, less 1: " << read/grains - 1
        << nl << endl;
}


void Foam::checkGrainVolume
(
    const volScalarField& p_rgh,
    const volScalarField::Internal& voidFractionRate,
    const scalar interval
)
{
    if (!p_rgh.needReference())
    {
        return;
    }

    const scalarField& V = p_rgh.mesh().V();
    const scalar more = -interval*gSum(V*voidFractionRate.field());

    if (mag(more) > roundingOfRoom*gSum(V))
    {
        FatalErrorInFunction
            << "The volume of the grains changes by " << more << " m3 at time "
            << p_rgh.time().timeName() << " s, but the tank is closed:"
            << " the fluid has no place to go, or to come from." << nl
            << "    Give " << p_rgh.name() << " a value on a patch, with"
            << " totalPressure for instance, where grains enter or leave."
            << exit(FatalError);
    }
}
