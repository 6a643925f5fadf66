// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which grains are missing, and where they were last seen.

#include "rollCall.H"

#include "DynamicList.H"
#include "HashSet.H"
#include "ListListOps.H"
#include "PstreamCombineReduceOps.H"

void Foam::rollCall::note
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


Foam::List<Foam::rollCall::seen> Foam::rollCall::missing
(
    const UList<label>& id
) const
{
    const labelHashSet here(id);
    DynamicList<seen> notHere;

    forAll(id_, i)
    {
        if (!here.found(id_[i]))
        {
            notHere.append
            (
                seen(id_[i], Pair<vector>(position_[i], velocity_[i]))
            );
        }
    }

    List<List<seen>> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = notHere;
    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);

    const List<seen> all
    (
        ListListOps::combine<List<seen>>(ofRanks, accessOp<List<seen>>())
    );

    // Most of them are on another rank now
    labelList found(all.size(), Zero);
    forAll(all, i)
    {
        found[i] = here.found(all[i].first());
    }
    Pstream::listCombineGather(found, maxEqOp<label>());
    Pstream::listCombineScatter(found);

    DynamicList<seen> result;
    forAll(all, i)
    {
        if (!found[i])
        {
            result.append(all[i]);
        }
    }

    return List<seen>(std::move(result));
}
