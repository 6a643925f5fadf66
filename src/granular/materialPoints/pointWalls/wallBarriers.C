// SPDX-License-Identifier: GPL-3.0-or-later
// Walls for material points: which planes points of a cell may not pass.

#include "pointWalls.H"

Foam::List<Foam::DynamicList<Foam::label>>
Foam::pointWalls::facetsAround() const
{
    List<DynamicList<label>> result(grid_.nNodes());

    forAll(facets_, i)
    {
        nodesIn(around(facets_[i]), [&](const label node)
        {
            const point p(grid_.position(node));

            if (cmptMax(cmptMag(nearest(facets_[i], p) - p)) < grid_.h())
            {
                result[node].append(i);
            }
        });
    }

    return result;
}


Foam::label Foam::pointWalls::beyondEdge
(
    const facet& f,
    const labelUList& others
) const
{
    for (const label i : others)
    {
        const facet& other = facets_[i];

        for (const point& corner : other.corners)
        {
            const vector way(other.centre - corner);

            if
            (
                (way & f.normal) < -0.3*mag(way)
             && mag(nearest(f, corner) - corner) < little*grid_.h()
            )
            {
                return i;
            }
        }
    }

    return -1;
}


void Foam::pointWalls::addBarrier
(
    DynamicList<barrier>& ofNode,
    const label node,
    const facet& f,
    const labelUList& others
) const
{
    const point p(grid_.position(node));
    const lanes normal(normalOf(f));
    const scalar distance = (p - f.centre) & f.normal;
    const label beyond = beyondEdge(f, others);

    // Whether a point of the cell gets behind its plane in a step
    const scalar reach = (0.5*normal.abs().sum() + 0.5 - little)*grid_.h();
    const bool passes = beyond < 0 ? distance > 0 : distance > -reach;

    for (barrier& wall : ofNode)
    {
        if ((wall.normal*normal).sum() > 1 - little)
        {
            if (beyond >= 0)
            {
                setEdge(wall, p, facets_[beyond]);
            }
            return;
        }
    }

    if (normal.square().sum() > little && passes && distance < reach)
    {
        ofNode.append({normal, distance, false, normal, 0});
        if (beyond >= 0)
        {
            setEdge(ofNode.last(), p, facets_[beyond]);
        }
    }
}


void Foam::pointWalls::setEdge
(
    barrier& wall,
    const point& p,
    const facet& beyond
) const
{
    wall.hasEdge = true;
    wall.beyond = normalOf(beyond);
    wall.beyondDistance = (p - beyond.centre) & beyond.normal;
}


void Foam::pointWalls::findBarriers()
{
    const List<DynamicList<label>> around(facetsAround());
    List<DynamicList<barrier>> ofNodes(grid_.nNodes());

    for (const heldNode& held : held_)
    {
        ofNodes[held.node].append
        (
            {held.normal, held.distance, false, held.normal, 0}
        );
    }

    barriers_.clear();
    barriersFrom_.clear();
    barriersFrom_.setSize(grid_.nNodes() + 1, 0);

    forAll(ofNodes, node)
    {
        for (const label i : around[node])
        {
            const bool held = isHeld_[node];
            if (!held || beyondEdge(facets_[i], around[node]) >= 0)
            {
                addBarrier(ofNodes[node], node, facets_[i], around[node]);
            }
        }
        for (const barrier& wall : ofNodes[node])
        {
            barriers_.push_back(wall);
        }
        barriersFrom_[node + 1] = barriers_.size();
    }
}


Foam::scalar Foam::pointWalls::depth
(
    const point& p,
    const point& node,
    const lanes& normal,
    const scalar distance
) const
{
    scalar height = distance;
    for (label k = 0; k < 3 && k < grid_.nDims(); ++k)
    {
        const direction d = grid_.axes()[k];
        height += normal[k + 1]*(p[d] - node[d]);
    }

    return little*grid_.h() - height;
}


void Foam::pointWalls::putBackBehind(point& p, const label cell) const
{
    const point node(grid_.position(cell));

    for (label i = barriersFrom_[cell]; i < barriersFrom_[cell + 1]; ++i)
    {
        const barrier& wall = barriers_[i];
        const scalar most = wall.hasEdge
          ? depth(p, node, wall.beyond, wall.beyondDistance)
          : GREAT;
        const scalar behind =
            max(depth(p, node, wall.normal, wall.distance), scalar(0));

        // At an edge that stands out, by the shorter way
        if (behind <= most)
        {
            for (label k = 0; k < 3 && k < grid_.nDims(); ++k)
            {
                p[grid_.axes()[k]] += behind*wall.normal[k + 1];
            }
        }
    }
}
