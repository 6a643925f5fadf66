// SPDX-License-Identifier: GPL-3.0-or-later
// Which fault of a sensor is reported: sensors that show nothing, or only a part, and
// sensors that show wrong values.

#include "worldDiagnosis.H"

#include <gtest/gtest.h>

#include <set>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- The record of P1 of a flow in which nothing is missing
vec trueP1()
{
    const world w(20);
    return w.data.segments[0].of(w(truth(-1, 0), 1));
}


//- The diagnosis where P1 should have shown trueP1() and showed this, plus noise
finding diagnosed(const vec& shown)
{
    const world w(20);
    vec added = vec::Zero(w.data.size());
    w.data.segments[0].of(added) = shown - trueP1();
    worldSampler s(truth(-1, 0), 300, added);
    const finding f(diagnose(s));
    show(f);
    return f;
}


//- That verdict on P1, with this fault
void expectP1(const finding& f, const verdictKind verdict, const faultKind kind)
{
    EXPECT_EQ(f.verdict.kind, verdict);
    EXPECT_EQ(f.verdict.names, wordList({"P1"}));
    expectFault(f.best().what.fault, kind, "P1");
}


//- What P1 alone may have, of these kinds, where it shows that
label possible(const vec& shown, const std::vector<faultKind>& kinds)
{
    world w(20);
    w.data.y = w(truth(-1, 0));
    w.data.segments[0].of(w.data.y) = shown;
    label n = 0;
    for (const sensorFault& f : possibleFaults(w.data, kinds))
    {
        n += f.channel == "P1";
    }
    return n;
}

//- What is added where P1 and P2 are exchanged and a wave of that height passes that
//  no candidate has [Pa]
vec exchanged(const scalar wave)
{
    const world w(20);
    vec added = vec::Zero(w.data.size());
    for (const segment& s : w.data.segments)
    {
        s.of(added).array() +=
            (s.quantity == "pressure" ? wave : 1e-4*wave)
           *(-((s.x.array() - 2.6)/0.3).square()).exp();
    }
    const vec shown = w(truth(-1, 0), 1) + added;
    const segment& p1 = w.data.segments[0];
    const segment& p2 = w.data.segments[1];
    p1.of(added) += p2.of(shown) - p1.of(shown);
    p2.of(added) += p1.of(shown) - p2.of(shown);
    return added;
}

} // End anonymous namespace


TEST(misfitSensorFault, oneThatShowsNothingIsDead)
{
    worldSampler s(truth(-1, 0), 300, vec());
    s.mislabel(0);
    const finding f(diagnose(s));
    show(f);
    expectP1(f, verdictKind::sensor, faultKind::dead);
}


TEST(misfitSensorFault, oneThatIsStuckAtSomethingIsDeadToo)
{
    for (const scalar c : {-300., 0., 40., 500., 2000.})
    {
        expectP1(diagnosed(vec::Constant(20, c)), verdictKind::sensor, faultKind::dead);
    }
}


TEST(misfitSensorFault, oneThatShowsNothingAboveAValueIsSaturated)
{
    const vec f = trueP1();
    const scalar range = f.maxCoeff() - f.minCoeff();
    for (const scalar share : {0.4, 0.6, 0.75, 0.9})
    {
        const scalar c = f.minCoeff() + share*range;
        const finding found(diagnosed(f.cwiseMin(c)));
        expectP1(found, verdictKind::sensor, faultKind::saturated);
        EXPECT_NEAR(found.best().fit.x.tail(1)[0], c, 0.05*range);
    }
}


