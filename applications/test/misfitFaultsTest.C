// SPDX-License-Identifier: GPL-3.0-or-later
// What each kind of sensor fault makes of what should have been shown.

#include "clockFault.H"
#include "driftFault.H"
#include "gainFault.H"
#include "lagFault.H"
#include "misplacedFault.H"
#include "swappedFault.H"
#include "unitsFault.H"
#include "zeroFault.H"
#include "misfitWorld.H"
#include "numbersAlone.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

vec number(const scalar a)
{
    return vec::Constant(1, a);
}


recordedPtr recorded(const world& w)
{
    return std::make_shared<const stacked>(w.data);
}

} // End anonymous namespace


TEST(misfitFaults, withoutSizeTheyChangeNothing)
{
    const world w;
    const vec f = w(w.bounds.mean);
    const faultList all
    (
        possibleFaults
        (
            w.data,
            {
                "lag", "gain", "zero", "drift", "clock",
                "clogged", "misplaced"
            }
        )
    );

    // Six faults of each channel, and P1, P2, P3 each towards two others
    EXPECT_EQ(all.size(), 6*4 + 6);
    for (const auto& fault : all)
    {
        EXPECT_NEAR(((*fault)(f, vec::Zero(fault->size())) - f).norm(), 0, 1e-9)
            << fault->told();
    }
}


TEST(misfitFaults, aLagIsTheExactAnswerToARamp)
{
    world w;
    const segment& s = w.data.segments[0];
    vec f = vec::Zero(w.data.size());
    s.of(f) = s.x.array() - s.x[0];
    const lagFault lag(recorded(w), 0);
    const vec shown = lag(f, number(0.5));
    for (label k = 0; k < s.size; ++k)
    {
        const scalar t = s.x[k] - s.x[0];
        EXPECT_NEAR(shown[k], t - 0.5*(1 - std::exp(-t/0.5)), 1e-9);
    }
}


TEST(misfitFaults, theOthersDoWhatTheySay)
{
    world w;
    const segment& s = w.data.segments[0];
    vec f = vec::Zero(w.data.size());
    s.of(f) = s.x;
    w.data.segments[1].of(f).setConstant(7);

    EXPECT_NEAR(gainFault(recorded(w), 0)(f, number(0.2))[10], 1.2*s.x[10], 1e-12);
    EXPECT_NEAR(zeroFault(recorded(w), 0)(f, number(3))[10], s.x[10] + 3, 1e-12);
    EXPECT_NEAR(driftFault(recorded(w), 0)(f, number(3))[39], s.x[39] + 3, 1e-12);
    EXPECT_NEAR(clockFault(recorded(w), {0})(f, number(0.3))[20], s.x[20] - 0.3, 1e-9);
    EXPECT_NEAR(unitsFault(recorded(w), 0, 10)(f, vec())[20], 10*s.x[20], 1e-9);
    EXPECT_NEAR
    (
        misplacedFault(recorded(w), 0, 1)(f, number(0.25))[20],
        0.75*s.x[20] + 0.25*7,
        1e-9
    );
    const vec swapped = swappedFault(recorded(w), 0, 1)(f, vec());
    EXPECT_NEAR(swapped[20], 7, 1e-12);
    EXPECT_NEAR(swapped[60], s.x[20], 1e-12);
}


TEST(misfitFaults, theClockOfARecorderMovesAllItsChannels)
{
    world w;
    const label n = w.data.segments.size();
    w.data.segments[0].recorder = w.data.segments[2].recorder = "camera";
    vec f = vec::Zero(w.data.size());
    for (const segment& s : w.data.segments)
    {
        s.of(f) = s.x;
    }
    const faultList all
    (
        possibleFaults(w.data, {"clock"})
    );
    ASSERT_EQ(all.size(), n + 1);
    EXPECT_EQ(all[0]->told(), "clock of camera");
    EXPECT_EQ(all[0]->told(number(0.3)), "camera's clock is 0.3 s late");

    const vec moved = f - (*all[0])(f, number(0.3));
    for (label i = 0; i < n; ++i)
    {
        const bool here = i == 0 || i == 2;
        EXPECT_NEAR
        (
            moved[w.data.segments[i].first + 20], here ? 0.3 : 0, 1e-9
        );
    }

    // Of channels that were held out, those of the recorder are late as well
    stacked held(w.data);
    held.segments[0].recorder = "";
    const vec there = f - all[0]->elsewhere(held, f, number(0.3));
    EXPECT_NEAR(there[held.segments[0].first + 20], 0, 1e-12);
    EXPECT_NEAR(there[held.segments[2].first + 20], 0.3, 1e-9);
    EXPECT_EQ((all[1]->elsewhere(held, f, number(0.3)) - f).norm(), 0);
}


TEST(misfitFaults, aNumberAloneHasNoTimeAndNoShape)
{
    const stacked data(numbers({1.0, 2.0}));
    EXPECT_EQ(data.segments[0].duration(), 1);
    EXPECT_EQ(data.segments[1].range(data.y), 2);

    const faultList all
    (
        possibleFaults
        (
            data,
            {
                "lag", "gain", "zero", "drift", "clock",
                "clogged", "swapped", "misplaced"
            }
        )
    );
    ASSERT_EQ(all.size(), 2);
    EXPECT_EQ(all[0]->told(), "gain of n0");
    EXPECT_EQ(all[1]->told(), "gain of n1");
}
