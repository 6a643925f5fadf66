// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of faults that a sensor can have, as a table.

#include "faultKinds.H"
#include "faultBounds.H"

#include <algorithm>

namespace
{

using namespace statistics;

//- What a first-order lag, T p' + p = true value, makes of a channel
vec lagged(const segment& s, const vec& f, const double time)
{
    vec reading = s.of(f);
    if (time <= 1e-9*s.duration())
    {
        return reading;
    }
    for (int i = 1; i < s.size; ++i)
    {
        const double h = s.x[i] - s.x[i-1];
        const double before = f[s.first + i - 1];
        const double now = f[s.first + i];
        const double behind = time*(now - before)/h;
        reading[i] =
            now - behind
          + (reading[i-1] - before + behind)*std::exp(-std::min(h/time, 700.0));
    }
    return reading;
}


vec later(const segment& s, const vec& f, const double time)
{
    segment late(s);
    late.x.array() += time;
    return across(f, late, s);
}


// What a channel shows. s: the channel; o: that of its partner; f: the true samples;
// u: the unknowns

using F = const sensorFault&;
using S = const segment&;
using V = const vec&;


//- All later by u [s], in one channel or in those of a recorder
vec ofClock(F, S s, S, V f, V u)
{
    return later(s, f, u[0]);
}


//- Lag u0 [s] and loss of gain u1 [-] together
vec ofClogged(F, S s, S, V f, V u)
{
    return (1 + u[1])*lagged(s, f, u[0]);
}


//- A constant u [SI], whatever the true value is
vec ofDead(F, S s, S, V, V u)
{
    return vec::Constant(s.size, u[0]);
}


//- True value plus u [SI] times the share of time gone
vec ofDrift(F, S s, S, V f, V u)
{
    const vec gone = s.x.array() - s.x[0];
    return s.of(f) + u[0]/s.duration()*gone;
}


//- (1 + u) times the true value
vec ofGain(F, S s, S, V f, V u)
{
    return (1 + u[0])*s.of(f);
}


//- u p' + p = true value; u [s]
vec ofLag(F, S s, S, V f, V u)
{
    return lagged(s, f, u[0]);
}


//- On the way to another probe by a share u [-]
vec ofMisplaced(F, S s, S o, V f, V u)
{
    return (1 - u[0])*s.of(f) + u[0]*across(f, o, s);
}


//- True value, but never above u [SI]
vec ofSaturated(F, S s, S, V f, V u)
{
    return s.of(f).cwiseMin(u[0]);
}


//- Each of two channels has the record of the other
vec ofSwapped(F, S s, S o, V f, V)
{
    return across(f, o, s);
}


//- Another power of ten than its unit states, or the sign
vec ofUnits(F x, S s, S, V f, V)
{
    return x.factor*s.of(f);
}


//- True value plus u [SI]
vec ofZero(F, S s, S, V f, V u)
{
    return s.of(f).array() + u[0];
}

} // End anonymous namespace


const std::vector<statistics::faultRow>& statistics::faultTable()
{
    static const std::vector<faultRow> table
    {
        {"clock", possible::clocks, ofClock},
        {"clogged", possible::clogged, ofClogged},
        {"dead", possible::dead, ofDead},
        {"drift", possible::drifts, ofDrift},
        {"gain", possible::gains, ofGain},
        {"lag", possible::lags, ofLag},
        {"misplaced", possible::misplaced, ofMisplaced},
        {"saturated", possible::saturated, ofSaturated},
        {"swapped", possible::swapped, ofSwapped},
        {"units", possible::units, ofUnits},
        {"zero", possible::zeros, ofZero}
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
    const std::string& experiment,
    const stacked& data
)
{
    std::vector<int> channels;
    for (int i = 0; i < count(data.segments); ++i)
    {
        const segment& s = data.segments[i];
        const bool its = s.recorder == recorder && s.experiment == experiment;
        if (s.overTime && !recorder.empty() && its)
        {
            channels.push_back(i);
        }
    }
    return channels;
}