TEST(misfitSensorFault, theOthersAreStillReported)
{
    const vec f = trueP1();
    expectP1(diagnosed(1.3*f), verdictKind::sensor, faultKind::gain);
    expectP1(diagnosed(0.1*f), verdictKind::sensor, faultKind::gain);
    expectP1(diagnosed(f.array() + 90), verdictKind::sensor, faultKind::zero);
    expectP1(diagnosed(f.array() - 90), verdictKind::sensor, faultKind::zero);
    expectP1(diagnosed(-f), verdictKind::registration, faultKind::units);
    for (const scalar factor : {1e-3, 0.1, 10., 1e3})
    {
        worldSampler s(truth(-1, 0), 300, vec());
        s.mislabel(factor);
        expectP1(diagnose(s), verdictKind::registration, faultKind::units);
    }

    const segment s(world(20).data.segments[0]);
    vec late = f;
    for (label i = 0; i < s.size; ++i)
    {
        const scalar before = max(i - 2., 0.);
        late[i] = f[label(before)];
    }
    expectP1(diagnosed(late), verdictKind::registration, faultKind::clock);
}


TEST(misfitSensorFault, exchangedGaugesAreBothNamedAlsoBesideSomethingUnknown)
{
    for (const scalar wave : {0., 60.})
    {
        worldSampler s(truth(-1, 0), 300, exchanged(wave));
        const finding f(diagnose(s));
        expectAnswer(f, "registration", {"P1", "P2"});
        expectFault(f.best().what.fault, faultKind::swapped, "P1", "P2");
        EXPECT_EQ(f.tests.gates.applied(gateKind::alone), f.hasMore());
    }
}


TEST(misfitSensorFault, whatTheSimulationIsUncertainByIsDrawnWhereTheRecordIsFrom)
{
    for (const scalar wave : {0., 60.})
    {
        worldSampler s(truth(-1, 0), 300, exchanged(wave));
        s.refine(0.1);
        settings set(worldSettings());
        set.resolutions = {"mesh"};
        const finding f(diagnose(s, set));
        ASSERT_EQ(f.verdict.kind, verdictKind::registration);
        const segment& p1 = f.detection.data.segments[0];
        const segment& p2 = f.detection.data.segments[1];
        const auto distance = [](const vec& a, const vec& b) { return (a - b).norm(); };
        const vec drawn = p1.of(f.verdict.sigma);
        const vec own = p1.of(f.detection.sigma);
        const vec other = p2.of(f.detection.sigma);
        EXPECT_LT(distance(drawn, other), 0.2*distance(drawn, own)) << wave;
    }
}


TEST(misfitSensorFault, besideSomethingUnknownAnExchangeMustGainByItself)
{
    worldSampler s(truth(-1, 0), 300, exchanged(60));
    const finding found(diagnose(s));
    ASSERT_TRUE(found.hasMore());
    const hypothesisFit* known = nullptr;
    for (const hypothesisFit& w : found.explained.all())
    {
        known = w.what == found.best().what.known() ? &w : known;
    }
    ASSERT_NE(known, nullptr);

    // More than it gains alone, less than both gain
    const scalar none = found.explained.baseline().score;
    settings set(worldSettings());
    set.evidence = none - 0.5*(known->score + found.best().score);
    worldSampler again(truth(-1, 0), 300, exchanged(60));
    const finding f(diagnose(again, set));
    show(f);
    EXPECT_FALSE(passes(f, "alone"));
    EXPECT_TRUE(passes(f, "evidence"));
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}


TEST(misfitSensorFault, anExchangeIsNotNamedWhereRivalsDisagreeAboutThePartner)
{
    // P1 shows what P2 and P2b should; both are too uncertain to show which of them
    // shows what P1 should
    const world w(20);
    const vec right = w(truth(-1, 0), 1);
    const segment& p1 = w.data.segments[0];
    const segment& p2 = w.data.segments[1];
    vec added = vec::Zero(w.data.size());
    p1.of(added) = p2.of(right) - p1.of(right);
    p2.of(added) = -0.5*p1.of(added);
    settings set(worldSettings());
    set.faults = {faultKind::swapped};
    worldSampler s(truth(-1, 0), 300, added);
    s.addGaugeBesideP2(2000);
    const finding f(diagnose(s, set));
    expectAnswer(f, "set", {"P1", "P2", "P2b"});
    ASSERT_EQ(f.verdict.alternatives.size(), 2);
    std::set<std::string> partners;
    for (const hypothesisFit& w : f.verdict.alternatives)
    {
        ASSERT_TRUE(w.what.fault);
        EXPECT_EQ(w.what.fault->kind, faultKind::swapped);
        EXPECT_EQ(w.what.fault->channel, "P1");
        partners.insert(w.what.fault->partner);
    }
    EXPECT_EQ(partners, std::set<std::string>({"P2", "P2b"}));
    EXPECT_FALSE(passes(f, "gap"));
}


