// SPDX-License-Identifier: GPL-3.0-or-later
// The grains beside the fluid: the void fraction that they make.

#include "demCoupling.H"

const Foam::word Foam::demCoupling::waterName("waterAtExchange");


void Foam::demCoupling::makeWaterAtExchange(const scalarField& water)
{
    waterAtExchange_.reset
    (
        new volScalarField
        (
            IOobject
            (
                waterName,
                mesh_.time().timeName(),
                mesh_,
                phase_->restarted()
              ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            mesh_,
            dimensionedScalar("water", dimless, 1),
            "zeroGradient"
        )
    );

    if (!hasWaterAtExchange(mesh_) || !phase_->restarted())
    {
        setWaterAtExchange(water);
    }
}


void Foam::demCoupling::setWaterAtExchange(const scalarField& water)
{
    if (water.size())
    {
        waterAtExchange_->primitiveFieldRef() = water;
        waterAtExchange_->correctBoundaryConditions();
    }
}


bool Foam::demCoupling::hasWaterAtExchange(const fvMesh& mesh)
{
    return
        IOobject(waterName, mesh.time().timeName(), mesh)
       .typeHeaderOk<volScalarField>(true);
}


void Foam::demCoupling::findVoidFraction(const scalarField& water)
{
    setWaterAtExchange(water);
    findVoidFraction();
}


void Foam::demCoupling::findVoidFraction()
{
    const stageTimes::stage stage(times_, "findVoidFraction");
    solidBefore_ = solidAfter_;
    solids_->setWater(waterAtExchange_->primitiveField());
    solids_->update();
    solidAfter_ = solids_->solidFraction();
    if (transport_)
    {
        transport_->update(*exchange_, solids_->mapping());
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
    const scalar interval = clock_->interval();
    const scalar done = min((clock_->elapsed() + dt)/interval, scalar(1));
    const scalarField target
    (
        1 - ((1 - done)*solidBefore_ + done*solidAfter_)
    );

    // Within a fluid step the flux would jump where their number in an interval
    // changes, and the pressure with it
    auto rate = tmp<volScalarField::Internal>::New
    (
        IOobject("voidFractionRate", mesh_.time().timeName(), mesh_),
        mesh_,
        dimless/dimTime,
        (target - voidFraction.primitiveField())/relaxationTime()
    );
    if (transport_)
    {
        lag_ = gMax(mag(target - voidFraction.primitiveField()));
        rate.ref().field() += transport_->voidFractionRate(voidFraction, gate);
    }
    return rate;
}
