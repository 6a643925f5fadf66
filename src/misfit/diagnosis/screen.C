// SPDX-License-Identifier: GPL-3.0-or-later
// S4: candidates that cannot be the cause, before a run is spent on them.

#include "diagnosis.H"

#include <random>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Place where a rising or falling series passes a level, between samples
scalar passage(const vec& x, const vec& v, label i, const label step, scalar level)
{
    while (i > 0 && i < v.size() - 1 && v[i] < level)
    {
        i += step;
    }
    const label before = min(max(i - step, 0), label(v.size() - 1));
    const scalar d = v[i] - v[before];
    return
        mag(d) > VSMALL && i != before
      ? x[before] + (x[i] - x[before])*(level - v[before])/d : x[i];
}


//- The numbers of featureNames: arrival (a fifth of the rise), peak, time of the
//  rise, time of the decay to half, and mean of the last tenth
vec features(const segment& s, const vec& all)
{
    const vec v = s.of(all).array() - all[s.first];
    label top = 0;
    const scalar peak = v.maxCoeff(&top);
    const label tenth = max(s.size/10, 1);
    vec f(5);
    label i = 0;
    while (i < top && v[i] < 0.2*peak)
    {
        ++i;
    }
    f[0] = passage(s.x, v, i, 1, 0.2*peak);
    f[1] = peak;
    f[2] = s.x[top] - f[0];
    i = top;
    while (i < s.size - 1 && v[i] > 0.5*peak)
    {
        ++i;
    }
    f[3] = s.x[i] - s.x[top];
    f[4] = v.tail(tenth).mean();
    return f;
}


//- Change of the features over their standard deviation
vec change
(
    const segment& s,
    const vec& from,
    const vec& to,
    const whitener& white
)
{
    const label n = 100;
    std::mt19937 generator(1);
    std::normal_distribution<scalar> normal;
    vec squares = vec::Zero(5);
    const vec centre = features(s, from);
    for (label k = 0; k < n; ++k)
    {
        vec u(from.size());
        for (scalar& value : u)
        {
            value = normal(generator);
        }
        squares += (features(s, from + white.colour(u)) - centre).cwiseAbs2()/n;
    }
    return (features(s, to) - centre).cwiseQuotient
    (
        squares.cwiseSqrt().cwiseMax(VSMALL)
    );
}


//- Misfit of a channel beyond its uncertainty, over what changes in it: as it was
//  recorded or computed, and its uncertainty at least
scalar shareBeyond
(
    const segment& s,
    const vec& recorded,
    const vec& computed,
    const vec& sigma
)
{
    const auto changing = [&s](const vec& v)
    {
        return s.isNumber() ? mag(v[0]) : vec(v.array() - v[0]).norm();
    };
    const scalar beyond =
        vec(recorded - computed).squaredNorm() - sigma.squaredNorm();
    return
        std::sqrt(max(beyond, 0.0))
       /max(max(changing(recorded), changing(computed)), sigma.norm());
}

} // End anonymous namespace


void Foam::misfit::diagnosis::screen(const weighed& base)
{
    Info<< "S4 screen" << endl;
    const stacked& data = fit_->data();
    const whitener white(base.covariance);
    const vec sigma = base.covariance.diagonal().cwiseSqrt();
    List<vec> changes;
    scalar largest = 0;
    for (const segment& s : data.segments)
    {
        changes.append(change(s, base.best.f, data.y, white));
        largest = max
        (
            largest,
            shareBeyond(s, s.of(data.y), s.of(base.best.f), s.of(sigma))
        );
    }

    mechanisms_.clear();
    forAll(settings_.candidates, i)
    {
        const candidate& c = settings_.candidates[i];
        label asExpected = 0;
        label opposite = 0;
        for (const expectedSign& e : c.signs)
        {
            forAll(data.segments, k)
            {
                const label f = featureNames.find(e.feature);
                if (data.segments[k].quantity == e.quantity && f >= 0)
                {
                    asExpected += e.sign*changes[k][f] > 3;
                    opposite += e.sign*changes[k][f] < -3;
                }
            }
        }
        string why;
        if (never_.found(i))
        {
            why = "the solver failed in each run with it";
        }
        else if (opposite && !asExpected)
        {
            why = "the recording differs the other way in what it changes";
        }
        else if (largest > 3*c.bound)
        {
            why =
                "it can change at most " + Foam::name(100*c.bound)
              + " % and the misfit is " + Foam::name(100*largest) + " %";
        }
        if (why.empty())
        {
            mechanisms_.append(i);
        }
        else
        {
            found_.dropped.append(Tuple2<word, string>(c.name, why));
        }
    }
}
