// SPDX-License-Identifier: GPL-3.0-or-later
// Looks for where and when recording and simulation part.

#include "scan.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::scan::makeWindows()
{
    forAll(data_.segments, i)
    {
        const label n = data_.segments[i].size;
        label last = 0;
        for (const scalar length : {2., 3., 4., 6., 8., 12., 16., 24., 32., GREAT})
        {
            const label l = min(scalar(n), length);
            if (l == last)
            {
                break;
            }
            last = l;
            const label step = max(l/4, 1);
            for (label begin = 0; begin + l <= n; begin += step)
            {
                places_.append({i, begin, begin + l, 0});
            }
        }
    }

    mat plain = mat::Zero(data_.size(), places_.size());
    forAll(places_, k)
    {
        const window& w = places_[k];
        plain.col(k).segment
        (
            data_.segments[w.segment].first + w.begin,
            w.end - w.begin
        ).setOnes();
    }
    templates_ = white_(plain).colwise().normalized();
}


void Foam::misfit::scan::addShapes(const mat& shapes)
{
    for (label i = 0; i < shapes.cols(); ++i)
    {
        const vec w = white_(vec(shapes.col(i)));
        if (w.norm() > VSMALL)
        {
            appendColumn(templates_, w.normalized());
        }
    }
}


void Foam::misfit::scan::draw(const label n, const label seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<scalar> normal;
    strongest_.setSize(n);
    sums_.setSize(n);
    for (label k = 0; k < n; ++k)
    {
        vec u(data_.size());
        for (scalar& v : u)
        {
            v = normal(generator);
        }
        strongest_[k] = (templates_.transpose()*u).cwiseAbs().maxCoeff();
        sums_[k] = u.squaredNorm();
    }

    const List<scalar> s(strongest_);
    const List<scalar> q(sums_);
    std::sort(strongest_.begin(), strongest_.end());
    std::sort(sums_.begin(), sums_.end());
    lower_.setSize(n);
    for (label k = 0; k < n; ++k)
    {
        lower_[k] = min(chance(strongest_, s[k]), chance(sums_, q[k]));
    }
    std::sort(lower_.begin(), lower_.end());
}


Foam::scalar
Foam::misfit::scan::chance(const List<scalar>& sorted, const scalar value)
{
    const auto reach =
        sorted.cend() - std::lower_bound(sorted.cbegin(), sorted.cend(), value);
    return (reach + 1.0)/(sorted.size() + 1.0);
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::scan::scan
(
    const stacked& data,
    const whitener& white,
    const label draws,
    const label seed,
    const mat& shapes
)
:
    data_(data),
    white_(white)
{
    makeWindows();
    addShapes(shapes);
    draw(draws, seed);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::scanned
Foam::misfit::scan::operator()(const vec& misfit, const scalar level) const
{
    vec u = white_(misfit);
    scanned found;
    found.sum = u.squaredNorm();
    found.pSum = chance(sums_, found.sum);
    found.pWindow = chance
    (
        strongest_, vec(templates_.transpose()*u).cwiseAbs().maxCoeff()
    );

    while (found.windows.size() < 20)
    {
        const vec z = templates_.leftCols(places_.size()).transpose()*u;
        label best = 0;
        const scalar size = z.cwiseAbs().maxCoeff(&best);
        const scalar p = chance(strongest_, size);
        if (found.windows.size() && p > level)
        {
            break;
        }
        found.windows.append(places_[best]);
        found.windows.last().size = z[best];
        u -= z[best]*templates_.col(best);
        if (p > level)
        {
            break;
        }
    }

    const scalar lower = min(found.pWindow, found.pSum);
    const auto reach =
        std::upper_bound(lower_.cbegin(), lower_.cend(), lower)
      - lower_.cbegin();
    found.p = (reach + 1.0)/(lower_.size() + 1.0);
    return found;
}


Foam::misfit::mat Foam::misfit::withFitted
(
    const mat& covariance,
    const mat& directions,
    const vec& deviations
)
{
    // Nothing is known along a direction: a thousand of its own deviations. More
    // would drown those of the samples in rounding.
    const whitener white(covariance);
    mat all = covariance;
    for (label i = 0; i < directions.cols(); ++i)
    {
        const vec d = directions.col(i);
        const scalar size = white(d).norm();
        if (size > 0)
        {
            const scalar deviation =
                deviations[i] > 0 ? deviations[i] : 1000/size;
            all += sqr(deviation)*d*d.transpose();
        }
    }
    return all;
}
