// SPDX-License-Identifier: GPL-3.0-or-later
// Velocity of the grains around each grain, where computed ones stand for many.

#include "meanGrainVelocity.H"

void Foam::meanGrainVelocity::update()
{
    const List<locatedGrain>& grains = exchange_.grains();
    scalarField mass(grains.size());
    mean_.setSize(grains.size());

    forAll(grains, i)
    {
        mass[i] = grains[i].mass;
        mean_[i] = grains[i].velocity;
    }

    const auto around = [this](const auto& ofGrains)
    {
        const smoothingModel& smoothing = mapping_.ofMomentum();
        return mapping_.gather(mapping_.spread(ofGrains, smoothing), smoothing);
    };

    mean_ = around(vectorField(mass*mean_))/around(mass);
}
