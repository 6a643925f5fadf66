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
