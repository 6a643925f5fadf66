// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with their intervals, and whether these show that a goal is reached.

#include "interval.H"

#include <algorithm>
#include <cmath>

//- Standard deviations of an interval of 95 %
static const Foam::scalar z = 1.96;


Foam::misfit::interval Foam::misfit::ofShare(const label hits, const label n)
{
    interval i;
    i.n = n;
    if (n)
    {
        const scalar p = scalar(hits)/n;
        const scalar middle = (p + z*z/(2*n))/(1 + z*z/n);
        const scalar half =
            z*std::sqrt(p*(1 - p)/n + z*z/(4.0*n*n))/(1 + z*z/n);
        i.value = p;
        i.low = hits ? max(middle - half, 0.0) : 0;
        i.high = hits < n ? min(middle + half, 1.0) : 1;
    }
    return i;
}


Foam::misfit::interval Foam::misfit::ofMedian(scalarList values)
{
    interval i;
    i.n = values.size();
    if (i.n)
    {
        std::sort(values.begin(), values.end());
        const scalar half = 0.5*z*std::sqrt(scalar(i.n));
        const auto ranked = [&](const scalar rank)
        {
            return values[min(max(label(rank) - 1, label(0)), i.n - 1)];
        };
        i.value = 0.5*(values[(i.n - 1)/2] + values[i.n/2]);
        // The least and the largest of five hold the median in 94 of 100 cases
        i.known = i.n > 5;
        i.low = ranked(std::floor(0.5*i.n - half));
        i.high = ranked(std::ceil(1 + 0.5*i.n + half));
    }
    return i;
}


Foam::misfit::interval Foam::misfit::ofMean(const scalarList& values)
{
    interval i;
    i.n = values.size();
    if (i.n)
    {
        scalar squares = 0;
        for (const scalar v : values)
        {
            i.value += v/i.n;
        }
        for (const scalar v : values)
        {
            squares += sqr(v - i.value);
        }
        const scalar half = z*std::sqrt(squares)/max(i.n, label(2));
        i.low = max(i.value - half, 0.0);
        i.high = i.value + half;
    }
    return i;
}


std::string Foam::misfit::against(const interval& i, const std::string& goal)
{
    if (goal.empty() || !i.n)
    {
        return "";
    }
    const scalar bound = std::stod(goal.substr(3));
    const bool least = goal[0] == '>';
    const auto reaches = [&](const scalar v)
    {
        return least ? v >= bound : v <= bound;
    };
    return
        !reaches(i.value) ? "short"
      : i.known && reaches(least ? i.low : i.high) ? "shown" : "open";
}
