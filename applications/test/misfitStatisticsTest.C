// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of misfitFoam: covariance, response surface, fit, scan.

#include "misfitWorld.H"
#include "scan.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- A channel of n samples of ten readings each, 0.1 s apart
stacked oneChannel(const label n, const scalar memory)
{
    stacked data;
    segment s;
    s.name = "S1";
    s.quantity = "pressure";
    s.size = n;
    s.x = vec::LinSpaced(n, 0, 0.1*(n - 1));
    s.span = 0.1;
    s.readings = vec::Constant(n, 10);
    s.uncertainty = 2;
    s.memory = memory;
    data.segments.push_back(s);
    data.y = vec::Zero(n);
    return data;
}


//- Noise with a memory, its samples averaged over ten readings
vec averagedNoise(const label n, const scalar memory, std::mt19937& generator)
{
    std::normal_distribution<scalar> normal;
    const scalar keep = std::exp(-0.01/memory);
    scalar e = normal(generator);
    vec v = vec::Zero(n);
    for (label k = 0; k < n; ++k)
    {
        for (label i = 0; i < 10; ++i)
        {
            v[k] += 0.1*2*e;
            e = keep*e + std::sqrt(1 - keep*keep)*normal(generator);
        }
    }
    return v;
}


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
class line
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


line threePoints()
{
    line l;
    l.a.resize(3, 2);
    l.a << 1, 0, 1, 1, 1, 2;
    l.priorMean = vec::Zero(2);
    l.priorDeviation = vec::Constant(2, 10);
    l.least = vec::Constant(2, -100);
    l.most = vec::Constant(2, 100);
    return l;
}

} // End anonymous namespace


TEST(misfitCovariance, whiteNoiseIsAveragedOverTheReadings)
{
    const stacked data(oneChannel(5, 0));
    const mat c = covariance(data, 0).at(data.y);
    EXPECT_NEAR((c - 0.4*mat::Identity(5, 5)).norm(), 0, 1e-12);
}


TEST(misfitCovariance, noiseWithAMemoryIsThatOfTheAveragedProcess)
{
    std::mt19937 generator(1);
    const label n = 6;
    const stacked data(oneChannel(n, 0.15));
    const mat expected = covariance(data, 0).at(data.y);
    mat found = mat::Zero(n, n);
    const label draws = 20000;
    for (label k = 0; k < draws; ++k)
    {
        const vec v = averagedNoise(n, 0.15, generator);
        found += v*v.transpose()/draws;
    }
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 0.04*expected(0, 0));
}


TEST(misfitCovariance, gainAndStartOfTimeAddTheirDirections)
{
    stacked data(oneChannel(5, 0));
    data.segments[0].gainUncertainty = 0.1;
    vec f(5);
    f << 0, 1, 4, 9, 16;
    const mat c = covariance(data, 0.02).at(f);
    vec slope(5);
    slope << 10, 20, 40, 60, 70;
    const mat expected =
        0.4*mat::Identity(5, 5) + 0.01*f*f.transpose()
      + 0.0004*slope*slope.transpose();
    EXPECT_NEAR((c - expected).norm(), 0, 1e-9);
}


TEST(misfitCovariance, itsSourcesMakeUpTheWhole)
{
    stacked data(oneChannel(40, 0));
    data.segments[0].gainUncertainty = 0.1;
    data.segments[0].zeroUncertainty = 3;
    const vec t = data.segments[0].x;
    const vec f = 100*t.array().sin();
    mat runs(40, 3);
    runs << f, 1.1*f, 0.8*f;

    covariance c(data, 0.02);
    c.addRepeats(runs, 1);
    c.addDifference("mesh", 0.05*f);
    const std::vector<uncertaintySource> sources(c.sources(f));
    ASSERT_EQ(sources.size(), 4);
    vec sum = vec::Zero(40);
    for (const uncertaintySource& s : sources)
    {
        EXPECT_GT(s.second.maxCoeff(), 0) << s.first;
        sum += s.second.cwiseAbs2();
    }
    const vec whole = c.at(f).diagonal();
    EXPECT_LT((sum - whole).cwiseAbs().maxCoeff(), 1e-9*whole.maxCoeff());

    // The change itself and its parametric part, which is twice as large
    EXPECT_EQ(sources[2].first, "mesh");
    EXPECT_NEAR
    (
        sources[2].second.squaredNorm(), 5*Foam::sqr(0.05)*f.squaredNorm(),
        0.3*5*Foam::sqr(0.05)*f.squaredNorm()
    );
    EXPECT_EQ(sources[3].first, "clock");
}


TEST(misfitCovariance, whatStandsStillHasNoUncertaintyOfTheStartOfTime)
{
    const stacked data(oneChannel(40, 0));
    const vec still = vec::Constant(40, 5);
    const std::vector<uncertaintySource> sources(covariance(data, 0.02).sources(still));
    EXPECT_EQ(sources[1].first, "clock");
    EXPECT_EQ(sources[1].second.maxCoeff(), 0);
}


TEST(misfitCovariance, twentyReplicatesGiveItsSizeAndMemory)
{
    std::mt19937 generator(3);
    const label n = 40;
    const stacked data(oneChannel(n, 0));
    mat runs(n, 20);
    for (label r = 0; r < 20; ++r)
    {
        runs.col(r) = 10*averagedNoise(n, 0.3, generator);
    }
    covariance c(data, 0);
    c.addRepeats(runs, 1);
    const mat all = c.at(data.y);

    // Twice the spread of the runs: the recording is one draw, the run another
    scalar spread = 0;
    for (label r = 0; r < 20; ++r)
    {
        spread += (runs.col(r) - runs.rowwise().mean()).squaredNorm()/19/n;
    }
    EXPECT_NEAR(all.trace()/n, 2*spread + 0.4, 0.1*spread);
    EXPECT_NEAR(c.memory()*data.segments[0].duration(), 0.3, 0.15);
    EXPECT_GT(c.shrinkage(), 0.3);

    // Whitened, a new run looks like independent numbers
    const whitener white(all);
    scalar sum = 0;
    for (label k = 0; k < 200; ++k)
    {
        const vec misfit =
            10*averagedNoise(n, 0.3, generator)
          - 10*averagedNoise(n, 0.3, generator);
        sum += white(misfit).squaredNorm()/n/200;
    }
    testNumber("mean square of whitened runs", sum);
    EXPECT_NEAR(sum, 1, 0.35);
}


