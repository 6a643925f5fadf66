// SPDX-License-Identifier: GPL-3.0-or-later
// How well data that were not used to find an answer are matched with it.

#include "heldOut.H"

Foam::List<Foam::misfit::heldOut> Foam::misfit::compared
(
    const heldOut::part what,
    const word& experiment,
    const purpose use,
    const stacked& data,
    const vec& before,
    const vec& after,
    const covariance& known,
    const rules& limits
)
{
    const label n = data.size();
    if (!n || before.size() != n || after.size() != n)
    {
        return List<heldOut>();
    }
    const mat uncertain(known.at(after));
    const whitener white(uncertain);
    const auto square = [&](const vec& f)
    {
        return white(vec(data.y - f)).squaredNorm()/n;
    };
    return List<heldOut>
    (
        1,
        {
            what, experiment, use, data, before, after,
            uncertain.diagonal().cwiseSqrt(), square(before), square(after),
            statistics::chanceOfSquare(n, limits.adequacy), matchLimit(n, limits)
        }
    );
}


Foam::scalar Foam::misfit::matchLimit(const label samples, const rules& limits)
{
    return max
    (
        limits.matchedSquare,
        statistics::chanceOfSquare(samples, limits.matchedChance)
    );
}


Foam::scalar Foam::misfit::removed(const heldOut& h)
{
    return
        h.squareBefore > 1
      ? min((h.squareBefore - h.squareAfter)/(h.squareBefore - 1), 1.0) : 0;
}
