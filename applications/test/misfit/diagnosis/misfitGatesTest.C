// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass before it is given: each gate, one by one.

#include "terminalOutput.H"
#include "testNumber.H"
#include "testedGates.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


namespace
{

//- True if the placebo moved the misfit in time
bool isMoved(const finding& f)
{
    return gateOf(f, "placebo").moved;
}

} // End anonymous namespace


TEST(misfitGates, aSensorIsNotBlamedWhereOthersPartTooThatItDoesNotMove)
{
    world w(20);
    vec added = vec::Zero(w.data.size());
    w.data.segments[0].of(added).setConstant(90);
    worldSampler s(truth(-1, 0), 300, added);
    s.mislabelHeldOut(1.3);
    const finding f(diagnose(s));
    show(f);
    EXPECT_FALSE(passes(f, "heldOut"));
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}


TEST(misfitGates, whatGainsTooLittleIsNotStated)
{
    settings set(worldSettings());
    set.evidence = 1e4;
    worldSampler s(truth(0, 0.7), 200, vec());
    s.holdNothingOut();
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_EQ(passes(f, "evidence"), false);
    EXPECT_EQ(f.verdict.kind, verdictKind::none);
    EXPECT_NE
    (
        describe(f).find("too little to say why: the best explanation, porePressure"),
        std::string::npos
    ) << describe(f);
}


TEST(misfitGates, anExperimentThatTestsIsAsUncertainAsOneThatValidates)
{
    settings set(worldSettings());
    set.replicates = 8;
    set.resolutions = {"mesh"};
    std::vector<heldOut> there;
    for (const bool tests : {false, true})
    {
        worldSampler s(truth(-1, 0), 300, vec());
        s.scatterReplicates(0.04);
        s.refine(0.02);
        if (tests)
        {
            s.testInB();
        }
        const finding f(diagnose(s, set));
        for (const heldOut& h : f.held())
        {
            if (h.experiment == "B")
            {
                there.push_back(h);
            }
        }
    }
    ASSERT_EQ(there.size(), 2);
    EXPECT_EQ(there[0].use, purpose::validation);
    EXPECT_EQ(there[1].use, purpose::test);
    EXPECT_NEAR((there[0].sigma - there[1].sigma).norm(), 0, 1e-9*there[0].sigma.norm());
    EXPECT_NEAR(there[0].squareBefore, there[1].squareBefore, 1e-9);

    // Much of it is scatter and numerics
    const scalar noise = 60/std::sqrt(10.0);
    EXPECT_GT(there[1].sigma[15], 1.2*noise);
}


TEST(misfitGates, otherReplicatesAreNoAlarmInAnotherExperiment)
{
    settings set(worldSettings());
    set.replicates = 20;
    set.commonRandomNumbers = 3;
    const label n = 40;
    label alarms = 0;
    for (label k = 0; k < n; ++k)
    {
        worldSampler s(truth(-1, 0), 5000 + k, vec());
        s.scatterReplicates(0.04);
        alarms += diagnose(s, set).verdict.kind != verdictKind::none;
    }
    testNumber("alarms of 40 nulls whose replicates scatter", alarms);
    EXPECT_LE(alarms, 4);
}


TEST(misfitGates, aParameterAtItsBoundIsUncertainInAnotherExperimentToo)
{
    // Gains that are a quarter off bring the release to its bound
    settings set(worldSettings());
    set.parameters[0].mean = set.parameters[0].measured = 0.05;
    set.parameters[0].lower = 0;
    label alarms = 0;
    label pinned = 0;
    for (label k = 0; k < 20; ++k)
    {
        vec x = truth(-1, 0);
        x[0] = 0.1;
        x[1] = 0;
        worldSampler s(x, 6000 + k, vec());
        s.weakenGains(0.25);
        const finding f(diagnose(s, set));
        alarms += f.verdict.kind != verdictKind::none;
        pinned += f.detection.parameters[0].pinned;
    }
    testNumber("of 20 nulls with a parameter at its bound", pinned);
    testNumber("alarms of these 20", alarms);
    EXPECT_GE(pinned, 10);
    EXPECT_LE(alarms, 2);
}


