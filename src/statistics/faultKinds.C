// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of faults that a sensor can have, as a table.

#include "faultKinds.H"

#include <algorithm>

namespace
{

using namespace statistics;

using faults = std::vector<sensorFault>;

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
        s.memory > 0 ? s.uncertainty
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
    return
    {
        kind, s.name, "", 1, false, lower, upper, 0.01*upper,
        {vec::Zero(lower.size())}
    };
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
            b.name != a.name && a.quantity == b.quantity
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
    const std::vector<int> together(recordedBy(s.recorder, data));
    if (together.size() > 1 && data.segments[together[0]].name == s.name)
    {
        all.push_back(one);
        all.back().channel = s.recorder;
        all.back().ofRecorder = true;
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


//- By a number of SI units, either way
faults shift(const faultKind kind, const stacked& data, const segment& s)
{
    const double most = 10*range(data, s);
    return {fault(kind, s, number(-most), number(most))};
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


//- What a first-order lag, T p' + p = true value, makes of a channel
vec lagged(const segment& s, const vec& f, const double time)
{
    vec shown = s.of(f);
    if (time <= 1e-9*s.duration())
    {
        return shown;
    }
    for (int i = 1; i < s.size; ++i)
    {
        const double h = s.x[i] - s.x[i-1];
        const double before = f[s.first + i - 1];
        const double now = f[s.first + i];
        const double behind = time*(now - before)/h;
        shown[i] =
            now - behind
          + (shown[i-1] - before + behind)*std::exp(-std::min(h/time, 700.0));
    }
    return shown;
}


vec later(const segment& s, const vec& f, const double time)
{
    segment late(s);
    late.x.array() += time;
    return across(f, late, s);
}

} // End anonymous namespace


const std::vector<statistics::faultRow>& statistics::faultTable()
{
    using S = const segment&;
    using D = const stacked&;
    using V = const vec&;
    using F = const sensorFault&;

    static const std::vector<faultRow> table
    {
        // Shows all later by u [s], in one channel or in those of a recorder
        {
            "clock", clocks,
            [](F, S s, S, V f, V u) { return later(s, f, u[0]); }
        },
        // Lag u0 [s] and loss of gain u1 [-] together
        {
            "clogged", clogged,
            [](F, S s, S, V f, V u) { return vec((1 + u[1])*lagged(s, f, u[0])); }
        },
        // A constant u [SI], whatever the true value is
        {
            "dead", dead,
            [](F, S s, S, V, V u) { return vec(vec::Constant(s.size, u[0])); }
        },
        // True value plus u [SI] times the share of time gone
        {
            "drift",
            [](D d, S s)
            {
                return s.overTime ? shift(faultKind::drift, d, s) : faults();
            },
            [](F, S s, S, V f, V u)
            {
                const vec gone = s.x.array() - s.x[0];
                return vec(s.of(f) + u[0]/s.duration()*gone);
            }
        },
        // (1 + u) times the true value; a series with less than a twentieth of
        // its gain is reported as dead
        {
            "gain",
            [](D, S s)
            {
                const double least = s.isNumber() ? -1 : -0.95;
                return faults({fault(faultKind::gain, s, number(least), number(9))});
            },
            [](F, S s, S, V f, V u) { return vec((1 + u[0])*s.of(f)); }
        },
        // u p' + p = true value; u [s]
        {
            "lag", lags,
            [](F, S s, S, V f, V u) { return lagged(s, f, u[0]); }
        },
        // On the way to another probe by a share u [-]
        {
            "misplaced", misplaced,
            [](F, S s, S o, V f, V u)
            {
                return vec((1 - u[0])*s.of(f) + u[0]*across(f, o, s));
            }
        },
        // True value, but never above u [SI]
        {
            "saturated", saturated,
            [](F, S s, S, V f, V u) { return vec(s.of(f).cwiseMin(u[0])); }
        },
        // Each of two channels has the record of the other
        {
            "swapped",
            [](D d, S s) { return towards(faultKind::swapped, d, s, 0); },
            [](F, S s, S o, V f, V) { return across(f, o, s); }
        },
        // Another power of ten than it says, or the sign
        {
            "units", units,
            [](F x, S s, S, V f, V) { return vec(x.factor*s.of(f)); }
        },
        // True value plus u [SI]; a number alone that is off by some is off by a
        // share, too
        {
            "zero",
            [](D d, S s)
            {
                return s.isNumber() ? faults() : shift(faultKind::zero, d, s);
            },
            [](F, S s, S, V f, V u) { return vec(s.of(f).array() + u[0]); }
        }
    };
    return table;
}


statistics::vec statistics::across
(
    const vec& f,
    const segment& from,
    const segment& to
)
{
    vec values(to.size);
    int k = 0;
    for (int i = 0; i < to.size; ++i)
    {
        const double x =
            std::min(std::max(to.x[i], from.x[0]), from.x[from.size - 1]);
        while (k + 2 < from.size && from.x[k+1] < x)
        {
            ++k;
        }
        const double w = (x - from.x[k])/(from.x[k+1] - from.x[k]);
        values[i] =
            (1 - w)*f[from.first + k] + w*f[from.first + k + 1];
    }
    return values;
}


std::vector<int> statistics::recordedBy
(
    const std::string& recorder,
    const stacked& data
)
{
    std::vector<int> channels;
    for (int i = 0; i < count(data.segments); ++i)
    {
        const segment& s = data.segments[i];
        if (s.overTime && !recorder.empty() && s.recorder == recorder)
        {
            channels.push_back(i);
        }
    }
    return channels;
}
