// SPDX-License-Identifier: GPL-3.0-or-later
// Whole diagnoses of a surge in closed form, whose truth has other formulas
// than the library: the verdict and its words.

#include "report.H"
#include "testNumber.H"
#include "worldDiagnosis.H"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitDiagnosis, aMistunedModelLacksNothing)
{
    label none = 0;
    for (label k = 0; k < 5; ++k)
    {
        worldSampler s(truth(-1, 0), 100 + k, vec());
        const finding f(diagnose(s));
        none += f.verdict.kind == verdictKind::none;
        if (f.verdict.kind != verdictKind::none)
        {
            show(f);
        }
    }
    EXPECT_EQ(none, 5);
}


TEST(misfitDiagnosis, whatWasMeasuredOfAParameterLeavesThePlannedRuns)
{
    for (const label ensemble : {0, 60})
    {
        settings before(worldSettings());
        before.trainingEnsemble = ensemble;
        settings measured(before);
        measured.parameters[0].measured = 0.06;
        measured.parameters[0].measuredDeviation = 0.002;
        worldSampler s(truth(-1, 0), 110, vec());
        const List<plannedStage> with(plan(s, measured));
        const List<plannedStage> without(plan(s, before));
        ASSERT_EQ(with.size(), without.size());
        forAll(with, i)
        {
            ASSERT_EQ(with[i].states.size(), without[i].states.size());
            forAll(with[i].states, k)
            {
                EXPECT_EQ(describe(with[i].states[k]), describe(without[i].states[k]));
            }
        }
    }
}


TEST(misfitDiagnosis, whatWasMeasuredOfAParameterHoldsTheFit)
{
    // The release is 0.06 more than that of the runs
    worldSampler s(truth(-1, 0), 110, vec());
    settings near(worldSettings());
    near.parameters[0].measured = 0.04;
    near.parameters[0].measuredDeviation = 0.03;
    const finding f(diagnose(s, near));
    EXPECT_EQ(f.verdict.kind, verdictKind::none);
    EXPECT_EQ(f.detection.parameters[0].before, 0.04);
    EXPECT_EQ(f.detection.parameters[0].prior, 0.03);
    EXPECT_NEAR(f.detection.parameters[0].value, 0.06, 0.01);

    // What the parameter may not be is something that is missing
    settings wrong(near);
    wrong.parameters[0].measured = -0.06;
    wrong.parameters[0].measuredDeviation = 0.002;
    EXPECT_NE(diagnose(s, wrong).verdict.kind, verdictKind::none);
}


TEST(misfitDiagnosis, aMechanismIsNamedAlthoughItsFormulaDiffers)
{
    for (label m = 0; m < 4; ++m)
    {
        worldSampler s(truth(m, 0.7), 200 + m, vec());
        const finding f(diagnose(s));
        show(f);
        EXPECT_EQ(f.verdict.kind, verdictKind::named) << world::mechanism(m);
        EXPECT_EQ(f.verdict.names, wordList({world::mechanism(m)}));
        EXPECT_GE(f.verdict.confidence, leastOfAName());
        EXPECT_FALSE(f.verdict.located.empty());
        ASSERT_EQ(f.held().size(), 2);
        EXPECT_LT(f.held()[1].squareAfter, f.held()[1].squareBefore);
    }
}


TEST(misfitDiagnosis, aNamedEffectIsLocatedWithoutMostOfTheNoise)
{
    const settings set(worldSettings());
    const vec with = truth(0, 0.5);
    const world w(20);
    std::vector<int> fitted;
    w.data.without(2, fitted);
    const vec effect = vec(w(with, 1) - w(truth(-1, 0), 1))(fitted);

    // F1 of the samples at which what the parameters leave of the effect is
    // beyond two deviations
    scalar both = 0;
    scalar lengths = 0;
    for (label k = 0; k < 6; ++k)
    {
        worldSampler s(with, 300 + k, vec());
        const visibility v(visible(s, set));
        const vec left = v.all*v.calibrated.ldlt().solve(effect);
        const finding f(diagnose(s, set));
        ASSERT_EQ(f.verdict.kind, verdictKind::named);
        labelHashSet found;
        for (const place& p : f.verdict.located)
        {
            for (label i = p.where.begin; i < p.where.end; ++i)
            {
                found.insert(f.detection.data.segments[p.where.segment].first + i);
            }
        }
        lengths += found.size();
        for (label i = 0; i < left.size(); ++i)
        {
            if (mag(left[i]) > 2*std::sqrt(v.all(i, i)))
            {
                ++lengths;
                both += found.found(i);
            }
        }
    }

    // From the recordings alone: 0.66
    EXPECT_GT(2*both/lengths, 0.8);
}


