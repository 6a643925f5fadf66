// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what is named makes held-out channels worse.

#include "degradesHeldOut.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Covariance of the errors of what the best predicts at the held-out channels: of
//  its variables, of another formula, of something unknown beside it
mat predictionErrors
(
    const models& m,
    const scored& best,
    const scalar discrepancy
)
{
    const vec& x = best.best.x;
    const mat unsure = statistics::covarianceWithin
    (
        m.calibration->model(best.what), whitener(best.covariance), x
    );
    const mat there = m.validation->model(best.what).slopes(x);
    const scoring score(m.validation->score(discrepancy));
    mat errors =
        there*unsure*there.transpose() + score.modelDiscrepancy(best);
    if (best.what.unknown)
    {
        errors += score.unknownShape(best.amplitude, best.length);
    }
    return errors;
}

} // End anonymous namespace


Foam::scalar Foam::misfit::chanceOfDegradation
(
    const models& m,
    const scored& best,
    const heldOut& h,
    const scalar discrepancy
)
{
    // Given the effect that it predicts, what a right prediction leaves has the mean
    // nought; where it points against the effect, too much was predicted
    const covariance known(h.data, m.validation->uncertainty());
    const whitener white(known.at(h.after));
    const vec effect = white(vec(h.after - h.before));
    const vec left = white(vec(h.data.y - h.after));
    const mat half = white(predictionErrors(m, best, discrepancy));
    const mat errors = white(mat(half.transpose()));
    const scalar deviation =
        std::sqrt(effect.squaredNorm() + effect.dot(errors*effect));
    return
        0.5*std::erfc(-left.dot(effect)/max(deviation, VSMALL)/std::sqrt(2.0));
}
