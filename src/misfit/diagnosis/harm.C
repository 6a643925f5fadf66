// SPDX-License-Identifier: GPL-3.0-or-later
// S7: whether what is named makes held-out channels worse.

#include "diagnosis.H"

#include <cmath>

Foam::misfit::mat Foam::misfit::diagnosis::predictionErrors() const
{
    const hypothesisModel model(gate_->surface(), bounds_, best().what);
    const mat slopes = model.slopes(best().best.x);
    return
        slopes*best().best.covariance*slopes.transpose()
      + gate_->weigh(settings_.formulaTolerance).otherFormula(best());
}


Foam::scalar
Foam::misfit::diagnosis::chanceOfHarm(const heldOut& h) const
{
    // What a right prediction leaves has nothing to do with the effect that it
    // predicts; where it points against the effect, too much was predicted
    const covariance known(h.data, gate_->uncertainty());
    const whitener white(known.at(h.after));
    const vec effect = white(vec(h.after - h.before));
    const vec left = white(vec(h.data.y - h.after));
    const mat half = white(predictionErrors());
    const mat errors = white(mat(half.transpose()));
    const scalar deviation =
        std::sqrt(effect.squaredNorm() + effect.dot(errors*effect));
    return
        0.5*std::erfc(-left.dot(effect)/max(deviation, VSMALL)/std::sqrt(2.0));
}
