// SPDX-License-Identifier: GPL-3.0-or-later
// Pushes overlapping clumps apart until none overlap (no friction, no weight).

#include "clumpRelaxation.H"

#include "fireStep.H"

#include <cmath>

namespace Foam
{
namespace
{

//- The spheres are relaxed this much too large, so that the true ones end up
//  clear of each other in a finite number of steps
constexpr scalar oversize = 2e-4;

//- Steps from one check of the progress to the next
constexpr label stepsPerCheck = 50;

//- Shorter steps than for spheres: a clump touches more neighbours
constexpr scalar longestStep = 0.3;


labelList bodyOfSphere(const label nBodies, const label nEach)
{
    labelList body(nBodies*nEach);
    forAll(body, i)
    {
        body[i] = i/nEach;
    }
    return body;
}


//- Turn by a vector of angles [rad]
void turn(quaternion& q, const vector& angles)
{
    const scalar angle = mag(angles);
    if (angle > VSMALL)
    {
        const quaternion by
        (
            std::cos(0.5*angle), std::sin(0.5*angle)/angle*angles
        );
        q = by*q;
        q.normalize();
    }
}

} // End anonymous namespace
} // End namespace Foam


Foam::DynamicList<Foam::grainPair> Foam::pairsOfBodies
(
    const packingBox& box,
    const UList<point>& positions,
    const UList<scalar>& diameters,
    const UList<label>& body,
    const scalar gap
)
{
    pointField inside(positions);
    for (point& p : inside)
    {
        box.wrap(p);
    }

    DynamicList<grainPair> result(4*positions.size());
    for (grainPair pair : pairsWithin(box, inside, diameters, gap))
    {
        const label i = pair.first;
        const label j = pair.second;
        pair.shift +=
            (inside[j] - positions[j]) - (inside[i] - positions[i]);
        const bool image = mag(pair.shift) > 0.5*cmptMin(box.span());

        if (body[i] != body[j] || image)
        {
            result.append(pair);
        }
    }
    return result;
}


Foam::clumpRelaxation::clumpRelaxation
(
    const packingBox& box,
    const clumpShape& shape,
    const pointField& start,
    const List<quaternion>& orientations
)
:
    box_(box),
    shape_(shape),
    centres_(start),
    orientations_(orientations),
    body_(bodyOfSphere(start.size(), shape.size())),
    target_(shape.diameters(start.size())),
    diameters_((1 + oversize)*target_),
    spheres_(shape.placed(start, orientations)),
    sphereForces_(spheres_.size(), Zero),
    velocities_(2*start.size(), Zero),
    forces_(2*start.size(), Zero),
    pairs_(),
    pairSpheres_(),
    gap_(0.4*min(shape.radii()))
{
    updatePairs();
}


void Foam::clumpRelaxation::updatePairs()
{
    for (point& p : centres_)
    {
        box_.wrap(p);
    }
    spheres_ = shape_.placed(centres_, orientations_);
    pairs_ = pairsOfBodies(box_, spheres_, diameters_, body_, gap_);
    pairSpheres_ = spheres_;
}


bool Foam::clumpRelaxation::pairsAreOld() const
{
    const scalar limit = sqr(0.5*gap_);

    forAll(spheres_, i)
    {
        if (magSqr(spheres_[i] - pairSpheres_[i]) > limit)
        {
            return true;
        }
    }
    return false;
}


void Foam::clumpRelaxation::addPairForces()
{
    for (const grainPair& pair : pairs_)
    {
        const label i = pair.first;
        const label j = pair.second;
        const vector r(spheres_[j] + pair.shift - spheres_[i]);
        const scalar contact = 0.5*(diameters_[i] + diameters_[j]);

        if (magSqr(r) < sqr(contact))
        {
            const scalar distance = max(mag(r), VSMALL);
            const vector force((contact/distance - 1)*r);
            sphereForces_[i] -= force;
            sphereForces_[j] += force;
        }
    }
}


void Foam::clumpRelaxation::addWallForces()
{
    const point& low = box_.bounds().min();
    const point& high = box_.bounds().max();

    for (direction d = 0; d < 3; ++d)
    {
        if (!box_.periodic(d))
        {
            forAll(spheres_, i)
            {
                const scalar radius = 0.5*diameters_[i];
                const scalar x = spheres_[i][d];
                sphereForces_[i][d] += max(low[d] + radius - x, scalar(0));
                sphereForces_[i][d] -= max(x - high[d] + radius, scalar(0));
            }
        }
    }
}


void Foam::clumpRelaxation::updateForces()
{
    const label n = centres_.size();

    sphereForces_ = Zero;
    addPairForces();
    addWallForces();

    forces_ = Zero;
    forAll(spheres_, i)
    {
        const label k = body_[i];
        const vector& force = sphereForces_[i];
        forces_[k] += force;
        forces_[n + k] +=
            ((spheres_[i] - centres_[k]) ^ force)/shape_.gyration();
    }
}


void Foam::clumpRelaxation::move(const vectorField& steps)
{
    const label n = centres_.size();

    forAll(centres_, k)
    {
        centres_[k] += steps[k];
        turn(orientations_[k], steps[n + k]/shape_.gyration());
    }
    spheres_ = shape_.placed(centres_, orientations_);
}


Foam::scalar Foam::clumpRelaxation::overlap() const
{
    return largestOverlap(box_, spheres_, target_, pairs_);
}


Foam::scalar Foam::clumpRelaxation::relax
(
    const scalar tolerance,
    const label maxSteps
)
{
    fireStep engine(longestStep);
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

            if (now <= tolerance || checksWithoutGain > 20)
            {
                break;
            }
        }
        updateForces();
        vectorField steps(forces_.size(), Zero);
        engine.advance(steps, velocities_, forces_);
        move(steps);
    }

    updatePairs();
    return overlap();
}


void Foam::clumpRelaxation::shake(const scalar amplitude, Random& random)
{
    forAll(centres_, k)
    {
        const vector kick(2*random.sample01<vector>() - vector::one);
        const vector angles(2*random.sample01<vector>() - vector::one);
        centres_[k] += amplitude*shape_.diameter()*kick;
        box_.clipToWalls(centres_[k], 0.5*shape_.diameter());
        turn(orientations_[k], 2*amplitude*angles);
    }
    updatePairs();
}
