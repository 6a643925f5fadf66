// SPDX-License-Identifier: GPL-3.0-or-later
// The design of an experiment, where the answer is known in closed form: numbers alone,
// with effects in standard deviations.

#include "designReport.H"
#include "jsonSchema.H"
#include "parallelWork.H"
#include "recordedFiles.H"
#include "simulatedRecordings.H"
#include "terminalOutput.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Channels a, b, c ... that are 0, plus the sum of strengths times effects: a row of
//  these for each channel, a column for each mechanism. The deviation of each is 1
class numbersWorld
:
    public sampler
{
    const mat effects_;

    List<observation> data_;

public:

    //- The solver fails with it; empty: with none
    word failing;

    //- Number of the channel that a finer mesh changes; -1: none
    label changedByMesh = -1;

    explicit numbersWorld(const mat& effects)
    :
        effects_(effects),
        data_(1)
    {
        data_.first().experiment = "A";
        data_.first().use = purpose::calibration;
        stacked& all = data_.first().calibration;
        for (label i = 0; i < effects.rows(); ++i)
        {
            segment s;
            s.name = std::string(1, char('a' + i));
            s.quantity = "length";
            s.first = i;
            s.size = 1;
            s.x = vec::Zero(1);
            s.overTime = false;
            s.readings = vec::Ones(1);
            s.uncertainty = 1;
            all.segments.push_back(s);
        }
        all.y = vec::Zero(effects.rows());
    }

    List<samples> operator()(const List<runState>& states) override
    {
        List<samples> all(states.size());
        forAll(states, i)
        {
            all[i].calibration = vec::Zero(effects_.rows());
            if (states[i].strengths.lookup(failing, 0) > 0)
            {
                all[i].failure = "diverged";
            }
            if (!states[i].isBase() && changedByMesh >= 0)
            {
                all[i].calibration[changedByMesh] += 0.1;
            }
            for (label m = 0; m < effects_.cols(); ++m)
            {
                all[i].calibration +=
                    states[i].strengths.lookup(Foam::name(m), 0)*effects_.col(m);
            }
        }
        return all;
    }

    const List<observation>& data() const override
    {
        return data_;
    }
};


settings settingsFor(const label mechanisms)
{
    settings s;
    for (label m = 0; m < mechanisms; ++m)
    {
        const word name(Foam::name(m), false);
        // What is recorded may be larger than the effect, and no bound may limit the fit
        s.candidates.append({name, name, {}, 0.5, 1, 2, GREAT, {}});
    }
    s.modelDiscrepancy = 0;
    s.draws = 2000;
    return s;
}


designSettings designOfAll(const label channels, const label draws)
{
    designSettings d;
    for (label i = 0; i < channels; ++i)
    {
        d.channels.append(word(std::string(1, char('a' + i))));
    }
    d.strengths = {1};
    d.repeats = {1};
    d.draws = draws;
    return d;
}


//- Probability that a normal number of mean k is beyond the level of 5 % of both signs
scalar detection(const scalar k)
{
    const auto below = [](const scalar z) { return 0.5*std::erfc(-z/std::sqrt(2.0)); };
    return below(k - 1.96) + below(-k - 1.96);
}


//- Three standard deviations of a fraction of so many
scalar within(const scalar p, const label n)
{
    return 3*std::sqrt(p*(1 - p)/n);
}

} // End anonymous namespace


TEST(misfitDesign, anEffectIsDetectedWithTheProbabilityOfTheNormalLaw)
{
    const label n = 300;
    const scalar k = 2;
    numbersWorld w(mat::Constant(1, 1, k));
    const experimentDesign d
    (
        designExperiment(w, settingsFor(1), designOfAll(1, n), 1)
    );
    const designRow& r = d.row("0", 1, 1);
    EXPECT_NEAR(r.share(r.detected), detection(k), within(detection(k), n));

    // What nothing shows is detected as often as is allowed
    const designRow& none = d.row("", 0, 1);
    EXPECT_NEAR(none.share(none.detected), 0.05, within(0.05, n));
    EXPECT_LE(none.share(none.wrong), 0.05);
}


