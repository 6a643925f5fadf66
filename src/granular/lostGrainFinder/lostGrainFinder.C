// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which grains are missing, and where they were last seen.

#include "lostGrainFinder.H"

#include "DynamicList.H"
#include "HashSet.H"
#include "ListListOps.H"
#include "Map.H"
#include "foamCompatibility.H"
#include "swapLists.H"

void Foam::lostGrainFinder::note
(
    const UList<label>& id,
    const UList<vector>& position,
    const UList<vector>& velocity
)
{
    id_ = id;
    position_ = position;
    velocity_ = velocity;
}


namespace
{
    //- Ids, each for the rank that hears of it from whoever lost it and from
    //  whoever got it
    Foam::List<Foam::List<Foam::label>> toMeet(const Foam::labelUList& ids)
    {
        using namespace Foam;

        List<DynamicList<label>> toRanks(Pstream::nProcs());

        for (const label id : ids)
        {
            toRanks[id % Pstream::nProcs()].append(id);
        }

        return swapLists(toRanks);
    }
}


Foam::List<Foam::lostGrainFinder::record> Foam::lostGrainFinder::missing
(
    const UList<label>& id
) const
{
    labelHashSet newcomers(id);
    DynamicList<label> notHere;
    Map<label> noted;

    forAll(id_, i)
    {
        if (!newcomers.erase(id_[i]))
        {
            notHere.append(id_[i]);
            noted.insert(id_[i], i);
        }
    }

    // Most of them are on another rank now
    labelHashSet elsewhere;
    for (const List<label>& from : toMeet(newcomers.toc()))
    {
        elsewhere.insert(from);
    }

    List<List<label>> answers(toMeet(notHere));
    for (List<label>& ids : answers)
    {
        inplaceSubsetList
        (
            ids,
            [&](const label gone){ return !elsewhere.found(gone); }
        );
    }

    List<List<record>> all(Pstream::nProcs());
    DynamicList<record> lost;

    for (const List<label>& ids : swapLists(std::move(answers)))
    {
        for (const label gone : ids)
        {
            const label i = noted[gone];
            lost.append(record(gone, Pair<vector>(position_[i], velocity_[i])));
        }
    }

    all[Pstream::myProcNo()] = lost;
    Pstream::gatherList(all);
    compatibility::broadcast(all);

    return ListListOps::combine<List<record>>(all, accessOp<List<record>>());
}
