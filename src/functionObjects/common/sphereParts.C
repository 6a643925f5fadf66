// SPDX-License-Identifier: GPL-3.0-or-later
// Shares of a sphere's volume that lie within other bodies.

#include "sphereParts.H"

#include "mathematicalConstants.H"

Foam::scalar Foam::sphereParts::below(const scalar t)
{
    const scalar s = max(min(t, scalar(1)), scalar(-1));

    return (2 + 3*s - s*s*s)/4;
}


Foam::scalar Foam::sphereParts::inBox
(
    const point& centre,
    const scalar r,
    const boundBox& box
)
{
    scalar share = 1;

    for (direction k = 0; k < 3; ++k)
    {
        share *=
            below((box.max()[k] - centre[k])/r)
          - below((box.min()[k] - centre[k])/r);
    }

    return share;
}


Foam::scalar Foam::sphereParts::inSphere
(
    const point& centre,
    const scalar r,
    const point& other,
    const scalar R
)
{
    const scalar s = mag(centre - other);

    if (s >= R + r)
    {
        return 0;
    }

    if (s <= mag(R - r))
    {
        return r <= R ? 1 : pow3(R/r);
    }

    // Two caps, one of either sphere
    return
        sqr(R + r - s)*(sqr(s) + 2*s*(R + r) - 3*sqr(R - r))
       /(16*s*pow3(r));
}


Foam::scalar Foam::sphereParts::inDisc
(
    const scalar s,
    const scalar r,
    const scalar R
)
{
    if (s >= R + r)
    {
        return 0;
    }

    if (s <= mag(R - r))
    {
        return r <= R ? 1 : sqr(R/r);
    }

    // Two segments, one of either disc, beyond the common chord at t
    const scalar t = (sqr(s) + sqr(r) - sqr(R))/(2*s);
    const auto segment = [](const scalar radius, const scalar at)
    {
        const scalar c = max(min(at/radius, scalar(1)), scalar(-1));
        return sqr(radius)*(std::acos(c) - c*std::sqrt(1 - sqr(c)));
    };

    return
        (segment(r, t) + segment(R, s - t))
       /(constant::mathematical::pi*sqr(r));
}
