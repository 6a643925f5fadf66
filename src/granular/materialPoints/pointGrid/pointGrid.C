// SPDX-License-Identifier: GPL-3.0-or-later
// The uniform grid on which material points exchange momentum.

#include "pointGrid.H"

#include "Pstream.H"
#include "error.H"

void Foam::pointGrid::fit(const label k)
{
    const direction d = axes_[k];
    const scalar span = box_.max()[d] - box_.min()[d];
    const scalar cells = span/h_;

    if (!periodic_[k])
    {
        nCells_[k] = label(std::ceil(cells - 1e-6)) + 1 + 2*margin;
        origin_[d] = box_.min()[d] - margin*h_;
        return;
    }

    nCells_[k] = label(std::round(cells));
    origin_[d] = box_.min()[d] + 0.5*h_;

    if (mag(cells - nCells_[k]) > 1e-6*cells || nCells_[k] < 3)
    {
        FatalErrorInFunction
            << "The mesh repeats itself along " << "xyz"[d] << " after "
            << span << " m, which is " << cells << " cells of the points." << nl
            << "    Give materialPoints/cellSize as that length over a whole"
            << " number, 3 or more." << exit(FatalError);
    }
}


void Foam::pointGrid::cutSlabs()
{
    const label n = cut_ ? Pstream::nProcs() : 1;

    if (nCells_[0] < 2*n)
    {
        FatalErrorInFunction
            << "The grid of the points has " << nCells_[0] << " cells along "
            << "xyz"[axes_[0]] << ", its longest side, for " << n
            << " ranks, which need 2 each." << nl
            << "    Take fewer ranks or a smaller materialPoints/cellSize."
            << exit(FatalError);
    }

    slabs_.setSize(n + 1);
    for (label rank = 0; rank <= n; ++rank)
    {
        slabs_[rank] = nCells_[0]*rank/n;
    }

    const label me = cut_ ? Pstream::myProcNo() : 0;
    first_ = slabs_[me];
    last_ = slabs_[me + 1];
}


Foam::pointGrid::pointGrid
(
    const boundBox& box,
    const scalar h,
    const Vector<bool>& solved,
    const Vector<bool>& periodic,
    const bool cut
)
:
    h_(h),
    nDims_(0),
    axes_(direction(0)),
    box_(box),
    origin_(box.midpoint()),
    nCells_(1),
    periodic_(false),
    cut_(cut && Pstream::parRun()),
    first_(0),
    last_(0),
    stride_(0),
    nNodes_(0)
{
    for (direction d = 0; d < 3; ++d)
    {
        if (solved[d])
        {
            axes_[nDims_++] = d;
        }
    }

    if (nDims_ < 2)
    {
        FatalErrorInFunction
            << "Material points need a mesh with two or three directions that"
            << " are solved, but this one has " << nDims_ << '.'
            << exit(FatalError);
    }

    // Slabs along the longest side; planes of nodes of a slab are one piece
    for (label k = 1; k < nDims_; ++k)
    {
        if (box.span()[axes_[k]] > (1 + 1e-6)*box.span()[axes_[0]])
        {
            std::swap(axes_[0], axes_[k]);
        }
    }

    for (label k = 0; k < nDims_; ++k)
    {
        periodic_[k] = periodic[axes_[k]];
        fit(k);
    }

    cutSlabs();

    nNodes_ = 1;
    for (label k = nDims_ - 1; k >= 0; --k)
    {
        stride_[k] = nNodes_;
        nNodes_ *= (k ? nCells_[k] : last_ - first_) + 2;
    }
}


Foam::scalar Foam::pointGrid::cubeVolume(const scalar edge) const
{
    const vector span(box_.span());
    scalar volume = span.x()*span.y()*span.z();

    for (label k = 0; k < nDims_; ++k)
    {
        volume *= edge/span[axes_[k]];
    }

    return volume;
}


Foam::FixedList<Foam::label, 2> Foam::pointGrid::neighbours() const
{
    FixedList<label, 2> result(-1);

    if (cut_)
    {
        const label me = Pstream::myProcNo();
        const label last = Pstream::nProcs() - 1;
        const label around = periodic_[0] ? 1 : 0;
        result[0] = me > 0 ? me - 1 : around*(last + 1) - 1;
        result[1] = me < last ? me + 1 : around - 1;
    }

    return result;
}


Foam::label Foam::pointGrid::rankOf(const label cell) const
{
    if (cell < 0 || cell >= nCells_[0])
    {
        return -1;
    }

    if (!cut_)
    {
        return Pstream::myProcNo();
    }

    // The most frequent case
    if (cell >= first_ && cell < last_)
    {
        return Pstream::myProcNo();
    }

    label rank = 0;
    while (cell >= slabs_[rank + 1])
    {
        ++rank;
    }
    return rank;
}


Foam::FixedList<Foam::label, 3> Foam::pointGrid::numbers
(
    const label node
) const
{
    FixedList<label, 3> result(0);
    label rest = node;

    for (label k = 0; k < nDims_; ++k)
    {
        result[k] = rest/stride_[k] - 1 + (k ? 0 : first_);
        rest %= stride_[k];
    }

    return result;
}


Foam::label Foam::pointGrid::node(const FixedList<label, 3>& numbers) const
{
    label result = 0;

    for (label k = 0; k < nDims_; ++k)
    {
        result += (numbers[k] + 1 - (k ? 0 : first_))*stride_[k];
    }

    return result;
}


Foam::point Foam::pointGrid::position(const label node) const
{
    const FixedList<label, 3> at(numbers(node));
    point result(origin_);

    for (label k = 0; k < nDims_; ++k)
    {
        result[axes_[k]] += at[k]*h_;
    }

    return result;
}


bool Foam::pointGrid::owns(const label node) const
{
    const FixedList<label, 3> at(numbers(node));
    bool result = true;

    for (label k = 0; k < nDims_; ++k)
    {
        // Nodes beyond the last cells belong to who has these
        const label begin = k ? 0 : first_;
        const label end = k ? nCells_[k] : last_;
        const bool below = at[k] < begin && (begin > 0 || periodic_[k]);
        const bool above = at[k] >= end && (end < nCells_[k] || periodic_[k]);

        result = result && !below && !above;
    }

    return result;
}


void Foam::pointGrid::wrap(point& p) const
{
    for (label k = 0; k < nDims_; ++k)
    {
        const direction d = axes_[k];

        if (periodic_[k] && (p[d] < box_.min()[d] || p[d] >= box_.max()[d]))
        {
            const scalar span = box_.max()[d] - box_.min()[d];
            p[d] -= span*std::floor((p[d] - box_.min()[d])/span);

        }

        // The last cell ends before the box by what fit() allows or by a rounding:
        // what is beyond is in the first one, whatever rounding does
        const scalar at = coordinate(p, k);
        if (periodic_[k] && (at >= nCells_[k] - 0.5 || at < -0.5))
        {
            p[d] = box_.min()[d] + 1e-9*h_;
        }
    }
}


bool Foam::pointGrid::holds(const point& p) const
{
    bool result = true;

    for (label k = 0; k < nDims_; ++k)
    {
        const scalar at = coordinate(p, k);
        result = result && at >= -0.5 && at < nCells_[k] - 0.5;
    }

    return result;
}
