// SPDX-License-Identifier: GPL-3.0-or-later
// Frictional contact of bodies of material points, on the nodes of the grid.

#include "pointContact.H"

#include "keywords.H"

namespace
{
    using namespace Foam;

    //- Product of two vectors in lanes, without the first number
    scalar inner(const lanes& a, const lanes& b)
    {
        return (a*b).tail<3>().sum();
    }

    //- A coefficient of friction
    scalar readFriction
    (
        const dictionary& dict,
        const word& keyword,
        const scalar byDefault
    )
    {
        const scalar friction = dict.getOrDefault<scalar>(keyword, byDefault);

        if (!(friction >= 0))
        {
            FatalIOErrorInFunction(dict)
                << "The friction of the contact of bodies, " << keyword
                << ", is " << friction << "; it may not be below zero."
                << exit(FatalIOError);
        }
        return friction;
    }
}


Foam::pointContact::pointContact
(
    const dictionary& dict,
    const wordList& bodies
)
:
    friction_(bodies.size(), scalarField(bodies.size(), Zero))
{
    keywords::check(dict, {"friction", "frictions"});

    if (bodies.size() < 2)
    {
        FatalIOErrorInFunction(dict)
            << "contact is that of two or more bodies, but there is only "
            << bodies[0] << '.' << nl
            << "    Remove contact, or add the other body to bodies."
            << exit(FatalIOError);
    }

    const scalar all = readFriction(dict, "friction", 0);
    for (scalarField& friction : friction_)
    {
        friction = all;
    }

    const dictionary pairs(keywords::sub(dict, "frictions", bodies));
    forAll(bodies, a)
    {
        const dictionary with(keywords::sub(pairs, bodies[a], bodies));

        forAll(bodies, b)
        {
            if (!with.found(bodies[b]))
            {
                continue;
            }

            const bool twice =
                b < a && keywords::sub(pairs, bodies[b]).found(bodies[a]);

            if (a == b || twice)
            {
                FatalIOErrorInFunction(pairs)
                    << "The friction of " << bodies[a] << " with " << bodies[b]
                    << " is given "
                    << (twice ? "twice." : "but is one body.") << nl
                    << "    Give it for two bodies, once for each pair."
                    << exit(FatalIOError);
            }

            friction_[a][b] = readFriction(with, bodies[b], all);
            friction_[b][a] = friction_[a][b];
        }
    }
}


Foam::scalar Foam::pointContact::flatness
(
    const lanes& inward,
    const scalar cell
)
{
    // The moment of a half-space that has the share s of a cell is close to
    // 0.65 (s(1 - s))^0.84 in cells and spacings; of points in rows up to 5 %
    // more. Beyond that they are clumps
    constexpr scalar most = 1.2;
    const scalar share = min(max(inward[0]/cell, 0.01), 0.99);
    const scalar ratio =
        inner(inward, inward)
       /sqr(0.65*std::pow(share*(1 - share), 0.84)*cell);

    return ratio < most ? ratio : sqr(most)/ratio;
}


void Foam::pointContact::touch
(
    lanes& a,
    lanes& b,
    const lanes& normal,
    const scalar friction
)
{
    const lanes difference(a - b);
    const scalar square = inner(normal, normal);
    const scalar approach = inner(difference, normal);

    if (approach <= 0 || square <= 0)
    {
        return;
    }

    const lanes along((approach/square)*normal);
    const lanes sliding(difference - along);
    const scalar speed = std::sqrt(inner(sliding, sliding));
    const scalar braked =
        speed > 0 ? min(friction*approach/(std::sqrt(square)*speed), 1.0) : 0;

    // Equal and opposite: the mass of both over that of one
    lanes change(along + braked*sliding);
    change[0] = 0;
    const scalar mass = a[0] + b[0];
    const scalar shareOfA = a[0]/mass;
    const scalar shareOfB = b[0]/mass;
    a -= shareOfB*change;
    b += shareOfA*change;
}


void Foam::pointContact::apply
(
    std::vector<nodeLanes>& velocity,
    const std::vector<nodeLanes>& inward,
    const scalar cell,
    const labelUList& nodes
) const
{
    for (const label node : nodes)
    {
        scalar filled = 0;
        for (const nodeLanes& volume : inward)
        {
            filled += volume[node][0];
        }
        if (filled < leastFilled*cell)
        {
            continue;
        }

        for (label a = 0; a < nBodies(); ++a)
        {
            for (label b = a + 1; b < nBodies(); ++b)
            {
                const lanes& ofA = inward[a][node];
                const lanes& ofB = inward[b][node];

                if (min(ofA[0], ofB[0]) >= leastShare*cell)
                {
                    touch
                    (
                        velocity[a][node],
                        velocity[b][node],
                        flatness(ofA, cell) > flatness(ofB, cell)
                      ? lanes(-ofA) : ofB,
                        friction_[a][b]
                    );
                }
            }
        }
    }
}
