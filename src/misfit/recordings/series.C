// SPDX-License-Identifier: GPL-3.0-or-later
// Values over time, or over a distance.

#include "series.H"

#include <algorithm>

Foam::scalar Foam::misfit::series::operator()(const scalar at) const
{
    const auto upper = std::upper_bound(x.cbegin(), x.cend(), at);
    if (upper == x.cbegin())
    {
        return y.first();
    }
    if (upper == x.cend())
    {
        return y.last();
    }
    const label i = upper - x.cbegin();
    const scalar w = (at - x[i-1])/(x[i] - x[i-1]);
    return (1 - w)*y[i-1] + w*y[i];
}


Foam::misfit::series Foam::misfit::series::within
(
    const scalar from,
    const scalar to
) const
{
    series kept;
    forAll(x, i)
    {
        if (x[i] >= from && x[i] <= to)
        {
            kept.x.append(x[i]);
            kept.y.append(y[i]);
        }
    }
    return kept;
}


bool Foam::misfit::series::isCopyOf(const series& other) const
{
    const bool varies = std::count(y.cbegin(), y.cend(), y.first()) < y.size();
    return varies && x == other.x && y == other.y;
}
