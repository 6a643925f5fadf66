// SPDX-License-Identifier: GPL-3.0-or-later
// A plane cut through spheres: discs that overlap.

#include "discUnion.H"

#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

using Foam::constant::mathematical::pi;

Foam::List<Foam::Pair<Foam::scalar>> Foam::gaussLegendre(const label n)
{
    List<Pair<scalar>> result(n);

    forAll(result, i)
    {
        // Newton's method from an estimate that is near enough
        scalar x = std::cos(pi*(i + 0.75)/(n + 0.5));
        scalar slope = 1;

        for (label iteration = 0; iteration < 10; ++iteration)
        {
            scalar last = 1, value = x;
            for (label k = 2; k <= n; ++k)
            {
                const scalar next = ((2*k - 1)*x*value - (k - 1)*last)/k;
                last = value;
                value = next;
            }
            slope = n*(x*value - last)/(x*x - 1);
            x -= value/slope;
        }
        result[i] = Pair<scalar>(x, 2/((1 - x*x)*slope*slope));
    }

    return result;
}


Foam::discUnion::discUnion
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const scalar z
)
:
    centres_(centres),
    radii_(radii.size())
{
    forAll(radii_, i)
    {
        radii_[i] = max(sqr(radii[i]) - sqr(z - centres[i].z()), scalar(0));
    }
    // In a loop of its own: above, GCC 12 takes the roots of negative numbers as well,
    // and leaves them out after OpenFOAM's trap has stopped the program
    Foam::sqrt(radii_, radii_);

    forAll(radii_, i)
    {
        if (radii_[i] > 0)
        {
            for (const Pair<scalar>& arc : freeArcs(i))
            {
                addArc(i, arc);
                rim += radii[i]*(arc.second() - arc.first());
            }
        }
    }
}


bool Foam::discUnion::covered
(
    const label i,
    DynamicList<Pair<scalar>>& arcs
) const
{
    const scalar r = radii_[i];

    forAll(radii_, j)
    {
        const scalar other = radii_[j];
        const scalar dx = centres_[j].x() - centres_[i].x();
        const scalar dy = centres_[j].y() - centres_[i].y();
        const scalar d = std::hypot(dx, dy);

        const bool holdsIt = d + r <= other;
        const bool isHeld = d + other <= r;

        // Of equal discs, which hold each other, the first counts
        if (j == i || other == 0 || d >= r + other || (isHeld && (!holdsIt || j > i)))
        {
            continue;
        }
        if (holdsIt)
        {
            return false;
        }

        const scalar cosine = (d*d + r*r - other*other)/(2*d*r);
        const scalar half = std::acos(min(max(cosine, -1.0), 1.0));
        const scalar begin = std::atan2(dy, dx) - half;
        const scalar from = begin < -pi ? begin + 2*pi : begin;
        const scalar to = from + 2*half;

        arcs.append(Pair<scalar>(from, min(to, pi)));
        if (to > pi)
        {
            arcs.append(Pair<scalar>(-pi, to - 2*pi));
        }
    }

    std::sort(arcs.begin(), arcs.end());
    return true;
}


Foam::DynamicList<Foam::Pair<Foam::scalar>>
Foam::discUnion::freeArcs(const label i) const
{
    DynamicList<Pair<scalar>> hidden;
    DynamicList<Pair<scalar>> result;

    if (!covered(i, hidden))
    {
        return result;
    }

    scalar from = -pi;
    for (const Pair<scalar>& arc : hidden)
    {
        if (arc.first() > from)
        {
            result.append(Pair<scalar>(from, arc.first()));
        }
        from = max(from, arc.second());
    }
    if (from < pi)
    {
        result.append(Pair<scalar>(from, pi));
    }

    return result;
}


void Foam::discUnion::addArc(const label i, const Pair<scalar>& arc)
{
    static const List<Pair<scalar>> nodes(gaussLegendre(16));

    // Of a quarter at most: the integrands go up to the fourth power of a sine
    const scalar length = arc.second() - arc.first();
    const label n = max(label(std::ceil(2*length/pi)), label(1));
    const scalar half = 0.5*length/n;

    for (label k = 0; k < n; ++k)
    {
        for (const Pair<scalar>& node : nodes)
        {
            const scalar angle =
                arc.first() + half*(2*k + 1 + node.first());
            const scalar c = radii_[i]*std::cos(angle);
            const scalar s = radii_[i]*std::sin(angle);
            const scalar u = centres_[i].x() + c;
            const scalar v = centres_[i].y() + s;
            const scalar dx = -s*half*node.second();
            const scalar dy = c*half*node.second();

            area += 0.5*(u*dy - v*dx);
            x += 0.5*sqr(u)*dy;
            y -= 0.5*sqr(v)*dx;
            xx += pow3(u)*dy/3;
            yy -= pow3(v)*dx/3;
            xy += 0.5*sqr(u)*v*dy;
        }
    }
}
