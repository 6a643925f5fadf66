// SPDX-License-Identifier: GPL-3.0-or-later
// A misfit of unknown shape, learnt from some channels and expected at others.

#include "gaussianProcess.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double statistics::gaussianProcess::duration() const
{
    double longest = small;
    for (const segment& s : data_.segments)
    {
        longest = std::max(longest, s.duration());
    }
    return longest;
}


double statistics::gaussianProcess::extent() const
{
    double longest = small;
    for (const segment& a : data_.segments)
    {
        for (const segment& b : data_.segments)
        {
            if (a.hasPlace && b.hasPlace)
            {
                longest = std::max(longest, (a.place - b.place).norm());
            }
        }
    }
    return longest;
}


statistics::mat
statistics::gaussianProcess::kernel(const stacked& other) const
{
    mat k = mat::Zero(other.size(), data_.size());
    for (const segment& a : other.segments)
    {
        for (int n = 0; n < count(data_.segments); ++n)
        {
            const segment& b = data_.segments[n];
            if (a.quantity != b.quantity || a.overTime != b.overTime)
            {
                continue;
            }
            const double away =
                a.hasPlace && b.hasPlace ? (a.place - b.place).norm()/length_
              : a.name == b.name ? 0 : large;
            const double top =
                sqr(size_*range_[n])*std::exp(-std::min(0.5*away*away, 700.0));
            for (int i = 0; i < a.size; ++i)
            {
                for (int j = 0; j < b.size; ++j)
                {
                    const double d = (a.x[i] - b.x[j])/time_;
                    k(a.first + i, b.first + j) =
                        top*std::exp(-std::min(0.5*d*d, 700.0));
                }
            }
        }
    }
    return k;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

statistics::gaussianProcess::gaussianProcess
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
    for (int i = 0; i < count(data.segments); ++i)
    {
        for (const segment& s : data.segments)
        {
            if (s.quantity == data.segments[i].quantity)
            {
                const vec y = s.of(data.y);
                range_[i] = std::max(range_[i], y.maxCoeff() - y.minCoeff());
            }
        }
    }

    double least = large;
    double best[] = {0, 1, 1};
    for (const double t : {0.02, 0.05, 0.1, 0.2, 0.4})
    {
        for (const double x : {0.03, 0.2, 0.5, 1.5})
        {
            for (double s = 0.005; s < 0.7; s *= 2)
            {
                size_ = s;
                time_ = t*duration();
                length_ = x*extent();
                const whitener white(noise + kernel(data));
                const double minusTwoLogLikelihood =
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

statistics::vec
statistics::gaussianProcess::operator()(const stacked& other) const
{
    return kernel(other)*weights_;
}
