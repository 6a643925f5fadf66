// SPDX-License-Identifier: GPL-3.0-or-later
// Which grains are missing, and which have only changed rank.

#include "lostGrainFinder.H"

#include "DynamicList.H"
#include "Pstream.H"
#include "pointField.H"

#include <algorithm>

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const label nGrains = 600;


//- The grains that this rank has in a round; each changes rank from one to the
//  next, but for every fifth
labelList held(const label round)
{
    DynamicList<label> ids;

    for (label id = 1; id <= nGrains; ++id)
    {
        const label rank = (id % 5 ? id/5 + round : id/5) % Pstream::nProcs();

        if (rank == Pstream::myProcNo())
        {
            ids.append(id);
        }
    }

    return labelList(std::move(ids));
}


//- Where a grain is, and how it moves
point place(const label id)
{
    return point(id, 2*id, -id);
}


lostGrainFinder noted(const labelList& ids)
{
    pointField places(ids.size());

    forAll(ids, i)
    {
        places[i] = place(ids[i]);
    }

    lostGrainFinder before;
    before.note(ids, places, -places);

    return before;
}

} // End anonymous namespace


TEST(ParallelLostGrainFinder, missesNoneThatOnlyChangedRank)
{
    const lostGrainFinder before(noted(held(0)));

    EXPECT_EQ(before.missing(held(0)).size(), 0);
    EXPECT_EQ(before.missing(held(1)).size(), 0);
}


TEST(ParallelLostGrainFinder, allRanksKnowEachGrainThatNoRankHas)
{
    const lostGrainFinder before(noted(held(0)));
    DynamicList<label> left;

    for (const label id : held(1))
    {
        if (id % 7 != 3)
        {
            left.append(id);
        }
    }
    // One that has come in meanwhile is not missed
    if (Pstream::master())
    {
        left.append(nGrains + 1);
    }

    const List<lostGrainFinder::record> missing(before.missing(left));
    labelList ids(missing.size());

    forAll(missing, i)
    {
        ids[i] = missing[i].first();
        EXPECT_EQ(missing[i].second().first(), place(ids[i]));
        EXPECT_EQ(missing[i].second().second(), -place(ids[i]));
    }

    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids.size(), 86);
    forAll(ids, i)
    {
        EXPECT_EQ(ids[i], 7*i + 3);
    }
}
