// SPDX-License-Identifier: GPL-3.0-or-later
// How a fit predicts data that it was not fitted to, and by what chance it errs there.

#include "heldOutChance.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace statistics;

//- Covariance of the errors of what the best predicts at the held-out channels: of
//  its variables, of another formula, of something unknown beside it
mat predictionErrors
(
    const sampledModel& fitted,
    const sampledModel& heldOut,
    const hypothesisFit& best
)
{
    const vec& x = best.fit.x;
    const mat unsure = covarianceWithin
    (
        fitted.model(best.what), whitener(best.covariance), x
    );
    const mat there = heldOut.model(best.what).slopes(x);
    const scoring score(heldOut.score());
    mat errors =
        there*unsure*there.transpose() + score.modelDiscrepancy(best);
    if (best.what.unknown)
    {
        errors += score.unknownShape(best.amplitude, best.length);
    }
    return errors;
}

} // End anonymous namespace


std::vector<statistics::vec> statistics::stepsWithin
(
    const fittedModel& model,
    const whitener& white,
    const vec& x,
    const vec& width
)
{
    // A variable at its bound is as uncertain as the others. In widths, as the units
    // may be any
    std::vector<vec> steps;
    const int n = width.size();
    if (!n)
    {
        return steps;
    }
    const mat slopes = white(mat(model.slopes(x)))*width.asDiagonal();
    const vec prior = width.cwiseQuotient(model.deviation().head(n));
    const mat curvature =
        slopes.transpose()*slopes + mat(prior.cwiseAbs2().asDiagonal());
    const Eigen::SelfAdjointEigenSolver<mat> axes(curvature);
    const vec at = x.head(n).cwiseQuotient(width);
    const vec lower = model.lower().head(n).cwiseQuotient(width);
    const vec upper = model.upper().head(n).cwiseQuotient(width);
    for (int k = 0; k < n; ++k)
    {
        const vec step =
            axes.eigenvectors().col(k)/std::sqrt(axes.eigenvalues()[k]);
        const auto within = [&](const vec& to)
        {
            return vec(to.cwiseMax(lower).cwiseMin(upper) - at);
        };
        const vec up = within(at + step);
        const vec down = within(at - step);
        const vec longer =
            (up.norm() < down.norm() ? down : up).cwiseProduct(width);
        if (longer.norm() > 0)
        {
            steps.push_back(longer);
        }
    }
    return steps;
}


double statistics::chanceOfDegradation
(
    const sampledModel& fitted,
    const sampledModel& heldOut,
    const hypothesisFit& best,
    const vec& before,
    const vec& after,
    const double shared
)
{
    // Given the effect that it predicts, what a right prediction leaves has the mean
    // nought; where it points against the effect, too much was predicted
    const whitener white(heldOut.uncertainty().at(after));
    const vec effect = white(vec(after - before));
    const vec left = white(vec(heldOut.data().y - after));
    const auto whitened = [&white](const mat& covariance)
    {
        const mat half = white(covariance);
        return mat(white(mat(half.transpose())));
    };
    const mat errors = whitened(predictionErrors(fitted, heldOut, best));

    // What chaos adds to the prediction is missing from what is left, and is in the
    // effect as far as both share it: they contradict each other by that, for nothing
    const mat chaos = shared*whitened(heldOut.chaosOfRun());
    const double deviation = std::sqrt
    (
        effect.squaredNorm() + effect.dot(errors*effect) + chaos.squaredNorm()
    );
    const double along = left.dot(effect) + chaos.trace();
    return 0.5*std::erfc(-along/std::max(deviation, tiny)/std::sqrt(2.0));
}
