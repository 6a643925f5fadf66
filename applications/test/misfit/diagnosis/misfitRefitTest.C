// SPDX-License-Identifier: GPL-3.0-or-later
// Refits in the solver: they settle where the surface is right, and turn back where
// it leads too far.

#include "refit.H"
#include "stages.H"
#include "worldDiagnosis.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- The solver gives steepness*x, and fails below a limit; the surface through the
//  last run has slope 1, so that each step overshoots if the steepness is above 2
class steepSolver
{
    const scalar steepness_;

    const scalar limit_;

    scalar at_ = 0;

    scalar given_ = 0;

public:

    explicit steepSolver(const scalar steepness, const scalar limit = -GREAT)
    :
        steepness_(steepness),
        limit_(limit)
    {}

    evaluation from(const scalar start)
    {
        refitSteps with;
        with.expand = [](const hypothesisFit& n)
        {
            return n.fit.x;
        };
        with.compute = [this](const vec& x)
        {
            samples s;
            s.calibration = steepness_*x;
            s.failure = x[0] < limit_ ? "below the limit" : "";
            return s;
        };
        with.passThrough = [this](const vec& x, const samples& s)
        {
            at_ = x[0];
            given_ = s.calibration[0];
        };
        with.stay = [this](hypothesisFit n)
        {
            n.score = sqr(given_ + n.fit.x[0] - at_);
            return n;
        };
        with.fit = [this](hypothesisFit n)
        {
            n.fit.x[0] = at_ - given_;
            return n;
        };
        hypothesisFit n;
        n.fit.x = vec::Constant(1, start);
        return refit(n, rules(), vec::Constant(1, 1), with);
    }
};

//- Explanations of a world that lacks the first mechanism, and how many runs the refit
//  took
struct rankedWorld
{
    worldSampler solver;

    settings set;

    study s;

    explanations explained;

    label runs = 0;


    explicit rankedWorld(const scalar within, const scalar share = 0)
    :
        solver(truth(0, 0.7), 300, vec()),
        set(worldSettings()),
        s(solver, set)
    {
        set.refitWithin = within;
        set.refitWithinShare = share;
        addUncertainty(s);
        const std::vector<int> failing(addCalibrationRuns(s));
        const hypothesisFit base(s.calibration.score().base());
        const screenedCandidates some(screen(s, base, failing));
        const std::vector<int> left(addSensitivityRuns(s, base, some).left);
        const label before = solver.runs();
        explained = rank(s, left, true);
        runs = solver.runs() - before;
    }
};

} // End anonymous namespace


TEST(misfitRefit, onlyWhatCouldStillWinIsComputedAgain)
{
    const rankedWorld all(GREAT);
    const rankedWorld some(4);
    EXPECT_LT(some.runs, all.runs);
    EXPECT_TRUE(some.explained.best().what == all.explained.best().what);
    EXPECT_NEAR(some.explained.best().score, all.explained.best().score, 1e-6);
    const scalar lowest = some.explained.lowestScore();
    label computed = 0;
    for (const hypothesisFit& w : some.explained.all())
    {
        const bool isComputed = some.explained.find(w.what);
        computed += isComputed;
        if (isComputed && !w.what.isNone())
        {
            EXPECT_LE(w.score, lowest + 4);
        }
    }
    EXPECT_EQ(computed, 2);
}


TEST(misfitRefit, howFarBehindMayStillWinGrowsWithTheMisfit)
{
    // The second is behind by a share of what the best gains over the base
    const rankedWorld all(GREAT);
    const rankedWorld none(0);
    std::vector<const hypothesisFit*> list(none.explained.byScore());
    const scalar gain = none.explained.baseline().score - list[0]->score;
    const scalar behind = list[1]->score - list[0]->score;
    ASSERT_GT(gain, 0);
    EXPECT_EQ(rankedWorld(0, 0.5*behind/gain).runs, none.runs);
    EXPECT_EQ(rankedWorld(0, 1).runs, all.runs);
    EXPECT_LT(none.runs, all.runs);
}


TEST(misfitRefit, theRunsThatAreForecastIncludeThoseThatCome)
{
    for (const scalar within : {4., 100., GREAT})
    {
        const rankedWorld r(within);
        const labelRange forecast(refitRuns(r.set));
        EXPECT_GE(r.runs, forecast.min());
        EXPECT_LE(r.runs, forecast.max());
    }
}


TEST(misfitRefit, aSurfaceThatIsNearlyRightIsFollowed)
{
    const evaluation s(steepSolver(1.2).from(1));
    EXPECT_NEAR(s.variables[0], 0, 0.05);
    EXPECT_NEAR(s.best.fit.x[0], 0, 0.01);
}


TEST(misfitRefit, whatGoesToAndFroTurnsBackAndEndsWhereItWasComputed)
{
    const evaluation s(steepSolver(3).from(1));
    EXPECT_LT(mag(s.variables[0]), 0.3);
    EXPECT_EQ(s.best.fit.x[0], s.variables[0]);
    EXPECT_EQ(s.computed.calibration[0], 3*s.variables[0]);
    EXPECT_NEAR(s.best.score, sqr(3*s.variables[0]), 1e-12);
}


TEST(misfitRefit, whereTheSolverFailsOnTheWayHalfOfItIsTried)
{
    const evaluation s(steepSolver(1.8, -0.6).from(1));
    EXPECT_TRUE(s.failure.empty());
    EXPECT_LT(mag(s.variables[0]), 0.3);
    EXPECT_TRUE(s.computed.ok());
}


TEST(misfitRefit, whereTheSolverFailsAtOnceTheFitStaysAndStatesWhy)
{
    const evaluation s(steepSolver(1, 2).from(1));
    EXPECT_EQ(s.failure, "below the limit");
    EXPECT_EQ(s.variables.size(), 0);
    EXPECT_EQ(s.best.fit.x[0], 1);
}