TEST(misfitDesign, repeatsOfTheExperimentLessenTheNoise)
{
    const label n = 150;
    numbersWorld w(mat::Constant(1, 1, 1));
    designSettings design(designOfAll(1, n));
    design.repeats = {9};
    const experimentDesign d(designExperiment(w, settingsFor(1), design, 1));
    const designRow& many = d.row("0", 1, 9);
    EXPECT_NEAR(many.share(many.detected), detection(3), within(detection(3), n));
}


TEST(misfitDesign, whatIsLargeIsNamedAndWhatIsSmallIsNot)
{
    const label n = 20;
    numbersWorld w(mat::Constant(1, 1, 3));
    designSettings design(designOfAll(1, n));
    design.repeats = {1, 16};
    const experimentDesign d(designExperiment(w, settingsFor(1), design, 1));

    // A gain in score of 10 takes 3.5 standard deviations
    EXPECT_LT(d.row("0", 1, 1).named, 0.5*n);
    EXPECT_GE(d.row("0", 1, 16).named, 0.95*n);
    EXPECT_EQ(d.repeatsNeeded("0", 1), 16);
}


TEST(misfitDesign, mechanismsWithTheSameEffectAreNeverSeparated)
{
    mat effects(3, 2);
    effects << 5, 5, -6, -6, 7, 7;
    numbersWorld w(effects);
    designSettings design(designOfAll(3, 15));
    design.repeats = {1, 10};
    const experimentDesign d(designExperiment(w, settingsFor(2), design, 1));
    for (const label repeats : design.repeats)
    {
        for (const word name : {"0", "1"})
        {
            const designRow& r = d.row(name, 1, repeats);
            EXPECT_EQ(r.named, 0) << name;
            EXPECT_EQ(r.wrong, 0) << name;
            EXPECT_GE(r.inSet, 0.9*r.draws) << name;
        }
    }
    EXPECT_EQ(d.repeatsNeeded("0", 1), 0);
    EXPECT_EQ(d.row("0", 1, 1).others.count(std::vector<word>{"1"}), 1);

    // Answers of other processes come back whole
    const experimentDesign two(designExperiment(w, settingsFor(2), design, 2));
    EXPECT_EQ(two.row("0", 1, 1).inSet, d.row("0", 1, 1).inSet);
    EXPECT_EQ(two.row("0", 1, 1).others, d.row("0", 1, 1).others);
}


TEST(misfitDesign, theChannelThatSeparatesThemHelpsMost)
{
    // c shows nothing, d one of both
    mat effects(4, 2);
    effects << 5, 5, -6, -6, 0, 0, 12, 0;
    numbersWorld w(effects);
    const experimentDesign d
    (
        designExperiment(w, settingsFor(2), designOfAll(2, 10), 1)
    );
    ASSERT_EQ(d.options.size(), 2);
    EXPECT_EQ(d.options[0].channel, "d");
    EXPECT_EQ(d.options[0].before, 0);
    EXPECT_GE(d.options[0].after, 0.5);
    EXPECT_EQ(d.options[1].channel, "c");
    EXPECT_EQ(d.options[1].after, 0);
}


TEST(misfitDesign, channelsThatHelpAlikeAreTied)
{
    // c and d show the same difference of the two, e none
    mat effects(5, 2);
    effects << 5, 5, -6, -6, 12, 0, 12, 0, 0, 0;
    numbersWorld w(effects);
    const experimentDesign d
    (
        designExperiment(w, settingsFor(2), designOfAll(2, 12), 1)
    );
    ASSERT_EQ(d.options.size(), 3);
    EXPECT_TRUE(d.options[0].isTied);
    EXPECT_TRUE(d.options[1].isTied);
    EXPECT_EQ(d.options[2].channel, "e");
    EXPECT_FALSE(d.options[2].isTied);

    // The standard error is that of the draws
    const designOption& first = d.options[0];
    ASSERT_EQ(first.gains.size(), 12);
    scalar mean = 0;
    scalar square = 0;
    for (const scalar gain : first.gains)
    {
        mean += gain/12;
        square += sqr(gain)/12;
    }
    EXPECT_NEAR(mean, first.gain(), 1e-9);
    EXPECT_NEAR(sqr(first.standardError()), (square - sqr(mean))/11, 1e-9);
}


