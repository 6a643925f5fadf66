// SPDX-License-Identifier: GPL-3.0-or-later
// Gathering from cells and spreading to them.

#include "swapLists.H"

template<class T>
Foam::Field<T> Foam::cellWeights::gather(const UList<T>& cells) const
{
    Field<T> values(nCells_);
    SubList<T>(values, nCells_) = SubList<T>(cells, nCells_);

    if (Pstream::parRun())
    {
        List<List<T>> toRanks(Pstream::nProcs());

        forAll(toRanks, rank)
        {
            toRanks[rank] = List<T>(UIndirectList<T>(cells, ours_[rank]));
        }

        for (const List<T>& from : swapLists(std::move(toRanks)))
        {
            values.append(from);
        }
    }

    Field<T> result(nGrains());

    forAll(result, grain)
    {
        T sum(Zero);
        for (label i = start_[grain]; i < start_[grain + 1]; ++i)
        {
            sum += weights_[i]*values[slots_[i]];
        }
        result[grain] = sum;
    }

    return result;
}


template<class T>
Foam::Field<T> Foam::cellWeights::spread(const UList<T>& grains) const
{
    label nSlots = nCells_;
    for (const labelList& cells : theirs_)
    {
        nSlots += cells.size();
    }

    Field<T> sums(nSlots, Zero);

    forAll(grains, grain)
    {
        for (label i = start_[grain]; i < start_[grain + 1]; ++i)
        {
            sums[slots_[i]] += weights_[i]*grains[grain];
        }
    }

    if (Pstream::parRun())
    {
        List<List<T>> toRanks(Pstream::nProcs());
        label at = nCells_;

        forAll(toRanks, rank)
        {
            toRanks[rank] = SubList<T>(sums, theirs_[rank].size(), at);
            at += theirs_[rank].size();
        }

        const List<List<T>> fromRanks(swapLists(std::move(toRanks)));

        forAll(fromRanks, rank)
        {
            forAll(fromRanks[rank], i)
            {
                sums[ours_[rank][i]] += fromRanks[rank][i];
            }
        }

        sums.setSize(nCells_);
    }

    return sums;
}
