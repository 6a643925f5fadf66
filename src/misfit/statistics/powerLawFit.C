// SPDX-License-Identifier: GPL-3.0-or-later

#include "powerLawFit.H"

#include <boost/math/tools/minima.hpp>

#include <limits>
#include <stdexcept>

namespace statistics
{

powerLaw fitPowerLaw(const vec& x, const vec& y)
{
    if (x.size() == 0 || x.minCoeff() <= 0 || y.minCoeff() <= 0)
    {
        throw std::invalid_argument
        (
            "a power law needs points, all of them positive"
        );
    }
    if (x.maxCoeff() == x.minCoeff())
    {
        throw std::invalid_argument("a power law needs two different x");
    }

    // Logarithms about their mean keep the powers near 1
    const vec logX = x.array().log();
    const double middle = logX.mean();
    const vec u = logX.array() - middle;
    const vec logY = y.array().log();
    const double slope =
        u.dot(vec(logY.array() - logY.mean()))/u.squaredNorm();

    const auto shape = [&](const double b) -> vec
    {
        return (b*u.array()).exp();
    };
    const auto scale = [&](const vec& f)
    {
        return f.dot(y)/f.squaredNorm();
    };
    const auto misfit = [&](const double b)
    {
        const vec f = shape(b);
        return (y - scale(f)*f).squaredNorm();
    };

    const auto [b, left] = boost::math::tools::brent_find_minima
    (
        misfit, slope - 3, slope + 3, std::numeric_limits<double>::digits
    );
    const double variance = vec(y.array() - y.mean()).squaredNorm();

    return
    {
        scale(shape(b))*std::exp(-b*middle),
        b,
        variance > 0 ? 1 - left/variance : 1
    };
}

} // End namespace statistics
