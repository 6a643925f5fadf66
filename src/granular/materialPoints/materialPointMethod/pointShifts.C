// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: points shift out of places that they overfill.

#include "materialPointMethod.H"
#include "sharedNodes.H"

namespace
{
    using namespace Foam;

    //- Steps between two shifts. A number that divides those between two sortings
    constexpr label shiftInterval = 5;

    //- Share of its room by which a node may be overfilled: the sums over the
    //  points of a sheared packing differ by as much
    constexpr scalar overfillTolerance = 0.05;

    //- Length of a shift over the gradient of what is too much, in h^2 [-].
    //  Ten times as much is still stable
    constexpr scalar strength = 2;

    //- Longest shift, in spacings
    constexpr scalar maxShift = 0.1;

    //- Places along each direction at which a cell at a wall is probed
    constexpr label nSamples = 8;
}


Foam::scalar Foam::materialPointMethod::occupiedVolume(const label i) const
{
    // A point that flew apart from others may have grown without opening a pore
    // between them: loose, it takes no more room than when it closes
    const scalar closes = laws_[points_.body[i]].looseDensity();
    const scalar volume = points_.volume[i];
    return closes > 0 ? min(volume, points_.mass[i]/closes) : volume;
}


template<int D>
void Foam::materialPointMethod::addWholeCell
(
    nodeLanes& room,
    const label cell
) const
{
    // The integrals of a B-spline over the cells beside its own and that one
    constexpr label n = D == 3 ? 27 : 9;
    for (label i = 0; i < n; ++i)
    {
        label node = cell;
        scalar volume = grid_.cubeVolume(grid_.h());
        for (label k = 0, rest = i; k < D; ++k, rest /= 3)
        {
            const label way = rest % 3 - 1;
            node += way*grid_.stride(k);
            volume *= way ? 1/6.0 : 2/3.0;
        }
        room[node][0] += volume;
    }
}


template<int D>
void Foam::materialPointMethod::addCellAtWall
(
    nodeLanes& room,
    const label cell
) const
{
    constexpr label n = nSamples*nSamples*(D == 3 ? nSamples : 1);
    const scalar part = grid_.cubeVolume(grid_.h())/n;
    const scalar spacing = grid_.h()/nSamples;
    lanes flat[D];
    std::fill(flat, flat + D, lanes(lanes::Zero()));

    for (label sample = 0; sample < n; ++sample)
    {
        point p(grid_.position(cell));
        for (label k = 0, rest = sample; k < D; ++k, rest /= nSamples)
        {
            p[grid_.axes()[k]] += (rest % nSamples + 0.5)*spacing - 0.5*grid_.h();
        }

        point inFront(p);
        walls_.putBack(inFront, cell);
        if (inFront == p)
        {
            splineStencil<D>(grid_, p).add(room, lanes(part, 0, 0, 0), flat);
        }
    }
}


template<int D>
void Foam::materialPointMethod::findRoom()
{
    nodeLanes sum(grid_.nNodes(), lanes(lanes::Zero()));

    for (label cell = 0; cell < grid_.nNodes(); ++cell)
    {
        // A point of a cell at the rim of the slab is another rank's
        const FixedList<label, 3> at(grid_.numbers(cell));
        bool mine = at[0] >= grid_.first() && at[0] < grid_.last();
        for (label k = 1; k < D; ++k)
        {
            mine = mine && at[k] >= 0 && at[k] < grid_.nCells(k);
        }

        if (mine && walls_.isNear(cell))
        {
            addCellAtWall<D>(sum, cell);
        }
        else if (mine)
        {
            addWholeCell<D>(sum, cell);
        }
    }
    sumShared(grid_, sum);

    // What little is in front of a wall at nodes behind it does not count
    const scalar least = 0.25*grid_.cubeVolume(grid_.h());
    room_.setSize(grid_.nNodes());
    forAll(room_, node)
    {
        room_[node] = sum[node][0] > least ? sum[node][0] : 0;
    }
}


template<int D>
void Foam::materialPointMethod::findCrowding()
{
    crowded_ = false;
    if (!shifting_ || sinceSorted_ % shiftInterval)
    {
        return;
    }
    if (room_.empty())
    {
        findRoom<D>();
        crowding_.resize(nFields());
    }

    for (nodeLanes& crowding : crowding_)
    {
        crowding.assign(grid_.nNodes(), lanes(lanes::Zero()));
    }
    lanes flat[D];
    std::fill(flat, flat + D, lanes(lanes::Zero()));
    forAll(points_.x, i)
    {
        splineStencil<D>(grid_, points_.x[i]).add
        (
            crowding_[fieldOf(i)], lanes(occupiedVolume(i), 0, 0, 0), flat
        );
    }
    sumShared(grid_, crowding_);

    for (nodeLanes& ofBody : crowding_)
    {
        forAll(room_, node)
        {
            scalar& crowding = ofBody[node][0];
            crowding =
                room_[node] > 0
              ? max(crowding/room_[node] - 1 - overfillTolerance, scalar(0))
              : 0;
            crowded_ = crowded_ || crowding > 0;
        }
    }
}


template<int D>
Foam::vector Foam::materialPointMethod::shift
(
    const splineStencil<D>& stencil,
    const label field
) const
{
    lanes moment[D];
    stencil.mean(crowding_[field], moment);

    vector result(Zero);
    for (int k = 0; k < D; ++k)
    {
        // The gradient is 4/h times the first moment in spacings
        result[grid_.axes()[k]] = -4*strength*grid_.h()*moment[k][0];
    }

    const scalar most = maxShift*grid_.h();
    const scalar length = mag(result);
    return length > most ? most/length*result : result;
}


template void Foam::materialPointMethod::findCrowding<2>();
template void Foam::materialPointMethod::findCrowding<3>();
template Foam::vector Foam::materialPointMethod::shift<2>
(
    const splineStencil<2>&, const label
) const;
template Foam::vector Foam::materialPointMethod::shift<3>
(
    const splineStencil<3>&, const label
) const;