TEST(misfitDesign, eachAnswerCountsOnceAndTheBrierScoreIsThatOfItsConfidences)
{
    numbersWorld w(mat::Constant(1, 1, 3));
    const experimentDesign d(designExperiment(w, settingsFor(1), designOfAll(1, 40), 1));
    ASSERT_FALSE(d.rows.empty());
    for (const designRow& r : d.rows)
    {
        EXPECT_EQ(r.named + r.inSet + r.wrong + r.none + r.unknown, r.draws);
        EXPECT_GT(r.confidence(), 0);
        EXPECT_LE(r.confidence(), 1);

        // A mean square is at least the square of the mean
        const scalar right = r.share(r.mechanism.empty() ? r.none : r.named + r.inSet);
        EXPECT_GE(r.BrierScore(), sqr(r.confidence() - right) - 1e-9);
        EXPECT_LE(r.BrierScore(), 1);
    }
}


TEST(misfitDesign, aCandidateWhoseRunsFailIsReportedAndHasNoRows)
{
    numbersWorld w(mat::Constant(1, 2, 3));
    w.failing = "1";
    const experimentDesign d(designExperiment(w, settingsFor(2), designOfAll(1, 5), 1));
    EXPECT_EQ(d.failing, wordList({"1"}));
    ASSERT_FALSE(d.rows.empty());
    for (const designRow& r : d.rows)
    {
        EXPECT_NE(r.mechanism, "1");
    }
    expectHolds(designTable(d), "failed: 1. Correct");
    expectHolds(designHtml(d, "a case"), "failed: 1. Correct");
}


TEST(misfitDesign, aStrengthBeyondTheLargestIsRefused)
{
    settings set(settingsFor(1));
    set.candidates[0].upper = 2;
    designSettings design(designOfAll(1, 1));
    design.strengths = {1, 2};
    checkStrengths(dictionary(), design, set);
    design.strengths = {1, 2.5};
    expectHolds
    (
        refusal([&]() { checkStrengths(dictionary(), design, set); }),
        "no fit goes beyond its upper, 2"
    );
}


TEST(misfitDesign, channelsThatAFinerMeshLeavesAsTheyAreMayBeChosen)
{
    // The mesh changes b alone
    mat effects(2, 1);
    effects << 3, 3;
    numbersWorld w(effects);
    w.changedByMesh = 1;
    settings set(settingsFor(1));
    set.resolutions = {"mesh"};
    const experimentDesign d(designExperiment(w, set, designOfAll(1, 4), 1));
    EXPECT_EQ(d.row("0", 1, 1).draws, 4);

    // Where it changes none at all something is wrong
    w.changedByMesh = -1;
    expectHolds
    (
        refusal([&]() { designExperiment(w, set, designOfAll(1, 4), 1); }),
        "gives the same numbers"
    );
}


TEST(misfitDesign, recordingsScatterByWhatIsUncertain)
{
    // 1 of the sensor, and a fifth of the effect of another formula
    const scalar k = 5;
    numbersWorld w(mat::Constant(1, 1, k));
    settings set(settingsFor(1));
    set.modelDiscrepancy = 0.2;
    const simulatedRecordings recordings(w, set, 1);
    const label n = 4000;
    scalar mean = 0;
    scalar square = 0;
    for (label draw = 0; draw < n; ++draw)
    {
        const scalar y = recordings(0, 1, draw)[0];
        mean += y/n;
        square += sqr(y - k)/n;
    }
    EXPECT_NEAR(mean, k, 3*std::sqrt(2.0/n));
    EXPECT_NEAR(square, 2, 3*2*std::sqrt(2.0/n));
    EXPECT_EQ(recordings(0, 1, 7), recordings(0, 1, 7));
}


