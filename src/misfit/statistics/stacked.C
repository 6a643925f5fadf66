// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of several channels below each other in one vector.

#include "stacked.H"

void Foam::misfit::appendColumn(mat& m, const vec& v)
{
    m.conservativeResize(v.size(), m.cols() + 1);
    m.rightCols(1) = v;
}


Foam::misfit::stacked
Foam::misfit::stacked::without(const label omitted, List<label>& keep) const
{
    stacked rest;
    keep.clear();
    label n = 0;
    forAll(segments, i)
    {
        if (i != omitted)
        {
            segment s(segments[i]);
            for (label k = 0; k < s.size; ++k)
            {
                keep.append(s.first + k);
            }
            s.first = n;
            n += s.size;
            rest.segments.append(s);
        }
    }
    rest.y = rows(y, keep);
    return rest;
}


Foam::misfit::vec Foam::misfit::rows(const vec& v, const List<label>& keep)
{
    vec some(keep.size());
    forAll(keep, i)
    {
        some[i] = v[keep[i]];
    }
    return some;
}


Foam::misfit::vec Foam::misfit::timeSlope(const stacked& data, const vec& v)
{
    vec slope = vec::Zero(v.size());
    for (const segment& s : data.segments)
    {
        for (label i = 0; s.overTime && i < s.size; ++i)
        {
            const label a = max(i - 1, 0);
            const label b = min(i + 1, s.size - 1);
            slope[s.first + i] =
                (v[s.first + b] - v[s.first + a])/(s.x[b] - s.x[a]);
        }
    }
    return slope;
}
