// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnosis makes of runs in which the solver fails or differs from the surface.

#include "worldDiagnosis.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitFailedRuns, anExperimentInWhichTheSolverFailsConfirmsNothing)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.failIn("B");
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}


TEST(misfitFailedRuns, whatWasNotRunAsItWasFittedIsNotNamed)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.failBetween(0);
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_FALSE(f.verdict.state);
    EXPECT_FALSE(passes(f, "computed"));
    EXPECT_NE(describe(f).find("solver failed"), std::string::npos) << describe(f);
}


TEST(misfitFailedRuns, aStepThatFailsGoesBackToAStateThatRan)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.failBetween(3);
    const finding f(diagnose(s));
    show(f);
    expectAnswer(f, "named", {world::mechanism(0)});
    ASSERT_TRUE(f.verdict.state);
    EXPECT_LT(s.nearest(*f.verdict.state), 0.05);
}


TEST(misfitFailedRuns, whatTheSolverRefutesGivesWayToTheNextBest)
{
    // By the surface alone the two are alike
    settings set(worldSettings());
    set.refit = 0;
    set.pairs = false;
    for (label idle = 0; idle < 2; ++idle)
    {
        worldSampler s(truth(0, 0.7), 200, vec());
        s.makeTwins();
        s.idleBetween(idle);
        const finding f(diagnose(s, set));
        expectAnswer(f, "named", {world::mechanism(1 - idle)});
        ASSERT_EQ(f.verdict.strengths.size(), 1);
        EXPECT_EQ(f.verdict.strengths[0].name, world::mechanism(1 - idle));
        EXPECT_NEAR(f.verdict.strengths[0].value, 0.7, 0.2);
        ASSERT_TRUE(f.verdict.state);
        EXPECT_TRUE(f.verdict.state->strengths.found(world::mechanism(1 - idle)));
    }
}


TEST(misfitFailedRuns, aFailedResolutionStopsItAndAFailedReplicateIsReported)
{
    settings set(worldSettings());
    set.resolutions = {"mesh"};
    worldSampler same(truth(-1, 0), 100, vec());
    EXPECT_THROW(diagnose(same, set), Foam::error);

    worldSampler finer(truth(-1, 0), 100, vec());
    finer.failFiner();
    EXPECT_THROW(diagnose(finer, set), Foam::error);

    set.resolutions.clear();
    set.replicates = 2;
    set.commonRandomNumbers = 1;
    worldSampler one(truth(-1, 0), 100, vec());
    one.failReplicate(1);
    EXPECT_THROW(diagnose(one, set), Foam::error);

    set.replicates = 4;
    set.commonRandomNumbers = 2;
    worldSampler common(truth(-1, 0), 100, vec());
    common.failReplicate(1);
    try
    {
        diagnose(common, set);
        FAIL();
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("with common random numbers"), std::string::npos);
    }

    worldSampler other(truth(-1, 0), 100, vec());
    other.failReplicate(2);
    const finding f(diagnose(other, set));
    ASSERT_EQ(f.failedRuns.size(), 2);
    EXPECT_NE(describe(f.failedRuns[0]).find("replicate 2"), std::string::npos);
    EXPECT_NE(describe(f.failedRuns[1]).find("experiment B"), std::string::npos);
}


TEST(misfitFailedRuns, ofSeveralRunsWithAnotherMeshOneMayFail)
{
    settings set(worldSettings());
    set.resolutions = {"mesh"};
    set.chaotic = true;
    set.replicates = 4;
    set.commonRandomNumbers = 1;
    set.resolutionReplicates = 3;
    worldSampler s(truth(-1, 0), 100, vec());
    s.refine(0.01);
    s.failReplicate(2);
    const finding f(diagnose(s, set));
    ASSERT_EQ(f.failedRuns.size(), 4);
    EXPECT_NE
    (
        describe(f.failedRuns[1]).find("replicate 2, other mesh"), std::string::npos
    );
}


TEST(misfitFailedRuns, twoReplicatesThatAreTheSameAreAnError)
{
    // The surge in closed form has no grains: all its replicates are alike
    settings set(worldSettings());
    set.replicates = 2;
    worldSampler s(truth(-1, 0), 100, vec());
    EXPECT_THROW(diagnose(s, set), Foam::error);
}


TEST(misfitFailedRuns, aCandidateThatCrashesTheSolverDropsOut)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.crashWith(3);
    const finding f(diagnose(s));
    EXPECT_EQ(f.verdict.kind, verdictKind::named);
    ASSERT_EQ(f.candidates.dropped.size(), 1);
    EXPECT_EQ(f.candidates.dropped[0].name, "gate");
    EXPECT_NE
    (
        describe(f.candidates.dropped[0]).find("floating point"), std::string::npos
    );
}
