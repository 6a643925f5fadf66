// SPDX-License-Identifier: GPL-3.0-or-later
// Possible explanations of a misfit, fitted and weighed in one way: the weights.

#include "hypothesis.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The sort that the number of hypotheses counts in
label sortOf(const hypothesis& h)
{
    return h.fault ? 3 : h.unknown ? 4 : h.mechanisms.size();
}


//- Adds twice the logarithm of the number of hypotheses of its sort
void addNumbers(List<weighed>& list)
{
    List<label> number(5, 0);
    for (const weighed& w : list)
    {
        ++number[sortOf(w.what)];
    }
    for (weighed& w : list)
    {
        w.number = 2*std::log(scalar(number[sortOf(w.what)]));
        w.score += w.number;
    }
}


//- The covariance in the unit of the recording, if that is a larger one
mat inItsUnit(const mat& covariance, const vec& noiseScales)
{
    return noiseScales.asDiagonal()*covariance*noiseScales.asDiagonal();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::misfit::mat Foam::misfit::weighing::ownCovariance
(
    const hypothesis& h,
    const vec& f
) const
{
    if (!h.fault)
    {
        return covariance_.at(f);
    }
    const vec scales = h.fault->noiseScales();
    return inItsUnit(covariance_.at(f.cwiseQuotient(scales)), scales);
}


Foam::misfit::mat
Foam::misfit::weighing::otherFormula(const weighed& w) const
{
    mat c = mat::Zero(data_.size(), data_.size());
    const hypothesisModel model(surface_, bounds_, w.what);
    const vec all = model.expand(w.best.x);
    for (const label m : w.what.mechanisms)
    {
        vec without = all;
        without[bounds_.nParameters + m] = 0;
        const vec effect = tolerance_*(surface_(all) - surface_(without));
        for (const segment& s : data_.segments)
        {
            const vec part = s.of(effect);
            c.block(s.first, s.first, s.size, s.size) += part*part.transpose();
        }
    }
    return c;
}


Foam::misfit::mat Foam::misfit::weighing::unknownShape
(
    const scalar amplitude,
    const scalar length
) const
{
    mat k = mat::Zero(data_.size(), data_.size());
    for (const segment& s : data_.segments)
    {
        const scalar size = amplitude*s.range(data_.y);
        for (label i = 0; i < s.size; ++i)
        {
            for (label j = 0; j < s.size; ++j)
            {
                const scalar d = (s.x[i] - s.x[j])/(length*s.duration());
                k(s.first + i, s.first + j) =
                    sqr(size)*std::exp(-min(0.5*d*d, 700.0));
            }
        }
    }
    return k;
}


Foam::misfit::weighed
Foam::misfit::weighing::weighUnknown(const weighed& base) const
{
    hypothesis h(base.what);
    h.unknown = true;
    weighed best;
    for (const scalar length : {0.03, 0.1, 0.3})
    {
        for (scalar amplitude = 0.01; amplitude < 1.5; amplitude *= 2)
        {
            const whitener white
            (
                base.covariance + unknownShape(amplitude, length)
            );
            const weighed w(quickly(h, white));
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


void Foam::misfit::weighing::addPartly(List<weighed>& list) const
{
    List<weighed> partly;
    for (const weighed& w : list)
    {
        if (w.what.mechanisms.size() && partly.size() < 4)
        {
            partly.append(weighUnknown(w));
        }
    }
    list.append(partly);
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::weighing::weighing
(
    const stacked& data,
    const responseSurface& surface,
    const variableBounds& bounds,
    const covariance& covariance,
    const scalar tolerance
)
:
    data_(data),
    surface_(surface),
    bounds_(bounds),
    covariance_(covariance),
    tolerance_(tolerance),
    effectiveSize_
    (
        max(whitener(covariance.at(surface(bounds.mean))).effectiveSize(), 8.0)
    )
{}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::weighed Foam::misfit::weighing::quickly
(
    const hypothesis& h,
    const whitener& white
) const
{
    weighed w;
    w.what = h;
    w.best = fit(hypothesisModel(surface_, bounds_, h), data_.y, white);
    w.score =
        w.best.objective + white.logDeterminant()
      + h.size()*std::log(effectiveSize_);
    return w;
}


Foam::misfit::weighed Foam::misfit::weighing::base() const
{
    const vec atMean = surface_(bounds_.mean);
    return thoroughly(quickly(hypothesis(), whitener(covariance_.at(atMean))));
}


Foam::misfit::weighed
Foam::misfit::weighing::thoroughly(const weighed& quick) const
{
    weighed w(quick);
    if (w.what.unknown)
    {
        hypothesis known(w.what);
        known.unknown = false;
        const weighed start(quickly(known, whitener(quick.covariance)));
        w = weighUnknown(thoroughly(start));
    }
    else
    {
        for (label pass = 0; pass < 2; ++pass)
        {
            const mat c = ownCovariance(w.what, w.best.f) + otherFormula(w);
            w = quickly(quick.what, whitener(c));
            w.covariance = c;
        }
    }
    w.number = quick.number;
    w.score += w.number;
    return w;
}


Foam::misfit::weighed Foam::misfit::weighing::where(const weighed& w) const
{
    const hypothesisModel model(surface_, bounds_, w.what);
    weighed there(w);
    if (!w.what.unknown)
    {
        there.covariance =
            ownCovariance(w.what, model(w.best.x)) + otherFormula(w);
    }
    const whitener white(there.covariance);
    there.best = unfitted(model, data_.y, white, w.best.x);
    there.score =
        there.best.objective + white.logDeterminant()
      + w.what.size()*std::log(effectiveSize_) + w.number;
    return there;
}


Foam::List<Foam::misfit::weighed> Foam::misfit::weighing::all
(
    const List<label>& mechanisms,
    const faultList& faults,
    const bool pairs
) const
{
    // The others start from the base with its own covariance
    const weighed none(base());
    const whitener white(none.covariance);

    List<weighed> list;
    list.append(quickly(hypothesis(), white));
    forAll(mechanisms, i)
    {
        hypothesis h;
        h.mechanisms = {mechanisms[i]};
        list.append(quickly(h, white));
        for (label j = i + 1; pairs && j < mechanisms.size(); ++j)
        {
            h.mechanisms = {mechanisms[i], mechanisms[j]};
            list.append(quickly(h, white));
        }
    }
    for (const auto& fault : faults)
    {
        hypothesis h;
        h.fault = fault;
        const vec scales = fault->noiseScales();
        list.append
        (
            (scales.array() == 1).all()
          ? quickly(h, white)
          : quickly(h, whitener(inItsUnit(none.covariance, scales)))
        );
    }
    list.append(weighUnknown(none));
    addNumbers(list);
    sortByScore(list);

    // The best, the base and each mechanism alone, with their own covariance
    const scalar limit = list.first().score + 30;
    label thorough = 0;
    for (weighed& w : list)
    {
        if (w.what.unknown)
        {
            continue;
        }
        const bool single = w.what.mechanisms.size() == 1;
        if ((w.score < limit && thorough++ < 12) || single || w.what.isNone())
        {
            w = thoroughly(w);
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


void Foam::misfit::setProbabilities
(
    List<weighed>& list,
    const scalar temperature
)
{
    scalar least = GREAT;
    for (const weighed& w : list)
    {
        least = min(least, w.score);
    }
    scalar sum = 0;
    for (weighed& w : list)
    {
        w.probability =
            std::exp(-min(0.5*(w.score - least)/temperature, 700.0));
        sum += w.probability;
    }
    for (weighed& w : list)
    {
        w.probability /= sum;
    }
}
