// SPDX-License-Identifier: GPL-3.0-or-later
// A gate that holds material points back until it is drawn.

#include "pointGate.H"

namespace
{
    //- A length that is none, in spacings
    constexpr Foam::scalar tolerance = 1e-6;
}


Foam::pointGate::pointGate
(
    const pointGrid& grid,
    const point& onPlane,
    const vector& normal,
    const vector& direction
)
:
    grid_(grid),
    onPlane_(onPlane),
    normal_(normal),
    direction_(direction),
    edge_(-GREAT),
    normalLanes_(lanes::Zero())
{
    for (label k = 0; k < grid_.nDims(); ++k)
    {
        normalLanes_[k + 1] = normal_[grid_.axes()[k]];
    }
    findNodes();
}


void Foam::pointGate::findNodes()
{
    for (label node = 0; node < grid_.nNodes(); ++node)
    {
        const point p(grid_.position(node));
        const scalar behind = -distance(p)/grid_.h();

        if (behind > -tolerance && behind < reach - tolerance)
        {
            held_.push_back({node, p & direction_});
        }
    }
}


void Foam::pointGate::apply(nodeLanes& nodes) const
{
    for (const heldNode& held : held_)
    {
        lanes& node = nodes[held.node];
        const scalar inwards = (node*normalLanes_).sum();

        if (held.height >= edge_ - tolerance*grid_.h() && node[0] > 0 && inwards < 0)
        {
            node -= inwards*normalLanes_;
        }
    }
}


void Foam::pointGate::putBack(point& p, const point& from) const
{
    const scalar now = distance(p);
    const bool passed = now < 0 && distance(from) >= -tolerance*grid_.h();

    if (passed && stands(p))
    {
        p -= now*normal_;
    }
}
