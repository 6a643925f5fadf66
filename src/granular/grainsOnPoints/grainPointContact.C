// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of grains with material points.

#include "grainPointContact.H"

#include "PstreamReduceOps.H"
#include "foamCompatibility.H"
#include "keywords.H"
#include "pointGrid.H"
#include "pointSet.H"
#include "swapLists.H"

namespace
{
    using namespace Foam;

    //- The dictionary; its keywords are checked before any is read, since a
    //  misspelt one would be missed first, without the list of valid ones
    const dictionary& checked(const dictionary& dict)
    {
        keywords::check(dict, {"stiffness", "friction", "radius"});
        return dict;
    }

    //- A vector without what is across a slice
    vector solved(const vector& v, const pointGrid& grid)
    {
        vector result(Zero);
        for (label k = 0; k < grid.nDims(); ++k)
        {
            const direction d = grid.axes()[k];
            result[d] = v[d];
        }
        return result;
    }

    scalar positive(const dictionary& dict, const word& key, const scalar value)
    {
        if (!(value > 0))
        {
            FatalIOErrorInFunction(dict)
                << key << " of the contact of grains and points is " << value
                << "; it must be above zero." << exit(FatalIOError);
        }
        return value;
    }
}


Foam::grainPointContact::grainPointContact
(
    const dictionary& dict,
    const scalar distance,
    const label nDims
)
:
    stiffness_
    (
        positive(dict, "stiffness", checked(dict).get<scalar>("stiffness"))
    ),
    friction_(dict.getOrDefault<scalar>("friction", 0)),
    radius_
    (
        positive(dict, "radius", dict.getOrDefault("radius", 0.5*distance))
    ),
    // Midway between two points in a plane, amid four of a square in space
    opening_(0.5*distance*sqrt(scalar(nDims - 1)) - radius_),
    bounds_(Pstream::nProcs()),
    sent_(Pstream::nProcs())
{
    if (!(friction_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "friction of the contact of grains and points is " << friction_
            << "; it may not be below zero." << exit(FatalIOError);
    }
}


Foam::scalar Foam::grainPointContact::largestStep(const scalar mass) const
{
    // A quarter of what is stable
    return 0.5*sqrt(mass/stiffness_);
}


void Foam::grainPointContact::sort
(
    const pointGrid& grid,
    const pointSet& points
)
{
    first_.setSize(grid.nNodes());
    first_ = -1;
    next_.setSize(points.size());

    bounds_[Pstream::myProcNo()] = boundBox(points.x, false);
    Pstream::gatherList(bounds_);
    compatibility::broadcast(bounds_);

    allBounds_ = boundBox();
    for (const boundBox& bounds : bounds_)
    {
        allBounds_.add(bounds);
    }

    forAll(points.x, i)
    {
        FixedList<label, 3> cell(0);
        for (label k = 0; k < grid.nDims(); ++k)
        {
            cell[k] = pointGrid::cell(grid.coordinate(points.x[i], k));
        }
        label& first = first_[grid.node(cell)];
        next_[i] = first;
        first = i;
    }
}


bool Foam::grainPointContact::isNear
(
    const point& p,
    const scalar reach,
    const boundBox& bounds,
    const pointGrid& grid
) const
{
    bool result = true;
    for (label k = 0; k < grid.nDims(); ++k)
    {
        const direction d = grid.axes()[k];
        result =
            result
         && p[d] > bounds.min()[d] - reach
         && p[d] < bounds.max()[d] + reach;
    }
    return result;
}


Foam::label Foam::grainPointContact::find
(
    const grainsInStep& grains,
    const pointGrid& grid
)
{
    const auto near = [&](const label i, const boundBox& bounds)
    {
        const scalar reach = grains.radius[i] + radius_;
        return isNear(grains.position[i], reach, bounds, grid);
    };

    // Most grains may be far from all points
    DynamicList<label> candidates;
    forAll(grains.position, i)
    {
        if (near(i, allBounds_))
        {
            candidates.append(i);
        }
    }

    label n = 0;
    forAll(sent_, rank)
    {
        sent_[rank].clear();
        for (const label i : candidates)
        {
            if (near(i, bounds_[rank]))
            {
                sent_[rank].append(i);
            }
        }
        n += sent_[rank].size();
    }

    return n;
}


Foam::List<Foam::List<Foam::grainPointContact::bead>>
Foam::grainPointContact::collect(const grainsInStep& grains) const
{
    List<List<bead>> toRanks(sent_.size());

    forAll(sent_, rank)
    {
        toRanks[rank].setSize(sent_[rank].size());
        forAll(sent_[rank], j)
        {
            const label i = sent_[rank][j];
            toRanks[rank][j] = bead
            {
                grains.position[i],
                grains.velocity[i],
                grains.angularVelocity[i],
                grains.radius[i],
                grains.mass[i]
            };
        }
    }

    return swapLists(std::move(toRanks));
}


void Foam::grainPointContact::check
(
    const bead& grain,
    const label i,
    const pointSet& points
) const
{
    const scalar r = grain.radius;

    if (r > opening_ && grain.mass >= points.mass[i])
    {
        return;
    }

    const char* why =
        r > opening_
      ? "What is lighter than a point springs back from it, and the time step,"
        " made for points, may be too long for it."
      : "Grains so small slip between points as these lie at the start.";

    FatalErrorInFunction
        << "The grain of " << grain.mass << " kg and radius " << r << " m at "
        << grain.position << " m touches the point " << points.id[i] << " of "
        << points.mass[i] << " kg." << nl
        << "    " << why << nl
        << "    Lower materialPoints/cellSize or raise pointsPerCell, so that"
        << " points are finer, or take coarser grains." << exit(FatalError);
}


void Foam::grainPointContact::push
(
    const bead& grain,
    load& sum,
    const label i,
    const pointGrid& grid,
    const pointSet& points,
    const vector& from,
    UList<vector>& force,
    const scalar step
) const
{
    check(grain, i, points);

    const scalar r = grain.radius;
    const scalar distance = mag(from);

    if (distance < 0.5*r)
    {
        FatalErrorInFunction
            << "The point " << points.id[i] << " at " << points.x[i]
            << " m is deeper in a grain than half of its radius of " << r
            << " m." << nl
            << "    Let no grain overlap the points at the start; in a run,"
            << " take a larger stiffness in grainsOnPoints/contact, now "
            << stiffness_ << " N/m, or a smaller DEM step." << exit(FatalError);
    }

    const vector n(from/distance);
    const scalar normal = stiffness_*(r + radius_ - distance);
    const vector arm(-r*n);
    vector sliding
    (
        grain.velocity + (grain.spin^arm) - points.U[i]
    );
    sliding -= (sliding & n)*n;
    sliding = solved(sliding, grid);

    // What a force at the surface meets: a sphere gives way by its spin as well
    const scalar mass = 1/(3.5/grain.mass + 1/points.mass[i]);
    const scalar speed = mag(sliding);
    const scalar tangential = min(friction_*normal, mass*speed/step);
    const vector friction(-tangential/max(speed, VSMALL)*sliding);
    const vector contact(normal*n + friction);

    sum.force += contact;
    sum.torque += arm^friction;
    force[i] -= contact;
}


Foam::grainPointContact::load Foam::grainPointContact::touch
(
    const bead& grain,
    const pointGrid& grid,
    const pointSet& points,
    UList<vector>& force,
    const scalar step
) const
{
    const point& centre = grain.position;
    const scalar reach = grain.radius + radius_;
    load sum;
    const vector away(vector::uniform(reach));
    FixedList<label, 3> low(0), high(0);

    for (label k = 0; k < grid.nDims(); ++k)
    {
        // Points of this rank are in its cells alone
        const label begin = k ? 0 : grid.first();
        const label end = k ? grid.nCells(k) : grid.last();
        low[k] =
            max(begin, pointGrid::cell(grid.coordinate(centre - away, k)));
        high[k] =
            min(end - 1, pointGrid::cell(grid.coordinate(centre + away, k)));
    }

    FixedList<label, 3> cell(low);
    for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
    {
        for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        {
            for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
            {
                for
                (
                    label i = first_[grid.node(cell)];
                    i >= 0;
                    i = next_[i]
                )
                {
                    const vector from(solved(centre - points.x[i], grid));
                    if (magSqr(from) < sqr(reach))
                    {
                        push(grain, sum, i, grid, points, from, force, step);
                    }
                }
            }
        }
    }

    return sum;
}


void Foam::grainPointContact::act
(
    const grainsInStep& grains,
    const pointGrid& grid,
    const pointSet& points,
    UList<vector>& force,
    const scalar step
)
{
    // In most steps of a run there may be none
    if (!returnReduce(find(grains, grid), sumOp<label>()))
    {
        return;
    }

    const List<List<bead>> ofRanks(collect(grains));
    List<List<load>> loads(ofRanks.size());

    forAll(ofRanks, rank)
    {
        loads[rank].setSize(ofRanks[rank].size());
        forAll(ofRanks[rank], j)
        {
            loads[rank][j] =
                touch(ofRanks[rank][j], grid, points, force, step);
        }
    }

    const List<List<load>> fromRanks(swapLists(std::move(loads)));
    UList<vector> forces(grains.force);
    UList<vector> torques(grains.torque);

    forAll(sent_, rank)
    {
        forAll(sent_[rank], j)
        {
            forces[sent_[rank][j]] += fromRanks[rank][j].force;
            torques[sent_[rank][j]] += fromRanks[rank][j].torque;
        }
    }
}
