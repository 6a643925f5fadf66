// SPDX-License-Identifier: GPL-3.0-or-later
// How far recording and simulation may differ without anything being wrong.

#include "covariance.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace statistics;

//- Covariance of the means of noise over two spans of length w whose centres
//  are d apart, over the variance of a reading; the noise forgets
//  exponentially with the length m
double ofMeans(const double d, const double w, const double m)
{
    const double x = w/m;
    if (x < 1e-3)
    {
        return std::exp(-std::min(d/m, 700.0));
    }
    if (d < 0.5*w)
    {
        return 2*(x - 1 + std::exp(-std::min(x, 700.0)))/(x*x);
    }
    const double between = (d - w)/m;
    return std::exp(-std::min(std::max(between, 0.0), 700.0))
       *sqr((1 - std::exp(-std::min(x, 700.0)))/x);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void statistics::covariance::addNoise(const segment& s)
{
    auto block = fixed_.block(s.first, s.first, s.size, s.size);
    for (int i = 0; i < s.size; ++i)
    {
        const double white = sqr(s.uncertainty)/s.readings[i];
        for (int j = 0; j < s.size; ++j)
        {
            if (s.memory > 0)
            {
                block(i, j) +=
                    sqr(s.uncertainty)/s.repeats
                   *ofMeans(std::abs(s.x[i] - s.x[j]), s.span, s.memory);
            }
            else if (i == j)
            {
                block(i, j) += white;
            }
            block(i, j) += sqr(s.zeroUncertainty);
        }

        // The mean of correlated readings is never surer than of white ones
        block(i, i) = std::max(block(i, i), white + sqr(s.zeroUncertainty));
    }
}


statistics::mat statistics::covariance::ofRecordings() const
{
    mat share(data_.size(), data_.size());
    for (const segment& a : data_.segments)
    {
        for (const segment& b : data_.segments)
        {
            share.block(a.first, b.first, a.size, b.size)
                .setConstant(1.0/std::max(a.repeats, b.repeats));
        }
    }
    return share;
}


void statistics::covariance::add(const std::string& source, const mat& part)
{
    fixed_ += part;
    parts_.push_back({source, part.diagonal()});
}


statistics::mat statistics::covariance::ofGains(const vec& f) const
{
    mat all = mat::Zero(data_.size(), data_.size());
    for (const segment& s : data_.segments)
    {
        const vec part = s.gainUncertainty*s.of(f);
        all.block(s.first, s.first, s.size, s.size) = part*part.transpose();
    }
    return all;
}


statistics::vec
statistics::covariance::variance(const mat& deviations) const
{
    const vec raw =
        deviations.rowwise().squaredNorm()/double(deviations.cols());
    vec smooth(raw.size());
    for (const segment& s : data_.segments)
    {
        const double least = 1e-3*s.of(raw).maxCoeff();
        for (int i = 0; i < s.size; ++i)
        {
            const int a = std::max(i - 2, 0);
            const int b = std::min(i + 3, s.size);
            smooth[s.first + i] =
                std::max(raw.segment(s.first + a, b - a).mean(), least);
        }
    }
    return smooth;
}


double statistics::covariance::likelyMemory(const mat& scaled) const
{
    double best = 0;
    double least = large;
    for (double share = 0.003; share < 1.1; share *= 1.3)
    {
        double minusTwoLogLikelihood = 0;
        for (const segment& s : data_.segments)
        {
            for (int i = 1; i < s.size; ++i)
            {
                const double rho =
                    std::exp(-(s.x[i] - s.x[i-1])/(share*s.duration()));
                const double rest = std::max(1 - rho*rho, 1e-6);
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


statistics::mat
statistics::covariance::correlation(const double memory) const
{
    mat r = mat::Zero(data_.size(), data_.size());
    for (const segment& s : data_.segments)
    {
        for (int i = 0; i < s.size; ++i)
        {
            for (int j = 0; j < s.size; ++j)
            {
                r(s.first + i, s.first + j) =
                    std::exp(-std::abs(s.x[i] - s.x[j])/(memory*s.duration()));
            }
        }
    }
    return r;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

statistics::covariance::covariance(const stacked& data, const double clockUncertainty)
:
    data_(data),
    clockUncertainty_(clockUncertainty),
    fixed_(mat::Zero(data.size(), data.size())),
    memory_(0),
    shrinkage_(1)
{
    for (const segment& s : data.segments)
    {
        addNoise(s);
    }
    parts_.push_back({"sensors", fixed_.diagonal()});
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

statistics::mat statistics::covariance::addSpread
(
    const std::string& source,
    const mat& deviations,
    const double ofRecording,
    const double ofSimulation
)
{
    const int n = deviations.cols();
    if (n < 2 || deviations.squaredNorm() <= 0)
    {
        return mat::Zero(data_.size(), data_.size());
    }
    const vec scale = variance(deviations).cwiseSqrt().cwiseMax(tiny);
    const mat z = scale.cwiseInverse().asDiagonal()*deviations;
    memory_ = likelyMemory(z);

    const mat target = correlation(memory_);
    const mat sample = z*z.transpose()/double(n);

    // Sampling variance of each entry, and its distance from the target
    const mat squares = z.cwiseAbs2();
    const mat fourth = squares*squares.transpose()/double(n);
    const double noise =
        (fourth - sample.cwiseAbs2()).sum()/std::max(double(n - 1), 1.0);
    const double distance = (sample - target).squaredNorm();
    shrinkage_ = distance > 0 ? std::min(std::max(noise/distance, 0.0), 1.0) : 1;

    const mat one =
        scale.asDiagonal()
       *(shrinkage_*target + (1 - shrinkage_)*sample)*scale.asDiagonal();
    add(source, ofRecording*one.cwiseProduct(ofRecordings()) + ofSimulation*one);
    return one;
}


void statistics::covariance::addRepeats
(
    const mat& runs,
    const int averaged
)
{
    const int n = runs.cols();
    if (n < 2)
    {
        return;
    }
    const double single = double(n)/(n - 1);
    addSpread("replicates", deviations(runs), single, single/averaged);
}


statistics::vec statistics::covariance::between(const mat& runs) const
{
    return variance(deviations(runs))*runs.cols()/(runs.cols() - 1);
}


void statistics::covariance::addDifference
(
    const std::string& source,
    const vec& difference,
    const vec& chance
)
{
    mat column(difference);
    if (chance.size())
    {
        const vec size = variance(column).cwiseMax(tiny);
        const vec share = 1 - (chance.cwiseQuotient(size)).array().min(1);
        column.array() *= share.array();
    }
    if (column.squaredNorm() <= 0)
    {
        return;
    }

    // With other parameters the error has another shape of like size. Of first
    // order, it is twice what halving a cell changes
    const vec scale = 2*variance(column).cwiseSqrt().cwiseMax(tiny);
    const mat z = scale.cwiseInverse().asDiagonal()*column;
    add
    (
        source,
        mat(column*column.transpose())
      + scale.asDiagonal()*correlation(likelyMemory(z))*scale.asDiagonal()
    );
}


void statistics::covariance::addResolution
(
    const std::string& source,
    const mat& changes,
    const mat& repeats,
    const bool byChance
)
{
    const int n = changes.cols();
    const vec chance =
        !byChance ? vec() : n < 3 ? vec(2*between(repeats)/n) : vec(between(changes)/n);
    addDifference(source, changes.rowwise().mean(), chance);
}


void statistics::covariance::addDirections
(
    const std::string& source,
    const mat& changes
)
{
    if (changes.cols())
    {
        add(source, changes*changes.transpose());
    }
}


statistics::mat statistics::covariance::clockShifts(const vec& f) const
{
    const vec slope = timeSlope(data_, f);
    std::vector<std::string> experiments;
    mat shifts(f.size(), 0);
    for (const segment& s : data_.segments)
    {
        const auto known =
            std::find(experiments.begin(), experiments.end(), s.experiment);
        const auto column = known - experiments.begin();
        if (known == experiments.end())
        {
            experiments.push_back(s.experiment);
            appendColumn(shifts, vec::Zero(f.size()));
        }
        shifts.col(column).segment(s.first, s.size) = clockUncertainty_*s.of(slope);
    }
    return shifts;
}


statistics::mat statistics::covariance::at(const vec& f) const
{
    mat all = fixed_ + ofGains(f);
    if (clockUncertainty_ > 0)
    {
        const mat shifts = clockShifts(f);
        all += shifts*shifts.transpose();
    }
    return all;
}


std::vector<statistics::uncertaintySource>
statistics::covariance::sources(const vec& f) const
{
    std::vector<uncertaintySource> all(parts_);
    all[0].second += ofGains(f).diagonal();
    if (clockUncertainty_ > 0)
    {
        all.push_back({"clock", clockShifts(f).rowwise().squaredNorm()});
    }
    for (uncertaintySource& s : all)
    {
        s.second = s.second.cwiseSqrt().eval();
    }
    return all;
}
