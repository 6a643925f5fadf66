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
    nSizeClasses_(1),
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
    scalarList volumes(nOctaves);
    scalarList diameters(nOctaves);

    forAll(all, octave)
    {
        volumes[octave] = all[octave].volume;
        diameters[octave] = all[octave].diameter;
    }
    reduce(volumes, sumOp<scalarList>());
    reduce(diameters, sumOp<scalarList>());
    totalVolume_ = sum(volumes);

    // Octaves without a grain are no class
    labelList sizeClass(nOctaves, Zero);
    DynamicList<scalar> means;

    forAll(volumes, octave)
    {
        if (volumes[octave] > 0)
        {
            sizeClass[octave] = means.size();
            means.append(diameters[octave]/volumes[octave]);
        }
    }
    if (means.empty())
    {
        means.append(0);
    }

    for (label& k : sizeClasses_)
    {
        k = sizeClass[k];
    }
    nSizeClasses_ = means.size();
    ofVolume_->setDiameters(means);
}


void Foam::particleMeshMapping::setWater(const scalarField& water)
{
    ofVolume_->setWater(water);
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
