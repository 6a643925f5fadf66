// SPDX-License-Identifier: GPL-3.0-or-later
// The faults that a channel can have, with their bounds, by what it recorded.

#include "faultBounds.H"
#include "faultKinds.H"

#include <algorithm>

namespace
{

using namespace statistics;
using statistics::possible::faults;

vec number(const double value)
{
    return vec::Constant(1, value);
}


vec both(const double lag, const double gain)
{
    return (vec(2) << lag, gain).finished();
}


//- Highest minus lowest recorded value, above zero [SI]
double range(const stacked& data, const segment& s)
{
    return std::max(s.range(data.y), small);
}


//- Highest recorded value [SI]
double top(const stacked& data, const segment& s)
{
    return s.of(data.y).maxCoeff();
}


//- Standard deviation of the noise of a sample [SI]
double noiseOf(const segment& s)
{
    return
        s.memory > 0 ? s.uncertainty/std::sqrt(s.repeats)
      : s.uncertainty*std::sqrt(s.readings.cwiseInverse().mean());
}


//- True if the record shows no more than noise around a constant
bool isFlat(const stacked& data, const segment& s)
{
    if (s.isNumber())
    {
        return false;
    }

    // One in a unit that is a thousand times too large varies by less than its
    // noise, too, but smoothly: less from one sample to the next than noise does
    // (von Neumann 1941, Ann. Math. Stat. 12:367)
    const vec v = s.of(data.y).array() - s.of(data.y).mean();
    const vec step = v.tail(s.size - 1) - v.head(s.size - 1);
    const double kept =
        s.memory > 0 ? std::exp(-s.duration()/(s.size - 1)/s.memory) : 0;
    return
        v.squaredNorm() <= s.size*sqr(1.5*noiseOf(s))
     && step.squaredNorm() >= (1 - kept)*v.squaredNorm();
}


//- True if the record stays at its highest value, but for noise, for three samples
bool staysAtTop(const stacked& data, const segment& s)
{
    int peak = 0;
    const double least = s.of(data.y).maxCoeff(&peak) - 4*noiseOf(s);
    int n = 1;
    for (int i = peak + 1; i < s.size && data.y[s.first + i] >= least; ++i)
    {
        ++n;
    }
    for (int i = peak - 1; i >= 0 && data.y[s.first + i] >= least; --i)
    {
        ++n;
    }
    return n > 2;
}


//- One of that kind, with one unknown between these
sensorFault fault
(
    const faultKind kind,
    const segment& s,
    const vec& lower,
    const vec& upper
)
{
    sensorFault one;
    one.kind = kind;
    one.channel = s.name;
    one.lower = lower;
    one.upper = upper;
    one.slight = 0.01*upper;
    one.starts = {vec::Zero(lower.size())};
    return one;
}


//- Of each channel of the same quantity one, with it as partner
faults towards
(
    const faultKind kind,
    const stacked& data,
    const segment& a,
    const double upper
)
{
    faults all;
    for (const segment& b : data.segments)
    {
        const bool alike =
            b.name != a.name && a.experiment == b.experiment && a.quantity == b.quantity
         && a.overTime == b.overTime && !a.isNumber() && !b.isNumber();
        if (alike && (kind == faultKind::misplaced || a.first < b.first))
        {
            const int n = kind == faultKind::misplaced;
            all.push_back(fault(kind, a, vec::Zero(n), vec::Constant(n, upper)));
            all.back().partner = b.name;
        }
    }
    return all;
}


//- By a number of SI units, either way
faults shift(const faultKind kind, const stacked& data, const segment& s)
{
    const double most = 10*range(data, s);
    return {fault(kind, s, number(-most), number(most))};
}

} // End anonymous namespace


namespace statistics::possible
{

faults clocks(const stacked& data, const segment& s)
{
    if (!s.overTime)
    {
        return {};
    }
    const double d = s.duration();
    sensorFault one(fault(faultKind::clock, s, number(-0.5*d), number(0.5*d)));
    one.starts =
        {number(-0.1*d), number(-0.02*d), number(0.02*d), number(0.1*d)};

    // That of a recorder is counted at the first of its channels
    faults all;
    const std::vector<int> together(recordedBy(s.recorder, s.experiment, data));
    if (together.size() > 1 && data.segments[together[0]].name == s.name)
    {
        all.push_back(one);
        all.back().channel = s.recorder;
        all.back().ofRecorder = true;
        all.back().experiment = s.experiment;
        all.back().isInSeveral = std::any_of
        (
            data.segments.begin(), data.segments.end(),
            [&s](const segment& other)
            {
                return
                    other.recorder == s.recorder && other.experiment != s.experiment;
            }
        );
    }
    all.push_back(one);
    return all;
}


faults clogged(const stacked&, const segment& s)
{
    if (!s.overTime)
    {
        return {};
    }
    const double d = s.duration();
    sensorFault one(fault(faultKind::clogged, s, both(0, -1), both(2*d, 0)));
    one.starts = {both(0.05*d, -0.3), both(0.5*d, -0.05)};
    return {one};
}


faults dead(const stacked& data, const segment& s)
{
    if (!isFlat(data, s))
    {
        return {};
    }
    sensorFault one
    (
        fault
        (
            faultKind::dead,
            s,
            number(top(data, s) - range(data, s) - s.uncertainty),
            number(top(data, s) + s.uncertainty)
        )
    );
    one.slight = number(s.of(data.y).mean());
    one.starts = {one.slight};
    return {one};
}


faults drifts(const stacked& data, const segment& s)
{
    return s.overTime ? shift(faultKind::drift, data, s) : faults();
}


faults gains(const stacked&, const segment& s)
{
    // A series with less than a twentieth of its gain is reported as dead
    const double least = s.isNumber() ? -1 : -0.95;
    return {fault(faultKind::gain, s, number(least), number(9))};
}


faults lags(const stacked&, const segment& s)
{
    if (!s.overTime)
    {
        return {};
    }
    const double d = s.duration();
    sensorFault one(fault(faultKind::lag, s, number(0), number(d)));
    one.starts = {number(0.01*d), number(0.1*d)};
    return {one};
}


faults misplaced(const stacked& data, const segment& s)
{
    faults all(towards(faultKind::misplaced, data, s, 1.5));
    for (sensorFault& one : all)
    {
        one.starts = {number(0.3)};
    }
    return all;
}


faults saturated(const stacked& data, const segment& s)
{
    if (!staysAtTop(data, s) || isFlat(data, s))
    {
        return {};
    }
    const double high = top(data, s);
    const double d = range(data, s);
    sensorFault one
    (
        fault
        (
            faultKind::saturated, s, number(high - d), number(high + 0.05*d)
        )
    );
    one.slight = number(high - 0.05*d);
    one.starts = {one.slight, number(high - 0.2*d)};
    return {one};
}


faults swapped(const stacked& data, const segment& s)
{
    return towards(faultKind::swapped, data, s, 0);
}


faults units(const stacked& data, const segment& s)
{
    // Nothing is nothing in any unit
    faults all;
    if (!isFlat(data, s) || std::abs(s.of(data.y).mean()) > 3*s.uncertainty)
    {
        for (const double factor : {1e-3, 1e3, 0.01, 100., 0.1, 10., -1.})
        {
            all.push_back(fault(faultKind::units, s, vec(), vec()));
            all.back().factor = factor;
        }
    }
    return all;
}


//- A number alone that is off by some is off by a share, too
faults zeros(const stacked& data, const segment& s)
{
    return s.isNumber() ? faults() : shift(faultKind::zero, data, s);
}

} // End namespace statistics::possible
