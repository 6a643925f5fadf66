// SPDX-License-Identifier: GPL-3.0-or-later
// The probability of an outcome as a logistic function: its fit.

#include "logistic.H"

#include <cmath>
#include <stdexcept>

namespace
{

using namespace statistics;

double probability(const double logit)
{
    return 1/(1 + std::exp(-std::min(std::max(logit, -300.0), 300.0)));
}


//- The logarithm of the likelihood with a prior, and its slopes: it is concave, so that
//  Newton's steps, halved while they lead downwards, end where it is largest
struct likelihood
{
    //- A row for each outcome, with 1 in front
    mat x;

    vec outcome;

    vec weight;

    //- Of the prior of each coefficient
    vec precision;

    vec probabilities(const vec& c) const
    {
        return vec(x*c).unaryExpr(&probability);
    }

    double operator()(const vec& c) const
    {
        const vec logit = x*c;
        double sum = -0.5*precision.dot(c.cwiseAbs2());
        for (int i = 0; i < logit.size(); ++i)
        {
            // ln p of the outcome 1, ln(1 - p) of 0, without overflow
            const double z = outcome[i] > 0.5 ? logit[i] : -logit[i];
            sum -= weight[i]*(std::max(-z, 0.0) + std::log1p(std::exp(-std::abs(z))));
        }
        return sum;
    }

    vec slopes(const vec& c) const
    {
        const vec left = outcome - probabilities(c);
        return x.transpose()*weight.cwiseProduct(left) - precision.cwiseProduct(c);
    }

    vec newtonStep(const vec& c) const
    {
        const vec p = probabilities(c);
        const vec spread = weight.cwiseProduct(p.cwiseProduct(vec(1 - p.array())));
        mat curvature = x.transpose()*spread.asDiagonal()*x;
        curvature.diagonal() += precision;
        return curvature.ldlt().solve(slopes(c));
    }

    //- Where it is largest
    vec largest() const
    {
        vec c = vec::Zero(x.cols());
        for (int i = 0; i < 100 && slopes(c).norm() > 1e-10*x.rows(); ++i)
        {
            vec step = newtonStep(c);
            const double now = (*this)(c);
            for (int k = 0; k < 50 && !((*this)(c + step) >= now); ++k)
            {
                step /= 2;
            }
            c += step;
        }
        return c;
    }
};

} // End anonymous namespace


double statistics::logistic::operator()(const vec& x) const
{
    return probability(constant + coefficients.dot(x));
}


statistics::logistic statistics::fitLogistic
(
    const mat& x,
    const std::vector<bool>& outcomes,
    const double shrinkage
)
{
    const int n = x.rows();
    const int k = x.cols();
    if (n == 0 || n != count(outcomes))
    {
        throw std::domain_error("a logistic function needs outcomes to be fitted to");
    }
    const vec mean = x.colwise().mean();
    const mat off = x.rowwise() - mean.transpose();
    const vec deviation = (off.colwise().squaredNorm()/n).cwiseSqrt();

    // A column that is the same for all is no information: its coefficient stays zero
    const vec scale = deviation.unaryExpr
    (
        [](const double d) { return d > small ? 1/d : 0.0; }
    );
    likelihood f;
    f.x = mat::Zero(n + 2, k + 1);
    f.x.col(0).setOnes();
    f.x.block(0, 1, n, k) = off*scale.asDiagonal();
    f.outcome = vec::Zero(n + 2);
    for (int i = 0; i < n; ++i)
    {
        f.outcome[i] = outcomes[i];
    }
    f.outcome[n] = 1;
    f.weight = vec::Ones(n + 2);
    f.weight.tail(2).setConstant(0.5);
    f.precision = vec::Constant(k + 1, 1/sqr(shrinkage));
    f.precision[0] = 0;

    const vec c = f.largest();
    const vec slopes = f.slopes(c);
    if (!slopes.allFinite() || slopes.norm() > 1e-6*n)
    {
        throw std::domain_error("the fit of a logistic function does not converge");
    }
    logistic fitted;
    fitted.coefficients = c.tail(k).cwiseProduct(scale);
    fitted.constant = c[0] - fitted.coefficients.dot(mean);
    return fitted;
}
