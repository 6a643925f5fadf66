// SPDX-License-Identifier: GPL-3.0-or-later
// Which wall patches are planes: sides of the mesh's box.

#include "liggghtsWalls.H"

#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"

bool Foam::liggghtsWalls::isOnSide
(
    const polyPatch& patch,
    const label facei,
    const label side
) const
{
    const boundBox& box = mesh_.bounds();
    const direction k = side/2;
    const scalar plane = side % 2 ? box.max()[k] : box.min()[k];
    const scalar tolerance = 1e-3*sqrt(mag(patch.faceAreas()[facei]));

    for (const label p : patch[facei])
    {
        if (mag(mesh_.points()[p][k] - plane) > tolerance)
        {
            return false;
        }
    }

    return true;
}


bool Foam::liggghtsWalls::isInTheWay
(
    const label side,
    const polyPatch& of
) const
{
    vector outwards(Zero);
    outwards[side/2] = side % 2 ? 1 : -1;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        // A cut between ranks, but not one through which the mesh repeats itself
        const bool cut =
            isA<processorPolyPatch>(patch)
         && !isA<processorCyclicPolyPatch>(patch);

        if (&patch == &of || cut || isA<emptyPolyPatch>(patch))
        {
            continue;
        }

        forAll(patch, facei)
        {
            const vector& area = patch.faceAreas()[facei];
            const bool open =
                !isWall(patch) && (area & outwards) > 0.1*mag(area);

            if (open || isOnSide(patch, facei, side))
            {
                return true;
            }
        }
    }

    return false;
}


Foam::labelList Foam::liggghtsWalls::sides(const polyPatch& patch) const
{
    FixedList<bool, 6> has(false);
    bool planes = true;

    for (label facei = 0; facei < patch.size() && planes; ++facei)
    {
        label side = 0;
        while (side < 6 && !isOnSide(patch, facei, side))
        {
            ++side;
        }

        planes = side < 6;
        if (planes)
        {
            has[side] = true;
        }
    }

    reduce(planes, andOp<bool>());
    DynamicList<label> result;

    for (label side = 0; side < 6; ++side)
    {
        if (planes && returnReduce(has[side], orOp<bool>()))
        {
            planes = !returnReduce(isInTheWay(side, patch), orOp<bool>());
            result.append(side);
        }
    }

    return planes ? labelList(std::move(result)) : labelList();
}
