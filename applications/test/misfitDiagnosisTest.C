// SPDX-License-Identifier: GPL-3.0-or-later
// Whole diagnoses of a surge in closed form, whose truth has other formulas
// than the library: the verdict, its gates, and what it says.

#include "diagnosis.H"
#include "misfitWorld.H"
#include "testNumber.H"

#include "HashSet.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Stands for the solver. P1 gates; experiment B has a smaller release
class worldSampler
:
    public sampler
{
    world world_;

    List<observed> data_;

    HashSet<string, string::hash> asked_;

    HashSet<string, string::hash> between_;

    //- A mechanism at which the solver fails, and an experiment in which it
    //  fails with any
    label crashing_ = -1;
    word failing_;

    //- The second mechanism acts as the first one does
    bool twins_ = false;

    //- A mechanism that does nothing with strengths between those of S5
    label idle_ = -1;

    //- The solver fails in A with strengths between those of S5, after so many
    //  such states; with that packing; and where numerics are others
    label betweenAllowed_ = labelMax;

    label failingPacking_ = -1;

    scalar packingChanges_ = 0;

    bool failsFiner_ = false;


    stacked gate() const
    {
        stacked s;
        s.segments = List<segment>({world_.data.segments[2]});
        s.segments[0].first = 0;
        s.y = world_.data.segments[2].of(world_.data.y);
        return s;
    }

    static bool isBetween(const scalar strength)
    {
        return strength != 0 && strength != 0.5 && strength != 1;
    }

    vec variables(const runState& s) const
    {
        vec x = vec::Zero(world_.bounds.mean.size());
        x[0] = s.parameters.lookup("release", 0);
        x[1] = s.parameters.lookup("friction", 0);
        for (label m = 0; m < world::nMechanisms; ++m)
        {
            const scalar strength =
                s.strengths.lookup(world::mechanism(m), 0);
            x[world::nParameters + m] =
                m == idle_ && isBetween(strength) ? 0 : strength;
        }
        if (twins_)
        {
            scalar& second = x[world::nParameters + 1];
            x[world::nParameters] += second;
            second = 0;
        }
        return x;
    }

    vec simulated(const vec& x, const word& experiment) const
    {
        vec y = x;
        y[0] -= experiment == "A" ? 0 : 0.3;
        return world_(y);
    }

public:

    //- Different ones
    label runs = 0;

    //- What was recorded in both experiments: of these variables, with another
    //  formula, plus an addition to A
    worldSampler
    (
        const vec& x,
        const label seed,
        const vec& added,
        const scalar bend = 1
    )
    :
        world_(20)
    {
        std::mt19937 generator(seed);
        for (const word& e : wordList({"A", "B"}))
        {
            vec y = x;
            y[0] -= e == "B" ? 0.3 : 0;
            world_.data.y = world_(y, bend) + world_.noise(generator);
            if (e == "A" && added.size())
            {
                world_.data.y += added;
            }
            List<label> keep;
            observed o;
            o.experiment = e;
            o.use = e == "A" ? purpose::fit : purpose::gate;
            if (e == "A")
            {
                o.fit = world_.data.without(2, keep);
                o.gate = gate();
            }
            else
            {
                o.gate = world_.data;
            }
            data_.append(o);
        }
    }

    void crashWith(const label mechanism)
    {
        crashing_ = mechanism;
    }

    //- The first channel of A is in another unit than it says
    void mislabel(const scalar factor)
    {
        stacked& fit = data_[0].fit;
        fit.segments[0].of(fit.y) *= factor;
    }

    void mislabelHeldOut(const scalar factor)
    {
        data_[0].gate.y *= factor;
    }

    void makeTwins()
    {
        twins_ = true;
    }

    void idleBetween(const label mechanism)
    {
        idle_ = mechanism;
    }

    void failBetween(const label allowed)
    {
        betweenAllowed_ = allowed;
    }

    void failPacking(const label packing)
    {
        packingChanges_ = 1e-4;
        failingPacking_ = packing;
    }

    void failFiner()
    {
        failsFiner_ = true;
    }

    void failIn(const word& experiment)
    {
        failing_ = experiment;
    }

    void holdNothingOut()
    {
        data_.resize(1);
        data_[0].gate = stacked();
    }

    //- A further experiment like B, in which nothing was left out
    void addContradiction()
    {
        observed o(data_.last());
        o.experiment = "D";
        vec x = vec::Zero(world_.bounds.mean.size());
        x[0] = -0.3;
        o.gate.y = world_(x);
        data_.append(o);
    }

    List<samples> operator()(const List<runState>& states) override
    {
        List<samples> all(states.size());
        forAll(states, i)
        {
            asked_.insert(told(states[i]));
            runs = asked_.size();
            const vec x = variables(states[i]);
            const vec f =
                (1 + packingChanges_*states[i].packing)
               *simulated(x, states[i].experiment);
            const bool fails =
                states[i].experiment == failing_
             && states[i].strengths.size();
            bool between = false;
            forAllConstIters(states[i].strengths, strength)
            {
                between = between || isBetween(*strength);
            }
            if (between && states[i].experiment == "A")
            {
                between_.insert(told(states[i]));
            }
            between = between && between_.size() > betweenAllowed_;
            if
            (
                fails || (between && states[i].experiment == "A")
             || states[i].packing == failingPacking_
             || (failsFiner_ && states[i].resolution != "base")
             || (crashing_ >= 0 && x[world::nParameters + crashing_] > 0)
            )
            {
                all[i].failure = "floating point exception";
            }
            else if (states[i].experiment == "A")
            {
                List<label> keep;
                world_.data.without(2, keep);
                all[i].fit = rows(f, keep);
                if (data_[0].gate.size())
                {
                    all[i].gate = world_.data.segments[2].of(f);
                }
            }
            else
            {
                all[i].gate = f;
            }
        }
        return all;
    }

    const List<observed>& data() const override
    {
        return data_;
    }
};


