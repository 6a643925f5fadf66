// SPDX-License-Identifier: GPL-3.0-or-later
// Predictions from a training ensemble: what was run is given as it was, and the rest
// by a surface that is exact where the truth is quadratic.

#include "diagnosis.H"
#include "emulatedPredictor.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

runState at(const scalar p, const scalar s, const word& resolution = "base")
{
    runState state;
    state.parameters.insert("p", p);
    if (s > 0)
    {
        state.strengths.insert("m", s);
    }
    state.resolution = resolution;
    return state;
}


runState replicated(runState state, const label replicate)
{
    state.replicate = replicate;
    return state;
}


//- Quadratic in both; a finer mesh adds 0.25, each replicate 0.1 more
prediction truth(const runState& state)
{
    const scalar p = state.parameters["p"];
    const scalar s = state.strengths.lookup("m", 0);
    prediction run;
    run.channels.setSize(1);
    for (label i = 0; i <= 10; ++i)
    {
        const scalar t = 0.1*i;
        run.channels[0].x.append(t);
        run.channels[0].y.append
        (
            1 + p*t + s + 0.5*p*p + 2*s*s*t
          + (state.resolution == "mesh" ? 0.25 : 0) + 0.1*state.replicate
        );
    }
    return run;
}


emulatedPredictor emulator()
{
    List<runState> states
    ({
        at(0, 0), at(-1, 0), at(1, 0), at(0, 0.5), at(0, 1), at(1, 1),
        at(-1, 0.5), at(0.5, 0.3), at(0, 0, "mesh"),
        // The same replicate more than once: its change counts once
        replicated(at(0, 0), 2), replicated(at(1, 1), 2), replicated(at(0, 0, "mesh"), 2)
    });
    List<prediction> runs;
    for (const runState& s : states)
    {
        runs.append(truth(s));
    }
    return emulatedPredictor
    (
        {{"p", {}, 0, 1, -3, 3}},
        {{"m", "m", {}, 0.5, 1, 1, GREAT, {}}},
        states,
        runs
    );
}

} // End anonymous namespace


TEST(misfitEmulator, aQuadraticTruthIsMet)
{
    emulatedPredictor emulate(emulator());
    const runState s(at(-0.4, 0.8));
    const prediction p(emulate.predict({s})[0]);
    ASSERT_TRUE(p.ok());
    for (const scalar t : {0.0, 0.3, 1.0})
    {
        EXPECT_NEAR(p.channels[0](t), truth(s).channels[0](t), 1e-9) << t;
    }
}


TEST(misfitEmulator, whatWasRunIsGivenAsItWas)
{
    emulatedPredictor emulate(emulator());
    const prediction p(emulate.predict({at(1, 1)})[0]);
    EXPECT_EQ(p.channels[0].x.size(), 11);
    EXPECT_EQ(emulate.trainingEnsemble("A").size(), 8);
}


TEST(misfitEmulator, aFinerMeshIsTheDifferenceThatTheEnsembleHasOfIt)
{
    emulatedPredictor emulate(emulator());
    const prediction p(emulate.predict({at(0.7, 0, "mesh")})[0]);
    EXPECT_NEAR
    (
        p.channels[0](0.5), truth(at(0.7, 0)).channels[0](0.5) + 0.25, 1e-9
    );
}


TEST(misfitEmulator, anotherReplicateIsTheDifferenceThatTheEnsembleHasOfIt)
{
    emulatedPredictor emulate(emulator());
    const runState s(at(0.7, 0.4));
    const scalar first = truth(s).channels[0](0.5);
    const auto computed = [&](const label replicate)
    {
        return emulate.predict({replicated(s, replicate)})[0].channels[0](0.5);
    };
    EXPECT_NEAR(computed(2), first + 0.2, 1e-9);
    EXPECT_NEAR(computed(1), first, 1e-9) << "a replicate that it has not";
    EXPECT_NEAR
    (
        emulate.predict({replicated(at(0.7, 0.4, "mesh"), 2)})[0].channels[0](0.5),
        first + 0.25 + 0.2,
        1e-9
    );
}


