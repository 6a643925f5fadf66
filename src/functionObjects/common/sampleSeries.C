// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of a quantity over time.

#include "sampleSeries.H"

#include "ListOps.H"

Foam::linearFit::linearFit(const UList<scalar>& x, const UList<scalar>& y)
:
    slope(0),
    R2(0)
{
    const label n = x.size();

    if (n < 2)
    {
        return;
    }

    const scalar xMean = sum(x)/n;
    const scalar yMean = sum(y)/n;

    scalar xx = 0;
    scalar xy = 0;
    scalar yy = 0;

    for (label i = 0; i < n; ++i)
    {
        xx += sqr(x[i] - xMean);
        xy += (x[i] - xMean)*(y[i] - yMean);
        yy += sqr(y[i] - yMean);
    }

    if (xx > VSMALL)
    {
        slope = xy/xx;
        R2 = yy > VSMALL ? sqr(xy)/(xx*yy) : 1;
    }
}


Foam::sampleSeries::sampleSeries
(
    const scalarList& times,
    const scalarList& values
)
:
    times_(times),
    values_(values)
{}


void Foam::sampleSeries::append(const scalar time, const scalar value)
{
    label n = size();

    while (n && times_[n - 1] > time - 1e-9*(1 + mag(time)))
    {
        --n;
    }

    times_.setSize(n);
    values_.setSize(n);
    times_.append(time);
    values_.append(value);
}


Foam::scalar Foam::sampleSeries::slope(const scalar t1, const scalar t2) const
{
    DynamicList<scalar> x;
    DynamicList<scalar> y;

    forAll(times_, i)
    {
        if (times_[i] >= t1 - SMALL && times_[i] <= t2 + SMALL)
        {
            x.append(times_[i]);
            y.append(values_[i]);
        }
    }

    return linearFit(x, y).slope;
}


Foam::scalar Foam::sampleSeries::lastSlope(const scalar period) const
{
    const label n = size();

    if (n < 2)
    {
        return 0;
    }

    return slope(min(times_[n - 1] - period, times_[n - 2]), times_[n - 1]);
}


Foam::scalar Foam::sampleSeries::mean(const scalar t1, const scalar t2) const
{
    scalar integral = 0;
    scalar time = 0;
    scalar single = 0;
    label previous = -1;

    forAll(times_, i)
    {
        if (times_[i] < t1 - SMALL || times_[i] > t2 + SMALL)
        {
            continue;
        }

        single = values_[i];

        if (previous >= 0)
        {
            const scalar dt = times_[i] - times_[previous];
            integral += dt*(values_[i] + values_[previous])/2;
            time += dt;
        }
        previous = i;
    }

    return time > 0 ? integral/time : single;
}


Foam::label Foam::sampleSeries::peak() const
{
    return findMax(values_);
}


Foam::scalar Foam::sampleSeries::durationAbove(const scalar level) const
{
    scalar time = 0;

    for (label i = 1; i < size(); ++i)
    {
        const scalar dt = times_[i] - times_[i - 1];
        const scalar high = max(values_[i], values_[i - 1]);
        const scalar low = min(values_[i], values_[i - 1]);

        if (low > level)
        {
            time += dt;
        }
        else if (high > level)
        {
            time += dt*(high - level)/(high - low);
        }
    }

    return time;
}


Foam::scalar Foam::sampleSeries::lastAbove(const scalar level) const
{
    forAllReverse(values_, i)
    {
        if (values_[i] > level)
        {
            if (i == size() - 1)
            {
                return times_[i];
            }

            const scalar drop = values_[i] - values_[i + 1];
            return times_[i]
              + (times_[i + 1] - times_[i])*(values_[i] - level)/drop;
        }
    }

    return size() ? times_.first() : 0;
}
