// SPDX-License-Identifier: GPL-3.0-or-later
// When channels rise, and in which order recording and simulation first differ.

#include "departures.H"
#include "misfitWorld.H"
#include "testNumber.H"
#include "worldDiagnosis.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Evidence of a world whose gauge P3 departs from the start of its surge, P1 at 2 s, and
//  P2 and H1 not at all
stageResults twoDeparting()
{
    const world w(40);
    stageResults e;
    e.detection.data = w.data;
    e.detection.data.y = w(w.bounds.mean);
    e.detection.sigma = vec::Constant(w.data.size(), 10);
    const segment& h1 = w.data.segments[3];
    h1.of(e.detection.sigma).setConstant(0.002);
    e.detection.covariance = e.detection.sigma.cwiseAbs2().asDiagonal();
    for (label k = 0; k < 40; ++k)
    {
        w.data.segments[0].of(e.detection.data.y)[k] +=
            w.data.segments[0].x[k] > 2 ? 80 : 0;
        w.data.segments[2].of(e.detection.data.y)[k] +=
            w.data.segments[2].x[k] > 1 ? 80 : 0;
    }
    return e;
}

} // End anonymous namespace


TEST(misfitDepartures, whatDiffersFirstStandsFirst)
{
    const world w(40);
    const std::vector<departure> all
    (
        departuresOf(twoDeparting(), w(w.bounds.mean), worldSettings())
    );
    ASSERT_EQ(all.size(), 4);
    EXPECT_EQ(all[0].channel, "P3");
    EXPECT_NEAR(*all[0].differs, 1, 0.1);
    EXPECT_EQ(all[1].channel, "P1");
    EXPECT_NEAR(*all[1].differs, 2, 0.1);
    EXPECT_FALSE(all[2].differs || all[3].differs);

    // P1 is nearest to the gate
    EXPECT_NEAR(*all[1].simulated, 0.3, 0.1);
    EXPECT_LT(*all[1].simulated, *all[0].simulated);
    EXPECT_EQ(*all[2].recorded, *all[2].simulated);
}


TEST(misfitDepartures, whatDoesNotRiseDoesNotArrive)
{
    stageResults e(twoDeparting());
    const world w(40);
    w.data.segments[1].of(e.detection.data.y).setConstant(7);
    const std::vector<departure> all(departuresOf(e, w(w.bounds.mean), worldSettings()));
    ASSERT_EQ(all.size(), 4);
    for (const departure& d : all)
    {
        EXPECT_EQ(d.recorded.has_value(), d.channel != "P2");
        EXPECT_TRUE(d.simulated.has_value());
    }
}


TEST(misfitDepartures, noiseNeitherArrivesNorDiffers)
{
    // Of a gauge that is dry, in recordings that differ in their noise alone
    const label n = 300;
    std::mt19937 generator(49);
    const world w(40);
    const vec simulated = w(w.bounds.mean);
    stageResults e;
    e.detection.data = w.data;
    e.detection.covariance = mat::Zero(w.data.size(), w.data.size());
    for (const segment& s : w.data.segments)
    {
        const scalar variance = sqr(s.uncertainty)/s.readings[0];
        e.detection.covariance.diagonal().segment(s.first, s.size).setConstant(variance);
    }
    vec dry(simulated);
    w.data.segments[1].of(dry).setConstant(7);
    label arrivals = 0;
    label differences = 0;
    for (label k = 0; k < n; ++k)
    {
        e.detection.data.y = dry + w.noise(generator);
        bool arrives = false;
        bool differs = false;
        for (const departure& d : departuresOf(e, dry, worldSettings()))
        {
            arrives = arrives || (d.channel == "P2" && d.recorded);
            differs = differs || d.differs;
            EXPECT_TRUE(d.recorded || d.channel == "P2");
            EXPECT_FALSE(d.simulated && d.channel == "P2");
        }
        arrivals += arrives;
        differences += differs;
    }
    testNumber("of 300 dry gauges arrive", arrivals);
    testNumber("of 300 recordings differ by chance", differences);
    const scalar p = worldSettings().significance;
    const scalar most = n*p + 3*std::sqrt(n*p*(1 - p));
    EXPECT_LE(arrivals, most);
    EXPECT_LE(differences, most);
}


TEST(misfitDepartures, noiseBeforeASmallRiseIsNotItsArrival)
{
    // A fifth of the peak is a standard deviation of the noise
    const world w(40);
    std::mt19937 generator(49);
    const segment& s = w.data.segments[1];
    vec steps = vec::Zero(w.data.size());
    for (label k = 0; k < s.size; ++k)
    {
        steps[s.first + k] = s.x[k] > 3 ? 5 : 0;
    }
    stageResults e;
    e.detection.data = w.data;
    e.detection.covariance = mat::Identity(w.data.size(), w.data.size());
    std::normal_distribution<scalar> normal;
    label early = 0;
    for (label k = 0; k < 100; ++k)
    {
        e.detection.data.y = steps;
        for (scalar& y : e.detection.data.y)
        {
            y += normal(generator);
        }
        for (const departure& d : departuresOf(e, steps, worldSettings()))
        {
            early += d.recorded && *d.recorded < 2.8;
            EXPECT_EQ(d.simulated.has_value(), d.channel == "P2");
        }
    }
    testNumber("of 100 small rises arrive early", early);
    EXPECT_LE(early, 5 + 3*std::sqrt(5.0));
}


TEST(misfitDepartures, eachHasItsExperiment)
{
    stageResults e(twoDeparting());
    e.detection.data.segments[0].experiment = "A";
    e.detection.data.segments[2].experiment = "B";
    const world w(40);
    const std::vector<departure> all
    (
        departuresOf(e, w(w.bounds.mean), worldSettings())
    );
    EXPECT_EQ(all[0].experiment, "B");
    EXPECT_EQ(all[1].experiment, "A");
}


TEST(misfitDepartures, aDiagnosisHasThoseOfItsHeldOutChannelsToo)
{
    worldSampler s(truth(0, 0.7), 300, vec());
    const finding f(diagnose(s));
    ASSERT_EQ(f.departures.size(), 4);
    label validating = 0;
    for (const departure& d : f.departures)
    {
        validating += d.use == purpose::validation;
    }
    EXPECT_EQ(validating, 1);
    EXPECT_TRUE(f.departures.front().differs.has_value());
}
