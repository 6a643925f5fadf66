// SPDX-License-Identifier: GPL-3.0-or-later
// Free parameters chosen so that response surfaces meet their targets.

#include "calibration.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::misfit::vec Foam::misfit::calibration::all(const vec& x) const
{
    vec result = fixed_;
    forAll(open_, i)
    {
        result[open_[i]] = x[i];
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::calibration::calibration
(
    const List<freeParameter>& parameters,
    const List<calibrationTarget>& targets
)
:
    parameters_(parameters),
    targets_(targets),
    fixed_(vec::Zero(parameters.size()))
{
    forAll(parameters, i)
    {
        if (parameters[i].levels.empty())
        {
            open_.append(i);
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::misfit::vec> Foam::misfit::calibration::combinations() const
{
    List<vec> result(1, fixed_);
    forAll(parameters_, i)
    {
        DynamicList<vec> next;
        for (const vec& one : result)
        {
            for (const scalar level : parameters_[i].levels)
            {
                next.append(one);
                next.last()[i] = level;
            }
        }
        if (next.size())
        {
            result = next;
        }
    }
    return result;
}


Foam::misfit::vec Foam::misfit::calibration::wanted() const
{
    vec result;
    for (const calibrationTarget& target : targets_)
    {
        const vec before = result;
        result.resize(before.size() + target.wanted.size());
        result << before, target.wanted;
    }
    return result;
}


Foam::misfit::mat Foam::misfit::calibration::covariance() const
{
    vec deviations;
    for (const calibrationTarget& target : targets_)
    {
        const vec before = deviations;
        deviations.resize(before.size() + target.deviation.size());
        deviations << before, target.deviation;
    }
    return deviations.cwiseAbs2().asDiagonal();
}


Foam::misfit::vec Foam::misfit::calibration::predicted
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


Foam::misfit::vec Foam::misfit::calibration::operator()(const vec& x) const
{
    vec result = wanted();
    label first = 0;
    for (const calibrationTarget& target : targets_)
    {
        const label n = target.wanted.size();
        result.segment(first, n) =
            predicted(*target.surface, target.conditions, all(x));
        first += n;
    }
    return result;
}


Foam::misfit::mat Foam::misfit::calibration::slopes(const vec& x) const
{
    mat result(wanted().size(), open_.size());
    label first = 0;
    for (const calibrationTarget& target : targets_)
    {
        const label n = target.wanted.size();
        const label nConditions = target.conditions.size();
        vec variables(nConditions + parameters_.size());
        variables << target.conditions, all(x);
        const mat slopes = target.surface->slopes(variables);
        forAll(open_, i)
        {
            result.col(i).segment(first, n) =
                slopes.col(nConditions + open_[i]);
        }
        first += n;
    }
    return result;
}


Foam::misfit::vec Foam::misfit::calibration::lower() const
{
    vec result(open_.size());
    forAll(open_, i)
    {
        result[i] = parameters_[open_[i]].lower;
    }
    return result;
}


Foam::misfit::vec Foam::misfit::calibration::upper() const
{
    vec result(open_.size());
    forAll(open_, i)
    {
        result[i] = parameters_[open_[i]].upper;
    }
    return result;
}


Foam::List<Foam::misfit::vec> Foam::misfit::calibration::starts() const
{
    DynamicList<vec> result;
    result.append(mean());
    for (label corner = 0; corner < (1 << open_.size()); ++corner)
    {
        vec x = lower();
        forAll(open_, i)
        {
            x[i] = corner & (1 << i) ? upper()[i] : x[i];
        }
        result.append(x);
    }
    return List<vec>(std::move(result));
}


Foam::misfit::fitted Foam::misfit::calibration::choose
(
    vec& all,
    vec& deviations
)
{
    const whitener white(covariance());
    fitted best;
    best.objective = GREAT;

    for (const vec& levels : combinations())
    {
        setLevels(levels);
        const fitted one(fit(*this, wanted(), white));
        if (one.objective < best.objective)
        {
            best = one;
            all = this->all(one.x);
        }
    }

    setLevels(all);
    deviations = vec::Zero(all.size());
    forAll(open_, i)
    {
        deviations[open_[i]] = best.deviation(i);
    }
    return best;
}
