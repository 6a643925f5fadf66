// SPDX-License-Identifier: GPL-3.0-or-later
// Walls for material points: which nodes they hold.

#include "pointWalls.H"

#include "triPointRef.H"

Foam::point Foam::pointWalls::nearest(const facet& f, const point& p)
{
    point best(f.centre);

    forAll(f.corners, i)
    {
        const triPointRef triangle
        (
            f.corners[i], f.corners[f.corners.fcIndex(i)], f.centre
        );
        const point q(triangle.nearestPoint(p).rawPoint());

        if (magSqr(q - p) < magSqr(best - p))
        {
            best = q;
        }
    }

    return best;
}


Foam::boundBox Foam::pointWalls::around(const facet& f) const
{
    boundBox result(f.corners, false);
    const vector reach(vector::one*(pointGrid::margin + 1)*grid_.h());
    result.min() -= reach;
    result.max() += reach;
    return result;
}


bool Foam::pointWalls::holds
(
    const label i,
    const labelUList& meeting,
    const point& p,
    const point& q
) const
{
    const facet& f = facets_[i];
    const scalar none = tolerance*grid_.h();

    if (((p - q) & f.normal) > none)
    {
        return false;
    }

    // In front of a face that turns away from this one
    for (const label j : meeting)
    {
        const facet& other = facets_[j];

        if
        (
            ((p - q) & other.normal) > none
         && ((other.centre - q) & f.normal) < -none
        )
        {
            return false;
        }
    }

    return true;
}


Foam::lanes Foam::pointWalls::normalOf(const facet& f) const
{
    lanes normal(lanes::Zero());
    for (label k = 0; k < grid_.nDims(); ++k)
    {
        normal[k + 1] = f.normal[grid_.axes()[k]];
    }

    const scalar length = std::sqrt(normal.square().sum());
    return length < tolerance ? lanes(lanes::Zero()) : lanes(normal/length);
}


void Foam::pointWalls::hold
(
    const label node,
    const facet& f,
    const scalar distance,
    const std::size_t begin
)
{
    const lanes normal(normalOf(f));
    if (normal.square().sum() < tolerance)
    {
        return;
    }

    for (std::size_t i = begin; i < held_.size(); ++i)
    {
        if ((held_[i].normal*normal).sum() > 1 - tolerance)
        {
            return;
        }
    }

    held_.push_back({node, f.wall, normal, distance});
}


void Foam::pointWalls::findNodes()
{
    // A node lies in the plane of the middle where that is all there is
    scalarField distance(grid_.nNodes(), GREAT);
    pointField place(grid_.nNodes(), Zero);

    for (const facet& f : facets_)
    {
        nodesIn(around(f), [&](const label node)
        {
            const point p(grid_.position(node));
            const point q(nearest(f, p));

            if (mag(q - p) < distance[node])
            {
                distance[node] = mag(q - p);
                place[node] = q;
            }
        });
    }

    List<DynamicList<label>> meeting(grid_.nNodes());

    forAll(facets_, i)
    {
        nodesIn(around(facets_[i]), [&](const label node)
        {
            const point q(nearest(facets_[i], place[node]));

            if (mag(q - place[node]) < tolerance*grid_.h())
            {
                meeting[node].append(i);
            }
        });
    }

    held_.clear();
    isHeld_.clear();
    isHeld_.setSize(grid_.nNodes(), false);
    forAll(meeting, node)
    {
        const std::size_t begin = held_.size();
        const point p(grid_.position(node));

        for (const label i : meeting[node])
        {
            if (holds(i, meeting[node], p, place[node]))
            {
                const scalar distance = (p - place[node]) & facets_[i].normal;
                hold(node, facets_[i], distance, begin);
            }
        }

        isHeld_[node] = held_.size() > begin;
    }

    findMirrors();
    findBarriers(place);
    facets_.clear();
    resetImpulse();
}
