// SPDX-License-Identifier: GPL-3.0-or-later
// Sensor faults, and whether the right explanation is given the most weight, on
// a surge in closed form whose truth has another formula than the library's.

#include "misfitWorld.H"
#include "testNumber.H"

#include "scalarList.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

vec number(const scalar a)
{
    return vec::Constant(1, a);
}


//- Channels that are a number alone each, known to 0.02
stacked numbers(const scalarList& values)
{
    stacked data;
    data.y = vec::Zero(values.size());
    forAll(values, i)
    {
        segment s;
        s.name = "n" + Foam::name(i);
        s.quantity = "length";
        s.first = i;
        s.size = 1;
        s.x = vec::Zero(1);
        s.overTime = false;
        s.readings = vec::Ones(1);
        s.uncertainty = 0.02;
        data.segments.append(s);
        data.y[i] = values[i];
    }
    return data;
}


//- The best explanation of recorded samples
List<weighed> explain(world& w, const responseSurface& surface, const vec& y)
{
    w.data.y = y;
    covariance c(w.data, 0.005);
    c.addSpread("between the runs", surface.leftOut(), 1);
    using kind = sensorFault::kind;
    List<weighed> list
    (
        weighing(w.data, surface, w.bounds, c).all
        (
            {0, 1, 2, 3, 4},
            possibleFaults
            (
                w.data,
                {
                    kind::lag, kind::gain, kind::zero, kind::drift, kind::clock,
                    kind::clogged, kind::swapped, kind::misplaced, kind::units
                }
            ),
            true
        )
    );
    setProbabilities(list, 1);
    return list;
}


//- Parameters drawn from their priors, no mechanism
vec drawn(const world& w, std::mt19937& generator)
{
    std::normal_distribution<scalar> normal;
    vec x = vec::Zero(w.bounds.mean.size());
    for (label p = 0; p < world::nParameters; ++p)
    {
        x[p] = 0.1*min(max(normal(generator), -2.), 2.);
    }
    return x;
}

} // End anonymous namespace


TEST(misfitFaults, withoutSizeTheyChangeNothing)
{
    const world w;
    const vec f = w(w.bounds.mean);
    using kind = sensorFault::kind;
    const List<sensorFault> all
    (
        possibleFaults
        (
            w.data,
            {
                kind::lag, kind::gain, kind::zero, kind::drift, kind::clock,
                kind::clogged, kind::misplaced
            }
        )
    );

    // Six faults of each channel, and P1, P2, P3 each towards two others
    EXPECT_EQ(all.size(), 6*4 + 6);
    for (const sensorFault& fault : all)
    {
        EXPECT_NEAR((fault(f, vec::Zero(fault.size())) - f).norm(), 0, 1e-9)
            << fault.told();
    }
}


