// SPDX-License-Identifier: GPL-3.0-or-later
// How well data that were not used to find an answer are matched with it.

#include "finding.H"

#include <cmath>

void Foam::misfit::addCompared
(
    List<heldOut>& all,
    const string& what,
    const purpose use,
    const stacked& data,
    const vec& before,
    const vec& after,
    const covariance& known
)
{
    const label n = data.size();
    if (!n || before.size() != n || after.size() != n)
    {
        return;
    }
    const mat uncertain(known.at(after));
    const whitener white(uncertain);
    const auto square = [&](const vec& f)
    {
        return white(vec(data.y - f)).squaredNorm()/n;
    };
    all.append
    ({
        what, use, data, before, after, uncertain.diagonal().cwiseSqrt(),
        square(before), square(after)
    });
}


Foam::scalar Foam::misfit::chanceOfSquare
(
    const label samples,
    const scalar probability
)
{
    // Of a standard normal number, by halving
    scalar low = -10;
    scalar high = 10;
    for (label i = 0; i < 60; ++i)
    {
        const scalar z = 0.5*(low + high);
        (std::erfc(z/std::sqrt(2.0)) > 2*probability ? low : high) = z;
    }
    const scalar v = 2.0/(9*samples);
    return pow3(1 - v + low*std::sqrt(v));
}


Foam::scalar Foam::misfit::matchLimit(const heldOut& h)
{
    return max(1.5, chanceOfSquare(h.data.size(), 0.01));
}


Foam::scalar Foam::misfit::removed(const heldOut& h)
{
    return
        h.squareBefore > 1
      ? min((h.squareBefore - h.squareAfter)/(h.squareBefore - 1), 1.0) : 0;
}
