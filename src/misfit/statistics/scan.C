// SPDX-License-Identifier: GPL-3.0-or-later
// Looks for where and when recording and simulation part.

#include "scan.H"

#include <algorithm>

namespace
{

using namespace statistics;

//- Lengths of the windows [samples], each about a third to a half longer than the one
//  before: a difference of any length fills most of one of them. The last is a whole
//  channel
constexpr double windowLengths[] = {2, 3, 4, 6, 8, 12, 16, 24, 32, large};

//- Windows of a length begin every fourth of it, for the same reason
constexpr int startsPerWindow = 4;

//- Windows [-] that a scan lists at most. Each is taken out of the misfit before the next
//  is searched, so a misfit that no window fits could add hundreds
constexpr int mostWindows = 20;

//- Deviation of a fitted direction of which nothing is known, in deviations of the
//  samples along it [-]. More would drown those of the samples in rounding
constexpr double unknownDeviation = 1000;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void statistics::scan::makeWindows()
{
    for (int i = 0; i < count(data_.segments); ++i)
    {
        const int n = data_.segments[i].size;
        int last = 0;
        for (const double length : windowLengths)
        {
            const int l = std::min(double(n), length);
            if (l == last)
            {
                break;
            }
            last = l;
            const int step = std::max(l/startsPerWindow, 1);
            for (int begin = 0; begin + l <= n; begin += step)
            {
                places_.push_back({i, begin, begin + l, 0});
            }
        }
    }

    mat plain = mat::Zero(data_.size(), places_.size());
    for (int k = 0; k < count(places_); ++k)
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


void statistics::scan::addShapes(const mat& shapes)
{
    for (int i = 0; i < shapes.cols(); ++i)
    {
        const vec w = white_(vec(shapes.col(i)));
        if (w.norm() > tiny)
        {
            appendColumn(templates_, w.normalized());
        }
    }
}


void statistics::scan::draw(const int n, const int seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    strongest_.resize(n);
    sums_.resize(n);
    for (int k = 0; k < n; ++k)
    {
        vec u(data_.size());
        for (double& v : u)
        {
            v = normal(generator);
        }
        strongest_[k] = (templates_.transpose()*u).cwiseAbs().maxCoeff();
        sums_[k] = u.squaredNorm();
    }

    const std::vector<double> s(strongest_);
    const std::vector<double> q(sums_);
    std::sort(strongest_.begin(), strongest_.end());
    std::sort(sums_.begin(), sums_.end());
    lower_.resize(n);
    for (int k = 0; k < n; ++k)
    {
        lower_[k] = std::min(chance(strongest_, s[k]), chance(sums_, q[k]));
    }
    std::sort(lower_.begin(), lower_.end());
}


double
statistics::scan::chance(const std::vector<double>& sorted, const double value)
{
    const auto reach =
        sorted.cend() - std::lower_bound(sorted.cbegin(), sorted.cend(), value);
    return (reach + 1.0)/(sorted.size() + 1.0);
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

statistics::scan::scan
(
    const stacked& data,
    const whitener& white,
    const int draws,
    const int seed,
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

statistics::scanResult
statistics::scan::operator()(const vec& misfit, const double level) const
{
    vec u = white_(misfit);
    scanResult result;
    result.sum = u.squaredNorm();
    result.pSum = chance(sums_, result.sum);
    result.pWindow = chance
    (
        strongest_, vec(templates_.transpose()*u).cwiseAbs().maxCoeff()
    );

    while (count(result.windows) < mostWindows)
    {
        const vec z = templates_.leftCols(places_.size()).transpose()*u;
        int best = 0;
        const double size = z.cwiseAbs().maxCoeff(&best);
        const double p = chance(strongest_, size);
        if (result.windows.size() && p > level)
        {
            break;
        }
        result.windows.push_back(places_[best]);
        result.windows.back().size = z[best];
        u -= z[best]*templates_.col(best);
        if (p > level)
        {
            break;
        }
    }

    const double lower = std::min(result.pWindow, result.pSum);
    const auto reach =
        std::upper_bound(lower_.cbegin(), lower_.cend(), lower)
      - lower_.cbegin();
    result.p = (reach + 1.0)/(lower_.size() + 1.0);
    return result;
}


statistics::mat statistics::withFitted
(
    const mat& covariance,
    const mat& directions,
    const vec& deviations
)
{
    const whitener white(covariance);
    mat all = covariance;
    for (int i = 0; i < directions.cols(); ++i)
    {
        const vec d = directions.col(i);
        const double size = white(d).norm();
        if (size > 0)
        {
            const double deviation =
                deviations[i] > 0 ? deviations[i] : unknownDeviation/size;
            all += sqr(deviation)*d*d.transpose();
        }
    }
    return all;
}
