// SPDX-License-Identifier: GPL-3.0-or-later
// How far recording and simulation may differ without anything being wrong.

#include "covariance.H"
#include "error.H"

#include <cmath>

namespace
{

using namespace Foam;

//- Covariance of the means of noise over two spans of length w whose centres
//  are d apart, over the variance of a reading; the noise forgets
//  exponentially with the length m
scalar ofMeans(const scalar d, const scalar w, const scalar m)
{
    const scalar x = w/m;
    if (x < 1e-3)
    {
        return std::exp(-min(d/m, 700.0));
    }
    if (d < 0.5*w)
    {
        return 2*(x - 1 + std::exp(-min(x, 700.0)))/(x*x);
    }
    const scalar between = (d - w)/m;
    return std::exp(-min(max(between, 0.0), 700.0))
       *Foam::sqr((1 - std::exp(-min(x, 700.0)))/x);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::covariance::addNoise(const segment& s)
{
    auto block = fixed_.block(s.first, s.first, s.size, s.size);
    for (label i = 0; i < s.size; ++i)
    {
        const scalar white = Foam::sqr(s.uncertainty)/s.readings[i];
        for (label j = 0; j < s.size; ++j)
        {
            if (s.memory > 0)
            {
                block(i, j) +=
                    Foam::sqr(s.uncertainty)
                   *ofMeans(mag(s.x[i] - s.x[j]), s.span, s.memory);
            }
            else if (i == j)
            {
                block(i, j) += white;
            }
            block(i, j) += Foam::sqr(s.zeroUncertainty);
        }

        // The mean of correlated readings is never surer than of white ones
        block(i, i) = max(block(i, i), white + Foam::sqr(s.zeroUncertainty));
    }
}


void Foam::misfit::covariance::add(const string& source, const mat& part)
{
    fixed_ += part;
    parts_.append({source, part.diagonal()});
}


Foam::misfit::mat Foam::misfit::covariance::ofGains(const vec& f) const
{
    mat all = mat::Zero(data_.size(), data_.size());
    for (const segment& s : data_.segments)
    {
        const vec part = s.gainUncertainty*s.of(f);
        all.block(s.first, s.first, s.size, s.size) = part*part.transpose();
    }
    return all;
}


Foam::misfit::vec
Foam::misfit::covariance::variance(const mat& deviations) const
{
    const vec raw =
        deviations.rowwise().squaredNorm()/scalar(deviations.cols());
    vec smooth(raw.size());
    for (const segment& s : data_.segments)
    {
        const scalar least = 1e-3*s.of(raw).maxCoeff();
        for (label i = 0; i < s.size; ++i)
        {
            const label a = max(i - 2, 0);
            const label b = min(i + 3, s.size);
            smooth[s.first + i] =
                max(raw.segment(s.first + a, b - a).mean(), least);
        }
    }
    return smooth;
}


Foam::scalar Foam::misfit::covariance::likelyMemory(const mat& scaled) const
{
    scalar best = 0;
    scalar least = GREAT;
    for (scalar share = 0.003; share < 1.1; share *= 1.3)
    {
        scalar minusTwoLogLikelihood = 0;
        for (const segment& s : data_.segments)
        {
            for (label i = 1; i < s.size; ++i)
            {
                const scalar rho =
                    std::exp(-(s.x[i] - s.x[i-1])/(share*s.duration()));
                const scalar rest = max(1 - rho*rho, 1e-6);
                minusTwoLogLikelihood +=
                    scaled.cols()*std::log(rest)
                  + (scaled.row(s.first + i) - rho*scaled.row(s.first + i - 1))
                        .squaredNorm()/rest;
            }
        }
        if (minusTwoLogLikelihood < least)
        {
            least = minusTwoLogLikelihood;
            best = share;
        }
    }
    return best;
}


Foam::misfit::mat
Foam::misfit::covariance::correlation(const scalar memory) const
{
    mat r = mat::Zero(data_.size(), data_.size());
    for (const segment& s : data_.segments)
    {
        for (label i = 0; i < s.size; ++i)
        {
            for (label j = 0; j < s.size; ++j)
            {
                r(s.first + i, s.first + j) =
                    std::exp(-mag(s.x[i] - s.x[j])/(memory*s.duration()));
            }
        }
    }
    return r;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::misfit::covariance::covariance(const stacked& data, const scalar trigger)
:
    data_(data),
    trigger_(trigger),
    fixed_(mat::Zero(data.size(), data.size())),
    memory_(0),
    shrinkage_(1)
{
    for (const segment& s : data.segments)
    {
        addNoise(s);
    }
    parts_.append({"sensors", fixed_.diagonal()});
}


Foam::misfit::whitener::whitener(const mat& covariance)
:
    factor_(covariance)
{
    if (factor_.info() != Eigen::Success)
    {
        // Nearly dependent samples: a billionth of the variance tells them apart
        mat wider(covariance);
        wider.diagonal() *= 1 + 1e-9;
        wider.diagonal().array() += 1e-9*covariance.diagonal().mean();
        factor_.compute(wider);
    }
    if (factor_.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "The covariance of the samples is not positive definite: is the"
            << " uncertainty of a channel far too small?" << exit(FatalError);
    }
    logDeterminant_ =
        2*factor_.matrixLLT().diagonal().array().log().sum();

    const vec scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
    effectiveSize_ =
        Foam::sqr(scalar(covariance.rows()))
       /(scale.asDiagonal()*covariance*scale.asDiagonal()).squaredNorm();
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::misfit::covariance::addSpread
(
    const string& source,
    const mat& deviations,
    const scalar factor
)
{
    const label n = deviations.cols();
    if (n < 2 || deviations.squaredNorm() <= 0)
    {
        return;
    }
    const vec scale = variance(deviations).cwiseSqrt().cwiseMax(VSMALL);
    const mat z = scale.cwiseInverse().asDiagonal()*deviations;
    memory_ = likelyMemory(z);

    const mat target = correlation(memory_);
    const mat sample = z*z.transpose()/scalar(n);

    // Sampling variance of each entry, and its distance from the target
    const mat squares = z.cwiseAbs2();
    const mat fourth = squares*squares.transpose()/scalar(n);
    const scalar noise =
        (fourth - sample.cwiseAbs2()).sum()/max(scalar(n - 1), 1.0);
    const scalar distance = (sample - target).squaredNorm();
    shrinkage_ = distance > 0 ? min(max(noise/distance, 0.0), 1.0) : 1;

    add
    (
        source,
        factor*scale.asDiagonal()
       *(shrinkage_*target + (1 - shrinkage_)*sample)*scale.asDiagonal()
    );
}


void Foam::misfit::covariance::addRepeats
(
    const mat& runs,
    const label averaged
)
{
    const label n = runs.cols();
    if (n < 2)
    {
        return;
    }
    const mat deviations = runs.colwise() - vec(runs.rowwise().mean());
    addSpread("packings", deviations, (1 + 1.0/averaged)*n/(n - 1));
}


void Foam::misfit::covariance::addDifference
(
    const string& source,
    const vec& difference
)
{
    if (difference.squaredNorm() <= 0)
    {
        return;
    }

    // With other parameters the error has another shape of like size. Of first
    // order, it is twice what halving a cell changes
    const mat column(difference);
    const vec scale = 2*variance(column).cwiseSqrt().cwiseMax(VSMALL);
    const mat z = scale.cwiseInverse().asDiagonal()*column;
    add
    (
        source,
        mat(difference*difference.transpose())
      + scale.asDiagonal()*correlation(likelyMemory(z))*scale.asDiagonal()
    );
}


void Foam::misfit::covariance::addDirections
(
    const string& source,
    const mat& changes
)
{
    if (changes.cols())
    {
        add(source, changes*changes.transpose());
    }
}


Foam::misfit::mat Foam::misfit::covariance::at(const vec& f) const
{
    mat all = fixed_ + ofGains(f);
    if (trigger_ > 0)
    {
        const vec shift = trigger_*timeSlope(data_, f);
        all += shift*shift.transpose();
    }
    return all;
}


Foam::List<Foam::misfit::uncertaintySource>
Foam::misfit::covariance::sources(const vec& f) const
{
    List<uncertaintySource> all(parts_);
    all[0].second() += ofGains(f).diagonal();
    if (trigger_ > 0)
    {
        const vec shift = trigger_*timeSlope(data_, f);
        all.append({"start of time", shift.cwiseAbs2()});
    }
    for (uncertaintySource& s : all)
    {
        s.second() = s.second().cwiseSqrt().eval();
    }
    return all;
}
