// SPDX-License-Identifier: GPL-3.0-or-later
// What a flat convex face cuts off a sphere, and the solid angle it fills.

#include "flatFace.H"

#include "mathematicalConstants.H"

using Foam::constant::mathematical::twoPi;

namespace
{
    using namespace Foam;

    //- An edge as seen from the origin, along the direction of the face
    struct edgeView
    {
        //- Unit vector along the edge
        vector along;

        //- The point of its line next to the origin [m]
        vector foot;

        //- Places of the ends on the line, from the foot [m]
        scalar from;
        scalar to;
    };


    //- The same foot from both faces of the edge, to the last bit: near an
    //  edge the two must agree on which side the origin lies
    edgeView view(const point& a, const point& b)
    {
        const bool turned =
            a.x() > b.x()
         || (
                a.x() == b.x()
             && (a.y() > b.y() || (a.y() == b.y() && a.z() > b.z()))
            );
        const point& low = turned ? b : a;
        const point& high = turned ? a : b;

        vector along(high - low);
        along /= mag(along) + VSMALL;

        const scalar from = low & along;
        const scalar to = high & along;
        const vector foot(low - from*along);

        if (turned)
        {
            return edgeView{-along, foot, -to, -from};
        }
        return edgeView{along, foot, from, to};
    }


    //- Integral of 1 - h/l over the angle around the normal, from the foot to
    //  the place t on the edge; d is the edge's distance from the normal, h the
    //  height above the plane and l the distance of the place [m]
    scalar angle
    (
        const scalar d,
        const scalar h,
        const scalar l,
        const scalar t
    )
    {
        const scalar r2 = d*d + t*t;
        return std::atan2(t*d*r2/(l + h + VSMALL), d*d*l + h*t*t);
    }


    //- Angle from a to b anticlockwise about the normal, 0 to 2 pi
    scalar turn(const vector& a, const vector& b, const vector& normal)
    {
        const scalar result = std::atan2((a ^ b) & normal, a & b);
        return result < -1e-9 ? result + twoPi : max(result, scalar(0));
    }


    //- Arcs of a circle that lie in a face, put together while its edges are
    //  followed
    class arcsInside
    {
        const vector& normal_;

        //- The first entry, and the last exit with its edge: distance of that
        //  from the middle, and half its length in the circle
        vector entry_ = vector::zero;
        vector exit_ = vector::zero;
        label firstEdge_ = -1;
        label exitEdge_ = -1;
        scalar distance_ = 0;
        scalar half_ = 0;

        scalar sum_ = 0;

        scalar between
        (
            const label edge,
            const vector& entry,
            const label nEdges
        ) const
        {
            if (edge == exitEdge_)
            {
                return twoPi - 2*std::atan2(half_, distance_);
            }

            const scalar angle = turn(exit_, entry, normal_);

            // Around one corner it is less than half the circle
            return
                (exitEdge_ + 1) % nEdges == edge && angle > twoPi/2
              ? 0
              : angle;
        }

    public:

        arcsInside(const vector& normal)
        :
            normal_(normal)
        {}

        void enter(const label edge, const vector& at, const label nEdges)
        {
            if (exitEdge_ < 0)
            {
                firstEdge_ = edge;
                entry_ = at;
            }
            else
            {
                sum_ += between(edge, at, nEdges);
            }
        }

        void leave
        (
            const label edge,
            const scalar distance,
            const scalar half,
            const vector& at
        )
        {
            exit_ = at;
            exitEdge_ = edge;
            distance_ = distance;
            half_ = half;
        }

        //- Sum of the angles
        scalar close(const label nEdges) const
        {
            return
                exitEdge_ < 0 || firstEdge_ < 0
              ? sum_
              : sum_ + between(firstEdge_, entry_, nEdges);
        }
    };


    //- What the edges of a face add up to for a sphere: their part of the solid angle
    //  times r, of the cones below the face [m3], and the arcs between them
    struct edgeSums
    {
        arcsInside arcs;
        scalar angles = 0;
        scalar cones = 0;
        bool met = false;

        explicit edgeSums(const vector& normal)
        :
            arcs(normal)
        {}

        //- Add edge i of n from a to b, whose line meets the sphere. The face is at
        //  height h above the origin, on the side of sign
        void add
        (
            const point& a,
            const point& b,
            const label i,
            const label n,
            const vector& normal,
            const scalar sign,
            const scalar h,
            const scalar radius
        )
        {
            const edgeView e(view(a, b));
            const vector outward(e.along ^ normal);
            const scalar d = outward & e.foot;
            const scalar rho2 = magSqr(e.foot);

            const scalar half = Foam::sqrt(max(sqr(radius) - rho2, scalar(0)));
            const scalar from = max(e.from, -half);
            const scalar to = min(e.to, half);

            if (from >= to)
            {
                return;
            }
            met = true;

            const scalar above = sign*(normal & e.foot);
            cones += h*d*(to - from)/6;

            if (from == -half && to == half)
            {
                angles += 2*angle(d, above, radius, half);
            }
            else
            {
                angles +=
                    angle(d, above, Foam::sqrt(rho2 + sqr(to)), to)
                  - angle(d, above, Foam::sqrt(rho2 + sqr(from)), from);
            }

            if (e.from < -half)
            {
                arcs.enter(i, d*outward - half*e.along, n);
            }
            if (e.to > half)
            {
                arcs.leave(i, d, half, d*outward + half*e.along);
            }
        }
    };
}


Foam::scalar Foam::flatFace::volumeBehind
(
    const UList<point>& corners,
    const vector& normal,
    const scalar radius
)
{
    const scalar height = normal & corners[0];
    const scalar sign = height < 0 ? -1 : 1;
    const scalar h = mag(height);

    if (h >= radius)
    {
        return 0;
    }

    const label n = corners.size();
    const scalar r2 = sqr(radius);

    edgeSums sums(normal);
    bool within = true;

    for (label i = 0; i < n; ++i)
    {
        const point& a = corners[i];
        const point& b = corners[i + 1 < n ? i + 1 : 0];
        const vector edge(b - a);
        const vector moment(a ^ edge);

        // Distance of the edge's line from the normal, times its length
        const scalar away = normal & moment;
        const scalar length2 = magSqr(edge);

        if (away < 0)
        {
            if (sqr(away) >= (r2 - sqr(h))*length2)
            {
                return 0;
            }
            within = false;
        }

        if (magSqr(moment) < r2*length2)
        {
            sums.add(a, b, i, n, normal, sign, h, radius);
        }
    }

    const scalar arc = sums.met ? sums.arcs.close(n) : within ? twoPi : 0;

    return
        sign
       *(
            pow3(radius)/3*(sums.angles + arc*(1 - h/radius))
          - arc*h*(r2 - sqr(h))/6
          - sums.cones
        );
}


Foam::scalar Foam::flatFace::solidAngle
(
    const UList<point>& corners,
    const vector& normal
)
{
    const scalar sign = (normal & corners[0]) < 0 ? -1 : 1;
    scalar sum = 0;

    forAll(corners, i)
    {
        const edgeView e(view(corners[i], corners[corners.fcIndex(i)]));
        const scalar d = (e.along ^ normal) & e.foot;
        const scalar h = sign*(normal & e.foot);
        const scalar rho2 = magSqr(e.foot);

        sum +=
            angle(d, h, Foam::sqrt(rho2 + sqr(e.to)), e.to)
          - angle(d, h, Foam::sqrt(rho2 + sqr(e.from)), e.from);
    }

    return sign*sum;
}
