// SPDX-License-Identifier: GPL-3.0-or-later
// A calibration by several experiments: one run in each, fitted as one.

#include "covariance.H"
#include "diagnosis.H"
#include "sampler.H"
#include "sensorFault.H"
#include "terminalOutput.H"
#include "worldDiagnosis.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Channels of single values: n in each of the experiments, with these recorded ones
std::string valuesOf(const std::map<std::string, std::vector<scalar>>& recorded)
{
    std::string text("channels {");
    for (const auto& [experiment, values] : recorded)
    {
        for (size_t i = 0; i < values.size(); ++i)
        {
            text +=
                ' ' + experiment + std::to_string(i) + " { experiment " + experiment
              + "; quantity length; unit \"m\"; uncertainty 0.01; value "
              + std::to_string(values[i])
              + "; simulated { type table; function f; file \"f.dat\"; } }";
        }
    }
    return text + " }";
}


//- Two mechanisms that do the same in A and the reverse of each other in B
class contrary
:
    public predictor
{
    const recordings& all_;

public:

    //- Experiments that were run, in their order
    DynamicList<word> ran;

    //- That fails; empty: none
    word failing;

    explicit contrary(const recordings& all)
    :
        all_(all)
    {}

    List<prediction> predict(const List<runState>& states) override
    {
        List<prediction> results(states.size());
        forAll(states, i)
        {
            const runState& s = states[i];
            ran.append(s.experiment);
            results[i].failure = s.experiment == failing ? "no luck" : "";
            results[i].channels.setSize(all_.channels().size());
            const scalar first = s.strengths.lookup("first", 0);
            const scalar second = s.strengths.lookup("second", 0);
            forAll(all_.channels(), c)
            {
                const channel& its = all_.channels()[c];
                if (its.experiment == s.experiment)
                {
                    const scalar sign = its.experiment == "A" ? 1 : -1;
                    const scalar y = (1 + 0.1*c)*(first + sign*second);
                    results[i].channels[c] = series({0.0}, {y});
                }
            }
        }
        return results;
    }
};


//- One mechanism at 0.6, as recorded: of the channel numbers that all experiments share
std::vector<scalar> recordedWith(const label from, const scalar sign)
{
    std::vector<scalar> values;
    for (label c = from; c < from + 4; ++c)
    {
        values.push_back(0.6*sign*(1 + 0.1*c));
    }
    return values;
}


recordings readAll(const std::string& text)
{
    return recordings(dictionary(IStringStream(text)()), "");
}


const std::string twoCalibrations("experiments { A { } B { } C { use validation; } } ");

const std::string threeExperiments
(
    twoCalibrations
  + valuesOf
    ({
        {"A", recordedWith(0, 1)}, {"B", recordedWith(4, -1)}, {"C", recordedWith(8, -1)}
    })
);


settings twoMechanisms()
{
    settings s(worldSettings());
    s.parameters.clear();
    s.candidates.clear();
    for (const word name : {"first", "second"})
    {
        s.candidates.append({name, name, {}, 0.5, 1, 1, GREAT, {}});
    }
    s.faults.clear();
    s.clockUncertainty = 0;
    return s;
}

} // End anonymous namespace


TEST(misfitSeveralExperiments, aStateRunsInEachAndGivesTheSamplesOfAll)
{
    const recordings all(readAll(threeExperiments));
    contrary solver(all);
    predictedSampler simulation(all, solver);
    ASSERT_EQ(simulation.data().size(), 2);
    EXPECT_EQ(simulation.data().first().experiment, "A+B");
    EXPECT_EQ(simulation.data().first().calibration.size(), 8);

    runState s;
    s.experiment = "A+B";
    s.strengths.set("second", 1);
    const samples computed(simulation({s}).first());
    EXPECT_EQ(solver.ran, wordList({"A", "B"}));
    ASSERT_EQ(computed.calibration.size(), 8);
    EXPECT_DOUBLE_EQ(computed.calibration[0], 1);
    EXPECT_DOUBLE_EQ(computed.calibration[4], -1.4);
}


TEST(misfitSeveralExperiments, whatFailsInOneFailsAndIsNamed)
{
    const recordings all(readAll(threeExperiments));
    contrary solver(all);
    solver.failing = "B";
    predictedSampler simulation(all, solver);
    runState s;
    s.experiment = "A+B";
    EXPECT_EQ(simulation({s}).first().failure, "B: no luck");
    s.experiment = "C";
    EXPECT_TRUE(simulation({s}).first().ok());
}


TEST(misfitSeveralExperiments, whatOneCannotSeparateIsNamedByBoth)
{
    const recordings all(readAll(threeExperiments));
    contrary solver(all);
    predictedSampler simulation(all, solver);
    const settings set(twoMechanisms());
    const finding both(diagnose(simulation, set));
    expectAnswer(both, "named", {"second"});

    const recordings one
    (
        readAll
        (
            "experiments { A { } } " + valuesOf({{"A", recordedWith(0, 1)}})
        )
    );
    contrary alone(one);
    predictedSampler askOne(one, alone);
    const finding f(diagnose(askOne, set));
    show(f);
    EXPECT_EQ(f.verdict.kind, verdictKind::set);
}


TEST(misfitSeveralExperiments, oneWithoutARecordingIsRefused)
{
    const std::string text(twoCalibrations + valuesOf({{"A", {1, 2, 3}}}));
    IStringStream is(text);
    const dictionary dict(is);
    expectHolds
    (
        refusal([&]() { recordings(dict, "").checkEnough(dict, 2); }),
        "experiment B has no recorded channel"
    );
}


TEST(misfitSeveralExperiments, aFreeCorrectionIsRefused)
{
    const std::string text(threeExperiments + " correction { }");
    IStringStream is(text);
    const dictionary dict(is);
    expectHolds
    (
        refusal([&]() { recordings(dict, "").checkEnough(dict, 2); }),
        "follows the water of one experiment"
    );
}


TEST(misfitSeveralExperiments, eachHasItsOwnZeroOfTime)
{
    stacked data;
    for (const std::string experiment : {"A", "A", "B"})
    {
        segment s;
        s.name = "S" + std::to_string(data.segments.size());
        s.experiment = experiment;
        s.quantity = "pressure";
        s.first = 3*data.segments.size();
        s.size = 3;
        s.x = vec::LinSpaced(3, 0, 2);
        s.span = 1;
        s.readings = vec::Constant(3, 1);
        s.uncertainty = 1;
        data.segments.push_back(s);
    }
    data.y = vec::LinSpaced(9, 0, 8);
    const mat c = covariance(data, 0.5).at(data.y);
    EXPECT_NEAR(c(0, 3), 0.25, 1e-12);
    EXPECT_EQ(c(0, 6), 0);

    // Nor can channels of two experiments be exchanged
    const auto exchanges = possibleFaults(data, {faultKind::swapped});
    ASSERT_EQ(exchanges.size(), 1u);
    EXPECT_EQ(exchanges[0].channel, "S0");
    EXPECT_EQ(exchanges[0].partner, "S1");
}