TEST(misfitEmulator, aReplicateThatFailedInTheEnsembleFails)
{
    List<runState> states({at(0, 0), at(-1, 0), at(1, 0), replicated(at(0, 0), 1)});
    List<prediction> runs;
    for (const runState& s : states)
    {
        runs.append(truth(s));
    }
    runs.last().failure = "it exploded";
    emulatedPredictor emulate({{"p", {}, 0, 1, -3, 3}}, {}, states, runs);
    EXPECT_EQ(emulate.predict({states.last()})[0].failure, "it exploded");
    EXPECT_EQ(emulate.trainingEnsemble("A").size(), 3);
}


TEST(misfitEmulator, whatNeverRanWithACandidateIsNotGiven)
{
    List<runState> states({at(0, 0), at(-1, 0), at(1, 0), at(0, 0.5), at(0, 1)});
    List<prediction> runs;
    for (const runState& s : states)
    {
        runs.append(truth(s));
    }
    runs[4].failure = "it exploded";
    const List<parameter> parameters({{"p", {}, 0, 1, -3, 3}});
    const List<candidate> candidates({{"m", "m", {}, 0.5, 1, 1, GREAT, {}}});
    emulatedPredictor once(parameters, candidates, states, runs);
    EXPECT_TRUE(once.predict({at(0, 0.7)})[0].ok());

    runs[3].failure = "it exploded";
    emulatedPredictor never(parameters, candidates, states, runs);
    EXPECT_NE
    (
        never.predict({at(0, 0.7)})[0].failure.find("with m failed"), std::string::npos
    );
    EXPECT_TRUE(never.predict({at(0.5, 0)})[0].ok());
}


TEST(misfitEmulator, theSurfaceIsOfTheFirstReplicate)
{
    List<runState> states;
    List<prediction> runs;
    for (const scalar p : {0.0, -1.0, 1.0, 0.5})
    {
        states.append(replicated(at(p, 0), 1));
        runs.append(truth(states.last()));
    }
    emulatedPredictor emulate({{"p", {}, 0, 1, -3, 3}}, {}, states, runs);
    const runState s(replicated(at(0.7, 0), 1));
    EXPECT_NEAR
    (
        emulate.predict({s})[0].channels[0](0.5), truth(s).channels[0](0.5), 1e-9
    );
    EXPECT_EQ(emulate.trainingEnsemble("A").size(), 4);
}


TEST(misfitEmulator, anExperimentThatItHasNotIsAFailure)
{
    emulatedPredictor emulate(emulator());
    runState s(at(0, 0));
    s.experiment = "B";
    EXPECT_NE
    (
        emulate.predict({s})[0].failure.find("no experiment B"),
        std::string::npos
    );
}


namespace
{

//- Channels, but nothing recorded and nothing computed
class nothing
:
    public sampler
{
    List<observation> data_;

public:

    nothing()
    :
        data_(1)
    {
        data_[0].experiment = "A";
        data_[0].use = purpose::calibration;
    }

    List<samples> operator()(const List<runState>& states) override
    {
        return List<samples>(states.size());
    }

    const List<observation>& data() const override
    {
        return data_;
    }
};

} // End anonymous namespace


TEST(misfitEnsemble, eachCandidateIsInAsManyRunsAsTheOthers)
{
    settings set;
    set.parameters = {{"p", {}, 0, 1, -3, 3}};
    for (const word& name : wordList({"a", "b", "c", "d", "e", "f"}))
    {
        set.candidates.append({name, name, {}, 0.5, 1, 1, GREAT, {}});
    }
    set.trainingEnsemble = 26;
    nothing sampler;
    HashTable<label> runs;
    const List<plannedStage> stages(plan(sampler, set));
    for (const runState& s : stages[1].states)
    {
        for (const word& name : s.strengths.toc())
        {
            ++runs(name);
        }
    }
    ASSERT_EQ(runs.size(), 6);
    for (const word& name : runs.toc())
    {
        EXPECT_GE(runs[name], 3) << name;
        EXPECT_LE(runs[name], 5) << name;
    }
}
