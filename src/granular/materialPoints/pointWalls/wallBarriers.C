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


bool Foam::pointWalls::parallel(const plane& a, const plane& b)
{
    return (a.normal*b.normal).sum() > 1 - tolerance;
}


Foam::pointWalls::plane Foam::pointWalls::planeOf
(
    const facet& f,
    const point& p
) const
{
    return {normalOf(f), (p - f.centre) & f.normal};
}


Foam::DynamicList<Foam::label> Foam::pointWalls::beyondEdges
(
    const facet& f,
    const labelUList& others
) const
{
    DynamicList<label> result;

    for (const label i : others)
    {
        const facet& other = facets_[i];

        for (const point& corner : other.corners)
        {
            const vector way(other.centre - corner);

            if
            (
                (way & f.normal) < -tolerance*mag(way)
             && mag(nearest(f, corner) - corner) < tolerance*grid_.h()
            )
            {
                result.append(i);
                break;
            }
        }
    }

    return result;
}


bool Foam::pointWalls::facesAll
(
    const facet& f,
    const UList<barrier>& walls,
    const label n,
    const label node,
    const point& place
) const
{
    if (((place - f.centre) & f.normal) < -tolerance*grid_.h())
    {
        return false;
    }

    for (label i = 0; i < n; ++i)
    {
        if (depth(walls[i], f.centre, grid_.position(node)) >= 0)
        {
            return false;
        }
    }

    return true;
}


void Foam::pointWalls::addBarrier
(
    DynamicList<barrier>& ofNode,
    const label node,
    const facet& f,
    const labelUList& edges
) const
{
    const point p(grid_.position(node));
    const plane face(planeOf(f, p));

    // Whether a point of the cell gets behind its plane in a step
    const scalar reach = (0.5*face.normal.abs().sum() + 0.5 - tolerance)*grid_.h();
    const bool passes =
        face.distance > (edges.empty() && !isHeld_[node] ? 0 : -reach);

    for (barrier& wall : ofNode)
    {
        if (parallel(wall, face))
        {
            addEdges(wall, p, edges);
            return;
        }
    }

    if (face.normal.square().sum() > tolerance && passes && face.distance < reach)
    {
        ofNode.append(barrier{face, {}, false});
        addEdges(ofNode.last(), p, edges);
    }
}


void Foam::pointWalls::addEdges
(
    barrier& wall,
    const point& p,
    const labelUList& edges
) const
{
    for (const label i : edges)
    {
        const plane side(planeOf(facets_[i], p));

        // Neither what lies in the plane of a slice nor what goes straight on
        bool isNew =
            side.normal.square().sum() > tolerance && !parallel(side, wall);

        for (const plane& other : wall.beyond)
        {
            isNew =
                isNew
             && !(
                    parallel(side, other)
                 && mag(side.distance - other.distance) < tolerance*grid_.h()
                );
        }
        if (isNew)
        {
            wall.beyond.push_back(side);
        }
    }
}


bool Foam::pointWalls::isOfOutlet
(
    const barrier& wall,
    const label node,
    const labelUList& around
) const
{
    for (const label i : around)
    {
        const plane face(planeOf(facets_[i], grid_.position(node)));

        if
        (
            isOutlet_[facets_[i].wall]
         && parallel(wall, face)
         && mag(wall.distance - face.distance) < nearly*grid_.h()
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::pointWalls::findBarriers(const pointField& place)
{
    const List<DynamicList<label>> around(facetsAround());
    List<DynamicList<barrier>> ofNodes(grid_.nNodes());

    for (const heldNode& held : held_)
    {
        ofNodes[held.node].append(barrier{{held.normal, held.distance}, {}, false});
    }

    barriers_.clear();
    barriersFrom_.clear();
    barriersFrom_.setSize(grid_.nNodes() + 1, 0);

    forAll(ofNodes, node)
    {
        const label nHeld = ofNodes[node].size();

        for (const label i : around[node])
        {
            const DynamicList<label> edges
            (
                beyondEdges(facets_[i], around[node])
            );
            if
            (
                !isHeld_[node]
             || edges.size()
             || facesAll(facets_[i], ofNodes[node], nHeld, node, place[node])
            )
            {
                addBarrier(ofNodes[node], node, facets_[i], edges);
            }
        }
        for (const barrier& wall : ofNodes[node])
        {
            barriers_.push_back(wall);
            barriers_.back().isOutlet = isOfOutlet(wall, node, around[node]);
        }
        barriersFrom_[node + 1] = barriers_.size();
    }
}


Foam::scalar Foam::pointWalls::depth
(
    const plane& side,
    const point& p,
    const point& node
) const
{
    scalar height = side.distance;
    for (label k = 0; k < 3 && k < grid_.nDims(); ++k)
    {
        const direction d = grid_.axes()[k];
        height += side.normal[k + 1]*(p[d] - node[d]);
    }

    return tolerance*grid_.h() - height;
}


Foam::scalar Foam::pointWalls::depthBeyond
(
    const barrier& wall,
    const point& p,
    const point& node
) const
{
    scalar least = GREAT;
    for (const plane& side : wall.beyond)
    {
        least = min(least, depth(side, p, node));
    }
    return least;
}


bool Foam::pointWalls::isBehindOutlet(const point& p, const label cell) const
{
    const point node(grid_.position(cell));

    for (label i = barriersFrom_[cell]; i < barriersFrom_[cell + 1]; ++i)
    {
        const barrier& wall = barriers_[i];
        const scalar behind = depth(wall, p, node);

        if
        (
            wall.isOutlet
         && behind > 100*tolerance*grid_.h()
         && behind <= depthBeyond(wall, p, node)
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::pointWalls::putBackBehind(point& p, const label cell) const
{
    const point node(grid_.position(cell));

    // In a fold of less than a right angle the way out of one face leads behind
    // the other, by less each time
    const label most = 100;
    bool moved = true;

    for (label times = 0; moved && times < most; ++times)
    {
        moved = false;

        for (label i = barriersFrom_[cell]; i < barriersFrom_[cell + 1]; ++i)
        {
            moved = putBackBehind(barriers_[i], node, p) || moved;
        }
    }
}


bool Foam::pointWalls::putBackBehind
(
    const barrier& wall,
    const point& node,
    point& p
) const
{
    const scalar behind = depth(wall, p, node);

    // At an edge that stands out, by the shorter way
    if (behind <= 0 || behind > depthBeyond(wall, p, node))
    {
        return false;
    }

    for (label k = 0; k < 3 && k < grid_.nDims(); ++k)
    {
        p[grid_.axes()[k]] += behind*wall.normal[k + 1];
    }

    // Not for a rounding
    return behind > tolerance*grid_.h();
}
