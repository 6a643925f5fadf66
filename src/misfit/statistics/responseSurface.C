// SPDX-License-Identifier: GPL-3.0-or-later
// The observations as a quadratic function of parameters and strengths.

#include "responseSurface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::misfit::responseSurface::value
(
    const std::pair<label, label>& term,
    const vec& z
) const
{
    return
        (term.first < 0 ? 1 : z[term.first])
       *(term.second < 0 ? 1 : z[term.second]);
}


Foam::misfit::mat Foam::misfit::responseSurface::design(const mat& z) const
{
    mat d(z.cols(), terms_.size());
    for (label run = 0; run < z.cols(); ++run)
    {
        for (label t = 0; t < terms_.size(); ++t)
        {
            d(run, t) = value(terms_[t], z.col(run));
        }
    }
    return d;
}


void Foam::misfit::responseSurface::choose(const mat& z)
{
    const label n = z.rows();
    List<std::pair<label, label>> possible;
    possible.append({-1, -1});
    for (label i = 0; i < n; ++i)
    {
        possible.append({i, -1});
    }
    for (label i = 0; i < n; ++i)
    {
        possible.append({i, i});
    }
    const label pure = possible.size();
    for (label i = 0; i < n; ++i)
    {
        for (label j = i + 1; j < n; ++j)
        {
            possible.append({i, j});
        }
    }

    // Columns so far, made orthogonal
    mat basis(z.cols(), 0);
    forAll(possible, k)
    {
        const scalar share = k < pure ? 1 : 0.6;
        if (terms_.size() >= share*z.cols())
        {
            break;
        }
        vec column(z.cols());
        for (label run = 0; run < z.cols(); ++run)
        {
            column[run] = value(possible[k], z.col(run));
        }
        const scalar before = column.norm();
        for (label pass = 0; pass < 2; ++pass)
        {
            column -= basis*(basis.transpose()*column);
        }
        if (column.norm() > 1e-3*max(before, SMALL))
        {
            basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
            basis.col(basis.cols() - 1) = column.normalized();
            terms_.append(possible[k]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::responseSurface::responseSurface
(
    const mat& variables,
    const mat& samples,
    const vec& centre,
    const vec& width
)
:
    centre_(centre),
    width_(width),
    shift_(vec::Zero(samples.rows())),
    tilt_(mat::Zero(samples.rows(), centre.size()))
{
    const mat z =
        width.cwiseInverse().asDiagonal()*(variables.colwise() - centre);
    choose(z);

    const mat d = design(z);
    const Eigen::HouseholderQR<mat> qr(d);
    coefficients_ = qr.solve(samples.transpose());

    if (d.rows() > d.cols())
    {
        const mat q =
            qr.householderQ()*mat::Identity(d.rows(), d.cols());
        const vec leverage = q.rowwise().squaredNorm();
        const mat errors = samples - coefficients_.transpose()*d.transpose();

        // A run that alone fixes a term says nothing about the error
        leftOut_.resize(samples.rows(), 0);
        for (label run = 0; run < d.rows(); ++run)
        {
            if (leverage[run] < 0.95)
            {
                leftOut_.conservativeResize
                (
                    Eigen::NoChange, leftOut_.cols() + 1
                );
                leftOut_.col(leftOut_.cols() - 1) =
                    errors.col(run)/(1 - leverage[run]);
            }
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::vec
Foam::misfit::responseSurface::operator()(const vec& x) const
{
    const vec z = (x - centre_).cwiseQuotient(width_);
    vec f = coefficients_.transpose()*design(z).transpose() + shift_;
    if (at_.size())
    {
        f += tilt_*(z - at_);
    }
    return f;
}


Foam::misfit::mat Foam::misfit::responseSurface::slopes(const vec& x) const
{
    const vec z = (x - centre_).cwiseQuotient(width_);
    mat inTerms = mat::Zero(terms_.size(), z.size());
    forAll(terms_, t)
    {
        const label a = terms_[t].first;
        const label b = terms_[t].second;
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


void Foam::misfit::responseSurface::passThrough
(
    const vec& x,
    const vec& samples
)
{
    const vec z = (x - centre_).cwiseQuotient(width_);
    const vec error = samples - (*this)(x);
    if (at_.size() && (z - at_).squaredNorm() > SMALL)
    {
        const vec step = z - at_;
        tilt_ += error*step.transpose()/step.squaredNorm();
    }
    at_ = z;
    shift_ += samples - (*this)(x);
}