settings worldSettings()
{
    settings s;
    s.parameters =
    {
        {"release", {}, 0, 0.1, -0.4, 0.4}, {"friction", {}, 0, 0.1, -0.4, 0.4}
    };
    for (label m = 0; m < world::nMechanisms; ++m)
    {
        const word name(world::mechanism(m));
        s.candidates.append({name, name, {}, 0.5, 1, 1, GREAT, {}});
    }
    using kind = sensorFault::kind;
    s.faults =
    {
        kind::lag, kind::gain, kind::zero, kind::drift, kind::clock,
        kind::clogged, kind::swapped, kind::misplaced, kind::units
    };
    s.trigger = 0.005;
    s.draws = 500;
    return s;
}


vec truth(const label mechanism, const scalar strength)
{
    vec x = vec::Zero(world::nParameters + world::nMechanisms);
    x[0] = 0.06;
    x[1] = -0.08;
    if (mechanism >= 0)
    {
        x[world::nParameters + mechanism] = strength;
    }
    return x;
}


finding diagnose(worldSampler& s, const settings& set = worldSettings())
{
    diagnosis d(s, set);
    return d();
}


void show(const finding& f)
{
    std::printf("%s: %s\n", f.verdict.c_str(), f.told.c_str());
    for (const gate& g : f.gates)
    {
        std::printf
        (
            "  %-10s %-7s %s (%s)\n", g.name.c_str(),
            g.applies ? g.passed ? "passed" : "failed" : "-",
            g.value.c_str(), g.bound.c_str()
        );
    }
}


//- What a gate said; true where it was not asked
bool passes(const finding& f, const word& name)
{
    for (const gate& g : f.gates)
    {
        if (g.name == name && g.applies && !g.passed)
        {
            return false;
        }
    }
    return true;
}


//- Whatever their order
void expectAnswer(const finding& f, const word& verdict, wordList names)
{
    show(f);
    EXPECT_EQ(f.verdict, verdict);
    wordList found(f.names);
    std::sort(found.begin(), found.end());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(found, names);
}

} // End anonymous namespace


TEST(misfitDiagnosis, aMistunedModelLacksNothing)
{
    label none = 0;
    for (label k = 0; k < 5; ++k)
    {
        worldSampler s(truth(-1, 0), 100 + k, vec());
        const finding f(diagnose(s));
        none += f.verdict == "none";
        if (f.verdict != "none")
        {
            show(f);
        }
    }
    EXPECT_EQ(none, 5);
}


