// SPDX-License-Identifier: GPL-3.0-or-later
// What each kind of sensor fault makes of what should have been shown.

#include "misfitWorld.H"
#include "numbersAlone.H"
#include "worldDiagnosis.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

vec number(const scalar a)
{
    return vec::Constant(1, a);
}


//- The fault of that kind of P1; the one that has that factor
sensorFault ofP1(const world& w, const faultKind kind, const scalar factor = 1)
{
    for (const sensorFault& fault : possibleFaults(w.data, {kind}))
    {
        if (fault.channel == "P1" && fault.factor == factor)
        {
            return fault;
        }
    }
    ADD_FAILURE() << "P1 has no such fault";
    return sensorFault();
}

} // End anonymous namespace


TEST(misfitFaults, withoutSizeTheyChangeNothing)
{
    const world w;
    const vec f = w(w.bounds.mean);
    const std::vector<sensorFault> all
    (
        possibleFaults
        (
            w.data,
            {
                faultKind::lag, faultKind::gain, faultKind::zero, faultKind::drift,
                faultKind::clock, faultKind::clogged, faultKind::misplaced
            }
        )
    );

    // Six faults of each channel, and P1, P2, P3 each towards two others
    EXPECT_EQ(all.size(), 6*4 + 6);
    for (const sensorFault& fault : all)
    {
        EXPECT_NEAR((fault(w.data, f, vec::Zero(fault.size())) - f).norm(), 0, 1e-9)
            << describe(fault);
    }
}


TEST(misfitFaults, aLagIsTheExactAnswerToARamp)
{
    world w;
    const segment& s = w.data.segments[0];
    vec f = vec::Zero(w.data.size());
    s.of(f) = s.x.array() - s.x[0];
    const vec shown =
        ofP1(w, faultKind::lag)(w.data, f, number(0.5));
    for (label k = 0; k < s.size; ++k)
    {
        const scalar t = s.x[k] - s.x[0];
        EXPECT_NEAR(shown[k], t - 0.5*(1 - std::exp(-t/0.5)), 1e-9);
    }
}


TEST(misfitFaults, theOthersDoWhatTheyState)
{
    world w;
    const segment& s = w.data.segments[0];
    vec f = vec::Zero(w.data.size());
    s.of(f) = s.x;
    w.data.segments[1].of(f).setConstant(7);
    w.data.y = f;

    EXPECT_NEAR(ofP1(w, faultKind::gain)(w.data, f, number(0.2))[10], 1.2*s.x[10], 1e-12);
    EXPECT_NEAR(ofP1(w, faultKind::zero)(w.data, f, number(3))[10], s.x[10] + 3, 1e-12);
    EXPECT_NEAR(ofP1(w, faultKind::drift)(w.data, f, number(3))[39], s.x[39] + 3, 1e-12);
    EXPECT_NEAR
    (
        ofP1(w, faultKind::clock)(w.data, f, number(0.3))[20], s.x[20] - 0.3, 1e-9
    );
    EXPECT_NEAR(ofP1(w, faultKind::units, 10)(w.data, f, vec())[20], 10*s.x[20], 1e-9);
    EXPECT_NEAR
    (
        ofP1(w, faultKind::misplaced)(w.data, f, number(0.25))[20],
        0.75*s.x[20] + 0.25*7,
        1e-9
    );
    const vec swapped = ofP1(w, faultKind::swapped)(w.data, f, vec());
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
    const std::vector<sensorFault> all
    (
        possibleFaults(w.data, {faultKind::clock})
    );
    ASSERT_EQ(all.size(), n + 1);
    expectFault(all[0], faultKind::clock, "camera");
    EXPECT_EQ
    (
        describe(all[0], w.data.segments[0], number(0.3)),
        "camera's clock is 0.3 s late"
    );

    const vec moved = f - all[0](w.data, f, number(0.3));
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
    const vec there = f - all[0].elsewhere(held, f, number(0.3));
    EXPECT_NEAR(there[held.segments[0].first + 20], 0, 1e-12);
    EXPECT_NEAR(there[held.segments[2].first + 20], 0.3, 1e-9);
    EXPECT_EQ((all[1].elsewhere(held, f, number(0.3)) - f).norm(), 0);
}


TEST(misfitFaults, aRecorderHasAnotherClockInAnotherExperiment)
{
    // Four channels of one camera, two in each of two experiments
    world w;
    for (label i = 0; i < 4; ++i)
    {
        w.data.segments[i].recorder = "camera";
        w.data.segments[i].experiment = i < 2 ? "A" : "B";
    }
    vec f = vec::Zero(w.data.size());
    for (const segment& s : w.data.segments)
    {
        s.of(f) = s.x;
    }
    std::vector<sensorFault> cameras;
    for (const sensorFault& fault : possibleFaults(w.data, {faultKind::clock}))
    {
        if (fault.ofRecorder)
        {
            cameras.push_back(fault);
        }
    }
    ASSERT_EQ(cameras.size(), 2);
    EXPECT_FALSE(cameras[0] == cameras[1]);
    EXPECT_FALSE(cameras[0].blamesSame(cameras[1]));
    EXPECT_EQ(describe(cameras[1]), "clock of camera in experiment B");
    EXPECT_EQ
    (
        describe(cameras[0], w.data.segments[0], number(0.3)),
        "camera's clock is 0.3 s late in experiment A"
    );
    const vec moved = f - cameras[0](w.data, f, number(0.3));
    const vec elsewhere = f - cameras[0].elsewhere(w.data, f, number(0.3));
    for (label i = 0; i < 4; ++i)
    {
        const label middle = w.data.segments[i].first + 20;
        EXPECT_NEAR(moved[middle], i < 2 ? 0.3 : 0, 1e-9);
        EXPECT_NEAR(elsewhere[middle], i < 2 ? 0.3 : 0, 1e-9);
    }
}


TEST(misfitFaults, aNumberAloneHasNoTimeAndNoShape)
{
    const stacked data(numbers({1.0, 2.0}));
    EXPECT_EQ(data.segments[0].duration(), 1);
    EXPECT_EQ(data.segments[1].range(data.y), 2);

    const std::vector<sensorFault> all
    (
        possibleFaults
        (
            data,
            {
                faultKind::lag, faultKind::gain, faultKind::zero, faultKind::drift,
                faultKind::clock, faultKind::clogged, faultKind::swapped,
                faultKind::misplaced
            }
        )
    );
    ASSERT_EQ(all.size(), 2);
    expectFault(all[0], faultKind::gain, "n0");
    expectFault(all[1], faultKind::gain, "n1");
}
