// SPDX-License-Identifier: GPL-3.0-or-later
// The way of numbers between grains and cells.

#include "particleMeshMapping.H"

#include "mathematicalConstants.H"

Foam::particleMeshMapping::particleMeshMapping
(
    const grainExchange& exchange,
    const dictionary& dict
)
:
    exchange_(exchange),
    smoothing_(smoothingModel::New(exchange.mesh(), dict)),
    weights_(exchange.overlap()),
    totalVolume_(0)
{}


void Foam::particleMeshMapping::measure()
{
    const List<locatedGrain>& grains = exchange_.grains();

    volumes_.setSize(grains.size());
    // Equal numbers added one by one all round the same way: in double precision
    // 1e5 grains would be wrong by 1e-12
    long double volumeSum = 0;
    scalar diameterSum = 0;

    forAll(grains, i)
    {
        const scalar radius = grains[i].radius;

        volumes_[i] = 4*constant::mathematical::pi/3*pow3(radius);
        volumeSum += volumes_[i];
        diameterSum += volumes_[i]*2*radius;
    }

    totalVolume_ = returnReduce(scalar(volumeSum), sumOp<scalar>());
    reduce(diameterSum, sumOp<scalar>());
    smoothing_->setDiameter(diameterSum/max(totalVolume_, VSMALL));
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
