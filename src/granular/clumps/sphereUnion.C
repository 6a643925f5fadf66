// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, centre, moments and surface of spheres that overlap.

#include "sphereUnion.H"

#include "discUnion.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

using Foam::constant::mathematical::pi;

namespace
{

using namespace Foam;

//- Points between two heights: to round-off for a square root at both ends
constexpr label nPoints = 40;


//- The spheres that none of the others holds
labelList outermost(const UList<point>& centres, const UList<scalar>& radii)
{
    DynamicList<label> result;

    forAll(centres, i)
    {
        bool within = false;
        forAll(centres, j)
        {
            const scalar depth =
                radii[j] - radii[i] - mag(centres[j] - centres[i]);
            within = within || (j != i && (depth > 0 || (depth == 0 && j < i)));
        }
        if (!within)
        {
            result.append(i);
        }
    }

    return labelList(std::move(result));
}


//- Heights where arcs of the cuts begin or end
class heights
{
    const UList<point>& centres_;
    const UList<scalar>& radii_;
    const scalar tolerance_;
    DynamicList<scalar> z_;

    //- Take the height of a point that no sphere holds
    void take(const point& p)
    {
        forAll(centres_, i)
        {
            if (mag(p - centres_[i]) < radii_[i] - tolerance_)
            {
                return;
            }
        }
        z_.append(p.z());
    }

    //- Where the circle in which two spheres cut each other is highest and lowest,
    //  and where others cut it
    void takeCircle(const label i, const label j)
    {
        const vector between(centres_[j] - centres_[i]);
        const scalar d = mag(between);

        if (d >= radii_[i] + radii_[j] || d <= mag(radii_[i] - radii_[j]))
        {
            return;
        }

        const vector n(between/d);
        const scalar along =
            0.5*(d + (sqr(radii_[i]) - sqr(radii_[j]))/d);
        const point middle(centres_[i] + along*n);
        const scalar r = std::sqrt(max(sqr(radii_[i]) - sqr(along), scalar(0)));
        const vector up(vector(0, 0, 1) - n.z()*n);

        if (mag(up) > 1e-12)
        {
            take(middle + r/mag(up)*up);
            take(middle - r/mag(up)*up);
        }
        else
        {
            // Level: its middle is in both
            z_.append(middle.z());
        }

        for (label k = j + 1; k < centres_.size(); ++k)
        {
            takeCorners(middle, n, r, k);
        }
    }

    //- Where sphere k cuts a circle across n
    void takeCorners
    (
        const point& middle,
        const vector& n,
        const scalar r,
        const label k
    )
    {
        const vector to(centres_[k] - middle);
        const vector across(to - (to & n)*n);
        const scalar a = mag(across);
        if (a <= tolerance_)
        {
            return;
        }

        const scalar distance =
            (magSqr(to) + sqr(r) - sqr(radii_[k]))/(2*a);
        if (mag(distance) <= r)
        {
            const vector e(across/a);
            const vector side(std::sqrt(sqr(r) - sqr(distance))*(n ^ e));
            take(middle + distance*e + side);
            take(middle + distance*e - side);
        }
    }

public:

    heights(const UList<point>& centres, const UList<scalar>& radii)
    :
        centres_(centres),
        radii_(radii),
        tolerance_(1e-12*max(radii))
    {
        forAll(centres, i)
        {
            // A sphere is cut from its base to its top, covered or not
            z_.append(centres[i].z() - radii[i]);
            z_.append(centres[i].z() + radii[i]);

            for (label j = i + 1; j < centres.size(); ++j)
            {
                takeCircle(i, j);
            }
        }
        std::sort(z_.begin(), z_.end());
    }

    const UList<scalar>& operator()() const
    {
        return z_;
    }
};

} // End anonymous namespace


Foam::sphereUnion::sphereUnion
(
    const UList<point>& centres,
    const UList<scalar>& radii
)
:
    volume_(0),
    centre_(Zero),
    spread_(Zero),
    surface_(0)
{
    const labelList outer(outermost(centres, radii));
    const scalarField r(radii, outer);
    // From about the middle: far from it round-off would count
    const point origin(sum(pow3(r)*pointField(centres, outer))/sum(pow3(r)));
    const pointField places(pointField(centres, outer) - origin);
    const heights cuts(places, r);
    const List<Pair<scalar>> nodes(gaussLegendre(nPoints));

    for (label k = 1; k < cuts().size(); ++k)
    {
        const scalar half = 0.5*(cuts()[k] - cuts()[k - 1]);
        const scalar middle = 0.5*(cuts()[k] + cuts()[k - 1]);

        if (half < 1e-14*max(r))
        {
            continue;
        }

        for (const Pair<scalar>& node : nodes)
        {
            const scalar angle = 0.5*pi*node.first();
            const scalar z = middle + half*std::sin(angle);
            const scalar dz = 0.5*pi*half*std::cos(angle)*node.second();
            const discUnion cut(places, r, z);

            volume_ += dz*cut.area;
            surface_ += dz*cut.rim;
            centre_ += dz*vector(cut.x, cut.y, z*cut.area);
            spread_ += dz*symmTensor
            (
                cut.xx, cut.xy, z*cut.x, cut.yy, z*cut.y, sqr(z)*cut.area
            );
        }
    }

    centre_ /= volume_;
    spread_ -= volume_*sqr(centre_);
    centre_ += origin;
}


Foam::scalar Foam::sphereUnion::equivalentRadius() const
{
    return cbrt(3*volume_/(4*pi));
}


Foam::scalar Foam::sphereUnion::sphericity() const
{
    return 4*pi*sqr(equivalentRadius())/surface_;
}
