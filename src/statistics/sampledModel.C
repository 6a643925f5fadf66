// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded samples, what runs gave for them, and how far both may differ.

#include "sampledModel.H"

namespace
{

using namespace statistics;

mat rowsOf(const mat& m, const std::vector<int>& keep)
{
    mat some(keep.size(), m.cols());
    for (int i = 0; i < count(keep); ++i)
    {
        some.row(i) = m.row(keep[i]);
    }
    return some;
}

} // End anonymous namespace


statistics::sampledModel::sampledModel
(
    const stacked& data,
    const variableBounds& bounds,
    const double clockUncertainty
)
:
    data_(data),
    variables_(bounds.mean.size(), 0),
    samples_(data.size(), 0),
    repeats_(data.size(), 0),
    averaged_(1),
    clockUncertainty_(clockUncertainty),
    bounds_(bounds),
    covariance_(new covariance(data_, clockUncertainty))
{}


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


void statistics::sampledModel::build(const vec& width)
{
    if (!size())
    {
        return;
    }
    surface_.reset
    (
        new responseSurface(variables_, samples_, bounds_.mean, width)
    );
    covariance_.reset(new covariance(data_, clockUncertainty_));
    covariance_->addRepeats(repeats_, averaged_);
    covariance_->addSpread("between the runs", surface_->leftOut(), 1);
    for (const std::pair<std::string, vec>& d : differences_)
    {
        covariance_->addDifference(d.first, d.second);
    }
}


std::unique_ptr<statistics::sampledModel>
statistics::sampledModel::copy() const
{
    auto copy = std::make_unique<sampledModel>(data_, bounds_, clockUncertainty_);
    copy->variables_ = variables_;
    copy->samples_ = samples_;
    copy->repeats_ = repeats_;
    copy->averaged_ = averaged_;
    copy->differences_ = differences_;
    copy->surface_.reset(new responseSurface(*surface_));
    copy->covariance_.reset(new covariance(copy->data_, *covariance_));
    return copy;
}


std::unique_ptr<statistics::sampledModel>
statistics::sampledModel::withVariables(const variableBounds& bounds) const
{
    auto other = std::make_unique<sampledModel>(data_, bounds, clockUncertainty_);
    other->repeats_ = repeats_;
    other->averaged_ = averaged_;
    other->differences_ = differences_;
    return other;
}


std::unique_ptr<statistics::sampledModel>
statistics::sampledModel::without
(
    const int segment,
    const vec& width
) const
{
    std::vector<int> keep;
    const stacked rest(data_.without(segment, keep));
    auto copy = std::make_unique<sampledModel>(rest, bounds_, clockUncertainty_);
    copy->variables_ = variables_;
    copy->samples_ = rowsOf(samples_, keep);
    copy->repeats_ = rowsOf(repeats_, keep);
    copy->averaged_ = averaged_;
    for (const std::pair<std::string, vec>& d : differences_)
    {
        copy->differences_.push_back({d.first, rows(d.second, keep)});
    }
    copy->build(width);
    return copy;
}
