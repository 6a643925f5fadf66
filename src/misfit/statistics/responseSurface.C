// SPDX-License-Identifier: GPL-3.0-or-later
// The observations as a quadratic function of parameters and strengths.

#include "responseSurface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double statistics::responseSurface::value
(
    const std::pair<int, int>& term,
    const vec& z
) const
{
    return
        (term.first < 0 ? 1 : z[term.first])
       *(term.second < 0 ? 1 : z[term.second]);
}


statistics::mat statistics::responseSurface::design(const mat& z) const
{
    mat d(z.cols(), terms_.size());
    for (int run = 0; run < z.cols(); ++run)
    {
        for (int t = 0; t < count(terms_); ++t)
        {
            d(run, t) = value(terms_[t], z.col(run));
        }
    }
    return d;
}


void statistics::responseSurface::choose
(
    const mat& z,
    const std::vector<bool>& mayMix,
    const bool linear
)
{
    terms_.clear();
    const int n = z.rows();
    std::vector<std::pair<int, int>> possible;
    possible.push_back({-1, -1});
    for (int i = 0; i < n; ++i)
    {
        possible.push_back({i, -1});
    }
    for (int i = 0; i < n && !linear; ++i)
    {
        possible.push_back({i, i});
    }
    const int pure = possible.size();
    for (int i = 0; i < n && !linear; ++i)
    {
        for (int j = i + 1; j < n; ++j)
        {
            if (mayMix.empty() || (mayMix[i] && mayMix[j]))
            {
                possible.push_back({i, j});
            }
        }
    }

    // Columns so far, made orthogonal
    mat basis(z.cols(), 0);
    for (int k = 0; k < count(possible); ++k)
    {
        const double share = k < pure ? 1 : 0.6;
        if (terms_.size() >= share*z.cols())
        {
            break;
        }
        vec column(z.cols());
        for (int run = 0; run < z.cols(); ++run)
        {
            column[run] = value(possible[k], z.col(run));
        }
        const double before = column.norm();
        for (int pass = 0; pass < 2; ++pass)
        {
            column -= basis*(basis.transpose()*column);
        }
        if (column.norm() > 1e-3*std::max(before, small))
        {
            appendColumn(basis, column.normalized());
            terms_.push_back(possible[k]);
        }
    }
}


statistics::mat statistics::responseSurface::fit(const mat& design, const mat& samples)
{
    const Eigen::HouseholderQR<mat> qr(design);
    coefficients_ = qr.solve(samples.transpose());
    const mat q = qr.householderQ()*mat::Identity(design.rows(), design.cols());
    leverage_ = q.rowwise().squaredNorm();
    const int n = design.cols();
    spread_ = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>()
        .solve(mat::Identity(n, n));
    const vec rest = (1 - leverage_.array()).max(small);
    const mat errors = samples - coefficients_.transpose()*design.transpose();
    return errors.array().rowwise()/rest.transpose().array();
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

statistics::responseSurface::responseSurface
(
    const mat& variables,
    const mat& samples,
    const vec& centre,
    const vec& width,
    const std::vector<bool>& mayMix,
    const vec& chance
)
:
    centre_(centre),
    width_(width),
    shift_(vec::Zero(samples.rows())),
    tilt_(mat::Zero(samples.rows(), centre.size()))
{
    const mat z =
        width.cwiseInverse().asDiagonal()*(variables.colwise() - centre);
    choose(z, mayMix, false);
    mat errors = fit(design(z), samples);
    if (chance.size())
    {
        const vec weight = chance.cwiseMax(tiny).cwiseInverse();
        const auto square = [&]()
        {
            return weight.dot(vec(errors.rowwise().squaredNorm()));
        };
        const double all = square();
        choose(z, mayMix, true);
        errors = fit(design(z), samples);
        if (all < square())
        {
            choose(z, mayMix, false);
            errors = fit(design(z), samples);
        }
    }

    leftOut_.resize(samples.rows(), 0);
    for (int run = 0; z.cols() > nTerms() && run < z.cols(); ++run)
    {
        if (leverage_[run] < fixesTerm)
        {
            appendColumn(leftOut_, errors.col(run));
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

statistics::vec
statistics::responseSurface::operator()(const vec& x) const
{
    const vec z = (x - centre_).cwiseQuotient(width_);
    vec f = coefficients_.transpose()*design(z).transpose() + shift_;
    if (at_.size())
    {
        f += tilt_*(z - at_);
    }
    return f;
}


statistics::mat statistics::responseSurface::slopes(const vec& x) const
{
    const vec z = (x - centre_).cwiseQuotient(width_);
    mat inTerms = mat::Zero(terms_.size(), z.size());
    for (int t = 0; t < count(terms_); ++t)
    {
        const int a = terms_[t].first;
        const int b = terms_[t].second;
        if (a >= 0)
        {
            inTerms(t, a) += (b < 0 ? 1 : z[b])/width_[a];
        }
        if (b >= 0)
        {
            inTerms(t, b) += z[a]/width_[b];
        }
    }
    return
        coefficients_.transpose()*inTerms
      + tilt_*mat(width_.cwiseInverse().asDiagonal());
}


double statistics::responseSurface::chanceShared(const vec& at, const vec& other) const
{
    mat z(centre_.size(), 2);
    z << (at - centre_).cwiseQuotient(width_), (other - centre_).cwiseQuotient(width_);
    const mat chance = design(z)*spread_;
    return chance.row(0).dot(chance.row(0) - chance.row(1));
}


void statistics::responseSurface::passThrough
(
    const vec& x,
    const vec& samples
)
{
    const vec z = (x - centre_).cwiseQuotient(width_);
    const vec error = samples - (*this)(x);
    if (at_.size() && (z - at_).squaredNorm() > small)
    {
        const vec step = z - at_;
        tilt_ += error*step.transpose()/step.squaredNorm();
    }
    at_ = z;
    shift_ += samples - (*this)(x);
}
