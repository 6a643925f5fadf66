// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method on ranks: points that leave, and points that travel.

#include "materialPointMethod.H"
#include "sharedNodes.H"

void Foam::materialPointMethod::stopFor
(
    const label i,
    const char* what,
    const char* advice
) const
{
    FatalErrorInFunction
        << "Point " << points_.id[i] << " of body "
        << bodies_[points_.body[i]] << " " << what << ", at "
        << points_.x[i] << " m with velocity " << points_.U[i] << " m/s." << nl
        << "    The mesh's box is " << grid_.box() << nl
        << "    " << advice << exit(FatalError);
}


bool Foam::materialPointMethod::passBoundary(const label i)
{
    // Before it repeats: faces are around the cell that it came from
    const bool left = outlets_.isBeyond(points_.x[i], cell_[i]);
    grid_.wrap(points_.x[i]);
    nLeft_ += left;

    if (!left && !grid_.holds(points_.x[i]))
    {
        stopFor
        (
            i,
            "is beyond the grid of the points",
            "Close the mesh there with a wall patch, name the patch in"
            " materialPoints/outflow, or, if points pass a wall, take a"
            " smaller courant."
        );
    }

    return left;
}


void Foam::materialPointMethod::travel()
{
    const label me = Pstream::myProcNo();
    const FixedList<label, 2> other(grid_.neighbours());
    DynamicList<char> toSides[2];
    DynamicList<label> staying;
    bool all = true;

    forAll(points_.x, i)
    {
        const bool left = passBoundary(i);
        const label rank =
            grid_.cut()
          ? grid_.rankOf(pointGrid::cell(grid_.coordinate(points_.x[i], 0)))
          : me;

        if (left || rank != me)
        {
            if (all)
            {
                // Those before stay where they are
                all = false;
                staying.setCapacity(points_.size());
                for (label j = 0; j < i; ++j)
                {
                    staying.append(j);
                }
            }
            if (!left)
            {
                // A step is shorter than a slab
                if (rank != other[0] && rank != other[1])
                {
                    stopFor
                    (
                        i,
                        "moved past a whole rank in one step",
                        "Its speed has grown without bound, or steps are too"
                        " long: take a smaller materialPoints/courant."
                    );
                }
                points_.pack(i, toSides[rank == other[0] ? 0 : 1]);
            }
        }
        else if (!all)
        {
            staying.append(i);
        }
    }

    if (!all)
    {
        points_.take(staying);
    }

    if (grid_.cut())
    {
        arrive(other, toSides);
    }
}


void Foam::materialPointMethod::arrive
(
    const FixedList<label, 2>& other,
    const DynamicList<char> (&toSides)[2]
)
{
    // Their numbers first
    FixedList<label, 2> nOut({toSides[0].size(), toSides[1].size()});
    FixedList<label, 2> nIn(0);
    const std::streamsize one = sizeof(label);
    swapSides
    (
        other, {bytes(&nOut[0]), bytes(&nOut[1])}, {one, one},
        {bytes(&nIn[0]), bytes(&nIn[1])}, {one, one}
    );

    List<char> arrived[2] = {List<char>(nIn[0]), List<char>(nIn[1])};
    swapSides
    (
        other, {toSides[0].cdata(), toSides[1].cdata()}, {nOut[0], nOut[1]},
        {arrived[0].data(), arrived[1].data()}, {nIn[0], nIn[1]}
    );

    for (const List<char>& points : arrived)
    {
        points_.unpack(points);
    }
}
