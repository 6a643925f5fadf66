// SPDX-License-Identifier: GPL-3.0-or-later
// Volume that a sphere has in each cell of any mesh, exact.

#include "sphereOverlap.H"

#include "emptyPolyPatch.H"
#include "flatFace.H"
#include "mathematicalConstants.H"

namespace
{
    using namespace Foam;

    //- Distance of the farthest corner of the mesh from its own or from the
    //  origin: rounding of places is a share of it [m]
    scalar reach(const boundBox& box)
    {
        return max(box.mag(), max(mag(box.min()), mag(box.max())));
    }

    //- True if the corner after each edge turns the same way about the normal
    bool convex
    (
        const face& f,
        const pointField& points,
        const vector& normal
    )
    {
        const label n = f.size();

        for (label i = 0; i < n; ++i)
        {
            const vector a(points[f[(i + 1) % n]] - points[f[i]]);
            const vector b(points[f[(i + 2) % n]] - points[f[(i + 1) % n]]);

            if (((a ^ b) & normal) < -1e-12*mag(a)*mag(b))
            {
                return false;
            }
        }

        return true;
    }
}


Foam::sphereOverlap::sphereOverlap(const meshWalker& walker)
:
    mesh_(walker.mesh()),
    walker_(walker),
    faces_(mesh_.faces()),
    points_(mesh_.points()),
    whole_(mesh_.nFaces()),
    convex_(mesh_.nCells()),
    endless_(false, false, false),
    anyEndless_(false),
    aside_(2e-14*reach(mesh_.bounds())*vector(0.366, 0.477, 0.799))
{
    // Ten times nearer to flat than centres are moved aside: edges and plane of
    // a face must agree on which side a centre lies
    const scalar flat = 2e-15*reach(mesh_.bounds());

    forAll(mesh_.cells(), cell)
    {
        for (const meshWalker::side& s : walker.sides(cell))
        {
            if (s.face >= 0)
            {
                const face& f = faces_[s.face];

                whole_.set
                (
                    s.face,
                    s.warp < flat
                 && f.size() <= mostCorners
                 && convex(f, points_, s.normal)
                );
            }
        }
    }

    forAll(mesh_.cells(), cell)
    {
        convex_.set(cell, isConvex(cell, flat));
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (direction k = 0; k < 3; ++k)
        {
            endless_[k] =
                endless_[k]
             || (isA<emptyPolyPatch>(patch) && mesh_.solutionD()[k] == -1);
            anyEndless_ = anyEndless_ || endless_[k];
        }
    }
}


bool Foam::sphereOverlap::isConvex
(
    const label cell,
    const scalar tolerance
) const
{
    for (const label f : mesh_.cells()[cell])
    {
        if (!whole_[f])
        {
            return false;
        }

        for (const label corner : faces_[f])
        {
            if (walker_.outside(points_[corner], cell) > tolerance)
            {
                return false;
            }
        }
    }

    return true;
}


inline Foam::sphereOverlap::planes Foam::sphereOverlap::reached
(
    const point& centre,
    const scalar radius,
    const label cell
) const
{
    planes result{0, nullptr};

    // Without a branch on each, which no processor could foresee
    for (const meshWalker::side& s : walker_.sides(cell))
    {
        const bool reaches =
            s.offset - (s.normal & centre) < radius + s.warp;

        result.n += reaches;
        result.last = reaches ? &s : result.last;
    }

    return result;
}


Foam::sphereOverlap::cap Foam::sphereOverlap::capOf
(
    const point& centre,
    const scalar radius,
    const label cell
) const
{
    const planes here(reached(centre, radius, cell));

    // What lies behind a wall is not needed
    if (!here.n || (here.n == 1 && here.last->next == -1))
    {
        return cap{true, -1, 0};
    }

    const label behind = here.last->next;
    const bool alone =
        here.n == 1 && behind >= 0 && convex_[cell] && convex_[behind]
     && reached(centre, radius, behind).n == 1;

    if (!alone)
    {
        return cap{false, -1, 0};
    }

    const meshWalker::side& s = *here.last;
    const scalar height = s.offset - (s.normal & (centre + aside_));

    return cap{true, behind, flatFace::cap(height, radius)};
}


