// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass in recordings that were held out, and in other experiments.

#include "terminalOutput.H"
#include "testNumber.H"
#include "testedGates.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitHeldOutGates, eachHeldOutExperimentMustConfirmIt)
{
    worldSampler agrees(truth(0, 0.7), 200, vec());
    EXPECT_EQ(diagnose(agrees).verdict.kind, verdictKind::named);

    // B confirms it, the one behind it does not
    worldSampler s(truth(0, 0.7), 200, vec());
    s.addContradiction();
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_TRUE(f.verdict.names.empty());
}


TEST(misfitHeldOutGates, withoutHeldOutDataItIsStatedThatNothingConfirmsIt)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.holdNothingOut();
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::named);
    EXPECT_NE(describe(f).find("No held-out data"), std::string::npos)
        << describe(f);

    worldSampler with(truth(0, 0.7), 200, vec());
    const finding confirmed(diagnose(with));
    EXPECT_EQ(describe(confirmed).find("No held-out data"), std::string::npos);
}


TEST(misfitHeldOutGates, whatIsNotMatchedYetIsStated)
{
    // A front that another formula slows: a third of the held-out misfit goes
    worldSampler s(truth(1, 0.8), 3060, vec());
    const finding f(diagnose(s));
    show(f);
    ASSERT_EQ(f.verdict.kind, verdictKind::named);
    for (const heldOut& h : f.held())
    {
        const bool output =
            describe(f).find("not yet match " + describe(h)) != std::string::npos;
        EXPECT_EQ(output, h.squareAfter > h.limitOfMatch) << describe(f);
    }
    EXPECT_GT(f.held()[0].squareAfter, f.held()[0].limitOfMatch);
}


TEST(misfitHeldOutGates, aMatchOfFewSamplesIsJudgedByChance)
{
    const rules limits;
    EXPECT_NEAR(matchLimit(5, limits), 3.02, 0.02);
    EXPECT_EQ(matchLimit(1000, limits), 1.5);
}


TEST(misfitHeldOutGates, fewHeldOutSamplesThatChanceLeavesNeitherRefuteNorConfirm)
{
    // A level before the surge that no mechanism changes
    worldSampler s(truth(0, 0.7), 200, vec());
    s.holdOutFew(5, 34);
    const finding f(diagnose(s));
    show(f);
    ASSERT_EQ(f.held().size(), 1);
    EXPECT_GT(f.held()[0].squareBefore, 1.8);
    EXPECT_LT(f.held()[0].squareBefore, 2.8);
    EXPECT_EQ(f.verdict.kind, verdictKind::named);
    EXPECT_EQ(gateOf(f, "heldOut").kind, gateKind::heldOut);
    EXPECT_FALSE(gateOf(f, "heldOut").applies);
    EXPECT_EQ(describe(f).find("not yet match"), std::string::npos) << describe(f);

    // More than chance leaves
    worldSampler far(truth(0, 0.7), 200, vec());
    far.holdOutFew(5, 55);
    const finding refuted(diagnose(far));
    EXPECT_FALSE(passes(refuted, "heldOut"));
    EXPECT_EQ(refuted.verdict.kind, verdictKind::unknown);
}


TEST(misfitHeldOutGates, whatHeldOutChannelsDoNotShowIsNotNamedAndChanceDegradesNothing)
{
    // Where nothing was wrong before, held-out channels can only get worse
    for (const scalar share : {1.0, 0.1})
    {
        const label n = 20;
        label refused = 0;
        for (label seed = 1; seed <= n; ++seed)
        {
            worldSampler s(truth(0, 0.25), seed, vec());
            s.holdOutLessOf(truth(0, 0.25), share);
            const finding f(diagnose(s));
            refused += !passes(f, "degradesHeldOut");
            EXPECT_FALSE
            (
                f.verdict.kind == verdictKind::named && !passes(f, "degradesHeldOut")
            );
            EXPECT_EQ
            (
                describe(f).find("match of held-out channels worse")
             != std::string::npos,
                f.verdict.kind == verdictKind::unknown && !passes(f, "degradesHeldOut")
            ) << describe(f);
        }
        testNumber(share == 1 ? "refused, right" : "refused, wrong", refused);
        EXPECT_TRUE(share == 1 ? refused <= 0.05*n : refused >= 0.5*n) << refused;
    }
}


