// SPDX-License-Identifier: GPL-3.0-or-later
// How well data that were not used to find an answer are matched with it.

#include "heldOut.H"

std::optional<Foam::misfit::heldOut> Foam::misfit::compare
(
    const heldOut::part what,
    const observation& recorded,
    const samples& before,
    const samples& after,
    const covariance& known,
    const rules& limits
)
{
    const purpose use =
        what == heldOut::part::experiment ? recorded.use
      : what == heldOut::part::validation ? purpose::validation : purpose::test;
    const stacked& data = recorded.of(use);
    const vec& from = before.of(use);
    const vec& to = after.of(use);
    const label n = data.size();
    if (!n || from.size() != n || to.size() != n)
    {
        return std::nullopt;
    }
    const mat uncertain(known.at(to));
    const whitener white(uncertain);
    const auto square = [&](const vec& f)
    {
        return white(vec(data.y - f)).squaredNorm()/n;
    };
    return heldOut
    {
        what, recorded.experiment, use, data, from, to,
        uncertain.diagonal().cwiseSqrt(), square(from), square(to),
        statistics::chanceOfSquare(n, limits.adequacy), matchLimit(n, limits), uncertain
    };
}


Foam::List<Foam::misfit::heldOut> Foam::misfit::compareHere
(
    const study& s,
    const samples& before,
    const samples& after,
    const covariance& known
)
{
    const observation& here = s.data();
    const covariance ofTest(here.test, s.set.clockUncertainty);
    using part = heldOut::part;
    List<heldOut> all;
    for
    (
        const auto& one :
        {
            compare(part::validation, here, before, after, known, s.set),
            compare(part::test, here, before, after, ofTest, s.set)
        }
    )
    {
        if (one)
        {
            all.append(*one);
        }
    }
    return all;
}


Foam::scalar Foam::misfit::matchLimit(const label samples, const rules& limits)
{
    return max
    (
        limits.matchedSquare,
        statistics::chanceOfSquare(samples, limits.matchedChance)
    );
}


Foam::scalar
Foam::misfit::confirmingSquare(const heldOut& h, const rules& limits)
{
    return 1 + limits.leftIfConfirmed*(h.squareBefore - 1);
}


Foam::scalar Foam::misfit::removed(const heldOut& h)
{
    return
        h.squareBefore > 1
      ? min((h.squareBefore - h.squareAfter)/(h.squareBefore - 1), 1.0) : 0;
}
