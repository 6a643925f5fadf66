// SPDX-License-Identifier: GPL-3.0-or-later
// Porosity: a grain is cut by the planes of its cell.

#include "caps.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace porosityModels
{
    defineTypeName(caps);
    addToRunTimeSelectionTable(porosityModel, caps, dictionary);
}
}

namespace
{
    using namespace Foam;

    using cutList = FixedList<meshWalker::cut, 8>;

    //- A part of the grain
    struct part
    {
        //- A point in its cell, from the centre of the grain [m]
        vector to;

        scalar share;

        //- Bit i: it lies beyond cut i
        label cuts;
    };

    //- Share beyond cut i of what lies where the part does: none beyond two
    //  planes that face each other
    scalar shareBeyond
    (
        const part& here,
        const label i,
        const cutList& cuts,
        const FixedList<scalar, 8>& f
    )
    {
        scalar rest = 1;

        for (label j = 0; j < i; ++j)
        {
            if ((cuts[i].normal & cuts[j].normal) < -0.5)
            {
                if (here.cuts & (1 << j))
                {
                    return 0;
                }
                rest -= f[j];
            }
        }

        return rest > 0 ? min(f[i]/rest, scalar(1)) : 0;
    }
}


Foam::porosityModels::caps::caps(const dictionary&)
{}


Foam::scalar Foam::porosityModels::caps::beyond(const scalar depth)
{
    const scalar s = min(max(depth, scalar(-1)), scalar(1));

    return sqr(1 - s)*(2 + s)/4;
}


void Foam::porosityModels::caps::addShares
(
    const locatedGrain& grain,
    const meshWalker& walker,
    cellWeights& weights
) const
{
    cutList cuts;
    const label nCuts =
        min(walker.cuts(grain.position, grain.cell, grain.radius, cuts), 8);

    if (nCuts == 0)
    {
        weights.add(grain.cell, 1);
        return;
    }

    FixedList<scalar, 8> f;
    FixedList<part, 256> parts;
    parts[0] = part{Zero, 1, 0};
    label n = 1;

    for (label i = 0; i < nCuts; ++i)
    {
        f[i] = beyond(cuts[i].depth/grain.radius);

        // As far beyond the plane as the middle of the cap
        const vector across
        (
            0.5*(grain.radius + cuts[i].depth)*cuts[i].normal
        );

        const label before = n;
        for (label k = 0; k < before; ++k)
        {
            const scalar share = shareBeyond(parts[k], i, cuts, f);

            if (share > 0)
            {
                parts[n++] = part
                {
                    parts[k].to + across,
                    share*parts[k].share,
                    parts[k].cuts | (1 << i)
                };
                parts[k].share *= 1 - share;
            }
        }
    }

    for (label k = 0; k < n; ++k)
    {
        if (parts[k].cuts == 0)
        {
            weights.add(grain.cell, parts[k].share);
            continue;
        }

        point p(grain.position + parts[k].to);
        const meshWalker::place end = walker.walk(p, grain.cell);

        if (end.rank == Pstream::myProcNo())
        {
            weights.add(end.cell, parts[k].share);
        }
        else
        {
            weights.add(p, end, parts[k].share);
        }
    }
}
