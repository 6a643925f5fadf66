// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of misfitFoam: covariance of readings, and the scan that looks for
// where they part from a simulation.

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


TEST(misfitCovariance, whatHasAMemoryIsAveragedOverRepeatsAlso)
{
    stacked data(oneChannel(6, 0.15));
    const mat once = covariance(data, 0).at(data.y);
    data.segments[0].repeats = 4;
    data.segments[0].readings *= 4;
    EXPECT_NEAR((4*covariance(data, 0).at(data.y) - once).norm(), 0, 1e-12);
}


TEST(misfitCovariance, whatEffectsHaveInCommonIsNotRaisedByChance)
{
    std::mt19937 generator(5);
    std::normal_distribution<scalar> normal;
    const statistics::whitener white(4*mat::Identity(50, 50));
    EXPECT_NEAR(white.normInCommon(2*vec::Ones(50)), std::sqrt(50.0), 1e-12);
    scalar square = 0;
    for (label k = 0; k < 400; ++k)
    {
        const mat effects = mat::NullaryExpr
        (
            50, 3, [&](Eigen::Index, Eigen::Index) { return 2 + 2*normal(generator); }
        );
        square += sqr(white.normInCommon(effects))/400;
    }
    EXPECT_NEAR(square, 50, 2);
    EXPECT_EQ
    (
        white.normInCommon((mat(50, 2) << vec::Ones(50), -vec::Ones(50)).finished()), 0
    );
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


TEST(misfitCovariance, ofRepeatedExperimentsNoiseAndChanceAreAShare)
{
    mat runs(10, 3);
    runs.leftCols(2).setRandom();
    runs.col(2) = -runs.col(0) - runs.col(1);
    const auto added = [&](const label first, const label second, const bool chance)
    {
        stacked data;
        for (const label repeats : {first, second})
        {
            segment s(oneChannel(5, 0).segments[0]);
            s.first = 5*data.segments.size();
            s.repeats = repeats;
            s.readings *= repeats;
            data.segments.push_back(s);
        }
        data.y = vec::Zero(10);
        covariance c(data, 0);
        const mat noise = c.at(data.y);
        c.addRepeats(runs, 1);
        return chance ? mat(c.at(data.y) - noise) : noise;
    };
    const mat once = added(1, 1, true);
    const mat more = added(3, 1, true);
    EXPECT_NEAR
    (
        (added(3, 1, false).diagonal().head(5).array() - 0.4/3).abs().sum(), 0, 1e-12
    );
    EXPECT_NEAR((more.block(0, 0, 5, 5) - once.block(0, 0, 5, 5)*2/3).norm(), 0, 1e-12);
    EXPECT_NEAR((more.block(5, 5, 5, 5) - once.block(5, 5, 5, 5)).norm(), 0, 1e-12);
    EXPECT_NEAR((more.block(0, 5, 5, 5) - once.block(0, 5, 5, 5)*2/3).norm(), 0, 1e-12);
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


TEST(misfitScan, falseAlarmsAreAsFewAsStated)
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
    const scanResult found(scanning(misfit, 0.05));
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
