// SPDX-License-Identifier: GPL-3.0-or-later
// Walls for material points: which nodes behind them mirror the flow.

#include "pointWalls.H"

Foam::labelList Foam::pointWalls::heldBy() const
{
    labelList result(grid_.nNodes(), -1);

    for (std::size_t i = 0; i < held_.size(); ++i)
    {
        label& by = result[held_[i].node];
        by = by == -1 ? label(i) : -2;
    }

    return result;
}


bool Foam::pointWalls::isCellBehind(const heldNode& held) const
{
    return
        mag(held.distance + grid_.h()) < nearly*grid_.h()
     && held.normal.abs().maxCoeff() > 1 - tolerance;
}


Foam::label Foam::pointWalls::along
(
    const heldNode& held,
    const label cells
) const
{
    FixedList<label, 3> at(grid_.numbers(held.node));
    bool isHere = true;

    for (label k = 0; k < grid_.nDims(); ++k)
    {
        at[k] += cells*label(std::round(held.normal[k + 1]));
        isHere =
            isHere
         && at[k] >= (k ? 0 : grid_.first()) - 1
         && at[k] <= (k ? grid_.nCells(k) : grid_.last());
    }

    return isHere ? grid_.node(at) : -1;
}


Foam::boolList Foam::pointWalls::reachedFromBehind
(
    const labelList& heldBy
) const
{
    // Points reach a node from that far
    const scalar reach = (1.5 - tolerance)*grid_.h();
    boolList result(grid_.nNodes(), false);

    for (const facet& f : facets_)
    {
        const lanes normal(normalOf(f));

        nodesIn(around(f), [&](const label node)
        {
            const label by = heldBy[node];

            if
            (
                by >= 0
             && isCellBehind(held_[by])
             && (held_[by].normal*normal).sum() < 1 - tolerance
            )
            {
                const point p(grid_.position(node));
                const vector way(p - nearest(f, p));
                result[node] =
                    result[node]
                 || (
                        mag(way) < reach
                     && (way & f.normal) < -tolerance*grid_.h()
                    );
            }
        });
    }

    return result;
}


void Foam::pointWalls::findMirrors()
{
    const labelList by(heldBy());
    const boolList contested(reachedFromBehind(by));

    for (heldNode& held : held_)
    {
        held.counted = grid_.owns(held.node);

        if (by[held.node] < 0 || !isCellBehind(held))
        {
            continue;
        }

        // Who has the cell at the wall has all three nodes, and the points that
        // reach the one behind
        const label at = along(held, 1);
        const label before = along(held, 2);
        held.counted = at >= 0 && grid_.owns(at);

        if
        (
            before >= 0
         && by[at] >= 0
         && mag(held_[by[at]].distance) < nearly*grid_.h()
         && (held_[by[at]].normal*held.normal).sum() > 1 - tolerance
         && by[before] == -1
         && !contested[held.node]
        )
        {
            held.mirror = before;
        }
    }
}


Foam::label Foam::pointWalls::mirrorOf(const label node) const
{
    for (const heldNode& held : held_)
    {
        if (held.node == node)
        {
            return held.mirror;
        }
    }

    return -1;
}
