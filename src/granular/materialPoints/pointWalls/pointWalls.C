// SPDX-License-Identifier: GPL-3.0-or-later
// Walls for material points: nodes at and behind a wall may not move into it.

#include "pointWalls.H"

namespace
{
    using namespace Foam;

    //- Bring the velocity of a node closer to the one wanted by at most a loss
    void brake(lanes& node, const lanes& target, const scalar most)
    {
        const lanes way(target - node);
        const scalar speed =
            std::sqrt(sqr(way[1]) + sqr(way[2]) + sqr(way[3]));

        if (speed > 0)
        {
            node = target - (1 - min(most, speed)/speed)*way;
        }
    }
}


Foam::pointWalls::pointWalls(const pointGrid& grid)
:
    grid_(grid),
    friction_(1)
{}


void Foam::pointWalls::check(const word& wall, const scalar friction)
{
    if (!(friction >= 0))
    {
        FatalErrorInFunction
            << "The friction of wall " << wall << " is " << friction
            << "; it may not be below zero." << exit(FatalError);
    }
}


Foam::label Foam::pointWalls::add(const word& name, const scalar friction)
{
    check(name, friction);
    names_.append(name);
    isOutlet_.append(false);
    impulse_.append(Zero);
    for (scalarField& ofBody : friction_)
    {
        ofBody.append(friction);
    }

    return names_.size() - 1;
}


Foam::label Foam::pointWalls::addOutlet(const word& name)
{
    const label outlet = add(name, 0);
    isOutlet_[outlet] = true;
    return outlet;
}


void Foam::pointWalls::setBodies(const label n)
{
    const scalarField ofAll(friction_[0]);
    friction_ = List<scalarField>(n, ofAll);
    resetImpulse();
}


void Foam::pointWalls::setFriction(const List<scalarField>& ofBodies)
{
    for (const scalarField& friction : ofBodies)
    {
        forAll(friction, wall)
        {
            check(names_[wall], friction[wall]);
        }
    }

    friction_ = ofBodies;
    resetImpulse();
}


void Foam::pointWalls::addFace(const label wall, const pointField& corners)
{
    vector area(Zero);
    for (label i = 2; i < corners.size(); ++i)
    {
        area += (corners[i - 1] - corners[0])^(corners[i] - corners[0]);
    }

    if (mag(area) > VSMALL)
    {
        facets_.append
        (
            facet{wall, corners, average(corners), -area/mag(area)}
        );
    }
}


Foam::lanes Foam::pointWalls::frictionVelocity
(
    const nodeLanes& nodes,
    const heldNode& held
) const
{
    if (held.mirror < 0 || nodes[held.mirror][0] <= 0)
    {
        return lanes::Zero();
    }

    const lanes& before = nodes[held.mirror];
    return (before*held.normal).sum()*held.normal - before;
}


void Foam::pointWalls::apply
(
    nodeLanes& nodes,
    const label body,
    const bool counts
)
{
    const scalarField& friction = friction_[body];

    for (std::size_t i = 0; i < held_.size(); ++i)
    {
        const heldNode& held = held_[i];
        lanes& node = nodes[held.node];
        const lanes before(node);
        const scalar inwards = (node*held.normal).sum();

        if (before[0] <= 0 || inwards >= 0)
        {
            continue;
        }

        node -= inwards*held.normal;
        brake(node, frictionVelocity(nodes, held), -friction[held.wall]*inwards);
        node[0] = before[0];

        if (!counts)
        {
            continue;
        }

        nodeImpulse_[body][i] += before[0]*(node - before);
        if (held.counted)
        {
            vector& impulse = impulse_[held.wall];
            for (label k = 0; k < grid_.nDims(); ++k)
            {
                impulse[grid_.axes()[k]] +=
                    before[0]*(before[k + 1] - node[k + 1]);
            }
        }
    }
}


void Foam::pointWalls::resetImpulse()
{
    impulse_ = Zero;
    nodeImpulse_.assign
    (
        friction_.size(), nodeLanes(held_.size(), lanes(lanes::Zero()))
    );
}


std::vector<Foam::pointWalls::nodeImpulse> Foam::pointWalls::impulses
(
    const label wall,
    const label body
) const
{
    std::vector<nodeImpulse> result;

    for (std::size_t i = 0; i < held_.size(); ++i)
    {
        if (held_[i].wall == wall)
        {
            result.push_back({held_[i].node, nodeImpulse_[body][i]});
        }
    }

    return result;
}
