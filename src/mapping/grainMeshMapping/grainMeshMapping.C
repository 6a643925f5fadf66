// SPDX-License-Identifier: GPL-3.0-or-later
// The way of numbers between grains and cells.

#include "grainMeshMapping.H"

#include "Switch.H"
#include "noSmoothing.H"

Foam::grainMeshMapping::grainMeshMapping
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


void Foam::grainMeshMapping::set(const sizes& all, const bool keepClasses)
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

    if (!keepClasses)
    {
        octaves_.clear();
        diameters_.clear();
    }

    // Octaves without a grain are no class
    forAll(volumes, octave)
    {
        if (volumes[octave] > 0 && !octaves_.found(octave))
        {
            octaves_.append(octave);
            diameters_.append(diameters[octave]/volumes[octave]);
        }
    }
    if (octaves_.empty())
    {
        octaves_.append(0);
        diameters_.append(0);
    }

    for (label& k : sizeClasses_)
    {
        k = octaves_.find(k);
    }
    ofVolume_->setDiameters(diameters_);
}


void Foam::grainMeshMapping::setWater(const scalarField& water)
{
    ofVolume_->setWater(water);
}


Foam::scalarField Foam::grainMeshMapping::sauterDiameter() const
{
    const List<locatedGrain>& grains = exchange_.grains();
    scalarField areas(grains.size());

    forAll(grains, i)
    {
        areas[i] = volumes_[i]/(2*grains[i].clumpRadius);
    }

    return gather(spread(volumes_))/gather(spread(areas));
}
