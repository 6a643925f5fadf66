// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of misfitFoam: response surface, and fit with priors and bounds.

#include "misfitWorld.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- A quadratic in two variables, three samples
vec quadratic(const vec& x)
{
    vec f(3);
    f << 1 + 2*x[0] - x[1] + x[0]*x[0],
        3*x[1] + 0.5*x[1]*x[1],
        x[0] + 2*x[0]*x[1];
    return f;
}


//- A straight line through the samples, with priors and bounds
class straightLine
:
    public statistics::fittedModel
{
public:

    mat a;
    vec priorMean, priorDeviation, least, most;

    vec operator()(const vec& x) const override
    {
        return a*x;
    }

    mat slopes(const vec&) const override
    {
        return a;
    }

    vec lower() const override
    {
        return least;
    }

    vec upper() const override
    {
        return most;
    }

    vec mean() const override
    {
        return priorMean;
    }

    vec deviation() const override
    {
        return priorDeviation;
    }
};


straightLine threePoints()
{
    straightLine l;
    l.a.resize(3, 2);
    l.a << 1, 0, 1, 1, 1, 2;
    l.priorMean = vec::Zero(2);
    l.priorDeviation = vec::Constant(2, 10);
    l.least = vec::Constant(2, -100);
    l.most = vec::Constant(2, 100);
    return l;
}

} // End anonymous namespace


TEST(misfitSurface, eachUnknownChangedAloneGivesItsQuadratic)
{
    mat x(2, 5);
    x << 0, 1, -1, 0, 0,
        0, 0, 0, 0.5, 2;
    mat y(3, 5);
    for (label r = 0; r < 5; ++r)
    {
        y.col(r) = quadratic(x.col(r));
    }
    const statistics::responseSurface s(x, y, vec::Zero(2), vec::Constant(2, 1));
    EXPECT_EQ(s.nTerms(), 5);
    EXPECT_EQ(s.leftOut().cols(), 0);
    vec at(2);
    at << 0.7, 0;
    EXPECT_NEAR((s(at) - quadratic(at)).norm(), 0, 1e-9);
    at << 0, 1.3;
    EXPECT_NEAR((s(at) - quadratic(at)).norm(), 0, 1e-9);
}


TEST(misfitSurface, runsUnderOneValueOfAVariableAreNoneToSpareForItsMixedTerms)
{
    // 27 conditions with the same three parameters, and a few runs with others, each at
    // three levels
    std::mt19937 generator(7);
    std::uniform_real_distribution<scalar> any(-1, 1);
    const label nOld = 27;
    const label nNew = 12;
    mat x(6, nOld + nNew);
    for (label r = 0; r < nOld; ++r)
    {
        x.col(r) << r % 3 - 1, (r/3) % 3 - 1, r/9 - 1, 1, -2, -1;
    }
    for (label r = nOld; r < nOld + nNew; ++r)
    {
        x.col(r) << any(generator), any(generator), any(generator),
            r % 3 - 1, (r/3) % 3 - 1, (r + r/3) % 3 - 1;
    }
    mat y(1, x.cols());
    for (label r = 0; r < x.cols(); ++r)
    {
        y(0, r) = any(generator);
    }

    const vec zero(vec::Zero(6));
    const vec one(vec::Ones(6));
    const statistics::responseSurface all(x, y, zero, one);
    EXPECT_GT(all.leverage().tail(nNew).minCoeff(), 0.95);

    const statistics::responseSurface conditionsOnly
    (
        x, y, zero, one, {true, true, true, false, false, false}
    );
    EXPECT_EQ(conditionsOnly.nTerms(), 16);
    EXPECT_EQ(conditionsOnly.leftOut().cols(), nOld + nNew);
    EXPECT_LT(conditionsOnly.leverage().maxCoeff(), 0.95);
    EXPECT_NEAR(conditionsOnly.leverage().sum(), 16, 1e-9);
}


TEST(misfitSurface, aTrainingEnsembleGivesMixedTermsAndItsOwnError)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<scalar> any(-1, 1);
    std::normal_distribution<scalar> normal;
    mat x(2, 30);
    mat y(3, 30);
    for (label r = 0; r < 30; ++r)
    {
        x.col(r) << any(generator), any(generator);
        y.col(r) = quadratic(x.col(r));
        y(1, r) += 0.1*normal(generator);
    }
    const statistics::responseSurface s(x, y, vec::Zero(2), vec::Constant(2, 2));
    EXPECT_EQ(s.nTerms(), 6);
    vec at(2);
    at << 0.3, -0.6;
    EXPECT_NEAR(s(at)[0], quadratic(at)[0], 1e-9);
    EXPECT_NEAR(s(at)[2], quadratic(at)[2], 1e-9);
    EXPECT_NEAR(s(at)[1], quadratic(at)[1], 0.15);

    // The error at a run is what a surface made without that run shows
    ASSERT_EQ(s.leftOut().cols(), 30);
    for (label r = 0; r < 30; ++r)
    {
        mat otherX(2, 29);
        mat otherY(3, 29);
        otherX << x.leftCols(r), x.rightCols(29 - r);
        otherY << y.leftCols(r), y.rightCols(29 - r);
        const statistics::responseSurface without
        (
            otherX, otherY, vec::Zero(2), vec::Constant(2, 2)
        );
        EXPECT_NEAR
        (
            (y.col(r) - without(x.col(r)) - s.leftOut().col(r)).norm(), 0, 1e-9
        );
    }
}


