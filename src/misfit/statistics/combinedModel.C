// SPDX-License-Identifier: GPL-3.0-or-later
// The samples where the strengths of a surface are combinations of fewer numbers.

#include "combinedModel.H"

Foam::misfit::combinedModel::combinedModel
(
    const responseSurface& surface,
    const variableBounds& bounds,
    const mat& combination
)
:
    surface_(surface),
    bounds_(bounds),
    combination_(combination),
    size_(vec::Zero(combination.cols()))
{
    const vec size = bounds.deviation.tail(combination.rows());
    for (label k = 0; k < combination.cols(); ++k)
    {
        const scalar largest =
            combination.col(k).cwiseQuotient(size).cwiseAbs().maxCoeff();
        size_[k] = 1/max(largest, VSMALL);
    }
}


Foam::misfit::vec Foam::misfit::combinedModel::append
(
    const vec& all,
    const vec& ofCoefficients
) const
{
    vec x(bounds_.nParameters + ofCoefficients.size());
    x.head(bounds_.nParameters) = all.head(bounds_.nParameters);
    x.tail(ofCoefficients.size()) = ofCoefficients;
    return x;
}


Foam::misfit::vec Foam::misfit::combinedModel::expand(const vec& x) const
{
    return append(x, combination_*x.tail(combination_.cols()));
}


Foam::misfit::vec
Foam::misfit::combinedModel::operator()(const vec& x) const
{
    return surface_(expand(x));
}


Foam::misfit::mat Foam::misfit::combinedModel::slopes(const vec& x) const
{
    const mat all = surface_.slopes(expand(x));
    mat s(all.rows(), x.size());
    s.leftCols(bounds_.nParameters) = all.leftCols(bounds_.nParameters);
    s.rightCols(combination_.cols()) =
        all.rightCols(combination_.rows())*combination_;
    return s;
}


Foam::misfit::vec Foam::misfit::combinedModel::lower() const
{
    return append(bounds_.lower, -4*size_);
}


Foam::misfit::vec Foam::misfit::combinedModel::upper() const
{
    return append(bounds_.upper, 4*size_);
}


Foam::misfit::vec Foam::misfit::combinedModel::mean() const
{
    return append(bounds_.mean, vec::Zero(size_.size()));
}


Foam::misfit::vec Foam::misfit::combinedModel::deviation() const
{
    return append(bounds_.deviation, size_);
}