TEST(misfitDiagnosis, aMechanismIsNamedAlthoughItsFormulaDiffers)
{
    for (label m = 0; m < 4; ++m)
    {
        worldSampler s(truth(m, 0.7), 200 + m, vec());
        const finding f(diagnose(s));
        show(f);
        EXPECT_EQ(f.verdict, "named") << world::mechanism(m);
        EXPECT_EQ(f.names, wordList({world::mechanism(m)}));
        EXPECT_GT(f.confidence, 0.7);
        EXPECT_FALSE(f.located.empty());
        ASSERT_EQ(f.held.size(), 2);
        EXPECT_LT(f.held[1].squareAfter, f.held[1].squareBefore);
    }
}


TEST(misfitDiagnosis, aNamedEffectIsLocatedWithoutMostOfTheNoise)
{
    const settings set(worldSettings());
    const vec with = truth(0, 0.5);
    const world w(20);
    List<label> fitted;
    w.data.without(2, fitted);
    const vec effect = rows(w(with, 1) - w(truth(-1, 0), 1), fitted);

    // F1 of the samples at which what the parameters leave of the effect is
    // beyond two deviations
    scalar both = 0;
    scalar lengths = 0;
    for (label k = 0; k < 6; ++k)
    {
        worldSampler s(with, 300 + k, vec());
        const visibility v(diagnosis(s, set).visible());
        const vec left = v.all*v.calibrated.ldlt().solve(effect);
        const finding f(diagnose(s, set));
        ASSERT_EQ(f.verdict, "named");
        labelHashSet found;
        for (const window& place : f.detection.windows)
        {
            for (label i = place.begin; i < place.end; ++i)
            {
                found.insert(f.data.segments[place.segment].first + i);
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


TEST(misfitDiagnosis, eachHeldOutExperimentMustConfirmIt)
{
    worldSampler agrees(truth(0, 0.7), 200, vec());
    EXPECT_EQ(diagnose(agrees).verdict, "named");

    // B confirms it, the one behind it does not
    worldSampler s(truth(0, 0.7), 200, vec());
    s.addContradiction();
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict, "unknown");
    EXPECT_TRUE(f.names.empty());
}


TEST(misfitDiagnosis, anExperimentInWhichTheSolverFailsConfirmsNothing)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.failIn("B");
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict, "unknown");
}


TEST(misfitDiagnosis, whatWasNotRunAsItWasFittedIsNotNamed)
{
    // Never, and only at first
    for (const label allowed : {0, 3})
    {
        worldSampler s(truth(0, 0.7), 200, vec());
        s.failBetween(allowed);
        const finding f(diagnose(s));
        show(f);
        EXPECT_EQ(f.verdict, "unknown");
        EXPECT_TRUE(f.answer.empty());
        for (const gate& g : f.gates)
        {
            EXPECT_TRUE(g.name != "computed" || !g.passed);
        }
    }
}


TEST(misfitDiagnosis, whatTheSolverRefutesGivesWayToTheNextBest)
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
        ASSERT_EQ(f.strengths.size(), 1);
        EXPECT_EQ(f.strengths[0].name, world::mechanism(1 - idle));
        EXPECT_NEAR(f.strengths[0].value, 0.7, 0.2);
        ASSERT_EQ(f.answer.size(), 1);
        EXPECT_TRUE(f.answer[0].strengths.found(world::mechanism(1 - idle)));
    }
}


TEST(misfitDiagnosis, theStateThatIsNamedIsTold)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    const finding f(diagnose(s));
    ASSERT_EQ(f.answer.size(), 1);
    EXPECT_NEAR
    (
        f.answer[0].strengths[world::mechanism(0)], f.strengths[0].value, 1e-9
    );
}


