// SPDX-License-Identifier: GPL-3.0-or-later
// Independent numbers from those with a covariance.

#include "whitener.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>

statistics::whitener::whitener(const mat& covariance)
:
    factor_(covariance)
{
    if (factor_.info() != Eigen::Success)
    {
        // Nearly dependent samples: a billionth of the variance makes them distinct
        mat wider(covariance);
        wider.diagonal() *= 1 + 1e-9;
        wider.diagonal().array() += 1e-9*covariance.diagonal().mean();
        factor_.compute(wider);
    }
    if (factor_.info() != Eigen::Success)
    {
        throw std::domain_error
        (
            "The covariance of the samples is not positive definite: is the"
            " uncertainty of a channel far too small?"
        );
    }
    logDeterminant_ =
        2*factor_.matrixLLT().diagonal().array().log().sum();

    const vec scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
    effectiveSize_ =
        sqr(double(covariance.rows()))
       /(scale.asDiagonal()*covariance*scale.asDiagonal()).squaredNorm();
}


double statistics::whitener::normInCommon(const mat& columns) const
{
    const mat white = (*this)(columns);
    const double n = columns.cols();
    const double all = white.rowwise().sum().squaredNorm();
    const double square = n < 2 ? all : (all - white.squaredNorm())/(n*(n - 1));
    return std::sqrt(std::max(square, 0.0));
}