TEST(misfitDiagnosis, theStateThatIsNamedIsReported)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    const finding f(diagnose(s));
    ASSERT_TRUE(f.verdict.state);
    EXPECT_NEAR
    (
        f.verdict.state->strengths[world::mechanism(0)],
        f.verdict.strengths[0].value, 1e-9
    );
}


TEST(misfitDiagnosis, sensorsAloneCanBeExamined)
{
    settings set(worldSettings());
    set.parameters.clear();
    set.candidates.clear();
    world w(20);
    vec added = vec::Zero(w.data.size());
    w.data.segments[0].of(added).setConstant(90);
    worldSampler s(vec::Zero(world::nParameters + world::nMechanisms), 300, added);
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::sensor);
}


TEST(misfitDiagnosis, whatTheseChannelsCannotSeparateIsASet)
{
    for (const bool confirmed : {true, false})
    {
        worldSampler s(truth(0, 0.7), 200, vec());
        s.makeTwins();
        if (!confirmed)
        {
            s.holdNothingOut();
        }
        const finding f(diagnose(s));
        expectAnswer(f, "set", {world::mechanism(0), world::mechanism(1)});
        EXPECT_EQ(f.verdict.grounds[groundNames.find("confirmed")] > 0, confirmed);
    }
}


TEST(misfitDiagnosis, strengthsOfASetAreReportedWithWhatWasFitted)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.makeTwins();
    const finding f(diagnose(s));
    ASSERT_EQ(f.verdict.kind, verdictKind::set);
    ASSERT_EQ(f.verdict.strengths.size(), 1);
    const word& name = f.verdict.strengths[0].name;
    EXPECT_NE
    (
        describe(f).find(". As fitted with " + name + ": strength of " + name + ' '),
        std::string::npos
    ) << describe(f);
}


TEST(misfitDiagnosis, aSetStatesWhatActsTogether)
{
    vec x(truth(0, 0.7));
    x[2 + 2] = 0.7;
    worldSampler s(x, 200, vec());
    s.makeTwins();
    const finding f(diagnose(s));
    ASSERT_EQ(f.verdict.kind, verdictKind::set);
    EXPECT_NE
    (
        describe(f).find(" and longTail together, or "), std::string::npos
    ) << describe(f);
}


TEST(misfitDiagnosis, theSimplerOneIsNotCalledTheBest)
{
    // The second one is too weak to be named
    vec x(truth(0, 0.7));
    x[2 + 2] = 0.1;
    worldSampler s(x, 200, vec());
    s.addContradiction();
    const finding f(diagnose(s));
    show(f);
    ASSERT_EQ(f.verdict.kind, verdictKind::unknown);
    const std::vector<hypothesisFit>& all = f.explained.all();
    const auto lessLikely = [](const hypothesisFit& a, const hypothesisFit& b)
    {
        return a.probability < b.probability;
    };
    const hypothesisFit& likeliest =
        *std::max_element(all.begin(), all.end(), lessLikely);
    EXPECT_NE(likeliest.what.mechanisms, std::vector<int>{0});
    EXPECT_NE
    (
        describe(f).find
        (
            "the best simple explanation, " + world::mechanism(0) + " ("
        ),
        std::string::npos
    ) << describe(f);
}


TEST(misfitDiagnosis, twoMechanismsAtOnceAreBothNamed)
{
    vec both = truth(0, 0.9);
    both[world::nParameters + 2] = 0.9;
    worldSampler s(both, 200, vec());
    const finding f(diagnose(s));
    expectAnswer(f, "named", {world::mechanism(0), world::mechanism(2)});

    // With something unknown beside it is the same answer, which others are behind
    scalar others = GREAT;
    for (const hypothesisFit& w : f.explained.all())
    {
        others = hasAll(w.what, {0, 2}) ? others : min(others, w.score);
    }
    const scalar lead = others - f.explained.lowestScore();
    EXPECT_NEAR(f.verdict.grounds[groundNames.find("lead")], std::log1p(lead), 1e-6);
}