TEST(misfitSensorFault, faultsOfOneChannelStateTheSameButAnExchangeHasAPartner)
{
    const stacked data(world(20).data);
    const auto swapped(possibleFaults(data, {faultKind::swapped}));
    const sensorFault gain(possibleFaults(data, {faultKind::gain}).front());
    const sensorFault zero(possibleFaults(data, {faultKind::zero}).front());
    ASSERT_EQ(swapped[0].channel, "P1");
    ASSERT_EQ(swapped[1].channel, "P1");
    ASSERT_EQ(gain.channel, "P1");

    EXPECT_TRUE(gain.blamesSame(zero));
    EXPECT_TRUE(swapped[0].blamesSame(swapped[0]));
    EXPECT_FALSE(swapped[0].blamesSame(swapped[1]));
    EXPECT_FALSE(swapped[0].blamesSame(gain));
    EXPECT_FALSE(gain.blamesSame(swapped[0]));
}


TEST(misfitSensorFault, nothingHasNoUnitAndWhatMovesIsNotDead)
{
    const vec zero = vec::Zero(20);
    vec hum(20);
    for (label i = 0; i < 20; ++i)
    {
        hum[i] = i % 3 ? 10 : -20;
    }
    for (const vec& nothing : {zero, hum})
    {
        EXPECT_EQ(possible(nothing, {faultKind::units}), 0);
        EXPECT_EQ(possible(nothing, {faultKind::dead, faultKind::saturated}), 1);
    }

    // In kPa for Pa it varies by less than its noise, but as a surge does
    for (const scalar factor : {1e-3, 1., 10.})
    {
        EXPECT_EQ(possible(factor*trueP1(), {faultKind::units}), 7) << factor;
        EXPECT_EQ(possible(factor*trueP1(), {faultKind::dead}), 0) << factor;
    }

    // A level that rests, in another unit, is not nothing
    EXPECT_EQ(possible(vec::Constant(20, 1000), {faultKind::units}), 7);
}


TEST(misfitSensorFault, whatItShowedIsReportedInThreeDigits)
{
    world w(20);
    w.data.y.setZero();
    const segment& at = w.data.segments[0];
    const sensorFault dead
    (
        possibleFaults(w.data, {faultKind::dead}).front()
    );
    EXPECT_EQ
    (
        describe(dead, at, vec::Constant(1, 2004.)),
        "P1 shows 2000 Pa throughout, whatever happens: it is dead or stuck"
    );
    EXPECT_NE(describe(dead, at, vec::Constant(1, -0.008)).find(" 0 Pa"), string::npos);
    EXPECT_NE
    (
        describe(dead, at, vec::Constant(1, 12345.)).find(" 12300 Pa"), string::npos
    );
}


TEST(misfitSensorFault, itCanBeReportedWhenWhatWasRecordedIsGone)
{
    stacked data(world(20).data);
    data.y.setOnes();
    std::vector<sensorFault> faults(possibleFaults(data, {faultKind::gain}));
    faults.push_back(possibleFaults(data, {faultKind::misplaced}).front());
    for (segment& s : data.segments)
    {
        s.name = "gone";
    }
    EXPECT_EQ(describe(faults.front()), "gain of P1");
    EXPECT_EQ(describe(faults.back()), "misplaced of P1 towards P2");
}


TEST(misfitSensorFault, aFindingIsWholeWithoutItsDiagnosis)
{
    finding kept;
    {
        worldSampler s(truth(-1, 0), 300, vec());
        s.mislabel(0);
        kept = diagnose(s);
    }
    expectFault(kept.best().what.fault, faultKind::dead, "P1");
}
