// SPDX-License-Identifier: GPL-3.0-or-later
// When each channel rises, and when recording and simulation first differ there.

#include "departures.H"
#include "features.H"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Standard deviations that chance exceeds upwards with this probability in one of so
//  many
scalar beyondChance(const scalar probability, const scalar attempts)
{
    const boost::math::normal_distribution<scalar> normal;
    return boost::math::quantile(boost::math::complement(normal, probability/attempts));
}


//- Standard deviation of each sample less the first one
vec deviationOfRise(const segment& s, const mat& covariance)
{
    vec deviation(s.size);
    for (label k = 0; k < s.size; ++k)
    {
        const label i = s.first + k;
        const scalar square =
            covariance(i, i) + covariance(s.first, s.first) - 2*covariance(i, s.first);
        deviation[k] = std::sqrt(max(square, 0.0));
    }
    return deviation;
}


//- Time at which the samples first rise from the first one by a fifth of the peak, and by
//  more than chance; empty: never
std::optional<scalar> arrival(const segment& s, const vec& all, const vec& chance)
{
    const vec rise = s.of(all).array() - all[s.first];
    const vec level = chance.cwiseMax(statistics::shareAtArrival*rise.maxCoeff());
    for (label k = 1; k < s.size; ++k)
    {
        if (rise[k] > 0 && rise[k] >= level[k])
        {
            const scalar below = min(rise[k-1], level[k]);
            const scalar share = (level[k] - below)/max(rise[k] - below, VSMALL);
            return s.x[k-1] + share*(s.x[k] - s.x[k-1]);
        }
    }
    return std::nullopt;
}


//- The stretches that are beyond chance wherever they may begin and end
std::vector<window> clearStretches
(
    const stacked& data,
    const vec& misfit,
    const mat& covariance,
    const rules& limits
)
{
    std::vector<window> all
    (
        statistics::stretches(data, misfit, covariance, limits.beyond)
    );
    scalar windows = 0;
    for (const segment& s : data.segments)
    {
        windows += 0.5*s.size*(s.size + 1);
    }
    const scalar least = beyondChance(0.5*limits.significance, windows);
    all.erase
    (
        std::remove_if
        (
            all.begin(), all.end(),
            [least](const window& w) { return mag(w.size) < least; }
        ),
        all.end()
    );
    return all;
}


void addDepartures
(
    std::vector<departure>& all,
    const stacked& data,
    const vec& simulated,
    const mat& covariance,
    const purpose use,
    const rules& limits
)
{
    const std::vector<window> parts
    (
        clearStretches(data, data.y - simulated, covariance, limits)
    );
    const scalar level = beyondChance(limits.significance, data.size());
    for (label k = 0; k < count(data.segments); ++k)
    {
        const segment& s = data.segments[k];
        if (!s.overTime)
        {
            continue;
        }
        const vec chance = level*deviationOfRise(s, covariance);
        departure d
        {
            word(s.experiment, false), s.name, use, arrival(s, data.y, chance),
            arrival(s, simulated, chance), std::nullopt
        };
        for (const window& w : parts)
        {
            const scalar begin = s.x[w.segment == k ? w.begin : 0] - 0.5*s.span;
            if (w.segment == k && (!d.differs || begin < *d.differs))
            {
                d.differs = begin;
            }
        }
        all.push_back(d);
    }
}

} // End anonymous namespace


std::vector<Foam::misfit::departure> Foam::misfit::departuresOf
(
    const stageResults& e,
    const vec& calibrated,
    const rules& limits
)
{
    std::vector<departure> all;
    const misfitDetection& fitted = e.detection;
    addDepartures
    (
        all, fitted.data, calibrated, fitted.covariance, purpose::calibration, limits
    );
    for (const heldOut& h : e.tests.held)
    {
        if (h.isHere())
        {
            addDepartures(all, h.data, h.before, h.covariance, h.use, limits);
        }
    }
    const auto rank = [](const departure& d) { return d.differs ? *d.differs : GREAT; };
    std::stable_sort
    (
        all.begin(), all.end(),
        [&](const departure& a, const departure& b) { return rank(a) < rank(b); }
    );
    return all;
}
