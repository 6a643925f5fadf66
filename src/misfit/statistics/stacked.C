// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of several channels below each other in one vector.

#include "stacked.H"

void statistics::appendColumn(mat& m, const vec& v)
{
    m.conservativeResize(v.size(), m.cols() + 1);
    m.rightCols(1) = v;
}


statistics::mat statistics::deviations(const mat& runs)
{
    return runs.colwise() - vec(runs.rowwise().mean());
}


statistics::stacked
statistics::stacked::without(const int omitted, std::vector<int>& keep) const
{
    stacked rest;
    keep.clear();
    int n = 0;
    for (int i = 0; i < count(segments); ++i)
    {
        if (i != omitted)
        {
            segment s(segments[i]);
            for (int k = 0; k < s.size; ++k)
            {
                keep.push_back(s.first + k);
            }
            s.first = n;
            n += s.size;
            rest.segments.push_back(s);
        }
    }
    rest.y = y(keep);
    return rest;
}


statistics::vec statistics::timeSlope(const stacked& data, const vec& v)
{
    vec slope = vec::Zero(v.size());
    for (const segment& s : data.segments)
    {
        for (int i = 0; s.overTime && i < s.size; ++i)
        {
            const int a = std::max(i - 1, 0);
            const int b = std::min(i + 1, s.size - 1);
            slope[s.first + i] =
                (v[s.first + b] - v[s.first + a])/(s.x[b] - s.x[a]);
        }
    }
    return slope;
}