TEST(misfitHeldOutGates, whatSomethingUnknownDoesToHeldOutChannelsIsNotBlamedOnTheName)
{
    // It raises what is fitted and lowers what is held out
    vec added = strangeWave(120);
    const world w(20);
    w.data.segments[2].of(added) *= -1;
    const label n = 20;
    label refused = 0;
    for (label seed = 1; seed <= n; ++seed)
    {
        worldSampler s(truth(2, 0.25), seed, added);
        s.holdOutLessOf(truth(2, 0.25), 1);
        refused += !passes(diagnose(s), "degradesHeldOut");
    }
    testNumber("refused beside something unknown", refused);
    EXPECT_LE(refused, 0.3*n);
}


TEST(misfitHeldOutGates, anExperimentThatFailsIsNoDisagreement)
{
    worldSampler s(truth(-1, 0), 100, vec());
    s.failAlwaysIn("B");
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_EQ(f.tests.gates.failedExperiments(), wordList({"B"}));
    EXPECT_TRUE(f.failedRuns.size());
    EXPECT_LT(f.verdict.confidence, 0.7);
    EXPECT_EQ(failed(f), wordList({"computed"}));
}


TEST(misfitHeldOutGates, anExperimentThatFailsHidesNoOtherThatRefutes)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.mislabelHeldOut(1.6);
    s.failIn("B");
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_FALSE(passes(f, "heldOut"));
    EXPECT_EQ(f.tests.gates.failedExperiments(), wordList({"B"}));
}


TEST(misfitHeldOutGates, whatAFinerMeshChangesInAnExperimentMustBeKnownThere)
{
    settings set(worldSettings());
    set.resolutions = {"mesh"};
    worldSampler s(truth(0, 0.7), 200, vec());
    s.refine(0.01);
    s.failFiner("B");
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_EQ(failed(f), wordList({"computed"}));
    EXPECT_EQ(f.tests.gates.failedExperiments(), wordList({"B"}));
}


TEST(misfitHeldOutGates, whereOnlyHeldOutDataPartItIsNotStatedThatNothingIsMissing)
{
    world w(20);
    worldSampler s(truth(-1, 0), 100, vec());
    s.mislabelHeldOut(1.3);
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_FALSE(passes(f, "heldOut"));
    EXPECT_TRUE(passes(f, "transfer"));
    EXPECT_NE(describe(f).find("held-out ones do not"), std::string::npos)
        << describe(f);
    EXPECT_TRUE(f.verdict.strengths.empty());

    worldSampler agrees(truth(-1, 0), 100, vec());
    EXPECT_EQ(diagnose(agrees).held().size(), 2);
}


TEST(misfitHeldOutGates, chanceOfASquareIsThatOfItsDistribution)
{
    // Upper percentiles of chi-squared over its degrees of freedom
    EXPECT_NEAR(statistics::chanceOfSquare(10, 0.05), 1.8307, 0.01);
    EXPECT_NEAR(statistics::chanceOfSquare(40, 0.01), 1.5923, 0.005);
    EXPECT_NEAR(statistics::chanceOfSquare(1, 0.05), 3.841, 0.1);
    EXPECT_NEAR(statistics::chanceOfSquare(100, 0.5), 0.9933, 0.001);
}


TEST(misfitHeldOutGates, nothingIsNotStatedWhereHeldOutDataPartToo)
{
    settings set(worldSettings());
    set.evidence = 1e4;
    worldSampler s(truth(0, 0.7), 200, vec());
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_EQ(passes(f, "evidence"), false);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}
