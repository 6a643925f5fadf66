// SPDX-License-Identifier: GPL-3.0-or-later
// Gathering from cells and spreading to them.

#include "swapLists.H"

template<class T>
Foam::List<T> Foam::cellWeights::withRemoteCells(List<T>&& cells) const
{
    List<T> values(std::move(cells));

    if (Pstream::parRun())
    {
        List<List<T>> toRanks(Pstream::nProcs());

        forAll(toRanks, rank)
        {
            toRanks[rank] = List<T>(UIndirectList<T>(values, ours_[rank]));
        }

        for (const List<T>& from : swapLists(std::move(toRanks)))
        {
            values.append(from);
        }
    }

    return values;
}


template<class T>
inline T Foam::cellWeights::mean
(
    const UList<T>& reached,
    const label grain
) const
{
    const label last = start_[grain + 1];
    label i = start_[grain];

    T sum(weights_[i]*reached[slots_[i]]);
    while (++i < last)
    {
        sum += weights_[i]*reached[slots_[i]];
    }

    return sum;
}


template<class T>
Foam::List<T> Foam::cellWeights::noSums() const
{
    label nSlots = nCells_;
    for (const labelList& cells : theirs_)
    {
        nSlots += cells.size();
    }

    return List<T>(nSlots, T(Zero));
}


template<class T>
inline void Foam::cellWeights::add
(
    UList<T>& sums,
    const label grain,
    const T& value
) const
{
    for (label i = start_[grain]; i < start_[grain + 1]; ++i)
    {
        sums[slots_[i]] += weights_[i]*value;
    }
}


template<class T>
void Foam::cellWeights::sumOnOwners(List<T>& sums) const
{
    if (!Pstream::parRun())
    {
        return;
    }

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