TEST(misfitGates, theLeadIsThatOfTheBestThatStatesTheSame)
{
    // The second one is too weak to be named
    vec x(truth(0, 0.7));
    x[world::nParameters + 2] = 0.1;
    worldSampler s(x, 200, vec());
    const finding f(diagnose(s));
    ASSERT_EQ(f.verdict.names, wordList({world::mechanism(0)}));
    scalar same = GREAT;
    scalar other = GREAT;
    for (const hypothesisFit& w : f.explained.all())
    {
        scalar& lowest = statistics::contains(w.what.mechanisms, 0) ? same : other;
        lowest = min(lowest, w.score);
    }
    ASSERT_LT(same, f.best().score);
    EXPECT_NEAR(gateOf(f, "gap").value/(other - same), 1, 0.01);
}


TEST(misfitGates, besideSomethingUnknownWhatIsNamedMustGainByItself)
{
    worldSampler s(truth(2, 0.1), 201, strangeWave(120));
    EXPECT_EQ(diagnose(s).verdict.kind, verdictKind::named);

    // More than it gains alone, less than both gain
    settings set(worldSettings());
    set.evidence = 150;
    worldSampler strict(truth(2, 0.1), 201, strangeWave(120));
    const finding f(diagnose(strict, set));
    show(f);
    EXPECT_EQ(failed(f), wordList({"alone"}));
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}


TEST(misfitGates, whereMostIsUnknownWhatIsLeftMustBeChance)
{
    settings set(worldSettings());
    set.adequacy = 0.2;
    worldSampler most(truth(1, 0.3), 200, strangeWave(200));
    EXPECT_TRUE(gateOf(diagnose(most, set), "adequacy").applies);
    worldSampler little(truth(2, 0.3), 200, strangeWave(120));
    const gate untested(gateOf(diagnose(little, set), "adequacy"));
    EXPECT_EQ(untested.kind, gateKind::adequacy);
    EXPECT_FALSE(untested.applies);
}


TEST(misfitGates, theMisfitIsMovedInTimeOnlyWhereNoHeldOutDataConfirmTheAnswer)
{
    worldSampler with(truth(0, 0.7), 200, vec());
    worldSampler without(truth(0, 0.7), 200, vec());
    without.holdNothingOut();
    worldSampler third(truth(1, 0.8), 3060, vec());

    // B confirms it, the one behind it does not
    worldSampler refuted(truth(0, 0.7), 200, vec());
    refuted.addContradiction();
    EXPECT_TRUE(isMoved(diagnose(refuted)));

    EXPECT_FALSE(isMoved(diagnose(with)));
    EXPECT_TRUE(isMoved(diagnose(without)));
    EXPECT_TRUE(isMoved(diagnose(third)));
}


TEST(misfitGates, whereTooMuchIsLeftThereIsMoreToItWhichCountsForTheConfidence)
{
    const vec added(strangeWave(75));
    settings set(worldSettings());
    worldSampler mild(truth(0, 0.7), 200, added);
    const finding enough(diagnose(mild, set));
    EXPECT_TRUE(passes(enough, "adequacy"));
    EXPECT_EQ(describe(enough).find("There is more to it"), std::string::npos);

    set.adequacy = 0.1;
    worldSampler strict(truth(0, 0.7), 200, added);
    const finding f(diagnose(strict, set));
    show(f);
    EXPECT_EQ(f.verdict.names, enough.verdict.names);
    EXPECT_NE(describe(f).find("There is more to it"), std::string::npos)
        << describe(f);
    const label more = groundNames.find("more");
    EXPECT_EQ(enough.verdict.grounds[more], 0);
    EXPECT_EQ(f.verdict.grounds[more], 1);
}


TEST(misfitGates, oneThatWasNeverEvaluatedHasNotPassed)
{
    gateList gates;
    gates.addNothing(gateKind::degradesHeldOut);
    EXPECT_TRUE(gates.passed(gateKind::degradesHeldOut));
    EXPECT_NE
    (
        refusal([&]{ gates.passed(gateKind::placebo); }).find("never tested"),
        std::string::npos
    );
}
