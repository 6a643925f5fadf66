// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that LIGGGHTS is given for the faces of a wall patch.

#include "wallTriangles.H"

#include "Pstream.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <functional>

namespace
{
    using namespace Foam;

    //- True where LIGGGHTS takes the two for one
    bool same(const point& a, const point& b)
    {
        return cmptMax(cmptMag(a - b)) < wallTriangles::precision;
    }

    //- Normal of a polygon that may be warped
    vector normal(const wallTriangles::corners& at)
    {
        vector n(Zero);

        for (label i = 1; i + 1 < at.size(); ++i)
        {
            n += (at[i] - at[0]) ^ (at[i + 1] - at[0]);
        }

        return normalised(n);
    }

    //- Corners of a face of which LIGGGHTS takes no two neighbours for one
    DynamicList<point> distinct(const face& f, const pointField& points)
    {
        DynamicList<point> corners(f.size());

        for (const label p : f)
        {
            if (corners.empty() || !same(points[p], corners.last()))
            {
                corners.append(points[p]);
            }
        }
        while (corners.size() > 1 && same(corners.first(), corners.last()))
        {
            corners.remove();
        }

        return corners;
    }
}


bool Foam::wallTriangles::isBefore(const point& a, const point& b)
{
    for (direction k = 0; k < 2; ++k)
    {
        if (a[k] != b[k])
        {
            return a[k] < b[k];
        }
    }
    return a.z() < b.z();
}


bool Foam::wallTriangles::before::operator()
(
    const corners& a,
    const corners& b
) const
{
    return std::lexicographical_compare
    (
        a.begin(), a.end(), b.begin(), b.end(), isBefore
    );
}


Foam::scalar Foam::wallTriangles::smallestAngle
(
    const point& a,
    const point& b,
    const point& c,
    const vector& normal
)
{
    const vector sides[] = {b - a, c - b, a - c};
    const vector area(sides[0] ^ sides[1]);
    scalar angle = constant::mathematical::pi;

    for (label i = 0; i < 3; ++i)
    {
        angle = min
        (
            angle, std::atan2(mag(area), -(sides[i] & sides[(i + 1) % 3]))
        );
    }

    return (area & normal) > 0 ? angle : -angle;
}


Foam::List<Foam::triFace> Foam::wallTriangles::best
(
    const corners& at,
    scalar& angle
)
{
    // Between each two corners i < j, the best triangulation of the part of the
    // polygon from i to j: its smallest angle, which is its quality, and the tip
    // of the triangle on the side from i to j. If all triangles are turned as the
    // polygon is, they fill it without overlap
    const label n = at.size();
    const vector along(normal(at));
    List<scalar> quality(n*n, constant::mathematical::pi);
    labelList tip(n*n, -1);

    for (label span = 2; span < n; ++span)
    {
        for (label i = 0; i + span < n; ++i)
        {
            const label j = i + span;
            scalar& highest = quality[n*i + j];
            highest = -GREAT;

            // Of equals that which shares the first corner, as in a fan
            for (label k = j - 1; k > i; --k)
            {
                const scalar here = min
                (
                    min(quality[n*i + k], quality[n*k + j]),
                    smallestAngle(at[i], at[k], at[j], along)
                );

                if (tip[n*i + j] < 0 || here > highest + 1e-6*mag(highest))
                {
                    highest = here;
                    tip[n*i + j] = k;
                }
            }
        }
    }

    DynamicList<triFace> triangles(max(n - 2, label(0)));
    const std::function<void(label, label)> collect = [&](label i, label j)
    {
        if (j - i > 1)
        {
            const label k = tip[n*i + j];
            collect(i, k);
            triangles.append(triFace(i, k, j));
            collect(k, j);
        }
    };
    collect(0, n - 1);

    angle = n > 2 ? quality[n - 1] : -GREAT;

    return List<triFace>(std::move(triangles));
}


Foam::List<Foam::wallTriangles::corners> Foam::wallTriangles::faces
(
    const polyPatch& patch
)
{
    List<pointField> points(Pstream::nProcs());
    List<labelList> sizes(Pstream::nProcs());
    DynamicList<point> myPoints(4*patch.size());
    DynamicList<label> mySizes(patch.size());

    for (const face& f : patch.localFaces())
    {
        const DynamicList<point> at(distinct(f, patch.localPoints()));

        // LIGGGHTS would drop others as well
        if (at.size() > 2)
        {
            myPoints.append(at);
            mySizes.append(at.size());
        }
    }

    points[Pstream::myProcNo()] = myPoints;
    sizes[Pstream::myProcNo()] = mySizes;
    Pstream::gatherList(points);
    Pstream::gatherList(sizes);

    DynamicList<corners> result;

    for (label rank = 0; Pstream::master() && rank < points.size(); ++rank)
    {
        label first = 0;
        for (const label n : sizes[rank])
        {
            result.append(corners(SubList<point>(points[rank], n, first)));
            first += n;
        }
    }

    return List<corners>(std::move(result));
}


Foam::label Foam::wallTriangles::dropTwins
(
    List<corners>& faces,
    std::set<corners, before>& others
)
{
    label n = 0;

    forAll(faces, i)
    {
        // The other side has the same corners in another order
        corners key(faces[i]);
        std::sort(key.begin(), key.end(), isBefore);

        if (others.insert(key).second)
        {
            if (n < i)
            {
                faces[n] = faces[i];
            }
            ++n;
        }
    }

    const label nTwins = faces.size() - n;
    faces.resize(n);

    return nTwins;
}
