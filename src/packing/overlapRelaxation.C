// SPDX-License-Identifier: GPL-3.0-or-later
// Pushes overlapping spheres apart until none overlap (no friction, no weight).

#include "overlapRelaxation.H"

#include "fireStep.H"

namespace Foam
{
namespace
{

//- The spheres are relaxed this much too large, so that the true ones end up
//  clear of each other in a finite number of steps
constexpr scalar oversize = 2e-4;

//- Steps from one check of the progress to the next
constexpr label stepsPerCheck = 100;

} // End anonymous namespace
} // End namespace Foam


Foam::overlapRelaxation::overlapRelaxation
(
    const packingBox& box,
    const pointField& start,
    const scalarField& diameters
)
:
    box_(box),
    positions_(start),
    target_(diameters),
    diameters_((1 + oversize)*diameters),
    velocities_(start.size(), Zero),
    forces_(start.size(), Zero),
    pairs_(),
    pairPositions_(),
    gap_(0.2*(start.size() ? min(diameters) : 0))
{
    updatePairs();
}


void Foam::overlapRelaxation::updatePairs()
{
    for (point& p : positions_)
    {
        box_.wrap(p);
    }
    pairs_ = pairsWithin(box_, positions_, diameters_, gap_);
    pairPositions_ = positions_;
}


bool Foam::overlapRelaxation::pairsAreOld() const
{
    const scalar limit = sqr(0.5*gap_);

    forAll(positions_, i)
    {
        if (magSqr(positions_[i] - pairPositions_[i]) > limit)
        {
            return true;
        }
    }
    return false;
}


void Foam::overlapRelaxation::addPairForces()
{
    for (const grainPair& pair : pairs_)
    {
        const label i = pair.first;
        const label j = pair.second;
        const vector r = positions_[j] + pair.shift - positions_[i];
        const scalar contact = 0.5*(diameters_[i] + diameters_[j]);

        if (magSqr(r) < sqr(contact))
        {
            const scalar distance = max(mag(r), VSMALL);
            const vector force = (contact/distance - 1)*r;
            forces_[i] -= force;
            forces_[j] += force;
        }
    }
}


void Foam::overlapRelaxation::addWallForces()
{
    const point& low = box_.bounds().min();
    const point& high = box_.bounds().max();

    for (direction d = 0; d < 3; ++d)
    {
        if (!box_.periodic(d))
        {
            forAll(positions_, i)
            {
                const scalar radius = 0.5*diameters_[i];
                const scalar x = positions_[i][d];
                forces_[i][d] += max(low[d] + radius - x, scalar(0));
                forces_[i][d] -= max(x - high[d] + radius, scalar(0));
            }
        }
    }
}


void Foam::overlapRelaxation::updateForces()
{
    forces_ = Zero;
    addPairForces();
    addWallForces();
}


Foam::scalar Foam::overlapRelaxation::overlap() const
{
    return largestOverlap(box_, positions_, target_, pairs_);
}


Foam::scalar Foam::overlapRelaxation::relax
(
    const scalar tolerance,
    const label maxSteps
)
{
    fireStep engine;
    velocities_ = Zero;
    scalar best = VGREAT;
    label checksWithoutGain = 0;

    for (label step = 0; step < maxSteps; ++step)
    {
        if (pairsAreOld())
        {
            updatePairs();
        }
        if (step % stepsPerCheck == 0)
        {
            const scalar now = overlap();
            checksWithoutGain = now < 0.98*best ? 0 : checksWithoutGain + 1;
            best = min(best, now);

            if (now <= tolerance || checksWithoutGain > 10)
            {
                break;
            }
        }
        updateForces();
        engine.advance(positions_, velocities_, forces_);
    }

    updatePairs();
    return overlap();
}


void Foam::overlapRelaxation::shake(const scalar amplitude, Random& random)
{
    forAll(positions_, i)
    {
        const vector kick =
            2*random.sample01<vector>() - vector::one;
        positions_[i] += amplitude*diameters_[i]*kick;
        box_.clipToWalls(positions_[i], 0.5*diameters_[i]);
    }
    updatePairs();
}