TEST(misfitDiagnosis, aFailedResolutionStopsItAndAFailedPackingIsTold)
{
    settings set(worldSettings());
    set.resolutions = {"mesh"};
    worldSampler same(truth(-1, 0), 100, vec());
    EXPECT_THROW(diagnose(same, set), Foam::error);

    worldSampler finer(truth(-1, 0), 100, vec());
    finer.failFiner();
    EXPECT_THROW(diagnose(finer, set), Foam::error);

    set.resolutions.clear();
    set.packings = 2;
    set.common = 1;
    worldSampler one(truth(-1, 0), 100, vec());
    one.failPacking(1);
    EXPECT_THROW(diagnose(one, set), Foam::error);

    set.packings = 4;
    set.common = 2;
    worldSampler common(truth(-1, 0), 100, vec());
    common.failPacking(1);
    try
    {
        diagnose(common, set);
        FAIL();
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("one of the common"), std::string::npos);
    }

    worldSampler other(truth(-1, 0), 100, vec());
    other.failPacking(2);
    const finding f(diagnose(other, set));
    ASSERT_EQ(f.failedRuns.size(), 1);
    EXPECT_NE(f.failedRuns[0].find("packing 2"), std::string::npos);
}


TEST(misfitDiagnosis, withoutHeldOutDataItIsSaidThatNothingConfirmsIt)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.holdNothingOut();
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict, "named");
    EXPECT_NE(f.told.find("No held-out data"), std::string::npos) << f.told;

    worldSampler with(truth(0, 0.7), 200, vec());
    const finding confirmed(diagnose(with));
    EXPECT_EQ(confirmed.told.find("No held-out data"), std::string::npos);
}


TEST(misfitDiagnosis, whereOnlyHeldOutDataPartItIsNotSaidThatNothingIsMissing)
{
    world w(20);
    worldSampler s(truth(-1, 0), 100, vec());
    s.mislabelHeldOut(1.3);
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict, "unknown");
    EXPECT_FALSE(passes(f, "heldOut"));
    EXPECT_TRUE(passes(f, "transfer"));
    EXPECT_NE(f.told.find("held-out ones do not"), std::string::npos) << f.told;
    EXPECT_TRUE(f.strengths.empty());

    worldSampler agrees(truth(-1, 0), 100, vec());
    EXPECT_EQ(diagnose(agrees).held.size(), 2);
}


TEST(misfitDiagnosis, chanceOfASquareIsThatOfItsDistribution)
{
    // Upper percentiles of chi-squared over its degrees of freedom
    EXPECT_NEAR(chanceOfSquare(10, 0.05), 1.8307, 0.01);
    EXPECT_NEAR(chanceOfSquare(40, 0.01), 1.5923, 0.005);
    EXPECT_NEAR(chanceOfSquare(1, 0.05), 3.841, 0.1);
    EXPECT_NEAR(chanceOfSquare(100, 0.5), 0.9933, 0.001);
}


TEST(misfitDiagnosis, sensorsAloneCanBeAskedAfter)
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
    EXPECT_EQ(f.verdict, "sensor");
}


TEST(misfitDiagnosis, whatTheseChannelsCannotTellApartIsASet)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.makeTwins();
    expectAnswer
    (
        diagnose(s), "set", {world::mechanism(0), world::mechanism(1)}
    );
}


TEST(misfitDiagnosis, twoMechanismsAtOnceAreBothNamed)
{
    vec both = truth(0, 0.9);
    both[world::nParameters + 2] = 0.9;
    worldSampler s(both, 200, vec());
    expectAnswer
    (
        diagnose(s), "named", {world::mechanism(0), world::mechanism(2)}
    );
}


