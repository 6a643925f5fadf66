// SPDX-License-Identifier: GPL-3.0-or-later
// Possible explanations of a misfit, fitted and scored in one way: the scores.

#include "hypothesis.H"

#include <cmath>

namespace
{

using namespace statistics;

//- The sort that the number of hypotheses counts in
int sortOf(const hypothesis& h)
{
    return h.fault ? 3 : h.unknown ? 4 : h.mechanisms.size();
}


//- Adds twice the logarithm of the number of hypotheses of its sort
void addNumbers(std::vector<scored>& list)
{
    std::vector<int> number(5, 0);
    for (const scored& w : list)
    {
        ++number[sortOf(w.what)];
    }
    for (scored& w : list)
    {
        w.number = 2*std::log(double(number[sortOf(w.what)]));
        w.score += w.number;
    }
}


//- The covariance in the unit of the recording, if that is a larger one
mat inItsUnit(const mat& covariance, const vec& noiseScales)
{
    return noiseScales.asDiagonal()*covariance*noiseScales.asDiagonal();
}


//- A channel has the record of another place: what the simulation is uncertain by goes
//  with it
bool isMoved(const hypothesis& h)
{
    return
        h.fault
     && (h.fault->kind == faultKind::swapped
      || h.fault->kind == faultKind::misplaced);
}


//- Covariance of such an explanation at its fit: the sensors stay, all else is moved
mat movedCovariance
(
    const stacked& data,
    const covariance& known,
    const responseSurface& surface,
    const hypothesisModel& model,
    const scored& w
)
{
    const sensorFault& fault = *w.what.fault;
    const vec u = model.ofFault(w.best.x);
    const vec f = surface(model.expand(w.best.x));
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
    const hypothesis& h,
    const vec& f
) const
{
    if (!h.fault)
    {
        return covariance_.at(f);
    }
    const vec scales = h.fault->noiseScales(data_);
    return inItsUnit(covariance_.at(f.cwiseQuotient(scales)), scales);
}


statistics::mat
statistics::scoring::modelDiscrepancy(const scored& w) const
{
    mat c = mat::Zero(data_.size(), data_.size());
    const hypothesisModel model(this->model(w.what));
    const vec all = model.expand(w.best.x);
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


statistics::scored
statistics::scoring::scoreUnknown(const scored& base) const
{
    hypothesis h(base.what);
    h.unknown = true;
    scored best;
    for (const double length : {0.03, 0.1, 0.3})
    {
        for (double amplitude = 0.01; amplitude < 1.5; amplitude *= 2)
        {
            const whitener white
            (
                base.covariance + unknownShape(amplitude, length)
            );
            const scored w(withBaseCovariance(h, white));
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


void statistics::scoring::addPartly(std::vector<scored>& list) const
{
    std::vector<scored> partly;
    for (const scored& w : list)
    {
        if (w.what.mechanisms.size() && partly.size() < 4)
        {
            partly.push_back(scoreUnknown(w));
        }
    }
    for (const scored& w : list)
    {
        if (w.what.fault && w.what.fault->kind == faultKind::swapped)
        {
            partly.push_back(scoreUnknown(withOwnCovariance(w)));
            break;
        }
    }
    list.insert(list.end(), partly.begin(), partly.end());
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

statistics::scored statistics::scoring::withBaseCovariance
(
    const hypothesis& h,
    const whitener& white
) const
{
    scored w;
    w.what = h;
    w.best = fit(model(h), data_.y, white);
    w.score =
        w.best.objective + white.logDeterminant()
      + h.size()*std::log(effectiveSize_);
    return w;
}


statistics::scored statistics::scoring::base() const
{
    const vec atMean = surface_(bounds_.mean);
    const whitener white(covariance_.at(atMean));
    return withOwnCovariance(withBaseCovariance(hypothesis(), white));
}


statistics::scored
statistics::scoring::withOwnCovariance(const scored& first) const
{
    scored w(first);
    if (w.what.unknown)
    {
        hypothesis known(w.what);
        known.unknown = false;
        const scored start(withBaseCovariance(known, whitener(first.covariance)));
        w = scoreUnknown(withOwnCovariance(start));
    }
    else
    {
        for (int pass = 0; pass < 2; ++pass)
        {
            const mat own =
                isMoved(w.what)
              ? movedCovariance
                (
                    data_, covariance_, surface_, model(w.what), w
                )
              : ownCovariance(w.what, w.best.f);
            const mat c = own + modelDiscrepancy(w);
            w = withBaseCovariance(first.what, whitener(c));
            w.covariance = c;
        }
    }
    w.number = first.number;
    w.score += w.number;
    return w;
}


statistics::scored statistics::scoring::where(const scored& w) const
{
    scored there(w);
    if (!w.what.unknown)
    {
        const mat own =
            isMoved(w.what)
          ? movedCovariance(data_, covariance_, surface_, model(w.what), w)
          : ownCovariance(w.what, model(w.what)(w.best.x));
        there.covariance = own + modelDiscrepancy(w);
    }
    return where(there, whitener(there.covariance));
}


statistics::scored statistics::scoring::where
(
    const scored& w,
    const whitener& white
) const
{
    scored there(w);
    there.best = unfitted(model(w.what), data_.y, white, w.best.x);
    there.score =
        there.best.objective + white.logDeterminant()
      + w.what.size()*std::log(effectiveSize_) + w.number;
    return there;
}


statistics::scored statistics::scoring::again
(
    const scored& w,
    const whitener& white
) const
{
    scored next(withBaseCovariance(w.what, white));
    next.covariance = w.covariance;
    next.number = w.number;
    next.score += w.number;
    return next;
}


std::vector<statistics::scored> statistics::scoring::all
(
    const std::vector<int>& mechanisms,
    const std::vector<sensorFault>& faults,
    const bool pairs
) const
{
    // The others start from the base with its own covariance
    const scored none(base());
    const whitener white(none.covariance);

    std::vector<scored> list;
    list.push_back(withBaseCovariance(hypothesis(), white));
    for (int i = 0; i < count(mechanisms); ++i)
    {
        hypothesis h;
        h.mechanisms = {mechanisms[i]};
        list.push_back(withBaseCovariance(h, white));
        for (int j = i + 1; pairs && j < count(mechanisms); ++j)
        {
            h.mechanisms = {mechanisms[i], mechanisms[j]};
            list.push_back(withBaseCovariance(h, white));
        }
    }
    for (const sensorFault& fault : faults)
    {
        hypothesis h;
        h.fault = fault;
        const vec scales = fault.noiseScales(data_);
        scored w
        (
            (scales.array() == 1).all()
          ? withBaseCovariance(h, white)
          : withBaseCovariance(h, whitener(inItsUnit(none.covariance, scales)))
        );
        if (isMoved(h))
        {
            const mat own =
                movedCovariance(data_, covariance_, surface_, model(h), w);
            w = withBaseCovariance(h, whitener(own));
        }
        list.push_back(w);
    }
    list.push_back(scoreUnknown(none));
    addNumbers(list);
    sortByScore(list);

    // The best, the base and each mechanism alone, with their own covariance
    const double limit = list.front().score + 30;
    int withOwn = 0;
    for (scored& w : list)
    {
        if (w.what.unknown)
        {
            continue;
        }
        const bool single = w.what.mechanisms.size() == 1;
        if ((w.score < limit && withOwn++ < 12) || single || w.what.isNone())
        {
            w = withOwnCovariance(w);
        }
        else
        {
            w.covariance = none.covariance;
        }
    }
    sortByScore(list);
    addPartly(list);
    sortByScore(list);
    return list;
}


void statistics::setProbabilities
(
    std::vector<scored>& list,
    const double temperature
)
{
    double least = large;
    for (const scored& w : list)
    {
        least = std::min(least, w.score);
    }
    double sum = 0;
    for (scored& w : list)
    {
        w.probability =
            std::exp(-std::min(0.5*(w.score - least)/temperature, 700.0));
        sum += w.probability;
    }
    for (scored& w : list)
    {
        w.probability /= sum;
    }
}
