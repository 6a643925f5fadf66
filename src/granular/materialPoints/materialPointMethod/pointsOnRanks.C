// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method on ranks: sums at shared nodes, points that travel.

#include "materialPointMethod.H"

#include "UIPstream.H"
#include "UOPstream.H"

namespace
{
    using namespace Foam;

    template<class T>
    char* bytes(T* data)
    {
        return reinterpret_cast<char*>(data);
    }


    //- Send bytes to the ranks of both sides, below and above, and receive as
    //  many as they send; a side whose rank is -1 has none
    void swapSides
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
}


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
    if (!grid_.cut())
    {
        if (grid_.periodic(0))
        {
            foldAxis(nodes, 0);
        }
        return;
    }

    // The two lowest planes are shared with the rank below, the two highest
    // with the one above
    const FixedList<label, 2> other(grid_.neighbours());
    const label two = 2*grid_.stride(0);
    lanes* const planes[2] =
    {
        nodes.data(), nodes.data() + grid_.nNodes() - two
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


namespace
{
    //- Give one of the walls its faces
    void addFaces
    (
        Foam::pointWalls& walls,
        const Foam::label wall,
        const Foam::UList<Foam::pointField>& faces
    )
    {
        for (const Foam::pointField& face : faces)
        {
            walls.addFace(wall, face);
        }
    }
}


void Foam::materialPointMethod::addOutlet
(
    const word& name,
    const UList<pointField>& faces
)
{
    addFaces(outlets_, outlets_.addOutlet(name), faces);
    hasOutlets_ = true;
}


void Foam::materialPointMethod::addWallBesideOutlets
(
    const word& name,
    const UList<pointField>& faces
)
{
    addFaces(outlets_, outlets_.add(name, 0), faces);
}


bool Foam::materialPointMethod::hasLeft
(
    const point& p,
    const label cell
) const
{
    const boundBox& box = grid_.box();
    bool result = hasOutlets_ && outlets_.isBehindOutlet(p, cell);

    for (direction d = 0; d < 3; ++d)
    {
        result =
            result
         || (open_[2*d] && p[d] < box.min()[d])
         || (open_[2*d + 1] && p[d] > box.max()[d]);
    }

    return result;
}


bool Foam::materialPointMethod::passBoundary(const label i)
{
    // Before it repeats: faces are around the cell that it came from
    const bool left = hasLeft(points_.x[i], cell_[i]);
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
