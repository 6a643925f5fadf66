// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded samples, what runs gave for them, and how far both may differ.

#include "sampledModel.H"

statistics::sampledModel::sampledModel
(
    const stacked& data,
    const variableBounds& bounds,
    const double clockUncertainty,
    const double discrepancy,
    const bool chaotic
)
:
    data_(data),
    repeats_(data.size(), 0),
    averaged_(1),
    clockUncertainty_(clockUncertainty),
    discrepancy_(discrepancy),
    chaotic_(chaotic),
    covariance_(data, clockUncertainty)
{
    setVariables(bounds);
}


void statistics::sampledModel::setVariables(const variableBounds& bounds)
{
    bounds_ = bounds;
    variables_.resize(bounds.mean.size(), 0);
    samples_.resize(size(), 0);
    surface_.reset();
}


void statistics::sampledModel::addRun(const vec& variables, const vec& samples)
{
    appendColumn(variables_, variables);
    appendColumn(samples_, samples);
}


void statistics::sampledModel::addRepeats(const mat& runs, const int averaged)
{
    repeats_ = runs;
    averaged_ = averaged;
}


void statistics::sampledModel::build()
{
    if (!size())
    {
        return;
    }
    const bool chaotic = chaotic_ && repeats_.cols() > 1;
    const vec chance = chaotic ? covariance_.between(repeats_) : vec();
    surface_.emplace
    (
        variables_, samples_, bounds_.centre, bounds_.width, std::vector<bool>(), chance
    );
    covariance_ = covariance(data_, clockUncertainty_);
    chaosOfRun_ = mat::Zero(size(), size());
    if (chaotic)
    {
        chaosOfRun_ = covariance_.addSpread
        (
            "chaos", chaos(), 1, surface_->leverage().mean()
        );
    }
    else
    {
        covariance_.addRepeats(repeats_, averaged_);
        covariance_.addSpread("between the runs", surface_->leftOut(), 0, 1);
    }
    for (const std::pair<std::string, mat>& r : resolutions_)
    {
        covariance_.addResolution(r.first, r.second, repeats_, chaotic);
    }
}


statistics::mat statistics::sampledModel::chaos() const
{
    const int n = repeats_.cols();
    mat all = deviations(repeats_);
    all *= std::sqrt(n/(n - 1.0));
    for (int run = 0, k = 0; run < samples_.cols() && surface_->leftOut().cols(); ++run)
    {
        const double leverage = surface_->leverage()[run];
        if (leverage < responseSurface::fixesTerm)
        {
            const double share = std::sqrt(1 - leverage);
            appendColumn(all, share*surface_->leftOut().col(k++));
        }
    }
    return all;
}


statistics::sampledModel
statistics::sampledModel::without(const int segment) const
{
    std::vector<int> keep;
    sampledModel rest(*this);
    rest.data_ = data_.without(segment, keep);
    rest.covariance_ = covariance(rest.data_, clockUncertainty_);
    rest.samples_ = samples_(keep, Eigen::all);
    rest.repeats_ = repeats_(keep, Eigen::all);
    for (std::pair<std::string, mat>& r : rest.resolutions_)
    {
        r.second = r.second(keep, Eigen::all).eval();
    }
    rest.build();
    return rest;
}
