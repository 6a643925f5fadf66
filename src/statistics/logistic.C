// SPDX-License-Identifier: GPL-3.0-or-later
// The probability of an outcome as a logistic function: its fit.

#include "logistic.H"

#include <unsupported/Eigen/NonLinearOptimization>

#include <cfenv>
#include <cmath>
#include <stdexcept>

namespace
{

using namespace statistics;

double probability(const double logit)
{
    return 1/(1 + std::exp(-std::min(std::max(logit, -300.0), 300.0)));
}


//- Slopes of the likelihood with a prior, which vanish where it is largest; in the
//  form that Eigen's solver asks for
struct likelihood
{
    using Scalar = double;

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

    int operator()(const vec& c, vec& slopes) const
    {
        const vec left = outcome - probabilities(c);
        slopes =
            x.transpose()*weight.cwiseProduct(left) - precision.cwiseProduct(c);
        return 0;
    }

    int df(const vec& c, mat& curvature) const
    {
        const vec p = probabilities(c);
        const vec spread = p.cwiseProduct(vec(1 - p.array()));
        curvature = -x.transpose()*weight.cwiseProduct(spread).asDiagonal()*x;
        curvature.diagonal() -= precision;
        return 0;
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

    // What is the same for all tells nothing: its coefficient stays zero
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

    // Its rotations may divide by zero where nothing is to be rotated
    vec c = vec::Zero(k + 1);
    Eigen::HybridNonLinearSolver<likelihood> solver(f);
    std::fenv_t traps;
    std::feholdexcept(&traps);
    solver.hybrj1(c);
    std::fesetenv(&traps);
    vec slopes(k + 1);
    f(c, slopes);
    if (!slopes.allFinite() || slopes.norm() > 1e-6*n)
    {
        throw std::domain_error("the fit of a logistic function does not converge");
    }
    logistic fitted;
    fitted.coefficients = c.tail(k).cwiseProduct(scale);
    fitted.constant = c[0] - fitted.coefficients.dot(mean);
    return fitted;
}