TEST(misfitSurface, slopesAreDifferencesAndARunIsMet)
{
    const world w(10);
    statistics::responseSurface s(w.ensembleSurface(80, 2));
    vec at = vec::Constant(w.bounds.mean.size(), 0.2);
    const mat slopes = s.slopes(at);
    for (label i = 0; i < at.size(); ++i)
    {
        vec beside = at;
        beside[i] += 1e-6;
        EXPECT_LT
        (
            ((s(beside) - s(at))/1e-6 - slopes.col(i)).norm(),
            1e-4*(1 + slopes.col(i).norm())
        );
    }
    const vec run = w(at);
    EXPECT_GT((s(at) - run).norm(), 1e-3);
    s.passThrough(at, run);
    EXPECT_NEAR((s(at) - run).norm(), 0, 1e-9);
}


TEST(misfitFit, withAPriorItIsTheClosedForm)
{
    straightLine l(threePoints());
    l.priorMean << 1, 2;
    l.priorDeviation << 0.5, 3;
    vec y(3);
    y << 2, 3, 7;
    const whitener white(0.25*mat::Identity(3, 3));
    const fitResult best(statistics::fit(l, y, white));

    mat precision = 4*l.a.transpose()*l.a;
    precision(0, 0) += 4;
    precision(1, 1) += 1./9;
    vec right = 4*l.a.transpose()*y;
    right[0] += 4*1;
    right[1] += 2./9;
    const vec expected = precision.inverse()*right;
    EXPECT_NEAR((best.x - expected).norm(), 0, 1e-6);
    EXPECT_NEAR((best.covariance - precision.inverse()).norm(), 0, 1e-9);
    EXPECT_NEAR(best.misfit, 4*(y - l.a*expected).squaredNorm(), 1e-6);
}


TEST(misfitFit, variancesHaveAnyUnitsAndAFlatDirectionIsNotKnown)
{
    // A viscosity beside a density: the data determine neither
    straightLine l(threePoints());
    l.a.setZero();
    l.priorMean.setZero();
    l.priorDeviation << 1e-8, 2;
    const whitener white(mat::Identity(3, 3));
    const vec y = vec::Zero(3);
    const fitResult both(statistics::fit(l, y, white));
    EXPECT_NEAR(both.deviation(0), 1e-8, 1e-12);
    EXPECT_NEAR(both.deviation(1), 2, 1e-6);

    // Only their sum is known
    l.a.setOnes();
    l.priorDeviation.setZero();
    const fitResult sum(statistics::fit(l, y, white));
    EXPECT_GT(sum.deviation(0), 1e3);
    EXPECT_GT(sum.deviation(1), 1e3);
}


TEST(misfitFit, variablesOfNearlyTheSameEffectAreFittedToTheEnd)
{
    // Columns that are nearly parallel
    straightLine l(threePoints());
    l.a << 1, 1, 1, 1.01, 1, 1.02;
    l.priorDeviation.setZero();
    const vec truth = vec{{-40., 42.}};
    const fitResult best
    (
        statistics::fit(l, vec(l.a*truth), whitener(mat::Identity(3, 3)))
    );
    EXPECT_LT(best.misfit, 1e-6);
    EXPECT_NEAR((best.x - truth).norm(), 0, 0.1);
}


TEST(misfitFit, aVariableWhoseBoundsAreTheSameStays)
{
    for (const scalar at : {0., 1000.})
    {
        straightLine l(threePoints());
        l.priorDeviation.setZero();
        l.least[0] = l.most[0] = l.priorMean[0] = at;
        const vec y = vec{{at, at + 2, at + 4}};
        const fitResult best(statistics::fit(l, y, whitener(mat::Identity(3, 3))));
        EXPECT_EQ(best.x[0], at);
        EXPECT_NEAR(best.x[1], 2, 1e-6);
    }
}


TEST(misfitFit, whatIsBeyondAllScoresIsAnError)
{
    const vec y = vec{{1e9, 0., 0.}};
    EXPECT_THROW
    (
        statistics::fit(threePoints(), y, whitener(mat::Identity(3, 3))),
        std::domain_error
    );
}


TEST(misfitFit, aBoundHoldsAndIsReported)
{
    straightLine l(threePoints());
    l.priorDeviation.setZero();
    l.least << -100, 0;
    vec y(3);
    y << 5, 4, 3;
    const fitResult best(statistics::fit(l, y, whitener(mat::Identity(3, 3))));
    EXPECT_NEAR(best.x[1], 0, 1e-9);
    EXPECT_NEAR(best.x[0], 4, 1e-6);
    EXPECT_TRUE(best.pinned[1]);
    EXPECT_FALSE(best.pinned[0]);
    EXPECT_EQ(best.deviation(1), 0);
    EXPECT_NEAR(best.deviation(0), std::sqrt(1./3), 1e-9);
}


TEST(misfitFit, withinBoundsNoVariableIsSurerOrLessSureThanTheyLeave)
{
    const whitener white(mat::Identity(3, 3));
    straightLine l(threePoints());

    // At a bound, and by the prior: the closed form
    l.most = vec::Zero(2);
    const mat curvature =
        l.a.transpose()*l.a + mat(vec::Constant(2, 0.01).asDiagonal());
    const mat known = statistics::covarianceWithin(l, white, vec::Zero(2));
    EXPECT_LT((known*curvature - mat::Identity(2, 2)).norm(), 1e-10);

    // Two that act alike: along what no sample shows, the width of the bounds
    l.a << 1, 2, 1, 2, 1, 2;
    l.priorDeviation.setZero();
    l.least = vec::Zero(2);
    l.most = vec::Constant(2, 2);
    vec hidden(2);
    hidden << 2, -1;
    hidden.normalize();
    const mat open = statistics::covarianceWithin(l, white, vec::Zero(2));
    EXPECT_NEAR(hidden.dot(open*hidden), 4, 1e-6);
}
