// SPDX-License-Identifier: GPL-3.0-or-later
// Fits a model of the samples to what was recorded, within bounds and priors.

#include "boundedFit.H"

#include <cmath>

namespace
{

using namespace statistics;

//- 1 over the variance of the prior; 0 where nothing is known
vec priorWeight(const fittedModel& model)
{
    vec w = model.deviation();
    for (double& d : w)
    {
        d = d > 0 ? 1/(d*d) : 0;
    }
    return w;
}


//- Sets f, misfit and objective at x
void evaluate
(
    const fittedModel& model,
    const vec& y,
    const whitener& white,
    fitted& at
)
{
    at.f = model(at.x);
    at.misfit = white(vec(y - at.f)).squaredNorm();
    at.objective =
        at.misfit
      + priorWeight(model).dot((at.x - model.mean()).cwiseAbs2());
}


//- Curvature of half the objective at x
mat curvature(const mat& slopes, const vec& prior)
{
    mat a = slopes.transpose()*slopes;
    a.diagonal() += prior;
    return a;
}


//- Inverse of a curvature, whose variables may have any units. Where it is flat
//  nothing is known: a variance as large as numbers can tell
mat inverted(const mat& curved)
{
    const vec scale = curved.diagonal().unaryExpr
    (
        [](const double d) { return d > 0 ? 1/std::sqrt(d) : 1.0; }
    );
    const mat scaled = scale.asDiagonal()*curved*scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<mat> solver(scaled);
    const double least =
        curved.rows()*small*std::max(solver.eigenvalues().maxCoeff(), small);
    const vec weights = solver.eigenvalues().cwiseMax(least).cwiseInverse();
    const mat inverse =
        solver.eigenvectors()*weights.asDiagonal()
       *solver.eigenvectors().transpose();
    return scale.asDiagonal()*inverse*scale.asDiagonal();
}


//- Sets covariance and pinned
void findCovariance
(
    const fittedModel& model,
    const whitener& white,
    fitted& at
)
{
    const int n = at.x.size();
    const vec lower = model.lower();
    const vec upper = model.upper();
    std::vector<int> open;
    at.pinned.resize(n, false);
    for (int i = 0; i < n; ++i)
    {
        const double near = 1e-6*(upper[i] - lower[i]);
        at.pinned[i] = at.x[i] < lower[i] + near || at.x[i] > upper[i] - near;
        if (!at.pinned[i])
        {
            open.push_back(i);
        }
    }

    const mat all =
        curvature(white(model.slopes(at.x)), priorWeight(model));
    at.covariance = mat::Zero(n, n);
    if (open.empty())
    {
        return;
    }
    at.covariance(open, open) = inverted(all(open, open));
}


fitted fitFrom
(
    const fittedModel& model,
    const vec& y,
    const whitener& white,
    const vec& start
)
{
    const vec lower = model.lower();
    const vec upper = model.upper();
    const vec prior = priorWeight(model);
    const vec mean = model.mean();

    fitted now;
    now.x = start.cwiseMax(lower).cwiseMin(upper);
    evaluate(model, y, white, now);

    double damping = 1e-4;
    for (int iteration = 0; iteration < 60 && damping < 1e8; ++iteration)
    {
        const mat slopes = white(model.slopes(now.x));
        mat a = curvature(slopes, prior);
        const vec b =
            slopes.transpose()*white(vec(y - now.f))
          - prior.cwiseProduct(now.x - mean);
        a.diagonal() += damping*a.diagonal().cwiseMax(tiny);

        fitted next;
        next.x =
            now.x
          + boxMinimum
            (
                a, b, lower - now.x, upper - now.x, vec::Zero(now.x.size())
            );
        evaluate(model, y, white, next);

        if (next.objective < now.objective)
        {
            const double gain = now.objective - next.objective;
            now = next;
            damping *= 0.2;
            if (gain < 1e-8*(1 + now.objective))
            {
                break;
            }
        }
        else
        {
            damping *= 8;
        }
    }
    return now;
}

} // End anonymous namespace


statistics::mat statistics::covarianceWithin
(
    const fittedModel& model,
    const whitener& white,
    const vec& x
)
{
    const vec range = model.upper() - model.lower();
    vec weight = priorWeight(model);
    for (int i = 0; i < weight.size(); ++i)
    {
        weight[i] = weight[i] > 0 ? weight[i] : 1/sqr(std::max(range[i], small));
    }
    return inverted(curvature(white(model.slopes(x)), weight));
}


statistics::vec statistics::boxMinimum
(
    const mat& a,
    const vec& b,
    const vec& lower,
    const vec& upper,
    vec x
)
{
    for (int sweep = 0; sweep < 500; ++sweep)
    {
        double moved = 0;
        for (int i = 0; i < x.size(); ++i)
        {
            if (a(i, i) <= 0)
            {
                continue;
            }
            const double old = x[i];
            const double free = old + (b[i] - a.row(i).dot(x))/a(i, i);
            x[i] = std::min(std::max(free, lower[i]), upper[i]);
            moved += a(i, i)*sqr(x[i] - old);
        }
        if (moved < 1e-16*(1 + b.dot(x)*b.dot(x)))
        {
            break;
        }
    }
    return x;
}


statistics::fitted statistics::fit
(
    const fittedModel& model,
    const vec& y,
    const whitener& white
)
{
    fitted best;
    best.objective = large;
    for (const vec& start : model.starts())
    {
        const fitted one(fitFrom(model, y, white, start));
        if (one.objective < best.objective)
        {
            best = one;
        }
    }
    findCovariance(model, white, best);
    return best;
}


statistics::fitted statistics::unfitted
(
    const fittedModel& model,
    const vec& y,
    const whitener& white,
    const vec& x
)
{
    fitted there;
    there.x = x;
    evaluate(model, y, white, there);
    findCovariance(model, white, there);
    return there;
}
