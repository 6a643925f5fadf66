// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of grains with material points.

#include "grainPointContact.H"

#include "PstreamReduceOps.H"
#include "foamCompatibility.H"
#include "keywords.H"
#include "pointGrid.H"
#include "pointSet.H"

namespace
{
    using namespace Foam;

    //- Numbers of a grain: place, velocity, spin, radius and mass; and what acts
    //  on it: force, torque
    enum { PLACE = 0, VELOCITY = 3, SPIN = 6, RADIUS = 9, MASS = 10, ALL = 11 };
    enum { FORCE = 0, TORQUE = 3, GIVEN = 6 };

    vector at(const UList<scalar>& numbers, const label i)
    {
        return vector(numbers[i], numbers[i + 1], numbers[i + 2]);
    }

    void put(UList<scalar>& numbers, const label i, const vector& v)
    {
        for (direction d = 0; d < 3; ++d)
        {
            numbers[i + d] = v[d];
        }
    }

    //- The dictionary; its keywords are checked before any is read, since a
    //  misspelt one would be missed first, without the list of valid ones
    const dictionary& checked(const dictionary& dict)
    {
        keywords::check(dict, {"stiffness", "friction", "radius"});
        return dict;
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
    begin_(0)
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
    bounds_ = boundBox(points.x, true);

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
    const pointGrid& grid
) const
{
    bool result = true;
    for (label k = 0; k < grid.nDims(); ++k)
    {
        const direction d = grid.axes()[k];
        result =
            result
         && p[d] > bounds_.min()[d] - reach
         && p[d] < bounds_.max()[d] + reach;
    }
    return result;
}


void Foam::grainPointContact::collect
(
    const grainsInStep& grains,
    const pointGrid& grid
)
{
    List<scalarList> ofRanks(Pstream::nProcs());
    DynamicList<scalar> numbers;
    mine_.clear();

    forAll(grains.position, i)
    {
        if (isNear(grains.position[i], grains.radius[i] + radius_, grid))
        {
            mine_.append(i);
            numbers.setSize(ALL*mine_.size());
            SubList<scalar> last(numbers, ALL, numbers.size() - ALL);
            put(last, PLACE, grains.position[i]);
            put(last, VELOCITY, grains.velocity[i]);
            put(last, SPIN, grains.angularVelocity[i]);
            last[RADIUS] = grains.radius[i];
            last[MASS] = grains.mass[i];
        }
    }

    const label me = Pstream::myProcNo();
    ofRanks[me] = std::move(numbers);

    // In most steps of a run there may be none
    if (Pstream::parRun() && returnReduce(mine_.size(), sumOp<label>()))
    {
        Pstream::gatherList(ofRanks);
        compatibility::broadcast(ofRanks);
    }

    begin_ = 0;
    grains_.clear();
    forAll(ofRanks, rank)
    {
        begin_ += rank < me ? ofRanks[rank].size()/ALL : 0;
        grains_.append(ofRanks[rank]);
    }
}


void Foam::grainPointContact::check
(
    const label grain,
    const label i,
    const pointSet& points
) const
{
    const SubList<scalar> bead(grains_, ALL, ALL*grain);
    const scalar r = bead[RADIUS];
    const scalar mass = bead[MASS];

    if (r > opening_ && mass >= points.mass[i])
    {
        return;
    }

    const char* why =
        r > opening_
      ? "What is lighter than a point springs back from it, and the time step,"
        " made for points, may be too long for it."
      : "Grains so small slip between points as these lie at the start.";

    FatalErrorInFunction
        << "The grain of " << mass << " kg and radius " << r << " m at "
        << at(bead, PLACE) << " m touches the point " << points.id[i] << " of "
        << points.mass[i] << " kg." << nl
        << "    " << why << nl
        << "    Lower materialPoints/cellSize or raise pointsPerCell, so that"
        << " points are finer, or take coarser grains." << exit(FatalError);
}


void Foam::grainPointContact::push
(
    const label grain,
    const label i,
    const pointSet& points,
    const vector& from,
    UList<vector>& force,
    const scalar step
)
{
    check(grain, i, points);

    const SubList<scalar> bead(grains_, ALL, ALL*grain);
    SubList<scalar> given(given_, GIVEN, GIVEN*grain);
    const scalar r = bead[RADIUS];
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
        at(bead, VELOCITY) + (at(bead, SPIN)^arm) - points.U[i]
    );
    sliding -= (sliding & n)*n;

    // What a force at the surface meets: a sphere gives way by its spin as well
    const scalar mass = 1/(3.5/bead[MASS] + 1/points.mass[i]);
    const scalar speed = mag(sliding);
    const scalar tangential = min(friction_*normal, mass*speed/step);
    const vector friction(-tangential/max(speed, VSMALL)*sliding);
    const vector sum(normal*n + friction);

    put(given, FORCE, at(given, FORCE) + sum);
    put(given, TORQUE, at(given, TORQUE) + (arm^friction));
    force[i] -= sum;
}


void Foam::grainPointContact::touch
(
    const label grain,
    const pointGrid& grid,
    const pointSet& points,
    UList<vector>& force,
    const scalar step
)
{
    const point centre(at(grains_, ALL*grain + PLACE));
    const scalar reach = grains_[ALL*grain + RADIUS] + radius_;
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
                    vector from(Zero);
                    for (label k = 0; k < grid.nDims(); ++k)
                    {
                        const direction d = grid.axes()[k];
                        from[d] = centre[d] - points.x[i][d];
                    }
                    if (magSqr(from) < sqr(reach))
                    {
                        push(grain, i, points, from, force, step);
                    }
                }
            }
        }
    }
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
    collect(grains, grid);
    const label n = grains_.size()/ALL;
    given_.setSize(GIVEN*n);
    given_ = 0;

    for (label grain = 0; grain < n; ++grain)
    {
        touch(grain, grid, points, force, step);
    }

    if (n && Pstream::parRun())
    {
        Pstream::listCombineGather(given_, plusEqOp<scalar>());
        compatibility::broadcast(given_);
    }

    UList<vector> forces(grains.force);
    UList<vector> torques(grains.torque);
    forAll(mine_, i)
    {
        const label from = GIVEN*(begin_ + i);
        forces[mine_[i]] = at(given_, from + FORCE);
        torques[mine_[i]] = at(given_, from + TORQUE);
    }
}
