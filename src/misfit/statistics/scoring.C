// SPDX-License-Identifier: GPL-3.0-or-later
// Possible explanations of a misfit, fitted and scored in one way: the scores.

#include "hypothesis.H"

#include <cmath>

namespace
{

using namespace statistics;

//- Covariance where a channel has the record of another place, at the fit: the sensors
//  stay, and the uncertainty of the simulation moves with the record
mat movedCovariance
(
    const stacked& data,
    const covariance& known,
    const responseSurface& surface,
    const hypothesisModel& model,
    const hypothesisFit& w
)
{
    const sensorFault& fault = *w.what.fault;
    const vec u = model.ofFault(w.fit.x);
    const vec f = surface(model.expand(w.fit.x));
    const covariance sensors(data, 0);

    // It is linear: T C T' by its columns, twice
    mat all = known.at(f) - sensors.at(f);
    for (int pass = 0; pass < 2; ++pass)
    {
        for (int i = 0; i < all.cols(); ++i)
        {
            all.col(i) = fault(data, vec(all.col(i)), u);
        }
        all.transposeInPlace();
    }
    return all + sensors.at(fault(data, f, u));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

statistics::mat statistics::scoring::ownCovariance
(
    const hypothesisFit& w,
    const vec& f
) const
{
    if (w.what.movesRecord())
    {
        return movedCovariance(data_, covariance_, surface_, model(w.what), w);
    }
    return
        w.what.fault
      ? inUnitOf
        (
            *w.what.fault,
            covariance_.at(f.cwiseQuotient(w.what.fault->noiseScales(data_)))
        )
      : covariance_.at(f);
}


statistics::mat statistics::scoring::inUnitOf
(
    const sensorFault& fault,
    const mat& covariance
) const
{
    const vec scales = fault.noiseScales(data_);
    return scales.asDiagonal()*covariance*scales.asDiagonal();
}


statistics::mat
statistics::scoring::modelDiscrepancy(const hypothesisFit& w) const
{
    mat c = mat::Zero(data_.size(), data_.size());
    const hypothesisModel model(this->model(w.what));
    const vec all = model.expand(w.fit.x);
    for (const int m : w.what.mechanisms)
    {
        vec without = all;
        without[bounds_.nParameters + m] = 0;
        const vec effect = discrepancy_*(surface_(all) - surface_(without));
        for (const segment& s : data_.segments)
        {
            const vec part = s.of(effect);
            c.block(s.first, s.first, s.size, s.size) += part*part.transpose();
        }
    }
    return c;
}


statistics::mat statistics::scoring::unknownShape
(
    const double amplitude,
    const double length
) const
{
    mat k = mat::Zero(data_.size(), data_.size());
    for (const segment& s : data_.segments)
    {
        const double size = amplitude*s.range(data_.y);
        for (int i = 0; i < s.size; ++i)
        {
            for (int j = 0; j < s.size; ++j)
            {
                const double d = (s.x[i] - s.x[j])/(length*s.duration());
                k(s.first + i, s.first + j) =
                    sqr(size)*std::exp(-std::min(0.5*d*d, 700.0));
            }
        }
    }
    return k;
}


statistics::hypothesisFit
statistics::scoring::scoreUnknown(const hypothesisFit& base) const
{
    hypothesis h(base.what);
    h.unknown = true;
    hypothesisFit best;
    for (const double length : {0.03, 0.1, 0.3})
    {
        for (double amplitude = 0.01; amplitude < 1.5; amplitude *= 2)
        {
            const whitener white
            (
                base.covariance + unknownShape(amplitude, length)
            );
            const hypothesisFit w(withBaseCovariance(h, white));
            if (w.score < best.score)
            {
                best = w;
                best.amplitude = amplitude;
                best.length = length;
            }
        }
    }
    best.covariance =
        base.covariance + unknownShape(best.amplitude, best.length);
    best.number = base.number;
    best.score += best.number;
    return best;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

statistics::scoring::scoring
(
    const stacked& data,
    const responseSurface& surface,
    const variableBounds& bounds,
    const covariance& covariance,
    const double discrepancy
)
:
    data_(data),
    surface_(surface),
    bounds_(bounds),
    covariance_(covariance),
    discrepancy_(discrepancy),
    effectiveSize_
    (
        std::max(whitener(covariance.at(surface(bounds.mean))).effectiveSize(), 8.0)
    )
{}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

statistics::hypothesisFit statistics::scoring::withBaseCovariance
(
    const hypothesis& h,
    const whitener& white
) const
{
    hypothesisFit w;
    w.what = h;
    w.fit = fit(model(h), data_.y, white);
    w.score =
        w.fit.objective + white.logDeterminant()
      + h.size()*std::log(effectiveSize_);
    return w;
}


statistics::hypothesisFit statistics::scoring::base() const
{
    const vec atMean = surface_(bounds_.mean);
    const whitener white(covariance_.at(atMean));
    return withOwnCovariance(withBaseCovariance(hypothesis(), white));
}


statistics::hypothesisFit
statistics::scoring::withOwnCovariance(const hypothesisFit& first) const
{
    hypothesisFit w(first);
    if (w.what.unknown)
    {
        hypothesis known(w.what);
        known.unknown = false;
        const hypothesisFit start(withBaseCovariance(known, whitener(first.covariance)));
        w = scoreUnknown(withOwnCovariance(start));
    }
    else
    {
        for (int pass = 0; pass < 2; ++pass)
        {
            const mat c = ownCovariance(w, w.fit.f) + modelDiscrepancy(w);
            w = withBaseCovariance(first.what, whitener(c));
            w.covariance = c;
        }
    }
    w.number = first.number;
    w.score += w.number;
    return w;
}


statistics::hypothesisFit statistics::scoring::where(const hypothesisFit& w) const
{
    hypothesisFit there(w);
    if (!w.what.unknown)
    {
        there.covariance =
            ownCovariance(w, model(w.what)(w.fit.x)) + modelDiscrepancy(w);
    }
    return where(there, whitener(there.covariance));
}


statistics::hypothesisFit statistics::scoring::where
(
    const hypothesisFit& w,
    const whitener& white
) const
{
    hypothesisFit there(w);
    there.fit = fitAt(model(w.what), data_.y, white, w.fit.x);
    there.score =
        there.fit.objective + white.logDeterminant()
      + w.what.size()*std::log(effectiveSize_) + w.number;
    return there;
}


statistics::hypothesisFit statistics::scoring::again
(
    const hypothesisFit& w,
    const whitener& white
) const
{
    hypothesisFit next(withBaseCovariance(w.what, white));
    next.covariance = w.covariance;
    next.number = w.number;
    next.score += w.number;
    return next;
}
