// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: bodies, their points, and what is between them.

#include "materialPointMethod.H"

#include "PstreamReduceOps.H"
#include "keywords.H"

#include <cstdint>

namespace
{
    using namespace Foam;

    //- A number from -1 to 1 that belongs to a seed, a point and an axis, the same on
    //  any machine and number of ranks (splitmix64)
    scalar randomOffset(const label seed, const label id, const label axis)
    {
        const std::uint64_t number = (std::uint64_t(seed) << 32) + std::uint64_t(id);
        std::uint64_t x = 0x9e3779b97f4a7c15u*(3*number + axis + 1);
        x = (x ^ (x >> 30))*0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27))*0x94d049bb133111ebu;
        x ^= x >> 31;
        return 2*scalar(x >> 11)/9007199254740992.0 - 1;
    }


    //- What a seed shifts points by at most, in their distances: little enough that none
    //  leaves a body
    constexpr scalar scatter = 0.1;


    label pointsPerCell(const dictionary& dict)
    {
        const label perCell = dict.getOrDefault<label>("pointsPerCell", 2);

        if (perCell < 1)
        {
            FatalIOErrorInFunction(dict)
                << "pointsPerCell is " << perCell << "; give the number of points"
                << " of a cell along each direction, 1 or more (usual: 2)."
                << exit(FatalIOError);
        }

        return perCell;
    }


    label seedOf(const dictionary& dict)
    {
        const label seed = dict.getOrDefault<label>("seed", 0);

        if (seed < 0)
        {
            FatalIOErrorInFunction(dict)
                << "seed is " << seed << "; give 0 for points in rows, or a number above"
                << " for each replicate." << exit(FatalIOError);
        }

        return seed;
    }


    //- The entries of a body without those that its law does not know
    dictionary lawEntries(const dictionary& body)
    {
        dictionary law(body);

        for (const char* key : {"region", "walls", "settling", "U"})
        {
            law.remove(key);
        }

        return law;
    }
}


void Foam::materialPointMethod::addBodies
(
    const dictionary& dict,
    const bool withPoints
)
{
    const dictionary& bodies = dict.subDict("bodies");
    const label perCell = pointsPerCell(dict);
    const label seed = seedOf(dict);

    PtrList<pointRegion> regions;
    for (const entry& body : bodies)
    {
        if (!body.isDict())
        {
            FatalIOErrorInFunction(bodies)
                << "Entry " << body.keyword() << " of bodies is no dictionary:"
                << " give one for each body, with its law, density, E, nu and"
                << " region." << exit(FatalIOError);
        }

        bodies_.append(body.keyword());
        laws_.append(constitutiveLaw::New(lawEntries(body.dict())).ptr());

        if (withPoints)
        {
            place(body.dict(), regions, perCell, seed);
        }
    }

    if (laws_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No body in bodies: give a dictionary with law, density, E, nu"
            << " and region for each." << exit(FatalIOError);
    }

    damping_.setSize(laws_.size(), 0);

    if (dict.found("contact"))
    {
        contact_.reset
        (
            new pointContact(keywords::sub(dict, "contact"), bodies_)
        );
    }
    sizeFields();
}


void Foam::materialPointMethod::sizeFields()
{
    const label n = contact_ ? contact_->nBodies() : 1;
    const nodeLanes none(grid_.nNodes(), lanes(lanes::Zero()));

    walls_.setBodies(n);
    nodes_.assign(n, none);
    if (flipShare_ > 0)
    {
        change_.assign(n, none);
    }
    sideWalls_.setSize(n, grid_.nNodes());
    if (averaging_)
    {
        cellVolume_.setSize(n*grid_.nNodes());
        cellDilation_.setSize(n*grid_.nNodes());
    }
    if (contact_)
    {
        inward_.assign(n, none);
        nearContact_.setSize(grid_.nNodes());
    }
}


void Foam::materialPointMethod::checkAlone
(
    const dictionary& dict,
    const point& p,
    const PtrList<pointRegion>& regions
) const
{
    const label last = regions.size() - 1;

    for (label body = 0; body < last; ++body)
    {
        if (regions[body].contains(p))
        {
            FatalIOErrorInFunction(dict)
                << "The regions of bodies " << bodies_[body] << " and "
                << bodies_[last] << " overlap: both have a point at " << p
                << " m, where the mass would be that of both." << nl
                << "    Let one region end where the other begins."
                << exit(FatalIOError);
        }
    }
}


Foam::label Foam::materialPointMethod::lastId() const
{
    label last = -1;
    forAll(points_.id, i)
    {
        last = max(last, points_.id[i]);
    }
    reduce(last, maxOp<label>());

    return last;
}


