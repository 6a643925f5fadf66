// SPDX-License-Identifier: GPL-3.0-or-later
// Free parameters chosen so that response surfaces meet their targets.

#include "calibration.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

statistics::vec statistics::calibration::all(const vec& x) const
{
    vec result = fixed_;
    result(open_) = x;
    return result;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

statistics::calibration::calibration
(
    const std::vector<freeParameter>& parameters,
    const std::vector<calibrationTarget>& targets
)
:
    parameters_(parameters),
    targets_(targets),
    fixed_(vec::Zero(parameters.size())),
    lower_(fixed_),
    upper_(fixed_)
{
    for (int i = 0; i < count(parameters); ++i)
    {
        lower_[i] = parameters[i].lower;
        upper_[i] = parameters[i].upper;
        if (parameters[i].levels.empty())
        {
            open_.push_back(i);
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

std::vector<statistics::vec> statistics::calibration::combinations() const
{
    std::vector<vec> result(1, fixed_);
    for (int i = 0; i < count(parameters_); ++i)
    {
        std::vector<vec> next;
        for (const vec& one : result)
        {
            for (const double level : parameters_[i].levels)
            {
                next.push_back(one);
                next.back()[i] = level;
            }
        }
        if (next.size())
        {
            result = next;
        }
    }
    return result;
}


statistics::vec
statistics::calibration::below(const vec calibrationTarget::* part) const
{
    vec result;
    for (const calibrationTarget& target : targets_)
    {
        const vec before = result;
        result.resize(before.size() + (target.*part).size());
        result << before, target.*part;
    }
    return result;
}


statistics::vec statistics::calibration::predicted
(
    const responseSurface& surface,
    const vec& conditions,
    const vec& parameters
)
{
    vec variables(conditions.size() + parameters.size());
    variables << conditions, parameters;
    return surface(variables);
}


statistics::vec statistics::calibration::operator()(const vec& x) const
{
    vec result = targetValues();
    int first = 0;
    for (const calibrationTarget& target : targets_)
    {
        const int n = target.values.size();
        result.segment(first, n) =
            predicted(*target.surface, target.conditions, all(x));
        first += n;
    }
    return result;
}


statistics::mat statistics::calibration::slopes(const vec& x) const
{
    mat result(targetValues().size(), open_.size());
    int first = 0;
    for (const calibrationTarget& target : targets_)
    {
        const int n = target.values.size();
        const int nConditions = target.conditions.size();
        vec variables(nConditions + parameters_.size());
        variables << target.conditions, all(x);
        const mat slopes = target.surface->slopes(variables);
        result.middleRows(first, n) =
            slopes.rightCols(parameters_.size())(Eigen::all, open_);
        first += n;
    }
    return result;
}


statistics::vec statistics::calibration::targetValues() const
{
    return below(&calibrationTarget::values);
}


statistics::vec statistics::calibration::lower() const
{
    return lower_(open_);
}


statistics::vec statistics::calibration::upper() const
{
    return upper_(open_);
}


statistics::vec statistics::calibration::mean() const
{
    return (lower() + upper())/2;
}


statistics::vec statistics::calibration::deviation() const
{
    return vec::Zero(open_.size());
}


std::vector<statistics::vec> statistics::calibration::starts() const
{
    std::vector<vec> result;
    result.push_back(mean());
    for (int corner = 0; corner < (1 << open_.size()); ++corner)
    {
        vec x = lower();
        for (int i = 0; i < count(open_); ++i)
        {
            x[i] = corner & (1 << i) ? upper()[i] : x[i];
        }
        result.push_back(x);
    }
    return result;
}


statistics::fitResult statistics::calibration::choose
(
    vec& all,
    vec& deviations
)
{
    const vec deviation = below(&calibrationTarget::deviation);
    const whitener white(mat(deviation.cwiseAbs2().asDiagonal()));
    fitResult best;
    best.objective = large;

    for (const vec& levels : combinations())
    {
        setLevels(levels);
        const fitResult one(fit(*this, targetValues(), white));
        if (one.objective < best.objective)
        {
            best = one;
            all = this->all(one.x);
        }
    }

    setLevels(all);
    deviations = vec::Zero(all.size());
    for (int i = 0; i < count(open_); ++i)
    {
        deviations[open_[i]] = best.deviation(i);
    }
    return best;
}


std::shared_ptr<const statistics::responseSurface> statistics::surfaceOf
(
    const mat& variables,
    const mat& quantities,
    const std::vector<freeParameter>& parameters,
    const std::vector<bool>& mixed
)
{
    mat x = variables;
    const int nConditions = x.rows() - count(parameters);
    vec centre(x.rows());
    vec width(x.rows());
    for (int k = 0; k < nConditions; ++k)
    {
        const vec row = x.row(k).transpose();
        centre[k] = (row.maxCoeff() + row.minCoeff())/2;
        width[k] = std::max((row.maxCoeff() - row.minCoeff())/2, small);
    }
    for (int i = 0; i < count(parameters); ++i)
    {
        const freeParameter& p = parameters[i];
        const int k = nConditions + i;
        for (int run = 0; run < x.cols(); ++run)
        {
            x(k, run) = p.scaled(x(k, run));
        }
        centre[k] = (p.lower + p.upper)/2;
        width[k] = (p.upper - p.lower)/2;
    }
    return
        std::make_shared<const responseSurface>(x, quantities, centre, width, mixed);
}