TEST(misfitFaults, aLagIsTheExactAnswerToARamp)
{
    world w;
    const segment& s = w.data.segments[0];
    vec f = vec::Zero(w.data.size());
    s.of(f) = s.x.array() - s.x[0];
    const sensorFault lag(w.data, sensorFault::kind::lag, 0);
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
    using kind = sensorFault::kind;

    EXPECT_NEAR(sensorFault(w.data, kind::gain, 0)(f, number(0.2))[10], 1.2*s.x[10], 1e-12);
    EXPECT_NEAR(sensorFault(w.data, kind::zero, 0)(f, number(3))[10], s.x[10] + 3, 1e-12);
    EXPECT_NEAR(sensorFault(w.data, kind::drift, 0)(f, number(3))[39], s.x[39] + 3, 1e-12);
    EXPECT_NEAR(sensorFault(w.data, kind::clock, 0)(f, number(0.3))[20], s.x[20] - 0.3, 1e-9);
    EXPECT_NEAR(sensorFault(w.data, kind::units, 0, -1, 10)(f, vec(0))[20], 10*s.x[20], 1e-9);
    EXPECT_NEAR
    (
        sensorFault(w.data, kind::misplaced, 0, 1)(f, number(0.25))[20],
        0.75*s.x[20] + 0.25*7,
        1e-9
    );
    const vec swapped = sensorFault(w.data, kind::swapped, 0, 1)(f, vec(0));
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
    const List<sensorFault> all
    (
        possibleFaults(w.data, {sensorFault::kind::clock})
    );
    ASSERT_EQ(all.size(), n + 1);
    EXPECT_EQ(all[0].told(), "clock of camera");
    EXPECT_EQ(all[0].told(number(0.3)), "camera's clock is 0.3 s late");

    const vec moved = f - all[0](f, number(0.3));
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


TEST(misfitWeighing, aLateRecorderIsTakenForThatAndNotForItsChannels)
{
    world w(20);
    w.data.segments[0].recorder = w.data.segments[1].recorder = "logger";
    const responseSurface surface(w.bank(120, 2));
    const vec f = w(w.bounds.mean);
    const List<sensorFault> clocks
    (
        possibleFaults(w.data, {sensorFault::kind::clock})
    );
    const List<weighed> list(explain(w, surface, clocks[0](f, number(0.15))));
    ASSERT_TRUE(list.first().what.fault != nullptr);
    EXPECT_EQ(list.first().what.fault->told(), "clock of logger");
}


TEST(misfitFaults, aNumberAloneHasNoTimeAndNoShape)
{
    const stacked data(numbers({1.0, 2.0}));
    EXPECT_EQ(data.segments[0].duration(), 1);
    EXPECT_EQ(data.segments[1].range(data.y), 2);

    using kind = sensorFault::kind;
    const List<sensorFault> all
    (
        possibleFaults
        (
            data,
            {
                kind::lag, kind::gain, kind::zero, kind::drift, kind::clock,
                kind::clogged, kind::swapped, kind::misplaced
            }
        )
    );
    ASSERT_EQ(all.size(), 2);
    EXPECT_EQ(all[0].told(), "gain of n0");
    EXPECT_EQ(all[1].told(), "gain of n1");
}


TEST(misfitWeighing, numbersAloneNameAMechanism)
{
    // One parameter and two mechanisms, each with its own effect on six numbers
    static constexpr label n = 6;
    const auto truth = [](const vec& x)
    {
        vec f(n);
        for (label i = 0; i < n; ++i)
        {
            f[i] = 1 + 0.1*x[0] + 0.1*i*x[1] + 0.3*(i % 2)*x[2];
        }
        return f;
    };
    vec recorded(vec::Zero(3));
    recorded << 0.3, 0.8, 0;

    stacked data(numbers(scalarList(n, 1.0)));
    data.y = truth(recorded);
    variableBounds bounds;
    bounds.nParameters = 1;
    bounds.mean = bounds.deviation = bounds.lower = vec::Zero(3);
    bounds.deviation[0] = 0.5;
    bounds.lower[0] = -2;
    bounds.upper = vec::Constant(3, 2);

    mat x = mat::Zero(3, 7);
    for (label k = 0; k < 3; ++k)
    {
        x(k, 1 + 2*k) = 0.5;
        x(k, 2 + 2*k) = 1;
    }
    mat y(n, x.cols());
    for (label k = 0; k < x.cols(); ++k)
    {
        y.col(k) = truth(x.col(k));
    }
    const responseSurface surface(x, y, bounds.mean, vec(vec::Ones(3)));
    const covariance known(data, 0);
    const List<weighed> list
    (
        weighing(data, surface, bounds, known).all
        (
            {0, 1},
            possibleFaults(data, {sensorFault::kind::gain}),
            true
        )
    );
    EXPECT_EQ(list.first().what.mechanisms, List<label>({0}));
    EXPECT_NEAR(list.first().best.x[1], 0.8, 0.1);
    for (const weighed& w : list)
    {
        EXPECT_TRUE(std::isfinite(w.score));
    }
}


TEST(misfitWeighing, slopesOfAFaultyModelAreDifferences)
{
    world w(20);
    w.data.y = w(w.bounds.mean);
    const responseSurface surface(w.bank(80, 2));
    using kind = sensorFault::kind;
    for (const sensorFault& fault : possibleFaults(w.data, {kind::lag, kind::clogged, kind::gain}))
    {
        hypothesis h;
        h.mechanisms = {0};
        h.fault = std::make_shared<const sensorFault>(fault);
        const hypothesisModel model(surface, w.bounds, h);
        const vec x = model.starts()[0];
        const mat slopes = model.slopes(x);
        for (label i = 0; i < x.size(); ++i)
        {
            vec beside = x;
            beside[i] += 1e-6;
            EXPECT_LT
            (
                ((model(beside) - model(x))/1e-6 - slopes.col(i)).norm(),
                1e-3*(1 + slopes.col(i).norm())
            ) << fault.told() << ' ' << i;
        }
    }
}


TEST(misfitWeighing, aMistunedModelIsNotTakenForMissingPhysics)
{
    world w(20);
    const responseSurface surface(w.bank(120, 2));
    std::mt19937 generator(21);
    label named = 0;
    const label n = 60;
    for (label k = 0; k < n; ++k)
    {
        const vec y = w(drawn(w, generator)) + w.noise(generator);
        const auto list(explain(w, surface, y));
        named += !list[0].what.isNone() && list[0].probability > 0.9;
    }
    testNumber("nulls with another explanation [%]", 100.*named/n);
    EXPECT_LE(named, 3);
}


TEST(misfitWeighing, eachMechanismIsGivenTheMostWeightAlthoughItsFormulaDiffers)
{
    world w(20);
    const responseSurface surface(w.bank(120, 2));
    std::mt19937 generator(22);
    label right = 0;
    const label n = 40;
    for (label k = 0; k < n; ++k)
    {
        const label m = k % world::nMechanisms;
        vec x = drawn(w, generator);
        x[world::nParameters + m] = 0.7;
        const vec y = w(x, 1) + w.noise(generator);
        const auto list(explain(w, surface, y));
        const bool hit = list[0].what.mechanisms == List<label>({m});
        right += hit;
        if (!hit)
        {
            std::printf
            (
                "%s taken for %s\n",
                world::mechanism(m).c_str(),
                list[0].what.fault ? list[0].what.fault->told().c_str()
              : list[0].what.unknown ? "unknown"
              : list[0].what.mechanisms.size()
              ? world::mechanism(list[0].what.mechanisms[0]).c_str() : "none"
            );
        }
    }
    testNumber("mechanisms with the most weight [%]", 100.*right/n);
    EXPECT_GE(right, 36);
}


TEST(misfitWeighing, aFaultySensorIsNotTakenForPhysics)
{
    world w(20);
    const responseSurface surface(w.bank(120, 2));
    std::mt19937 generator(23);
    using kind = sensorFault::kind;
    const std::pair<kind, scalar> faults[] =
    {
        {kind::lag, 0.3}, {kind::gain, -0.2}, {kind::zero, 80},
        {kind::drift, 150}, {kind::clock, 0.25}
    };
    label right = 0;
    label physics = 0;
    label n = 0;
    for (const auto& f : faults)
    {
        for (label c = 0; c < 3; ++c)
        {
            const vec y =
                sensorFault(w.data, f.first, c)(w(drawn(w, generator)), number(f.second))
              + w.noise(generator);
            const auto list(explain(w, surface, y));
            const auto& best = list[0].what;
            right += best.fault && best.fault->channel() == w.data.segments[c].name;
            physics += best.mechanisms.size() > 0;
            ++n;
        }
    }
    testNumber("faults found in the right channel [%]", 100.*right/n);
    EXPECT_GE(right, n - 1);
    EXPECT_EQ(physics, 0);
}


TEST(misfitWeighing, whatIsNotInTheLibraryIsUnknown)
{
    world w(20);
    const responseSurface surface(w.bank(120, 2));
    std::mt19937 generator(24);
    label unknown = 0;
    const label n = 10;
    for (label k = 0; k < n; ++k)
    {
        vec y = w(drawn(w, generator)) + w.noise(generator);

        // A wave that comes back from the end and passes all gauges in turn
        forAll(w.data.segments, i)
        {
            const segment& s = w.data.segments[i];
            const scalar size = s.quantity == "pressure" ? 150 : 0.015;
            s.of(y).array() +=
                size*(-((s.x.array() - 3.2 + 0.3*i)/0.25).square()).exp();
        }
        unknown += explain(w, surface, y)[0].what.unknown;
    }
    testNumber("waves from outside the library taken as unknown [%]", 100.*unknown/n);
    EXPECT_GE(unknown, 9);
}
