// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over equal strips along a line.

#include "strips.H"

#include "PstreamReduceOps.H"
#include "error.H"
#include "sphereParts.H"

Foam::strips::strips
(
    const scalar start,
    const scalar end,
    const scalar width
)
:
    start_(start),
    width_(width),
    outside_(0)
{
    if (width <= 0 || end <= start)
    {
        FatalErrorInFunction
            << "Strips of " << width << " m from " << start << " to " << end
            << " m: the width must be above zero and the end beyond the start."
            << exit(FatalError);
    }

    // A strip more only where more than round-off is left
    values_.setSize(label(std::ceil((end - start)/width - 1e-6)), Zero);
}


Foam::label Foam::strips::find(const scalar x) const
{
    const scalar i = std::floor((x - start_)/width_);

    return i >= 0 && i < size() ? label(i) : -1;
}


void Foam::strips::add(const scalar x, const scalar v)
{
    const label i = find(x);

    (i < 0 ? outside_ : values_[i]) += v;
}


template<class Function>
void Foam::strips::spread
(
    const scalar low,
    const scalar high,
    const scalar v,
    const Function& below
)
{
    const scalar first = max(std::floor((low - start_)/width_), scalar(0));
    const scalar last =
        min(std::floor((high - start_)/width_), scalar(size() - 1));

    scalar done = 0;

    for (label i = label(first); i <= label(last); ++i)
    {
        const scalar a = max(low, start_ + i*width_);
        const scalar b = min(high, start_ + (i + 1)*width_);
        const scalar share = below(b) - below(a);

        values_[i] += v*share;
        done += share;
    }

    outside_ += v*(1 - done);
}


void Foam::strips::addRange(const scalar a, const scalar b, const scalar v)
{
    if (b - a < SMALL)
    {
        add(a, v);
        return;
    }

    spread(a, b, v, [=](const scalar x) { return (x - a)/(b - a); });
}


void Foam::strips::addSphere(const scalar x, const scalar r, const scalar v)
{
    spread
    (
        x - r,
        x + r,
        v,
        [=](const scalar s) { return sphereParts::below((s - x)/r); }
    );
}


void Foam::strips::reduce()
{
    Foam::reduce(values_, sumOp<scalarField>());
    Foam::reduce(outside_, sumOp<scalar>());
}


Foam::scalar Foam::strips::quantile(const scalar q) const
{
    const scalar target = q*sum(values_);

    if (target <= 0)
    {
        return start_;
    }

    scalar below = 0;

    forAll(values_, i)
    {
        if (values_[i] > 0 && below + values_[i] >= target)
        {
            return start_ + (i + (target - below)/values_[i])*width_;
        }
        below += values_[i];
    }

    return end();
}


Foam::scalar Foam::strips::farthest(const scalar threshold) const
{
    forAllReverse(values_, i)
    {
        if (values_[i] >= threshold)
        {
            const scalar before = i ? values_[i - 1] : values_[i];
            const scalar filled = values_[i]/max(before, VSMALL);

            return start_ + (i + min(filled, scalar(1)))*width_;
        }
    }

    return start_;
}


Foam::scalar Foam::strips::beyond(const scalar n) const
{
    scalar sum = 0;

    forAllReverse(values_, i)
    {
        if (values_[i] > 0 && sum + values_[i] >= n)
        {
            return start_ + (i + 1 - (n - sum)/values_[i])*width_;
        }
        sum += values_[i];
    }

    return start_;
}


Foam::scalar Foam::strips::mean(const scalar a, const scalar b) const
{
    scalar sum = 0;
    scalar length = 0;

    forAll(values_, i)
    {
        const scalar overlap =
            min(b, start_ + (i + 1)*width_) - max(a, start_ + i*width_);

        if (overlap > 0)
        {
            sum += overlap*values_[i];
            length += overlap;
        }
    }

    return length > 0 ? sum/length : 0;
}


Foam::scalarField Foam::strips::smoothed(const scalar width) const
{
    scalarField result(size());

    forAll(result, i)
    {
        const scalar half = max(width, width_)/2;
        result[i] = mean(centre(i) - half, centre(i) + half);
    }

    return result;
}