TEST(misfitCovariance, correlatedSamplesCountForLess)
{
    EXPECT_NEAR(whitener(mat::Identity(7, 7)).effectiveSize(), 7, 1e-9);
    mat c = mat::Constant(7, 7, 0.999);
    c.diagonal().setOnes();
    EXPECT_NEAR(whitener(c).effectiveSize(), 1, 0.05);
}


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
    // 27 conditions with the same three parameters, and a few runs with others, each at three levels
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
    line l(threePoints());
    l.priorMean << 1, 2;
    l.priorDeviation << 0.5, 3;
    vec y(3);
    y << 2, 3, 7;
    const whitener white(0.25*mat::Identity(3, 3));
    const fitted best(statistics::fit(l, y, white));

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
    // A viscosity beside a density: the data say nothing of either
    line l(threePoints());
    l.a.setZero();
    l.priorMean.setZero();
    l.priorDeviation << 1e-8, 2;
    const whitener white(mat::Identity(3, 3));
    const vec y = vec::Zero(3);
    const fitted both(statistics::fit(l, y, white));
    EXPECT_NEAR(both.deviation(0), 1e-8, 1e-12);
    EXPECT_NEAR(both.deviation(1), 2, 1e-6);

    // Only their sum is known
    l.a.setOnes();
    l.priorDeviation.setZero();
    const fitted sum(statistics::fit(l, y, white));
    EXPECT_GT(sum.deviation(0), 1e3);
    EXPECT_GT(sum.deviation(1), 1e3);
}


TEST(misfitFit, aBoundHoldsAndIsTold)
{
    line l(threePoints());
    l.priorDeviation.setZero();
    l.least << -100, 0;
    vec y(3);
    y << 5, 4, 3;
    const fitted best(statistics::fit(l, y, whitener(mat::Identity(3, 3))));
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
    line l(threePoints());

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


TEST(misfitScan, falseAlarmsAreAsFewAsSaid)
{
    const world w;
    const covariance c(w.data, 0);
    const whitener white(c.at(w.data.y));
    const statistics::scan scanning(w.data, white, 1000, 1);
    std::mt19937 generator(11);
    label alarms = 0;
    const label n = 400;
    for (label k = 0; k < n; ++k)
    {
        alarms += scanning(w.noise(generator), 0.05).p < 0.05;
    }
    testNumber("false alarms of the scan [%]", 100.*alarms/n);

    // Twenty are expected; two and a half standard deviations beyond
    EXPECT_LE(alarms, 20 + 2.5*std::sqrt(20.));
    EXPECT_GE(alarms, 20 - 2.5*std::sqrt(20.));
}


TEST(misfitScan, aDifferenceIsFoundWhereItIs)
{
    const world w;
    const whitener white(covariance(w.data, 0).at(w.data.y));
    const statistics::scan scanning(w.data, white, 500, 1);
    std::mt19937 generator(4);
    vec misfit = w.noise(generator);
    misfit.segment(40 + 10, 8).array() -= 40;
    const scanned found(scanning(misfit, 0.05));
    EXPECT_LT(found.p, 0.01);
    ASSERT_EQ(found.windows.size(), 1);
    EXPECT_EQ(found.windows[0].segment, 1);
    EXPECT_NEAR(found.windows[0].begin, 10, 2);
    EXPECT_NEAR(found.windows[0].end, 18, 2);
    EXPECT_LT(found.windows[0].size, -4);
}


TEST(misfitScan, whatCalibrationCanExplainIsNoFinding)
{
    const world w;
    const mat c = covariance(w.data, 0).at(w.data.y);
    const statistics::responseSurface s(w.ensembleSurface(80, 2));
    const vec direction = s.slopes(w.bounds.mean).col(0);
    const mat all = statistics::withFitted(c, direction, vec::Zero(1));
    const whitener white(all);
    const statistics::scan scanning(w.data, white, 500, 1);
    std::mt19937 generator(4);
    const vec e = w.noise(generator);
    EXPECT_GT(scanning(e, 0.05).p, 0.05);
    EXPECT_GT(scanning(e + 0.3*direction, 0.05).p, 0.05);
}


TEST(misfitScan, aFreeDirectionOfOneChannelIsTakenOutBesideMuchLargerUnits)
{
    // 50 Pa and 1e-6 m: what is free of the second must not drown in the first
    const label n = 40;
    mat c = mat::Identity(2*n, 2*n)*sqr(50.0);
    c.bottomRightCorner(n, n) *= sqr(1e-6/50);
    mat direction = mat::Zero(2*n, 1);
    direction.bottomRows(n).setOnes();
    const whitener white(statistics::withFitted(c, direction, vec::Zero(1)));

    vec offset = vec::Zero(2*n);
    offset.tail(n).setConstant(1e-5);
    EXPECT_LT(white(offset).norm(), 0.1);

    vec wave = vec::Zero(2*n);
    for (label i = 0; i < n; ++i)
    {
        wave[n + i] = i % 2 ? 1e-6 : -1e-6;
    }
    EXPECT_NEAR(white(wave).squaredNorm()/n, 1, 1e-3);
}
