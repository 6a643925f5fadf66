// SPDX-License-Identifier: GPL-3.0-or-later
// S7: whether what is named makes held-out channels worse.

#include "diagnosis.H"

#include <cmath>

Foam::misfit::mat Foam::misfit::diagnosis::predictionErrors() const
{
    const vec& x = best().best.x;
    const mat unsure = covarianceWithin
    (
        hypothesisModel(fit_->surface(), bounds_, best().what),
        whitener(best().covariance),
        x
    );
    const mat there =
        hypothesisModel(gate_->surface(), bounds_, best().what).slopes(x);
    const weighing weigh(gate_->weigh(settings_.formulaTolerance));
    mat errors =
        there*unsure*there.transpose()
      + weigh.otherFormula(best());
    if (best().what.unknown)
    {
        errors += weigh.unknownShape(best().amplitude, best().length);
    }
    return errors;
}


Foam::scalar
Foam::misfit::diagnosis::chanceOfHarm(const heldOut& h) const
{
    // Given the effect that it predicts, what a right prediction leaves has the mean
    // nought; where it points against the effect, too much was predicted
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
