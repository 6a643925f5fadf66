// SPDX-License-Identifier: GPL-3.0-or-later
// What a surge looks like: when it arrives, how high and long it is, and its parts.

#include "features.H"

#include <random>

namespace
{

using namespace statistics;

//- Place where a rising or falling series passes a level, between samples
double passage(const vec& x, const vec& v, int i, const int step, double level)
{
    while (i > 0 && i < v.size() - 1 && v[i] < level)
    {
        i += step;
    }
    const int before = std::min(std::max(i - step, 0), int(v.size() - 1));
    const double d = v[i] - v[before];
    return
        std::abs(d) > tiny && i != before
      ? x[before] + (x[i] - x[before])*(level - v[before])/d : x[i];
}

} // End anonymous namespace


statistics::vec statistics::features(const segment& s, const vec& all)
{
    const vec v = s.of(all).array() - all[s.first];
    int top = 0;
    const double peak = v.maxCoeff(&top);
    const int tenth = std::max(s.size/10, 1);

    vec f(5);
    int i = 0;
    while (i < top && v[i] < shareAtArrival*peak)
    {
        ++i;
    }
    f[0] = passage(s.x, v, i, 1, shareAtArrival*peak);
    f[1] = peak;
    f[2] = s.x[top] - f[0];
    i = top;
    while (i < s.size - 1 && v[i] > 0.5*peak)
    {
        ++i;
    }
    f[3] = s.x[i] - s.x[top];
    f[4] = v.tail(tenth).mean();
    return f;
}


statistics::vec statistics::changeOfFeatures
(
    const segment& s,
    const vec& from,
    const vec& to,
    const whitener& white
)
{
    const int n = 100;
    std::mt19937 generator(1);
    std::normal_distribution<double> normal;
    vec squares = vec::Zero(5);
    const vec centre = features(s, from);
    for (int k = 0; k < n; ++k)
    {
        vec u(from.size());
        for (double& value : u)
        {
            value = normal(generator);
        }
        squares += (features(s, from + white.colour(u)) - centre).cwiseAbs2()/n;
    }
    return (features(s, to) - centre).cwiseQuotient
    (
        squares.cwiseSqrt().cwiseMax(tiny)
    );
}


double statistics::shareBeyond
(
    const segment& s,
    const vec& recorded,
    const vec& computed,
    const vec& sigma
)
{
    const auto changing = [&s](const vec& v)
    {
        return
            s.isNumber() ? std::abs(v[0]) : vec(v.array() - v[0]).norm();
    };
    const double beyond =
        vec(recorded - computed).squaredNorm() - sigma.squaredNorm();
    return
        std::sqrt(std::max(beyond, 0.0))
       /std::max
        (
            std::max(changing(recorded), changing(computed)), sigma.norm()
        );
}


statistics::phase statistics::phaseOf
(
    const segment& s,
    const vec& y,
    const int begin,
    const int end
)
{
    const vec v = s.of(y).array() - y[s.first];
    int peak = 0;
    const double height = v.cwiseAbs().maxCoeff(&peak);
    int arrival = 0;
    while (arrival < peak && std::abs(v[arrival]) < 0.1*height)
    {
        ++arrival;
    }
    int last = s.size;
    while (last > peak + 1 && std::abs(v[last-1] - v[s.size-1]) < 0.1*height)
    {
        --last;
    }

    const double middle = 0.5*(begin + end - 1);
    const int tail = peak + (last - peak)/2;
    return
        middle < arrival - 0.5 ? phase::before
      : middle <= peak + 0.5 ? phase::front
      : middle < tail ? phase::body
      : middle < last ? phase::tail : phase::after;
}


double statistics::chanceOfSquare(const int samples, const double probability)
{
    // Of a standard normal number, by halving
    double low = -10;
    double high = 10;
    for (int i = 0; i < 60; ++i)
    {
        const double z = 0.5*(low + high);
        (std::erfc(z/std::sqrt(2.0)) > 2*probability ? low : high) = z;
    }
    const double v = 2.0/(9*samples);
    const double root = 1 - v + low*std::sqrt(v);
    return root*sqr(root);
}
