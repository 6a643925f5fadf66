// SPDX-License-Identifier: GPL-3.0-or-later

#include "rankCorrelation.H"

#include <algorithm>
#include <cmath>
#include <random>

namespace statistics
{

namespace
{

//- Normal numbers by Box and Muller from the generator of Park and Miller: what
//  std::normal_distribution draws differs between standard libraries
class normalNumbers
{
    std::minstd_rand0 generator_;


    //- Between 0 and 1, both excluded
    double even()
    {
        return double(generator_())/double(generator_.max() + 1);
    }


public:

    explicit normalNumbers(const unsigned seed)
    :
        generator_(seed)
    {}

    double operator()()
    {
        const double size = std::sqrt(-2*std::log(even()));
        return size*std::cos(2*M_PI*even());
    }
};

} // End anonymous namespace


double correlation(const vec& x, const vec& y)
{
    const vec dx = x.array() - x.mean();
    const vec dy = y.array() - y.mean();
    const double xx = dx.squaredNorm();
    const double yy = dy.squaredNorm();
    return xx > 0 && yy > 0 ? dx.dot(dy)/std::sqrt(xx*yy) : 0;
}


vec ranks(const vec& x)
{
    vec result(x.size());
    for (int i = 0; i < x.size(); ++i)
    {
        const double below = (x.array() < x[i]).count();
        const double equal = (x.array() == x[i]).count();
        result[i] = 0.5 + below + 0.5*equal;
    }
    return result;
}


double rankCorrelation(const vec& x, const vec& y)
{
    return correlation(ranks(x), ranks(y));
}


rankInterval rankCorrelationInterval
(
    const vec& x,
    const vec& y,
    const double scatter,
    const int nDraws,
    const unsigned seed
)
{
    normalNumbers normal(seed);
    std::vector<double> drawn(nDraws);
    for (double& rho : drawn)
    {
        vec z = x;
        for (int i = 0; i < z.size(); ++i)
        {
            z[i] += scatter*normal();
        }
        rho = rankCorrelation(z, y);
    }
    std::sort(drawn.begin(), drawn.end());

    const double rho = rankCorrelation(x, y);
    const auto mirrored = [&](const double share)
    {
        const int place = std::max(int(share*nDraws) - 1, 0);
        return std::clamp(2*rho - drawn[place], -1.0, 1.0);
    };
    return {mirrored(0.95), mirrored(0.05)};
}

} // End namespace statistics
