// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of the channels in which recording and simulation part.

#include "scan.H"

#include <algorithm>

Foam::List<Foam::misfit::window> Foam::misfit::stretches
(
    const stacked& data,
    const vec& misfit,
    const mat& covariance,
    const scalar level
)
{
    const vec z =
        misfit.cwiseQuotient(covariance.diagonal().cwiseSqrt());
    List<window> found;
    const auto close = [&](const label segment, const label begin, const label end)
    {
        const label first = data.segments[segment].first + begin;
        const label n = end - begin;
        if (n == 1 && mag(z[first]) < 1.5*level)
        {
            return;
        }
        const scalar size =
            misfit.segment(first, n).sum()
           /Foam::sqrt(covariance.block(first, first, n, n).sum());
        found.append({segment, begin, end, size});
    };

    forAll(data.segments, i)
    {
        const segment& s = data.segments[i];
        label begin = -1;
        label last = -1;
        for (label k = 0; k <= s.size; ++k)
        {
            const scalar here = k < s.size ? z[s.first + k] : 0;
            const bool beyond = mag(here) > level;
            const bool turned =
                beyond && begin >= 0 && here*z[s.first + last] < 0;
            if (begin >= 0 && (turned || k > last + 2 || k == s.size))
            {
                close(i, begin, last + 1);
                begin = -1;
            }
            if (beyond)
            {
                begin = begin < 0 ? k : begin;
                last = k;
            }
        }
    }
    std::sort
    (
        found.begin(),
        found.end(),
        [](const window& a, const window& b) { return mag(a.size) > mag(b.size); }
    );
    return found;
}