TEST(misfitDiagnosis, theStrengthLiesInItsInterval)
{
    for (label m = 0; m < 4; ++m)
    {
        worldSampler s(truth(m, 0.7), 250 + m, vec(), 0);
        const finding f(diagnose(s));
        ASSERT_EQ(f.strengths.size(), 1) << world::mechanism(m);
        EXPECT_NEAR
        (
            f.strengths[0].value, 0.7, 3*f.strengths[0].deviation
        ) << world::mechanism(m);
        EXPECT_LT(f.strengths[0].deviation, 0.2);
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
    EXPECT_EQ(f.verdict, "sensor");
    EXPECT_EQ(f.names, wordList({"P1"}));
    EXPECT_NE(f.told.find("zero"), std::string::npos) << f.told;
}


TEST(misfitDiagnosis, aChannelInALargerOrSmallerUnitIsFound)
{
    for (const scalar factor : {1e-3, 1e3})
    {
        worldSampler s(truth(-1, 0), 300, vec());
        s.mislabel(factor);
        const finding f(diagnose(s));
        show(f);
        EXPECT_EQ(f.verdict, "registration") << factor;
        EXPECT_EQ(f.names, wordList({"P1"}));
        EXPECT_NE(f.told.find("unit"), std::string::npos) << f.told;
    }
}


TEST(misfitDiagnosis, whatIsNotInTheLibraryIsUnknown)
{
    world w(20);
    vec added = vec::Zero(w.data.size());
    forAll(w.data.segments, i)
    {
        const segment& s = w.data.segments[i];
        s.of(added).array() +=
            (s.quantity == "pressure" ? 150 : 0.015)
           *(-((s.x.array() - 3.2 + 0.3*i)/0.25).square()).exp();
    }
    worldSampler s(truth(-1, 0), 400, added);
    const finding f(diagnose(s));
    show(f);
    EXPECT_EQ(f.verdict, "unknown");
}


TEST(misfitDiagnosis, whatGainsTooLittleIsNotSaid)
{
    settings set(worldSettings());
    set.evidence = 1e4;
    worldSampler s(truth(0, 0.7), 200, vec());
    const finding f(diagnose(s, set));
    show(f);
    EXPECT_EQ(passes(f, "evidence"), false);
    EXPECT_EQ(f.verdict, "none");
    EXPECT_NE(f.told.find("too little to say why"), std::string::npos);
}


TEST(misfitDiagnosis, whatAnotherChannelContradictsIsNotNamed)
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
    EXPECT_NE(f.verdict, "named");
}


TEST(misfitDiagnosis, whereTooMuchIsLeftItIsSaidThatThereIsMoreToIt)
{
    // A wave that no candidate makes, smaller than one that is found
    world w(20);
    vec added = vec::Zero(w.data.size());
    for (const segment& s : w.data.segments)
    {
        s.of(added).array() +=
            (s.quantity == "pressure" ? 75 : 0.0075)
           *(-((s.x.array() - 3.2 + 0.3*(s.place.x() - 1))/0.25).square()).exp();
    }
    settings set(worldSettings());
    worldSampler mild(truth(0, 0.7), 200, added);
    const finding enough(diagnose(mild, set));
    EXPECT_TRUE(passes(enough, "adequacy"));
    EXPECT_EQ(enough.told.find("There is more to it"), std::string::npos);

    set.adequacy = 0.1;
    worldSampler strict(truth(0, 0.7), 200, added);
    const finding f(diagnose(strict, set));
    show(f);
    EXPECT_EQ(f.names, enough.names);
    EXPECT_NE(f.told.find("There is more to it"), std::string::npos) << f.told;
}


TEST(misfitDiagnosis, twoPackingsThatAreTheSameAreAnError)
{
    // The surge in closed form has no grains: all its packings are alike
    settings set(worldSettings());
    set.packings = 2;
    worldSampler s(truth(-1, 0), 100, vec());
    EXPECT_THROW(diagnose(s, set), Foam::error);
}


TEST(misfitDiagnosis, aCandidateThatCrashesTheSolverDropsOut)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.crashWith(3);
    const finding f(diagnose(s));
    EXPECT_EQ(f.verdict, "named");
    ASSERT_EQ(f.dropped.size(), 1);
    EXPECT_EQ(f.dropped[0].first(), "gate");
    EXPECT_NE(f.dropped[0].second().find("floating point"), std::string::npos);
}


TEST(misfitDiagnosis, aWrongSignScreensACandidateOutBeforeItIsRun)
{
    settings set(worldSettings());
    set.candidates[2].signs = {{"pressure", "peak", -1}};
    worldSampler s(truth(0, 0.7), 200, vec());
    const finding f(diagnose(s, set));
    ASSERT_EQ(f.dropped.size(), 1);
    EXPECT_EQ(f.dropped[0].first(), "longTail");
    EXPECT_EQ(f.verdict, "named");
    testNumber("different states in a diagnosis of five mechanisms", s.runs);
    EXPECT_LE(s.runs, 30);
}