inline Foam::vector Foam::sphereOverlap::toCorner
(
    const point& at,
    const point& p,
    const scalar far
) const
{
    vector to(at - p);

    for (direction k = 0; anyEndless_ && k < 3; ++k)
    {
        if (endless_[k])
        {
            const scalar middle =
                0.5*(mesh_.bounds().min()[k] + mesh_.bounds().max()[k]);
            const scalar off = at[k] - middle;

            // The centre of a face is in the middle
            to[k] = mag(off) < 0.1*mesh_.bounds().span()[k] ? 0 : sign(off)*far;
        }
    }

    return to;
}


template<class Function>
Foam::scalar Foam::sphereOverlap::sumOverParts
(
    const label face,
    const vector& normal,
    const point& p,
    const scalar far,
    const Function& what
) const
{
    const Foam::face& f = faces_[face];

    if (whole_[face])
    {
        point corners[mostCorners];
        forAll(f, i)
        {
            corners[i] = toCorner(points_[f[i]], p, far);
        }
        return what(UList<point>(corners, f.size()), normal);
    }

    point triangle[3];
    triangle[0] = toCorner(mesh_.faceCentres()[face], p, far);
    scalar sum = 0;

    forAll(f, i)
    {
        triangle[1] = toCorner(points_[f[i]], p, far);
        triangle[2] = toCorner(points_[f.nextLabel(i)], p, far);

        const vector area
        (
            (triangle[1] - triangle[0]) ^ (triangle[2] - triangle[0])
        );
        const scalar size = mag(area);

        if (size > VSMALL)
        {
            sum += what(UList<point>(triangle, 3), area/size);
        }
    }

    return sum;
}


Foam::scalar Foam::sphereOverlap::volumeBehind
(
    const label face,
    const vector& normal,
    const point& p,
    const scalar radius
) const
{
    return sumOverParts
    (
        face,
        normal,
        p,
        10*radius,
        [radius](const UList<point>& corners, const vector& normal)
        {
            return flatFace::volumeBehind(corners, normal, radius);
        }
    );
}


bool Foam::sphereOverlap::inside(const point& p, const label cell) const
{
    scalar angle = 0;

    for (const label f : mesh_.cells()[cell])
    {
        const scalar solidAngle = sumOverParts
        (
            f,
            mesh_.faceAreas()[f]/mag(mesh_.faceAreas()[f]),
            p + aside_,
            mesh_.bounds().mag(),
            flatFace::solidAngle
        );
        angle += mesh_.faceOwner()[f] == cell ? solidAngle : -solidAngle;
    }

    return angle > constant::mathematical::twoPi;
}


Foam::label Foam::sphereOverlap::find
(
    const UList<piece>& pieces,
    const label cell,
    const point& centre,
    const scalar radius
)
{
    label i = 0;

    while
    (
        i < pieces.size()
     && (
            pieces[i].cell != cell
         || magSqr(pieces[i].centre - centre) > sqr(1e-3*radius)
        )
    )
    {
        ++i;
    }

    return i;
}


void Foam::sphereOverlap::flood
(
    const scalar radius,
    const label first,
    DynamicList<piece>& pieces,
    DynamicList<exit>& exits
) const
{
    const scalar least = 1e-15*pow3(radius);

    for (label i = first; i < pieces.size(); ++i)
    {
        const label cell = pieces[i].cell;
        const point centre(pieces[i].centre);
        for (const meshWalker::side& s : walker_.sides(cell))
        {
            const scalar depth = s.offset - (s.normal & centre);

            if (mag(depth) >= radius + s.warp)
            {
                continue;
            }

            point there(centre);
            const meshWalker::place behind = walker_.behind(s, there);
            const bool here = behind.rank == Pstream::myProcNo();
            const label j =
                here ? find(pieces, behind.cell, there, radius) : -1;

            // One before this has dealt with the face
            if (here && j < i)
            {
                continue;
            }

            const point p(centre + aside_);
            const scalar out =
                s.face >= 0
              ? volumeBehind(s.face, s.normal, p, radius)
              : -volumeBehind(-1 - s.face, -s.normal, p, radius);

            if (mag(out) < least)
            {
                continue;
            }

            pieces[i].volume -= out;

            if (here)
            {
                if (j == pieces.size())
                {
                    pieces.append(piece{behind.cell, there, 0});
                }
                pieces[j].volume += out;
            }
            else if (behind.rank >= 0)
            {
                exits.append(exit{behind, there});
            }
        }
    }
}
