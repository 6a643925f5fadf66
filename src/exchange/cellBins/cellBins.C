// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cell of a point on this rank without knowing where to begin.

#include "cellBins.H"

namespace
{
    //- Bounds of each cell of the mesh [m]
    Foam::List<Foam::boundBox> cellBounds(const Foam::polyMesh& mesh)
    {
        Foam::List<Foam::boundBox> result(mesh.nCells());

        forAll(result, cell)
        {
            for (const Foam::label f : mesh.cells()[cell])
            {
                result[cell].add
                (
                    Foam::pointField(mesh.points(), mesh.faces()[f])
                );
            }
        }

        return result;
    }
}


Foam::cellBins::cellBins(const sphereOverlap& overlap)
:
    overlap_(overlap),
    walker_(overlap.walker()),
    box_(walker_.mesh().points(), false),
    n_(1, 1, 1),
    perLength_(Zero),
    tolerance_(1e-9*walker_.mesh().bounds().mag())
{
    const polyMesh& mesh = walker_.mesh();

    if (!mesh.nCells())
    {
        start_.setSize(2, Zero);
        return;
    }

    const List<boundBox> bounds(cellBounds(mesh));
    setNumbers(bounds);
    fill(bounds);
}


void Foam::cellBins::setNumbers(const UList<boundBox>& bounds)
{
    vector size(Zero);
    for (const boundBox& cell : bounds)
    {
        size += cell.span()/bounds.size();
    }

    // Where most cells are small ones: no more than two bins for a cell
    const scalar nBins = box_.volume()/(cmptProduct(size) + VSMALL);
    size *= cbrt(max(nBins/(2*bounds.size()), scalar(1)));

    for (direction k = 0; k < 3; ++k)
    {
        const scalar span = max(box_.span()[k], SMALL);
        const scalar n = std::round(span/max(size[k], SMALL));

        n_[k] = label(min(max(n, scalar(1)), scalar(1000)));
        perLength_[k] = n_[k]/span;
    }
}


void Foam::cellBins::fill(const UList<boundBox>& bounds)
{
    labelList count(n_.x()*n_.y()*n_.z(), Zero);

    // Twice over the cells: first how many there are in each bin, then which
    for (const bool counting : {true, false})
    {
        if (!counting)
        {
            start_.setSize(count.size() + 1, Zero);
            forAll(count, i)
            {
                start_[i + 1] = start_[i] + count[i];
            }
            cells_.setSize(start_.last());
            count = Zero;
        }

        forAll(bounds, cell)
        {
            // A cell that ends at a border of bins is not in the next one, save
            // for round-off
            const vector inset(vector::uniform(tolerance_));
            const labelVector from(bin(bounds[cell].min() + inset));
            const labelVector to(bin(bounds[cell].max() - inset));

            for (label k = from.z(); k <= to.z(); ++k)
            {
                for (label j = from.y(); j <= to.y(); ++j)
                {
                    for (label i = from.x(); i <= to.x(); ++i)
                    {
                        const label at = index(i, j, k);
                        if (!counting)
                        {
                            cells_[start_[at] + count[at]] = cell;
                        }
                        ++count[at];
                    }
                }
            }
        }
    }
}


inline Foam::labelVector Foam::cellBins::bin(const point& p) const
{
    labelVector result;

    for (direction k = 0; k < 3; ++k)
    {
        const scalar at = (p[k] - box_.min()[k])*perLength_[k];
        result[k] = min(max(label(at), 0), n_[k] - 1);
    }

    return result;
}


inline bool Foam::cellBins::near(const point& p) const
{
    for (direction k = 0; k < 3; ++k)
    {
        // Written so that NaN is not inside
        if
        (
            !(
                p[k] >= box_.min()[k] - tolerance_
             && p[k] <= box_.max()[k] + tolerance_
            )
        )
        {
            return false;
        }
    }

    return true;
}


Foam::label Foam::cellBins::find(const point& p) const
{
    if (!near(p))
    {
        return -1;
    }

    const labelVector at(bin(p));
    const label i = index(at.x(), at.y(), at.z());

    for (label c = start_[i]; c < start_[i + 1]; ++c)
    {
        if (walker_.inside(p, cells_[c]))
        {
            return cells_[c];
        }
    }

    scalar least = GREAT;
    label nearest = -1;

    for (label c = start_[i]; c < start_[i + 1]; ++c)
    {
        const scalar outside = walker_.outside(p, cells_[c]);

        if (outside < least)
        {
            least = outside;
            nearest = cells_[c];
        }
    }

    if (nearest >= 0 && least <= tolerance_ + walker_.warp(nearest))
    {
        return nearest;
    }

    // At a slanted or curved face the bin can hold a neighbour only
    if (nearest >= 0)
    {
        point q(p);
        const meshWalker::place end = walker_.walk(q, nearest);

        if
        (
            end.rank == Pstream::myProcNo()
         && walker_.outside(q, end.cell) <= tolerance_ + walker_.warp(end.cell)
        )
        {
            return end.cell;
        }
    }

    return -1;
}


template<class Condition>
Foam::label Foam::cellBins::firstAround
(
    const point& p,
    const Condition& is
) const
{
    if (!near(p))
    {
        return -1;
    }

    // Cells that reach into a bin by round-off are not listed there
    const vector around(vector::uniform(2*tolerance_));
    const labelVector from(bin(p - around));
    const labelVector to(bin(p + around));

    for (label k = from.z(); k <= to.z(); ++k)
    {
        for (label j = from.y(); j <= to.y(); ++j)
        {
            for (label i = from.x(); i <= to.x(); ++i)
            {
                const label at = index(i, j, k);

                for (label c = start_[at]; c < start_[at + 1]; ++c)
                {
                    if (is(cells_[c]))
                    {
                        return cells_[c];
                    }
                }
            }
        }
    }

    return -1;
}


Foam::label Foam::cellBins::findByShape(const point& p) const
{
    return firstAround
    (
        p,
        [&](const label cell) { return overlap_.inside(p, cell); }
    );
}


Foam::label Foam::cellBins::findAtWall(const point& p) const
{
    return firstAround
    (
        p,
        [&](const label cell)
        {
            for (const meshWalker::side& s : walker_.sides(cell))
            {
                const scalar beyond = (p & s.normal) - s.offset;
                const scalar most = s.warp + tolerance_;

                if
                (
                    s.next == -1
                 && mag(beyond) <= most
                 && overlap_.inside(p - 2*most*s.normal, cell)
                )
                {
                    return true;
                }
            }
            return false;
        }
    );
}
