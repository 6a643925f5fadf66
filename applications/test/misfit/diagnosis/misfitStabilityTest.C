// SPDX-License-Identifier: GPL-3.0-or-later
// Answers that depend on one channel: what wins without it, and how that is reported.

#include "worldDiagnosis.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Another mechanism acts at one gauge only. What is held out shows that of the
//  first gauge, if anything is
finding ofTwoGauges
(
    const label atThird,
    const label atFirst,
    const bool twins,
    const bool held = false
)
{
    world w(20);
    vec added = vec::Zero(w.data.size());
    for (const auto& at : {std::make_pair(3, atThird), std::make_pair(1, atFirst)})
    {
        const segment& s = w.data.segments[at.first];
        s.of(added) = s.of(w(truth(at.second, 0.9)) - w(truth(-1, 0)));
    }
    settings set(worldSettings());
    set.faults.clear();
    set.adequacy = 1e-9;
    worldSampler s(truth(-1, 0), 200, added);
    held ? s.holdOutLessOf(truth(atFirst, 0.9), 2) : s.holdNothingOut();
    if (twins)
    {
        s.makeTwins();
    }
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_FALSE(passes(f, "stability"));
    return f;
}

} // End anonymous namespace


TEST(misfitStability, whatAnotherChannelContradictsIsNotNamed)
{
    // Each of two mechanisms acts at one gauge only
    world w(20);
    vec added = vec::Zero(w.data.size());
    for (const auto& at : {std::make_pair(3, 0), std::make_pair(1, 1)})
    {
        const vec effect = w(truth(at.second, 0.9)) - w(truth(-1, 0));
        const segment& s = w.data.segments[at.first];
        s.of(added) = s.of(effect);
    }
    settings set(worldSettings());
    set.faults.clear();
    set.pairs = false;
    worldSampler s(truth(-1, 0), 200, added);
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_EQ(passes(f, "stability"), false);
    EXPECT_NE(f.verdict.kind, verdictKind::named);
}


TEST(misfitStability, whatWinsWithoutAChannelIsInTheSet)
{
    const finding f(ofTwoGauges(0, 1, false));
    expectAnswer(f, "set", {"slowFront", "longTail"});
    EXPECT_FALSE(f.tests.winners.empty());
    EXPECT_TRUE(f.verdict.weakened);
    EXPECT_EQ(f.verdict.measure.what, advice::kind::check);
}


TEST(misfitStability, thatASetDependsOnAChannelCountsAgainstIt)
{
    const finding f(ofTwoGauges(4, 0, false, true));
    EXPECT_EQ(f.verdict.kind, verdictKind::set);
    EXPECT_TRUE(passes(f, "heldOut"));
    EXPECT_FALSE(passes(f, "stability"));
    EXPECT_LT(f.verdict.grounds[groundNames.find("gates")], 1);
}


TEST(misfitStability, aSetThatDependsOnAChannelStatesWhereBothAtOnceAreAsGood)
{
    const finding both(ofTwoGauges(0, 1, false));
    const finding one(ofTwoGauges(4, 0, false));
    ASSERT_EQ(both.verdict.kind, verdictKind::set);
    ASSERT_EQ(one.verdict.kind, verdictKind::set);
    EXPECT_EQ(ofTwoGauges(4, 1, false).verdict.kind, verdictKind::set);
    EXPECT_NE(describe(both).find(", or both. "), std::string::npos)
        << describe(both);
    EXPECT_EQ(describe(one).find(", or both"), std::string::npos) << describe(one);
}


TEST(misfitStability, aSetThatDependsOnAChannelBesidesStillStatesWhatToMeasure)
{
    const finding f(ofTwoGauges(4, 0, true));
    ASSERT_EQ(f.verdict.kind, verdictKind::set);
    EXPECT_FALSE(f.verdict.weakened);
    ASSERT_FALSE(f.tests.winners.empty());
    EXPECT_EQ(f.tests.winners.front().channel, "P2");
    EXPECT_TRUE(hasAll(f.tests.winners.front().explanation.what, {4}));
    EXPECT_NE(f.verdict.measure.what, advice::kind::nothing);
    EXPECT_NE(f.verdict.measure.what, advice::kind::check);
}
