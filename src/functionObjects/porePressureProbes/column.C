// SPDX-License-Identifier: GPL-3.0-or-later
// The cells over a point, and the base around it.

#include "column.H"

#include "DynamicList.H"
#include "Tuple2.H"
#include "triPointRef.H"

Foam::column::column
(
    const fvMesh& mesh,
    const point& inside,
    const vector& direction,
    const point& from
)
{
    const vector e(direction/mag(direction));
    const scalar beginning = (from - inside) & e;
    DynamicList<label> cells;
    DynamicList<scalar> lengths;

    forAll(mesh.cells(), celli)
    {
        scalar begin = beginning;
        scalar end = GREAT;

        for (const label facei : mesh.cells()[celli])
        {
            const vector& S = mesh.faceAreas()[facei];
            const bool own = mesh.faceOwner()[facei] == celli;
            const vector out((own ? S : -S)/mag(S));

            const scalar gap = (mesh.faceCentres()[facei] - inside) & out;
            const scalar speed = e & out;

            if (mag(speed) < 1e-12)
            {
                end = gap < 0 ? -GREAT : end;
            }
            else if (speed > 0)
            {
                end = min(end, gap/speed);
            }
            else
            {
                begin = max(begin, gap/speed);
            }
        }

        if (end > begin)
        {
            cells.append(celli);
            lengths.append(end - begin);
        }
    }

    cells_.transfer(cells);
    lengths_.transfer(lengths);
}


Foam::scalar Foam::column::length() const
{
    return sum(lengths_);
}


Foam::scalar Foam::column::integral(const volScalarField& field) const
{
    scalar result = 0;

    forAll(cells_, i)
    {
        result += lengths_[i]*field[cells_[i]];
    }

    return returnReduce(result, sumOp<scalar>());
}


Foam::patchDisc::patchDisc
(
    const fvPatch& patch,
    const point& centre,
    const scalar radius
)
:
    area_(0),
    normal_(Zero),
    nearest_(-1),
    offset_(Zero),
    inside_(Zero),
    cellSide_(0),
    distance_(GREAT),
    centre_(centre),
    radius_(radius)
{
    findNearest(patch, centre);

    forAll(patch, face)
    {
        addFace(patch, face);
    }

    area_ = returnReduce(sum(areas_), sumOp<scalar>());
}


void Foam::patchDisc::findNearest(const fvPatch& patch, const point& centre)
{
    const pointField& points = patch.patch().points();

    forAll(patch, face)
    {
        const scalar d =
            patch.patch()[face].nearestPoint(centre, points).distance();

        if (d < distance_)
        {
            distance_ = d;
            nearest_ = face;
        }
    }

    typedef Tuple2<scalar, label> ranked;
    ranked best(distance_, Pstream::myProcNo());
    reduce
    (
        best,
        [](const ranked& a, const ranked& b)
        {
            return a.first() < b.first()
             || (a.first() == b.first() && a.second() < b.second())
              ? a : b;
        }
    );

    distance_ = best.first();

    if (best.second() != Pstream::myProcNo())
    {
        nearest_ = -1;
    }

    if (nearest_ >= 0)
    {
        const vector& S = patch.Sf()[nearest_];
        const fvMesh& mesh = patch.boundaryMesh().mesh();
        const label cell = patch.faceCells()[nearest_];

        normal_ = S/mag(S);
        offset_ = centre - patch.Cf()[nearest_];
        offset_ -= (offset_ & normal_)*normal_;

        // Of a point that is beside the patch, too
        const point on
        (
            patch.patch()[nearest_].nearestPoint(centre, points).rawPoint()
        );
        inside_ = on + 1e-5*(mesh.cellCentres()[cell] - on);
        cellSide_ = cbrt(mesh.cellVolumes()[cell]);
    }

    reduce(normal_, sumOp<vector>());
    reduce(inside_, sumOp<vector>());
    reduce(cellSide_, sumOp<scalar>());
}


void Foam::patchDisc::addFace(const fvPatch& patch, const label face)
{
    // The disc's rim cuts faces: their area is taken from small triangles
    constexpr label fine = 12;

    const pointField& points = patch.patch().points();
    const Foam::face& f = patch.patch()[face];
    const point& middle = patch.Cf()[face];
    scalar area = 0;

    forAll(f, k)
    {
        const vector a = (points[f[k]] - middle)/fine;
        const vector b = (points[f.nextLabel(k)] - middle)/fine;
        const scalar small = mag(a ^ b)/2;

        for (label i = 0; i < fine; ++i)
        {
            for (label j = 0; j < fine - i; ++j)
            {
                const point lower(middle + (i + 1.0/3)*a + (j + 1.0/3)*b);
                area += contains(lower) ? small : 0;

                if (i + j < fine - 1)
                {
                    const point upper(middle + (i + 2.0/3)*a + (j + 2.0/3)*b);
                    area += contains(upper) ? small : 0;
                }
            }
        }
    }

    if (area > 0)
    {
        faces_.append(face);
        areas_.append(area);
    }
}


bool Foam::patchDisc::contains(const point& p) const
{
    const vector d(p - centre_);

    return magSqr(d - (d & normal_)*normal_) <= sqr(radius_);
}


Foam::scalar Foam::patchDisc::mean(const scalarField& values) const
{
    scalar result = 0;

    forAll(faces_, i)
    {
        result += areas_[i]*values[faces_[i]];
    }

    return returnReduce(result, sumOp<scalar>())/max(area_, VSMALL);
}


Foam::scalar Foam::patchDisc::atPoint
(
    const fvPatchScalarField& values,
    const vector& gradient,
    const scalarField& fraction
) const
{
    scalar value = 0;

    if (nearest_ >= 0)
    {
        const label cell = values.patch().faceCells()[nearest_];
        value = values[nearest_] + fraction[cell]*(offset_ & gradient);
    }

    return returnReduce(value, sumOp<scalar>());
}
