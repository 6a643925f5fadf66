// SPDX-License-Identifier: GPL-3.0-or-later
// Possible explanations of a misfit, fitted and scored in one way: the samples
// under a hypothesis.

#include "hypothesis.H"

#include <algorithm>

bool statistics::hypothesis::contains(const hypothesis& other) const
{
    for (const int m : other.mechanisms)
    {
        if (!statistics::contains(mechanisms, m))
        {
            return false;
        }
    }
    return true;
}


bool statistics::hypothesis::extends(const hypothesis& other) const
{
    return
        contains(other)
     && (!other.fault || other.fault == fault)
     && (unknown || !other.unknown)
     && size() > other.size();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void statistics::hypothesisModel::switchOn(const std::vector<int>& mechanisms)
{
    const int n = count(mechanisms);
    combination_ = mat::Zero(bounds_.nStrengths(), n);
    lower_ = upper_ = deviation_ = vec::Zero(n);
    for (int i = 0; i < n; ++i)
    {
        const int k = bounds_.nParameters + mechanisms[i];
        combination_(mechanisms[i], i) = 1;
        lower_[i] = bounds_.lower[k];
        upper_[i] = bounds_.upper[k];
    }
    start_ = 0.3*upper_;
}


void statistics::hypothesisModel::free()
{
    const vec size = bounds_.deviation.tail(combination_.rows());
    deviation_ = start_ = vec::Zero(combination_.cols());
    for (int k = 0; k < combination_.cols(); ++k)
    {
        const double largest =
            combination_.col(k).cwiseQuotient(size).cwiseAbs().maxCoeff();
        deviation_[k] = 1/std::max(largest, tiny);
    }
    lower_ = -4*deviation_;
    upper_ = 4*deviation_;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

statistics::hypothesisModel::hypothesisModel
(
    const stacked& data,
    const responseSurface& surface,
    const variableBounds& bounds,
    const hypothesis& h
)
:
    data_(data),
    surface_(surface),
    bounds_(bounds),
    combination_(h.combination),
    fault_(h.fault)
{
    if (h.combination.cols())
    {
        free();
    }
    else
    {
        switchOn(h.mechanisms);
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

statistics::vec statistics::hypothesisModel::join
(
    const vec& all,
    const vec& ofCoefficients,
    const vec& ofFault
) const
{
    const int nP = bounds_.nParameters;
    vec x(nP + ofCoefficients.size() + ofFault.size());
    x << all.head(nP), ofCoefficients, ofFault;
    return x;
}


statistics::vec statistics::hypothesisModel::expand(const vec& x) const
{
    const int nP = bounds_.nParameters;
    vec all(bounds_.mean.size());
    all << x.head(nP), combination_*x.segment(nP, combination_.cols());
    return all;
}


statistics::vec statistics::hypothesisModel::ofFault(const vec& x) const
{
    return x.tail(fault_ ? fault_->size() : 0);
}


statistics::vec
statistics::hypothesisModel::reading(const vec& f, const vec& ofFault) const
{
    const vec all = (*fault_)(data_, f, ofFault);
    const vec uncounted = fault_->uncomputed(data_, ofFault);
    return uncounted.isZero(0) ? all : all + uncounted.cwiseProduct(data_.y - all);
}


double statistics::hypothesisModel::cost(const vec& x) const
{
    return fault_ ? fault_->uncomputed(data_, ofFault(x)).sum() : 0;
}


statistics::vec statistics::hypothesisModel::costSlopes(const vec& x) const
{
    vec slopes = vec::Zero(x.size());
    const int unknowns = fault_ ? fault_->size() : 0;
    for (int i = x.size() - unknowns; i < x.size(); ++i)
    {
        vec beside = x;
        const double step = 1e-5*(upper()[i] - lower()[i]);
        beside[i] += step;
        slopes[i] = (cost(beside) - cost(x))/step;
    }
    return slopes;
}


statistics::vec statistics::hypothesisModel::operator()(const vec& x) const
{
    const vec f = surface_(expand(x));
    return fault_ ? reading(f, ofFault(x)) : f;
}


statistics::mat statistics::hypothesisModel::slopes(const vec& x) const
{
    const vec all = expand(x);
    const mat ofAll = surface_.slopes(all);
    const int n = bounds_.nParameters + combination_.cols();

    mat s(ofAll.rows(), x.size());
    s.leftCols(n) <<
        ofAll.leftCols(bounds_.nParameters),
        ofAll.rightCols(combination_.rows())*combination_;
    if (!fault_)
    {
        return s;
    }

    // A small step: what a fault shows is linear in what it should show, but for
    // a saturated one
    constexpr double part = 1e-4;
    const vec f = surface_(all);
    const vec u = ofFault(x);
    const vec here = reading(f, u);
    for (int i = 0; i < n; ++i)
    {
        s.col(i) =
            (reading(f + part*vec(s.col(i)), u) - here)/part;
    }
    const vec range = fault_->upper - fault_->lower;
    for (int i = 0; i < u.size(); ++i)
    {
        vec beside = u;
        const double step =
            (u[i] + 1e-5*range[i] > fault_->upper[i] ? -1e-5 : 1e-5)*range[i];
        beside[i] += step;
        s.col(n + i) = (reading(f, beside) - here)/step;
    }
    return s;
}


statistics::vec statistics::hypothesisModel::lower() const
{
    return join(bounds_.lower, lower_, fault_ ? fault_->lower : vec());
}


statistics::vec statistics::hypothesisModel::upper() const
{
    return join(bounds_.upper, upper_, fault_ ? fault_->upper : vec());
}


statistics::vec statistics::hypothesisModel::mean() const
{
    return
        join
        (
            bounds_.mean,
            vec::Zero(start_.size()),
            vec::Zero(fault_ ? fault_->size() : 0)
        );
}


statistics::vec statistics::hypothesisModel::deviation() const
{
    return
        join
        (
            bounds_.deviation,
            deviation_,
            vec::Zero(fault_ ? fault_->size() : 0)
        );
}


std::vector<statistics::vec> statistics::hypothesisModel::starts() const
{
    std::vector<vec> all;
    for (const vec& u : fault_ ? fault_->starts : std::vector<vec>(1))
    {
        // Samples are quadratic in a strength, their misfit may have two minima: from
        // low strengths, and from the largest. In the 40 quick cases of
        // validation/misfit/concealed 1,155 of some 18,600 fits end lower by it, by 339
        // at most
        all.push_back(join(bounds_.mean, start_, u));
        if (start_.any())
        {
            all.push_back(join(bounds_.mean, upper_, u));
        }
    }
    return all;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void statistics::sortByScore(std::vector<hypothesisFit>& list)
{
    std::stable_sort
    (
        list.begin(),
        list.end(),
        [](const hypothesisFit& a, const hypothesisFit& b) { return a.score < b.score; }
    );
}
