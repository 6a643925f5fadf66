// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over the spheres of each clump, whatever ranks they are on.

#include "clumpSums.H"

#include "HashSet.H"
#include "Tuple2.H"
#include "swapLists.H"

namespace
{
    using namespace Foam;

    typedef Tuple2<label, Pair<vector>> part;

    void addTo(Map<Pair<vector>>& sums, const label clump, const Pair<vector>& value)
    {
        Pair<vector>& sum = sums(clump, Pair<vector>(Zero, Zero));
        sum.first() += value.first();
        sum.second() += value.second();
    }
}


Foam::Map<Foam::Pair<Foam::vector>> Foam::clumpSums::sum
(
    const UList<vector>& first,
    const UList<vector>& second
) const
{
    Map<Pair<vector>> here;

    forAll(clump_, i)
    {
        if (clump_[i] > 0)
        {
            addTo(here, clump_[i], Pair<vector>(first[i], second[i]));
        }
    }
    if (!Pstream::parRun())
    {
        return here;
    }

    List<DynamicList<part>> toMeet(Pstream::nProcs());
    for (const label clump : here.sortedToc())
    {
        toMeet[clump % Pstream::nProcs()].append(part(clump, here[clump]));
    }
    List<List<part>> met(swapLists(toMeet));

    // By rank, so that their order is always the same
    Map<Pair<vector>> all;
    for (const List<part>& from : met)
    {
        for (const part& p : from)
        {
            addTo(all, p.first(), p.second());
        }
    }
    for (List<part>& from : met)
    {
        for (part& p : from)
        {
            p.second() = all[p.first()];
        }
    }
    for (const List<part>& from : swapLists(std::move(met)))
    {
        for (const part& p : from)
        {
            here.set(p.first(), p.second());
        }
    }

    return here;
}


Foam::label Foam::nClumps(const UList<label>& clump)
{
    labelHashSet here(clump);
    here.erase(0);
    List<DynamicList<label>> toMeet(Pstream::nProcs());

    for (const label c : here.sortedToc())
    {
        toMeet[c % Pstream::nProcs()].append(c);
    }

    labelHashSet met;
    for (const List<label>& from : swapLists(toMeet))
    {
        met.insert(from);
    }

    return returnReduce(met.size(), sumOp<label>());
}
