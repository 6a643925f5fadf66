// SPDX-License-Identifier: GPL-3.0-or-later
// The grains beside the fluid: what the fluid's equations take from them. Without
// grains it is what leaves an equation as it is.

#include "demCoupling.H"

#include "fvc.H"

void Foam::demCoupling::advanceVoidFraction
(
    volScalarField& voidFraction,
    const surfaceScalarField& phi,
    const scalar dt
) const
{
    if (hasGrains())
    {
        voidFraction.primitiveFieldRef() =
            voidFraction.oldTime().primitiveField()
          - dt*fvc::div(phi)().primitiveField();
        voidFraction.correctBoundaryConditions();
    }
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::demCoupling::voidFractionRate
(
    const volScalarField& voidFraction,
    const slidingGate& gate,
    const scalar dt
)
{
    auto rate = tmp<volScalarField::Internal>::New
    (
        IOobject("voidFractionRate", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless/dimTime, Zero)
    );
    if (!hasGrains())
    {
        return rate;
    }

    const scalar done =
        min((clock_->elapsed() + dt)/clock_->interval(), scalar(1));
    const scalarField target
    (
        1 - ((1 - done)*solidBefore_ + done*solidAfter_)
    );

    // Within a fluid step the flux would jump where the number of steps in an interval
    // changes, and the pressure with it
    rate.ref().field() =
        (target - voidFraction.primitiveField())/relaxationTime();

    if (transport_)
    {
        lag_ = gMax(mag(target - voidFraction.primitiveField()));
        rate.ref().field() += transport_->voidFractionRate(voidFraction, gate);
    }
    return rate;
}


Foam::tmp<Foam::surfaceScalarField> Foam::demCoupling::fluidPressureShare
(
    const volScalarField& voidFraction
) const
{
    if (!hasGrains())
    {
        return fvc::interpolate(voidFraction);
    }

    volScalarField share("fluidPressureShare", voidFraction);
    share.primitiveFieldRef() =
        1 - forces_->excessPressureStrength()*solidAfter_
      + forces_->pressureByDrag();
    share.correctBoundaryConditions();

    return forces_->division().atFaces(share);
}


Foam::scalar Foam::demCoupling::viscousForceStrength() const
{
    return hasGrains() ? forces_->viscousForceStrength() : 0;
}


Foam::tmp<Foam::scalarField> Foam::demCoupling::dragCoefficient() const
{
    return
        hasGrains()
      ? tmp<scalarField>(forces_->dragCoefficient())
      : tmp<scalarField>::New(mesh_.nCells(), Zero);
}


Foam::tmp<Foam::vectorField> Foam::demCoupling::explicitForce() const
{
    return
        hasGrains()
      ? tmp<vectorField>(forces_->explicitForce())
      : tmp<vectorField>::New(mesh_.nCells(), Zero);
}
