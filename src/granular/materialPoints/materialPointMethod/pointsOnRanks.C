// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method on ranks: sums at shared nodes, points that travel.

#include "materialPointMethod.H"

#include "UIPstream.H"
#include "UOPstream.H"
#include "swapLists.H"

void Foam::materialPointMethod::foldAxis
(
    nodeLanes& nodes,
    const label k
) const
{
    // Nodes -1 and N - 1 are one, and so are 0 and N
    const label n = grid_.nCells(k);
    const label across = n*grid_.stride(k);
    const label line = (n + 2)*grid_.stride(k);

    for (label begin = 0; begin < grid_.nNodes(); begin += line)
    {
        for (label i = begin; i < begin + 2*grid_.stride(k); ++i)
        {
            nodes[i] += nodes[i + across];
            nodes[i + across] = nodes[i];
        }
    }
}


void Foam::materialPointMethod::foldSlabs(nodeLanes& nodes) const
{
    const label nRanks = grid_.cut() ? Pstream::nProcs() : 1;
    const label me = Pstream::myProcNo();
    const bool repeats = grid_.periodic(0);

    if (nRanks == 1)
    {
        if (repeats)
        {
            foldAxis(nodes, 0);
        }
        return;
    }

    // The two lowest planes are shared with the rank below, the two highest
    // with the one above
    const label two = 2*grid_.stride(0);
    const label beginOf[2] = {0, grid_.nNodes() - two};
    const label other[2] =
    {
        me > 0 ? me - 1 : repeats ? nRanks - 1 : -1,
        me < nRanks - 1 ? me + 1 : repeats ? 0 : -1
    };

    nodeLanes theirs[2];
    const label started = Pstream::nRequests();

    for (const int side : {0, 1})
    {
        if (other[side] >= 0)
        {
            theirs[side].resize(two);
            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                other[side],
                reinterpret_cast<char*>(theirs[side].data()),
                two*sizeof(lanes),
                Pstream::msgType() + side
            );
        }
    }
    for (const int side : {0, 1})
    {
        if (other[side] >= 0)
        {
            // What is low here is high there
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                other[side],
                reinterpret_cast<const char*>(nodes.data() + beginOf[side]),
                two*sizeof(lanes),
                Pstream::msgType() + 1 - side
            );
        }
    }
    Pstream::waitRequests(started);

    for (const int side : {0, 1})
    {
        for (std::size_t i = 0; i < theirs[side].size(); ++i)
        {
            nodes[beginOf[side] + i] += theirs[side][i];
        }
    }
}


void Foam::materialPointMethod::share(nodeLanes& nodes) const
{
    for (label k = grid_.nDims() - 1; k > 0; --k)
    {
        if (grid_.periodic(k))
        {
            foldAxis(nodes, k);
        }
    }
    foldSlabs(nodes);
}


void Foam::materialPointMethod::share(std::vector<nodeLanes>& fields) const
{
    for (nodeLanes& nodes : fields)
    {
        share(nodes);
    }
}


void Foam::materialPointMethod::stopOutside(const label i) const
{
    FatalErrorInFunction
        << "Point " << points_.id[i] << " of body "
        << bodies_[points_.body[i]] << " is beyond the grid of the points, at "
        << points_.x[i] << " m with velocity " << points_.U[i] << " m/s." << nl
        << "    The mesh's box is " << grid_.box() << nl
        << "    Close the mesh there with a wall patch, name the patch in"
        << " materialPoints/outflow, or, if points pass a wall, take a smaller"
        << " courant." << exit(FatalError);
}


bool Foam::materialPointMethod::hasLeft(const point& p) const
{
    const boundBox& box = grid_.box();
    bool result = false;

    for (direction d = 0; d < 3; ++d)
    {
        result =
            result
         || (open_[2*d] && p[d] < box.min()[d])
         || (open_[2*d + 1] && p[d] > box.max()[d]);
    }

    return result;
}


void Foam::materialPointMethod::travel()
{
    const label me = Pstream::myProcNo();
    List<DynamicList<char>> toRanks(grid_.cut() ? Pstream::nProcs() : 0);
    DynamicList<label> staying;
    bool all = true;

    forAll(points_.x, i)
    {
        grid_.wrap(points_.x[i]);
        const bool left = hasLeft(points_.x[i]);
        nLeft_ += left;

        if (!left && !grid_.holds(points_.x[i]))
        {
            stopOutside(i);
        }

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
                points_.pack(i, toRanks[rank]);
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
        for (const List<char>& arrived : swapLists(toRanks))
        {
            points_.unpack(arrived);
        }
    }
}
