// SPDX-License-Identifier: GPL-3.0-or-later
// A misfit of unknown shape, learnt from some channels and expected at others.

#include "gaussianProcess.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::misfit::gaussianProcess::duration() const
{
    scalar longest = SMALL;
    for (const segment& s : data_.segments)
    {
        longest = max(longest, s.duration());
    }
    return longest;
}


Foam::scalar Foam::misfit::gaussianProcess::extent() const
{
    scalar longest = SMALL;
    for (const segment& a : data_.segments)
    {
        for (const segment& b : data_.segments)
        {
            if (a.hasPlace && b.hasPlace)
            {
                longest = max(longest, mag(a.place - b.place));
            }
        }
    }
    return longest;
}


Foam::misfit::mat
Foam::misfit::gaussianProcess::kernel(const stacked& other) const
{
    mat k = mat::Zero(other.size(), data_.size());
    for (const segment& a : other.segments)
    {
        forAll(data_.segments, n)
        {
            const segment& b = data_.segments[n];
            if (a.quantity != b.quantity || a.overTime != b.overTime)
            {
                continue;
            }
            const scalar away =
                a.hasPlace && b.hasPlace ? mag(a.place - b.place)/length_
              : a.name == b.name ? 0 : GREAT;
            const scalar top =
                sqr(size_*range_[n])*std::exp(-min(0.5*away*away, 700.0));
            for (label i = 0; i < a.size; ++i)
            {
                for (label j = 0; j < b.size; ++j)
                {
                    const scalar d = (a.x[i] - b.x[j])/time_;
                    k(a.first + i, b.first + j) =
                        top*std::exp(-min(0.5*d*d, 700.0));
                }
            }
        }
    }
    return k;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::gaussianProcess::gaussianProcess
(
    const stacked& data,
    const vec& misfit,
    const mat& noise
)
:
    data_(data),
    range_(vec::Zero(data.segments.size())),
    size_(0),
    time_(1),
    length_(1)
{
    forAll(data.segments, i)
    {
        for (const segment& s : data.segments)
        {
            if (s.quantity == data.segments[i].quantity)
            {
                const vec y = s.of(data.y);
                range_[i] = max(range_[i], y.maxCoeff() - y.minCoeff());
            }
        }
    }

    scalar least = GREAT;
    scalar best[] = {0, 1, 1};
    for (const scalar t : {0.02, 0.05, 0.1, 0.2, 0.4})
    {
        for (const scalar x : {0.03, 0.2, 0.5, 1.5})
        {
            for (scalar s = 0.005; s < 0.7; s *= 2)
            {
                size_ = s;
                time_ = t*duration();
                length_ = x*extent();
                const whitener white(noise + kernel(data));
                const scalar minusTwoLogLikelihood =
                    white.logDeterminant() + white(misfit).squaredNorm();
                if (minusTwoLogLikelihood < least)
                {
                    least = minusTwoLogLikelihood;
                    best[0] = size_;
                    best[1] = time_;
                    best[2] = length_;
                }
            }
        }
    }
    size_ = best[0];
    time_ = best[1];
    length_ = best[2];
    weights_ = mat(noise + kernel(data)).ldlt().solve(misfit);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::vec
Foam::misfit::gaussianProcess::operator()(const stacked& other) const
{
    return kernel(other)*weights_;
}