TEST(misfitDiagnosis, theStrengthLiesInItsInterval)
{
    for (label m = 0; m < 4; ++m)
    {
        worldSampler s(truth(m, 0.7), 250 + m, vec(), 0);
        const finding f(diagnose(s));
        ASSERT_EQ(f.verdict.strengths.size(), 1) << world::mechanism(m);
        EXPECT_NEAR
        (
            f.verdict.strengths[0].value, 0.7, 3*f.verdict.strengths[0].deviation
        ) << world::mechanism(m);
        EXPECT_LT(f.verdict.strengths[0].deviation, 0.2);
    }
}


TEST(misfitDiagnosis, aFaultySensorIsBlamedAndNotPhysics)
{
    world w(20);
    vec added = vec::Zero(w.data.size());
    w.data.segments[0].of(added).setConstant(90);
    worldSampler s(truth(-1, 0), 300, added);
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::sensor);
    EXPECT_EQ(f.verdict.names, wordList({"P1"}));
    expectFault(f.best().what.fault, faultKind::zero, "P1");
    const auto fault = nlohmann::json::parse(verdictJson(f, "case"))["fault"];
    const scalar deviation = fault["deviations"][0];
    EXPECT_GT(deviation, 1);
    EXPECT_LT(deviation, 30);
    EXPECT_NEAR(scalar(fault["values"][0]), 90, 3*deviation);
}


TEST(misfitDiagnosis, aChannelInALargerOrSmallerUnitIsFound)
{
    for (const scalar factor : {1e-3, 1e3})
    {
        worldSampler s(truth(-1, 0), 300, vec());
        s.mislabel(factor);
        const finding f(diagnose(s));
        show(f);
        EXPECT_EQ(f.verdict.kind, verdictKind::registration) << factor;
        EXPECT_EQ(f.verdict.names, wordList({"P1"}));
        expectFault(f.best().what.fault, faultKind::units, "P1");
    }
}


TEST(misfitDiagnosis, whatIsNotInTheLibraryIsUnknown)
{
    world w(20);
    vec added = vec::Zero(w.data.size());
    for (label i = 0; i < count(w.data.segments); ++i)
    {
        const segment& s = w.data.segments[i];
        s.of(added).array() +=
            (s.quantity == "pressure" ? 150 : 0.015)
           *(-((s.x.array() - 3.2 + 0.3*i)/0.25).square()).exp();
    }
    worldSampler s(truth(-1, 0), 400, added);
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}


TEST(misfitDiagnosis, aWrongSignScreensACandidateOutBeforeItIsRun)
{
    settings set(worldSettings());
    set.candidates[2].signs = {{"pressure", "peak", -1}};
    worldSampler s(truth(0, 0.7), 200, vec());
    const finding f(diagnose(s, set));
    ASSERT_EQ(f.candidates.dropped.size(), 1);
    EXPECT_EQ(f.candidates.dropped[0].name, "longTail");
    EXPECT_EQ(f.verdict.kind, verdictKind::named);
    testNumber("different states in a diagnosis of five mechanisms", s.runs());
    EXPECT_LE(s.runs(), 30);
}


TEST(misfitDiagnosis, aFlatRecordDoesNotScreenTheLibraryOut)
{
    settings set(worldSettings());
    for (candidate& c : set.candidates)
    {
        c.bound = 0.5;
    }
    for (const scalar dry : {0.0, 1.0})
    {
        worldSampler s(truth(0, 0.7), 200, vec());
        s.recordConstant(1, dry);
        EXPECT_EQ(diagnose(s, set).candidates.dropped.size(), 0) << dry;
    }
}


TEST(misfitDiagnosis, theStateThatIsNamedWasRunInTheSolver)
{
    label named = 0;
    for (label m = 0; m < 5; ++m)
    {
        for (label k = 0; k < 6; ++k)
        {
            worldSampler s(truth(m, 0.3 + 0.1*k), 3000 + 50*m + k, vec());
            const finding f(diagnose(s));
            if (f.verdict.kind == verdictKind::named && f.verdict.state)
            {
                ++named;
                EXPECT_LT(s.nearest(*f.verdict.state), 0.05) << describe(f);
            }
        }
    }
    testNumber("of 30 surges named", named);
    EXPECT_GE(named, 10);
}
