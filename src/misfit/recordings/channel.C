// SPDX-License-Identifier: GPL-3.0-or-later
// One recorded series: where it was measured, how surely, and what it is for.

#include "channel.H"
#include "keywords.H"
#include "units.H"
#include "Tuple2.H"

#include <algorithm>
#include <cmath>

const Foam::Enum<Foam::misfit::purpose> Foam::misfit::purposeNames
({
    {purpose::calibration, "calibration"},
    {purpose::validation, "validation"},
    {purpose::test, "test"}
});


namespace
{

Foam::scalar rangeOf(const Foam::scalarList& y)
{
    return
        *std::max_element(y.cbegin(), y.cend())
      - *std::min_element(y.cbegin(), y.cend());
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::channel::cut(const dictionary& dict)
{
    series kept;
    forAll(recorded_.x, i)
    {
        const scalar x = recorded_.x[i];
        if (x >= interval_.first() && x <= interval_.second())
        {
            kept.x.append(x);
            kept.y.append(recorded_.y[i]);
        }
    }

    if (kept.x.size() < 3)
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << name_ << " has " << kept.x.size()
            << " readings in the interval " << interval_ << "; it needs three."
            << " The file covers " << recorded_.x.first() << " to "
            << recorded_.x.last() << exit(FatalIOError);
    }
    recorded_ = kept;
}


void Foam::misfit::channel::divide(const label n)
{
    const scalarList& x = recorded_.x;
    start_.clear();
    centre_.clear();

    if (x.size() <= n)
    {
        span_ = 0;
        start_ = identity(x.size() + 1);
        centre_ = x;
        return;
    }

    span_ = (x.last() - x.first())/n;
    label i = 0;
    for (label k = 0; k < n; ++k)
    {
        const label first = i;
        const scalar end = x.first() + (k + 1)*span_;
        while (i < x.size() && (x[i] < end || k == n - 1))
        {
            ++i;
        }
        if (i > first)
        {
            start_.append(first);
            centre_.append(end - 0.5*span_);
        }
    }
    start_.append(x.size());
}


void Foam::misfit::channel::estimateNoise(const bool memoryGiven)
{
    const scalarList& x = recorded_.x;
    const scalarList& y = recorded_.y;
    const scalar range = rangeOf(y);

    // Quiet: until it first leaves a band of 5 % of the range
    label quiet = 0;
    while (quiet < y.size() && mag(y[quiet] - y[0]) < 0.05*range)
    {
        ++quiet;
    }
    quiet = (4*quiet)/5;
    if (!overTime() || quiet < 40)
    {
        return;
    }

    scalar mean = 0;
    for (label i = 0; i < quiet; ++i)
    {
        mean += y[i]/quiet;
    }
    scalar variance = 0;
    scalar neighbours = 0;
    for (label i = 0; i < quiet; ++i)
    {
        variance += sqr(y[i] - mean)/quiet;
        neighbours += i ? (y[i] - mean)*(y[i-1] - mean)/quiet : 0;
    }

    uncertainty_ = max(uncertainty_, Foam::sqrt(variance));

    // A neighbour that is alike by less than chance would make it: white
    const scalar alike = variance > 0 ? neighbours/variance : 0;
    if (!memoryGiven && alike > 2/Foam::sqrt(scalar(quiet)))
    {
        memory_ = -(x[1] - x[0])/std::log(min(alike, 0.999));
    }
}


void Foam::misfit::channel::doubtUncertainty() const
{
    const scalarList& y = recorded_.y;
    const scalar range = rangeOf(y);
    if (y.size() > 1 && range <= uncertainty_)
    {
        WarningInFunction
            << "Channel " << name_ << " does not change by more than its uncertainty:"
            << " its range is " << range << ", its uncertainty " << uncertainty_
            << " (SI), so it can say little. Is the sensor dead or dry, or the"
            << " uncertainty not in SI units?" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::channel::channel
(
    const word& name,
    const dictionary& dict,
    const purpose use,
    const fileName& folder,
    const label samples
)
:
    name_(name),
    experiment_(dict.getOrDefault<word>("experiment", "A")),
    purpose_(use),
    quantity_(dict.get<word>("quantity")),
    recorder_(dict.getOrDefault<word>("recorder", word())),
    at_(dict.getOrDefault<scalar>("at", dict.found("value") ? 0 : -1)),
    hasPlace_(dict.found("place")),
    place_(dict.getOrDefault<point>("place", Zero)),
    uncertainty_(dict.get<scalar>("uncertainty")),
    memory_(dict.getOrDefault<scalar>("memory", 0)),
    gainUncertainty_(dict.getOrDefault<scalar>("gainUncertainty", 0)),
    zeroUncertainty_(dict.getOrDefault<scalar>("zeroUncertainty", 0)),
    interval_
    (
        dict.getOrDefault("interval", Tuple2<scalar, scalar>(-GREAT, GREAT))
    ),
    span_(0),
    simulated_(dict.subDict("simulated"))
{
    keywords::check
    (
        dict,
        {
            "experiment", "quantity", "recorder", "at", "place", "uncertainty", "memory",
            "gainUncertainty", "zeroUncertainty", "value", "file", "column", "xColumn",
            "unit", "scale", "offset", "xUnit", "xScale", "xOffset",
            "duplicates", "interval", "simulated"
        }
    );
    if (!findQuantity(quantity_))
    {
        FatalIOErrorInFunction(dict)
            << "The quantity " << quantity_ << " of the channel " << name
            << " is not known. Valid quantities:"
            << keywords::listed(quantityNames()).c_str()
            << exit(FatalIOError);
    }
    if (uncertainty_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The uncertainty of the channel " << name << " is "
            << uncertainty_ << "; it must be above zero: the standard"
            << " deviation of a reading in SI units" << exit(FatalIOError);
    }

    if (dict.found("value"))
    {
        readNumber(dict);
    }
    else if (dict.found("file"))
    {
        readRecorded(dict, folder);
        cut(dict);
        divide(samples);
        estimateNoise(dict.found("memory"));
        doubtUncertainty();
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::labelList Foam::misfit::channel::readings() const
{
    labelList n(size());
    forAll(n, k)
    {
        n[k] = start_[k+1] - start_[k];
    }
    return n;
}


Foam::scalarList Foam::misfit::channel::sampled(const series& simulated) const
{
    scalarList samples(size(), 0.0);
    forAll(samples, k)
    {
        for (label i = start_[k]; i < start_[k+1]; ++i)
        {
            samples[k] += simulated(recorded_.x[i]);
        }
        samples[k] /= start_[k+1] - start_[k];
    }
    return samples;
}


Foam::scalarList Foam::misfit::channel::sampled() const
{
    return sampled(recorded_);
}
