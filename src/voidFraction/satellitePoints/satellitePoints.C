// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction: a grain is points, each in the cell that it lies in.

#include "satellitePoints.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace voidFractionModels
{
    defineTypeName(satellitePoints);
    addToRunTimeSelectionTable(voidFractionModel, satellitePoints, dictionary);
}
}


namespace
{

//- Number of points of a grain in each cell, of few cells
class pointCounts
{
    static constexpr Foam::label most_ =
        Foam::voidFractionModels::satellitePoints::nPoints;

    Foam::FixedList<Foam::label, most_> cells_;
    Foam::FixedList<Foam::label, most_> counts_;

    Foam::label n_;

public:

    //- No point yet in the first cell
    explicit pointCounts(const Foam::label first)
    :
        n_(1)
    {
        cells_[0] = first;
        counts_[0] = 0;
    }

    //- Count a point in the first cell
    void addToFirst()
    {
        ++counts_[0];
    }

    void add(const Foam::label cell)
    {
        Foam::label i = 0;
        while (i < n_ && cells_[i] != cell)
        {
            ++i;
        }
        if (i == n_)
        {
            cells_[n_] = cell;
            counts_[n_++] = 0;
        }
        ++counts_[i];
    }

    //- Add the shares of the cells, each point having one
    void addTo(Foam::cellWeights& weights, const Foam::scalar share) const
    {
        for (Foam::label i = 0; i < n_; ++i)
        {
            if (counts_[i])
            {
                weights.add(cells_[i], counts_[i]*share);
            }
        }
    }
};

} // End anonymous namespace


Foam::voidFractionModels::satellitePoints::satellitePoints(const dictionary&)
{
    // Each shell's points stand where half of its volume is within: the
    // shells reach from 1/29 to 15/29 and to 29/29 of the volume
    const scalar radii[] = {cbrt(8.0/29), cbrt(22.0/29)};

    points_[0] = Zero;
    label n = 1;

    for (const scalar radius : radii)
    {
        // Six points on the axes, eight towards the corners of a cube
        for (direction k = 0; k < 3; ++k)
        {
            for (const scalar sign : {-1.0, 1.0})
            {
                points_[n] = Zero;
                points_[n++][k] = sign*radius;
            }
        }

        for (label corner = 0; corner < 8; ++corner)
        {
            const scalar along = radius/sqrt(3.0);

            points_[n++] = point
            (
                corner & 1 ? along : -along,
                corner & 2 ? along : -along,
                corner & 4 ? along : -along
            );
        }
    }
}


void Foam::voidFractionModels::satellitePoints::addShares
(
    const locatedGrain& grain,
    const meshWalker& walker,
    cellWeights& weights
) const
{
    // Only the planes that the grain reaches can part it
    FixedList<meshWalker::cut, 8> cuts;
    const label nCuts =
        walker.cuts(grain.position, grain.cell, grain.radius, cuts);

    if (nCuts == 0)
    {
        weights.add(grain.cell, 1);
        return;
    }

    const label me = Pstream::myProcNo();
    const scalar share = 1.0/nPoints;

    pointCounts counts(grain.cell);

    for (const point& direction : points_)
    {
        bool inside = nCuts <= cuts.size();
        for (label c = 0; inside && c < nCuts; ++c)
        {
            inside =
                grain.radius*(cuts[c].normal & direction) <= cuts[c].depth;
        }

        if (inside)
        {
            counts.addToFirst();
            continue;
        }

        point p(grain.position + grain.radius*direction);
        const meshWalker::place end = walker.walk(p, grain.cell);

        if (end.rank != me)
        {
            weights.add(p, end, share);
            continue;
        }

        counts.add(end.cell);
    }

    counts.addTo(weights, share);
}
