// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of grains that touch or nearly touch, periodic images included.

#include "grainContacts.H"

namespace Foam
{
namespace
{

//- Real grains first, then the periodic copies near the box
struct imagedGrains
{
    DynamicList<point> position;
    DynamicList<label> original;
    DynamicList<vector> shift;
};


//- How many images away a grain within reach [m] of the box can sit
label imageRange(const packingBox& box, const direction d, const scalar reach)
{
    return
        box.periodic(d) ? label(std::ceil(reach/box.span()[d])) : label(0);
}


void addImage
(
    imagedGrains& all,
    const boundBox& region,
    const UList<point>& positions,
    const vector& shift
)
{
    forAll(positions, i)
    {
        const point p = positions[i] + shift;
        if (region.contains(p))
        {
            all.position.append(p);
            all.original.append(i);
            all.shift.append(shift);
        }
    }
}


//- Of an image and its mirror one is enough to see each pair once
bool forward(const vector& shift)
{
    for (direction d = 0; d < 3; ++d)
    {
        if (shift[d] != 0)
        {
            return shift[d] > 0;
        }
    }
    return false;
}


imagedGrains withImages
(
    const packingBox& box,
    const UList<point>& positions,
    const scalar reach
)
{
    imagedGrains all;
    all.position.append(positions);
    forAll(positions, i)
    {
        all.original.append(i);
        all.shift.append(Zero);
    }

    const boundBox region
    (
        box.bounds().min() - reach*vector::one,
        box.bounds().max() + reach*vector::one
    );
    const label nx = imageRange(box, 0, reach);
    const label ny = imageRange(box, 1, reach);
    const label nz = imageRange(box, 2, reach);
    const vector span = box.span();

    for (label i = -nx; i <= nx; ++i)
    {
        for (label j = -ny; j <= ny; ++j)
        {
            for (label k = -nz; k <= nz; ++k)
            {
                const vector shift(i*span.x(), j*span.y(), k*span.z());
                if (forward(shift))
                {
                    addImage(all, region, positions, shift);
                }
            }
        }
    }
    return all;
}


//- Grains sorted into cubes at least as wide as the reach
class linkedCells
{
    point origin_;
    scalar width_;
    FixedList<label, 3> n_;
    labelList head_;
    labelList next_;

public:

    linkedCells(const UList<point>& positions, const scalar width)
    :
        origin_(boundBox(positions, false).min()),
        width_(width),
        n_(),
        head_(),
        next_(positions.size(), -1)
    {
        // Few grains in a large box need no more cells than grains
        const vector span = boundBox(positions, false).span();
        const scalar most = 2.0*positions.size() + 1;
        while (nCells(span) > most)
        {
            width_ *= 1.26;
        }
        for (direction d = 0; d < 3; ++d)
        {
            n_[d] = label(span[d]/width_) + 1;
        }
        head_ = labelList(n_[0]*n_[1]*n_[2], label(-1));

        for (label i = positions.size() - 1; i >= 0; --i)
        {
            label& head = head_[index(coordinates(positions[i]))];
            next_[i] = head;
            head = i;
        }
    }

    //- As a number that may be larger than a label
    scalar nCells(const vector& span) const
    {
        return
            std::floor(span.x()/width_ + 1)*std::floor(span.y()/width_ + 1)
           *std::floor(span.z()/width_ + 1);
    }

    FixedList<label, 3> coordinates(const point& p) const
    {
        FixedList<label, 3> c;
        for (direction d = 0; d < 3; ++d)
        {
            c[d] = min(n_[d] - 1, label((p[d] - origin_[d])/width_));
        }
        return c;
    }

    label index(const FixedList<label, 3>& c) const
    {
        return c[0] + n_[0]*(c[1] + n_[1]*c[2]);
    }

    //- Call visit(j) for all grains in the 27 cells around a point
    template<class Visit>
    void forNeighbours(const point& p, const Visit& visit) const
    {
        const FixedList<label, 3> c = coordinates(p);
        FixedList<label, 3> m;

        for (m[2] = max(c[2]-1, 0); m[2] <= min(c[2]+1, n_[2]-1); ++m[2])
        {
            for (m[1] = max(c[1]-1, 0); m[1] <= min(c[1]+1, n_[1]-1); ++m[1])
            {
                for
                (
                    m[0] = max(c[0]-1, 0);
                    m[0] <= min(c[0]+1, n_[0]-1);
                    ++m[0]
                )
                {
                    for (label j = head_[index(m)]; j != -1; j = next_[j])
                    {
                        visit(j);
                    }
                }
            }
        }
    }
};


scalar wallOverlap
(
    const packingBox& box,
    const UList<point>& positions,
    const UList<scalar>& diameters
)
{
    scalar largest = -VGREAT;
    const point& low = box.bounds().min();
    const point& high = box.bounds().max();

    for (direction d = 0; d < 3; ++d)
    {
        if (!box.periodic(d))
        {
            forAll(positions, i)
            {
                const scalar distance =
                    min(positions[i][d] - low[d], high[d] - positions[i][d]);
                largest = max(largest, 0.5 - distance/diameters[i]);
            }
        }
    }
    return largest;
}

} // End anonymous namespace
} // End namespace Foam


Foam::DynamicList<Foam::grainPair> Foam::pairsWithin
(
    const packingBox& box,
    const UList<point>& positions,
    const UList<scalar>& diameters,
    const scalar gap
)
{
    DynamicList<grainPair> pairs(8*positions.size());
    if (positions.empty())
    {
        return pairs;
    }

    const scalar reach = max(diameters) + gap;
    const imagedGrains all = withImages(box, positions, reach);
    const linkedCells cells(all.position, reach);

    forAll(positions, i)
    {
        cells.forNeighbours
        (
            positions[i],
            [&](const label j)
            {
                const label jReal = all.original[j];
                const bool image = j >= positions.size();
                const scalar limit =
                    0.5*(diameters[i] + diameters[jReal]) + gap;

                if
                (
                    (image || j > i)
                 && magSqr(all.position[j] - positions[i]) < sqr(limit)
                )
                {
                    pairs.append(grainPair{i, jReal, all.shift[j]});
                }
            }
        );
    }
    return pairs;
}


Foam::scalar Foam::largestOverlap
(
    const packingBox& box,
    const UList<point>& positions,
    const UList<scalar>& diameters,
    const UList<grainPair>& pairs
)
{
    scalar largest = wallOverlap(box, positions, diameters);

    for (const grainPair& pair : pairs)
    {
        const label i = pair.first;
        const label j = pair.second;
        const scalar meanDiameter = 0.5*(diameters[i] + diameters[j]);
        const scalar distance = mag(positions[j] + pair.shift - positions[i]);
        largest = max(largest, 1 - distance/meanDiameter);
    }
    return largest;
}


Foam::scalar Foam::largestOverlap
(
    const packingBox& box,
    const UList<point>& positions,
    const UList<scalar>& diameters
)
{
    return largestOverlap
    (
        box,
        positions,
        diameters,
        pairsWithin(box, positions, diameters, 0)
    );
}
