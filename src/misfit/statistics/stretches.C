// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of the channels in which recording and simulation part.

#include "scan.H"

#include <algorithm>

namespace
{

//- Level that a sample alone must exceed, over that of neighbours [-]: chance puts one of
//  many samples beyond a level far more often than two in a row
constexpr double levelOfOne = 1.5;

//- Samples [-] within the level that a stretch may hold in a row: noise brings single
//  samples of a difference back
constexpr int largestGap = 2;

} // End anonymous namespace


std::vector<statistics::window> statistics::stretches
(
    const stacked& data,
    const vec& misfit,
    const mat& covariance,
    const double level
)
{
    const vec z =
        misfit.cwiseQuotient(covariance.diagonal().cwiseSqrt());
    std::vector<window> result;
    const auto close = [&](const int segment, const int begin, const int end)
    {
        const int first = data.segments[segment].first + begin;
        const int n = end - begin;
        if (n == 1 && std::abs(z[first]) < levelOfOne*level)
        {
            return;
        }
        const double size =
            misfit.segment(first, n).sum()
           /std::sqrt(covariance.block(first, first, n, n).sum());
        result.push_back({segment, begin, end, size});
    };

    for (int i = 0; i < count(data.segments); ++i)
    {
        const segment& s = data.segments[i];
        int begin = -1;
        int last = -1;
        for (int k = 0; k <= s.size; ++k)
        {
            const double here = k < s.size ? z[s.first + k] : 0;
            const bool beyond = std::abs(here) > level;
            const bool turned =
                beyond && begin >= 0 && here*z[s.first + last] < 0;
            if (begin >= 0 && (turned || k > last + largestGap || k == s.size))
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
        result.begin(),
        result.end(),
        [](const window& a, const window& b)
        {
            return std::abs(a.size) > std::abs(b.size);
        }
    );
    return result;
}