TEST(misfitDesign, processesGiveWhatOneGives)
{
    const auto work = [](const label i) { return std::to_string(i*i); };
    const auto one = inProcesses(7, 1, work);
    EXPECT_EQ(inProcesses(7, 3, work), one);
    EXPECT_EQ(one.back(), "36");
    const auto failing = [](const label) -> std::string
    {
        throw std::runtime_error("no memory, in a test");
    };
    expectHolds(refusal([&]() { inProcesses(4, 2, failing); }), "ended early");
}


TEST(misfitDesign, aChannelWithoutAFileIsPlanned)
{
    const Foam::recorded::files f;
    const auto read = [&](const std::string& entries)
    {
        return dictionary
        (
            IStringStream
            (
                "samples 8; channels { P { quantity pressure; uncertainty 10; " + entries
              + " simulated { type table; function f; file f; column p; } } }"
            )()
        );
    };
    recordings planned(read("interval (1 5); rate 100;"), f.folder());
    planned.plan();
    const channel& c = planned.channels()[0];
    EXPECT_TRUE(c.isPlanned && c.isRecorded());
    ASSERT_EQ(c.samples.size, 8);
    EXPECT_NEAR(c.samples.readings[3], 50, 1);
    EXPECT_NEAR(c.samples.x[0], 1.25, 1e-6);
    EXPECT_EQ(readDesign(read(""), planned).channels, wordList({"P"}));

    recordings without(read(""), f.folder());
    expectHolds(refusal([&]() { without.plan(); }), "give it interval");
    const dictionary wrong(IStringStream("design { channels (Q); }")());
    expectHolds(refusal([&]() { readDesign(wrong, planned); }), "names the channel Q");
    const dictionary none(IStringStream("design { strengths (0); }")());
    expectHolds(refusal([&]() { readDesign(none, planned); }), "must be above 0");
}


TEST(misfitDesign, itIsReadByProgramsAndPeople)
{
    typedef std::vector<word> names;
    experimentDesign d;
    d.channels = {"P1", "P2"};
    d.probability = 0.8;
    d.rows.append({"", 0, 1, 20, 1, 0, 0, 1, {{names{"leak"}, 1}}});

    // A channel whose name looks like a pair is not taken for it
    d.rows.append({"drag", 0.5, 1, 20, 19, 8, 4, 2, {}});
    d.rows.last().others =
        {{names{"leak"}, 5}, {names{"a", "b"}, 2}, {names{word("a and b", false)}, 1}};
    d.rows.append({"drag", 0.5, 3, 20, 20, 18, 1, 0, {}});
    d.options.append({"P3", {}, 0.4, 0.75, {0.2, 0.5}});
    const json all(designRecord(d, "a case"));
    EXPECT_EQ(all["rows"][1]["named"], 0.4);
    const json& others = all["rows"][1]["others"];
    ASSERT_EQ(others.size(), 3);
    EXPECT_EQ(others[0]["names"], json::array({"a", "b"}));
    EXPECT_EQ(others[0]["fraction"], 0.1);
    EXPECT_EQ(others[2]["names"], json::array({"leak"}));
    EXPECT_EQ(others[2]["fraction"], 0.25);
    EXPECT_EQ(all["repeatsNeeded"][0]["repeats"], 3);
    EXPECT_EQ(all["options"][0]["channel"], "P3");
    EXPECT_TRUE(json::accept(all.dump()));

    const std::string page(designHtml(d, "a case"));
    expectHolds(page, "<td>drag</td><td>0.5</td><td>1</td><td>95 %</td><td>40 %</td>");
    expectHolds(page, "<td>leak (25 %)</td>");
    expectHolds(page, "<td>P3</td><td>40 %</td><td>75 %</td><td>35 ± 15</td><td></td>");
    expectHolds
    (
        designTable(d),
        "Adding the channel P3 changes right names from 40 % to 75 % (35 +- 15 points)"
    );
    expectOfSchema("design.schema.json", nlohmann::json::parse(all.dump()));
}
