// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the right explanation is given the most weight, on a surge in closed form
// whose truth has another formula than the library's.

#include "misfitWorld.H"
#include "numbersAlone.H"
#include "testNumber.H"
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


//- The best explanation of recorded samples
std::vector<hypothesisFit> explain
(
    world& w,
    const statistics::responseSurface& surface,
    const vec& y
)
{
    w.data.y = y;
    covariance c(w.data, 0.005);
    c.addSpread("between the runs", surface.leftOut(), 0, 1);
    std::vector<hypothesisFit> list
    (
        scoring(w.data, surface, w.bounds, c).all
        (
            {0, 1, 2, 3, 4},
            possibleFaults
            (
                w.data,
                {
                    faultKind::lag, faultKind::gain, faultKind::zero, faultKind::drift,
                    faultKind::clock, faultKind::clogged, faultKind::swapped,
                    faultKind::misplaced, faultKind::units
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


TEST(misfitScoring, aLateRecorderIsTakenForThatAndNotForItsChannels)
{
    world w(20);
    w.data.segments[0].recorder = w.data.segments[1].recorder = "logger";
    const statistics::responseSurface surface(w.ensembleSurface(120, 2));
    const vec f = w(w.bounds.mean);
    const std::vector<sensorFault> clocks
    (
        possibleFaults(w.data, {faultKind::clock})
    );
    const std::vector<hypothesisFit> list
    (
        explain(w, surface, clocks[0](w.data, f, number(0.15)))
    );
    expectFault(list.front().what.fault, faultKind::clock, "logger");
}


TEST(misfitScoring, whatAClockMovesBeyondTheEndsDoesNotCount)
{
    // P1 rises to its end; it is shown 0.6 s early, so that its last 6 samples were
    // recorded after what was computed
    world w(40);
    const label n = w.bounds.mean.size();
    const segment& s = w.data.segments[0];
    const auto at = [&](const scalar early)
    {
        vec f = vec::Zero(w.data.size());
        s.of(f) = 1000*(s.x.array() + early).square();
        return f;
    };
    mat x = mat::Zero(n, 15);
    mat y(w.data.size(), 15);
    for (label r = 0; r < 15; ++r)
    {
        x(r % n, r) = r < n ? 0.1 : -0.1;
        y.col(r) = at(0) + 500*x.col(r).sum()*vec::Ones(w.data.size());
    }
    const statistics::responseSurface surface(x, y, w.bounds.mean, vec::Constant(n, 0.1));
    w.data.y = at(0.6);
    const hypothesis late
    {
        {}, mat(), possibleFaults(w.data, {faultKind::clock})[0], false
    };
    const covariance noise(w.data, 0);
    const hypothesisFit found
    (
        scoring(w.data, surface, w.bounds, noise).withBaseCovariance
        (
            late, whitener(noise.at(w.data.y))
        )
    );
    const hypothesisModel model(w.data, surface, w.bounds, late);
    const vec unknowns = model.ofFault(found.fit.x);
    EXPECT_NEAR(unknowns[0], -0.6, 0.02);
    EXPECT_LT(found.fit.misfit, 5);

    // Each of these costs what a right explanation leaves on average
    EXPECT_NEAR(found.fit.objective - found.fit.misfit, 6, 0.5);
}


TEST(misfitScoring, numbersAloneNameAMechanism)
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
    const statistics::responseSurface surface(x, y, bounds.mean, vec(vec::Ones(3)));
    const covariance known(data, 0);
    const std::vector<hypothesisFit> list
    (
        scoring(data, surface, bounds, known).all
        (
            {0, 1},
            possibleFaults(data, {faultKind::gain}),
            true
        )
    );
    EXPECT_EQ(list.front().what.mechanisms, std::vector<int>({0}));
    EXPECT_NEAR(list.front().fit.x[1], 0.8, 0.1);
    for (const hypothesisFit& w : list)
    {
        EXPECT_TRUE(std::isfinite(w.score));
    }
}


TEST(misfitScoring, theBetterOfTwoMinimaIsFound)
{
    // Two numbers: one is the same at 0.15 and 0.95, the other distinguishes them
    stacked data(numbers(scalarList(2, 1.0)));
    const auto at = [](const scalar strength)
    {
        return vec{{20*(strength - 0.15)*(strength - 0.95), strength}};
    };
    data.y = at(0.95);
    variableBounds bounds;
    bounds.nParameters = 0;
    bounds.mean = bounds.deviation = bounds.lower = vec::Zero(1);
    bounds.upper = bounds.width = vec::Ones(1);
    const mat x = vec{{0., 0.5, 1.}}.transpose();
    mat y(2, 3);
    y << at(0), at(0.5), at(1);
    const statistics::responseSurface surface(x, y, bounds.mean, bounds.width);
    hypothesis h;
    h.mechanisms = {0};
    const hypothesisFit found
    (
        scoring(data, surface, bounds, covariance(data, 0)).withBaseCovariance
        (
            h, statistics::whitener(0.01*mat::Identity(2, 2))
        )
    );
    EXPECT_NEAR(found.fit.x[0], 0.95, 1e-3);
}


TEST(misfitScoring, slopesOfAFaultyModelAreDifferences)
{
    world w(20);
    w.data.y = w(w.bounds.mean);
    const statistics::responseSurface surface(w.ensembleSurface(80, 2));
    const auto faults =
        possibleFaults(w.data, {faultKind::lag, faultKind::clogged, faultKind::gain});
    ASSERT_GE(faults.size(), 3);
    for (const sensorFault& fault : faults)
    {
        hypothesis h;
        h.mechanisms = {0};
        h.fault = fault;
        const hypothesisModel model(w.data, surface, w.bounds, h);
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
            ) << describe(fault) << ' ' << i;
        }
    }
}


TEST(misfitScoring, aMistunedModelIsNotTakenForMissingPhysics)
{
    world w(20);
    const statistics::responseSurface surface(w.ensembleSurface(120, 2));
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


TEST(misfitScoring, eachMechanismIsGivenTheMostWeightAlthoughItsFormulaDiffers)
{
    world w(20);
    const statistics::responseSurface surface(w.ensembleSurface(120, 2));
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
        const bool hit = list[0].what.mechanisms == std::vector<int>({m});
        right += hit;
        if (!hit)
        {
            std::printf
            (
                "%s taken for %s\n",
                world::mechanism(m).c_str(),
                list[0].what.fault ? describe(*list[0].what.fault).c_str()
              : list[0].what.unknown ? "unknown"
              : list[0].what.mechanisms.size()
              ? world::mechanism(list[0].what.mechanisms[0]).c_str() : "none"
            );
        }
    }
    testNumber("mechanisms with the most weight [%]", 100.*right/n);
    EXPECT_GE(right, 36);
}


TEST(misfitScoring, aFaultySensorIsNotTakenForPhysics)
{
    world w(20);
    const statistics::responseSurface surface(w.ensembleSurface(120, 2));
    std::mt19937 generator(23);
    const std::pair<const char*, scalar> faults[] =
    {
        {"lag", 0.3}, {"gain", -0.2}, {"zero", 80},
        {"drift", 150}, {"clock", 0.25}
    };
    label right = 0;
    label physics = 0;
    label n = 0;
    for (const auto& f : faults)
    {
        for (label c = 0; c < 3; ++c)
        {
            const vec y =
                possibleFaults(w.data, {statistics::faultNamed(f.first)})[c]
                (w.data, w(drawn(w, generator)), number(f.second))
              + w.noise(generator);
            const auto list(explain(w, surface, y));
            const auto& best = list[0].what;
            right += best.fault && best.fault->channel == w.data.segments[c].name;
            physics += best.mechanisms.size() > 0;
            ++n;
        }
    }
    testNumber("faults found in the right channel [%]", 100.*right/n);
    EXPECT_GE(right, n - 1);
    EXPECT_EQ(physics, 0);
}


TEST(misfitScoring, whatIsNotInTheLibraryIsUnknown)
{
    world w(20);
    const statistics::responseSurface surface(w.ensembleSurface(120, 2));
    std::mt19937 generator(24);
    label unknown = 0;
    const label n = 10;
    for (label k = 0; k < n; ++k)
    {
        vec y = w(drawn(w, generator)) + w.noise(generator);

        // A wave that comes back from the end and passes all gauges in turn
        for (label i = 0; i < count(w.data.segments); ++i)
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


TEST(misfitScoring, exchangedChannelsTakeWithThemWhatTheSimulationIsUncertainBy)
{
    // At P2 the simulation is off by a wave that another mesh shows, at P1 it is sure.
    // Each of the two has the record of the other
    world w(20);
    const statistics::responseSurface surface(w.ensembleSurface(120, 2));
    const segment& p2 = w.data.segments[1];
    vec wave = vec::Zero(w.data.size());
    p2.of(wave) = 300*(6*p2.x.array()).sin();
    std::mt19937 generator(25);
    const sensorFault exchanged
    (
        possibleFaults(w.data, {faultKind::swapped}).front()
    );
    ASSERT_EQ(exchanged.partner, "P2");
    w.data.y = exchanged(w.data, w(w.bounds.mean) + wave, vec());
    w.data.y += w.noise(generator);

    covariance c(w.data, 0.005);
    c.addSpread("between the runs", surface.leftOut(), 0, 1);
    c.addDifference("mesh", wave);
    const std::vector<hypothesisFit> list
    (
        scoring(w.data, surface, w.bounds, c).all
        (
            {0, 1, 2, 3, 4},
            possibleFaults(w.data, {faultKind::swapped, faultKind::gain}),
            true
        )
    );
    expectFault(list.front().what.fault, faultKind::swapped, "P1", "P2");
    for (const hypothesisFit& other : list)
    {
        if (!other.what.fault || !(*other.what.fault == exchanged))
        {
            EXPECT_GT(other.score, list.front().score + 6);
        }
    }
}

