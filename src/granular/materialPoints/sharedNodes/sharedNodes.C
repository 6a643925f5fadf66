// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that a rank of the material points has in common with others.

#include "sharedNodes.H"

#include "UIPstream.H"
#include "UOPstream.H"

namespace
{

using namespace Foam;

//- Add the images along axis k, which repeats on this rank
void foldAxis(const pointGrid& grid, nodeLanes& nodes, const label k)
{
    // Nodes -1 and N - 1 are one, and so are 0 and N
    const label n = grid.nCells(k);
    const label across = n*grid.stride(k);
    const label line = (n + 2)*grid.stride(k);

    for (label begin = 0; begin < grid.nNodes(); begin += line)
    {
        for (label i = begin; i < begin + 2*grid.stride(k); ++i)
        {
            nodes[i] += nodes[i + across];
            nodes[i + across] = nodes[i];
        }
    }
}


//- Add what the nodes have on other ranks, or the images along the first axis
void foldSlabs(const pointGrid& grid, nodeLanes& nodes)
{
    if (!grid.cut())
    {
        if (grid.periodic(0))
        {
            foldAxis(grid, nodes, 0);
        }
        return;
    }

    // The two lowest planes are shared with the rank below, the two highest
    // with the one above
    const FixedList<label, 2> other(grid.neighbours());
    const label two = 2*grid.stride(0);
    lanes* const planes[2] =
    {
        nodes.data(), nodes.data() + grid.nNodes() - two
    };
    nodeLanes theirs[2];

    for (const int side : {0, 1})
    {
        theirs[side].resize(other[side] < 0 ? 0 : two);
    }

    const std::streamsize n = two*sizeof(lanes);
    swapSides
    (
        other, {bytes(planes[0]), bytes(planes[1])}, {n, n},
        {bytes(theirs[0].data()), bytes(theirs[1].data())}, {n, n}
    );

    for (const int side : {0, 1})
    {
        for (std::size_t i = 0; i < theirs[side].size(); ++i)
        {
            planes[side][i] += theirs[side][i];
        }
    }
}

} // End anonymous namespace


void Foam::swapSides
(
    const FixedList<label, 2>& other,
    const FixedList<const char*, 2>& out,
    const FixedList<std::streamsize, 2>& nOut,
    const FixedList<char*, 2>& in,
    const FixedList<std::streamsize, 2>& nIn
)
{
    const label started = Pstream::nRequests();

    for (const int side : {0, 1})
    {
        if (other[side] >= 0 && nIn[side] > 0)
        {
            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                other[side],
                in[side],
                nIn[side],
                Pstream::msgType() + side
            );
        }
    }
    for (const int side : {0, 1})
    {
        // What is low here is high there
        if (other[side] >= 0 && nOut[side] > 0)
        {
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                other[side],
                out[side],
                nOut[side],
                Pstream::msgType() + 1 - side
            );
        }
    }

    Pstream::waitRequests(started);
}


void Foam::sumShared(const pointGrid& grid, nodeLanes& nodes)
{
    for (label k = grid.nDims() - 1; k > 0; --k)
    {
        if (grid.periodic(k))
        {
            foldAxis(grid, nodes, k);
        }
    }
    foldSlabs(grid, nodes);
}


void Foam::sumShared(const pointGrid& grid, std::vector<nodeLanes>& fields)
{
    for (nodeLanes& nodes : fields)
    {
        sumShared(grid, nodes);
    }
}
