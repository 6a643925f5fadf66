// SPDX-License-Identifier: GPL-3.0-or-later
// The way of numbers between grains and cells.

#include "particleMeshMapping.H"

#include "Switch.H"
#include "noSmoothing.H"

Foam::particleMeshMapping::particleMeshMapping
(
    const grainExchange& exchange,
    const dictionary& dict
)
:
    exchange_(exchange),
    ofVolume_(smoothingModel::New(exchange.mesh(), dict)),
    weights_(exchange.overlap()),
    totalVolume_(0)
{
    if (!dict.getOrDefault<Switch>("drag", true))
    {
        ofMomentum_.reset
        (
            new smoothingModels::noSmoothing(mesh(), dictionary::null)
        );
    }
}


void Foam::particleMeshMapping::set(const sizes& all)
{
    totalVolume_ = returnReduce(scalar(all.volume), sumOp<scalar>());
    ofVolume_->setDiameter
    (
        returnReduce(all.diameter, sumOp<scalar>())/max(totalVolume_, VSMALL)
    );
}


Foam::scalarField Foam::particleMeshMapping::sauterDiameter() const
{
    const List<locatedGrain>& grains = exchange_.grains();
    scalarField areas(grains.size());

    forAll(grains, i)
    {
        areas[i] = volumes_[i]/(2*grains[i].radius);
    }

    return gather(spread(volumes_))/gather(spread(areas));
}
