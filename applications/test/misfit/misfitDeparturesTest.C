// SPDX-License-Identifier: GPL-3.0-or-later
// When channels rise, and in which order recording and simulation first differ.

#include "departures.H"
#include "misfitWorld.H"
#include "worldDiagnosis.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Evidence of a world whose gauge P3 departs from the start of its surge, P1 at 2 s, and
//  P2 and H1 not at all
evidence twoDeparting()
{
    const world w(40);
    evidence e;
    e.detection.data = w.data;
    e.detection.data.y = w(w.bounds.mean);
    e.detection.sigma = vec::Constant(w.data.size(), 10);
    const segment& h1 = w.data.segments[3];
    h1.of(e.detection.sigma).setConstant(0.002);
    for (label k = 0; k < 40; ++k)
    {
        w.data.segments[0].of(e.detection.data.y)[k] += w.data.segments[0].x[k] > 2 ? 80 : 0;
        w.data.segments[2].of(e.detection.data.y)[k] += w.data.segments[2].x[k] > 1 ? 80 : 0;
    }
    return e;
}

} // End anonymous namespace


TEST(misfitDepartures, whatDiffersFirstStandsFirst)
{
    const world w(40);
    const std::vector<departure> all
    (
        departuresOf(twoDeparting(), w(w.bounds.mean), 2)
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
    evidence e(twoDeparting());
    const world w(40);
    w.data.segments[1].of(e.detection.data.y).setConstant(7);
    for (const departure& d : departuresOf(e, w(w.bounds.mean), 2))
    {
        EXPECT_EQ(d.recorded.has_value(), d.channel != "P2");
        EXPECT_TRUE(d.simulated.has_value());
    }
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
