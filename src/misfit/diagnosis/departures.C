// SPDX-License-Identifier: GPL-3.0-or-later
// When each channel rises, and when recording and simulation first differ there.

#include "departures.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Empty where the samples differ from the first one by no more than what is uncertain
std::optional<scalar> arrival
(
    const segment& s,
    const vec& all,
    const vec& sigma,
    const scalar level
)
{
    const vec rise = s.of(all).array() - all[s.first];
    const bool rises = (rise.array() > level*s.of(sigma).array()).any();
    const label first = label(statistics::feature::arrival);
    return
        rises
      ? std::optional<scalar>(statistics::features(s, all)[first]) : std::nullopt;
}


void addDepartures
(
    std::vector<departure>& all,
    const stacked& data,
    const vec& simulated,
    const vec& sigma,
    const purpose use,
    const scalar level
)
{
    const mat covariance = sigma.cwiseAbs2().asDiagonal();
    const std::vector<window> parts
    (
        statistics::stretches(data, data.y - simulated, covariance, level)
    );
    for (label k = 0; k < count(data.segments); ++k)
    {
        const segment& s = data.segments[k];
        if (!s.overTime)
        {
            continue;
        }
        departure d
        {
            s.name, use, arrival(s, data.y, sigma, level),
            arrival(s, simulated, sigma, level), std::nullopt
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
    const evidence& e,
    const vec& calibrated,
    const scalar level
)
{
    std::vector<departure> all;
    const misfitDetection& fitted = e.detection;
    addDepartures
    (
        all, fitted.data, calibrated, fitted.sigma, purpose::calibration, level
    );
    for (const heldOut& h : e.tests.held)
    {
        if (h.isHere())
        {
            addDepartures(all, h.data, h.before, h.sigma, h.use, level);
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