void Foam::materialPointMethod::addPoint
(
    const label id,
    const label body,
    const point& p,
    const vector& U,
    const scalar volume
)
{
    const label cell = pointGrid::cell(grid_.coordinate(p, 0));
    if (grid_.rankOf(cell) == Pstream::myProcNo())
    {
        const label last = points_.size();
        points_.resize(last + 1);
        points_.id[last] = id;
        points_.body[last] = body;
        points_.x[last] = p;
        points_.U[last] = U;
        points_.volume[last] = volume;
        points_.mass[last] = volume*laws_[body].density();
    }
}


void Foam::materialPointMethod::place
(
    const dictionary& dict,
    PtrList<pointRegion>& regions,
    const label perCell,
    const label seed
)
{
    const label body = regions.size();
    regions.append(new pointRegion(dict.subDict("region"), grid_));
    const vector U(dict.getOrDefault<vector>("U", Zero));
    const boundBox& box = grid_.box();
    const scalar spacing = grid_.h()/perCell;

    const scalar volume = grid_.cubeVolume(spacing);
    FixedList<label, 3> n(1);
    for (label k = 0; k < grid_.nDims(); ++k)
    {
        const scalar span = box.span()[grid_.axes()[k]];
        n[k] = label(std::ceil(span/spacing - 1e-6));
    }

    // All ranks count all points, so that numbers do not depend on their number
    const label before = lastId();
    label id = before;

    for (label i = 0; i < n[0]; ++i)
    {
        for (label j = 0; j < n[1]; ++j)
        {
            for (label k = 0; k < n[2]; ++k)
            {
                const FixedList<label, 3> at({i, j, k});
                point p(box.midpoint());

                for (label a = 0; a < grid_.nDims(); ++a)
                {
                    const direction d = grid_.axes()[a];
                    p[d] = box.min()[d] + (at[a] + 0.5)*spacing;
                }

                if (!regions[body].contains(p))
                {
                    continue;
                }
                checkAlone(dict, p, regions);
                ++id;
                for (label a = 0; seed && a < grid_.nDims(); ++a)
                {
                    p[grid_.axes()[a]] += scatter*spacing*randomOffset(seed, id, a);
                }
                addPoint(id, body, p, U, volume);
            }
        }
    }

    if (id == before)
    {
        FatalIOErrorInFunction(dict)
            << "The region of body " << bodies_[body] << " holds no point of the"
            << " grid in the mesh's box " << box << nl
            << "    Points are " << spacing << " m apart." << exit(FatalIOError);
    }
}


void Foam::materialPointMethod::addGate
(
    const point& onPlane,
    const vector& normal,
    const vector& direction,
    const scalar edge,
    const bool closed,
    const label side
)
{
    pointGate asGiven(grid_, onPlane, normal, direction);
    asGiven.move(edge);
    gateSide_ = side ? side : sideOf(asGiven, closed);
    gate_.reset(new pointGate(grid_, onPlane, gateSide_*normal, direction));
    gate_->move(edge);
}


Foam::label Foam::materialPointMethod::sideOf
(
    const pointGate& gate,
    const bool closed
) const
{
    // Mass on the side of the normal and on the other one, of points that nodes at the
    // gate would hold and of all
    FixedList<scalar, 2> near(scalar(0));
    FixedList<scalar, 2> all(scalar(0));
    label beyond = -1;

    forAll(points_.x, i)
    {
        const point& p = points_.x[i];
        const scalar distance = gate.distance(p);
        const label side = distance < 0;
        all[side] += points_.mass[i];

        if (gate.stands(p) && mag(distance) < pointGate::reach*grid_.h())
        {
            near[side] += points_.mass[i];
            beyond = side ? i : beyond;
        }
    }
    for (const label side : {0, 1})
    {
        reduce(near[side], sumOp<scalar>());
        reduce(all[side], sumOp<scalar>());
    }

    if (closed && near[0] > 0 && near[1] > 0)
    {
        stopForBothSides(gate, beyond);
    }

    const FixedList<scalar, 2>& mass = near[0] + near[1] > 0 ? near : all;
    return mass[1] > mass[0] ? -1 : 1;
}


void Foam::materialPointMethod::stopForBothSides
(
    const pointGate& gate,
    const label beyond
) const
{
    // The first of the ranks that have one
    const label rank = returnReduce
    (
        beyond >= 0 ? Pstream::myProcNo() : Pstream::nProcs(), minOp<label>()
    );
    const point at = returnReduce
    (
        rank == Pstream::myProcNo() ? points_.x[beyond] : point(Zero),
        sumOp<point>()
    );

    FatalErrorInFunction
        << "The gate at " << gate.onPlane() << " m has points on both sides, and it"
        << " holds those of one; beyond it some are at " << at << " m." << nl
        << "    Let the regions of the bodies end at the gate of"
        << " constant/slidingGate, or begin " << pointGate::reach
        << " cellSize = " << pointGate::reach*grid_.h() << " m beyond it; or put"
        << " the gate elsewhere."
        << exit(FatalError);
}
