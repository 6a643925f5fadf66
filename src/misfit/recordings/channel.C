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
    scalarList centre(x);
    start_ = identity(x.size() + 1);
    samples_.span = 0;
    if (x.size() > n)
    {
        start_.clear();
        centre.clear();
        samples_.span = (x.last() - x.first())/n;
        label i = 0;
        for (label k = 0; k < n; ++k)
        {
            const label first = i;
            const scalar end = x.first() + (k + 1)*samples_.span;
            while (i < x.size() && (x[i] < end || k == n - 1))
            {
                ++i;
            }
            if (i > first)
            {
                start_.append(first);
                centre.append(end - 0.5*samples_.span);
            }
        }
        start_.append(x.size());
    }

    samples_.size = centre.size();
    samples_.x.resize(samples_.size);
    samples_.readings.resize(samples_.size);
    forAll(centre, k)
    {
        samples_.x[k] = centre[k];
        samples_.readings[k] = start_[k+1] - start_[k];
    }
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

    samples_.uncertainty = max(samples_.uncertainty, Foam::sqrt(variance));

    // A neighbour that is alike by less than chance would make it: white
    const scalar alike = variance > 0 ? neighbours/variance : 0;
    if (!memoryGiven && alike > 2/Foam::sqrt(scalar(quiet)))
    {
        samples_.memory = -(x[1] - x[0])/std::log(min(alike, 0.999));
    }
}


void Foam::misfit::channel::doubtUncertainty() const
{
    const scalarList& y = recorded_.y;
    const scalar range = rangeOf(y);
    if (y.size() > 1 && range <= samples_.uncertainty)
    {
        WarningInFunction
            << "Channel " << name_ << " does not change by more than its uncertainty:"
            << " its range is " << range << ", its uncertainty "
            << samples_.uncertainty
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
    at_(dict.getOrDefault<scalar>("at", dict.found("value") ? 0 : -1)),
    interval_
    (
        dict.getOrDefault("interval", Tuple2<scalar, scalar>(-GREAT, GREAT))
    ),
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
    const point place(dict.getOrDefault<point>("place", Zero));
    statistics::segment& s = samples_;
    s.name = name;
    s.quantity = dict.get<word>("quantity");
    s.recorder = dict.getOrDefault<word>("recorder", word());
    s.overTime = at_ < 0;
    s.hasPlace = dict.found("place");
    s.place << place.x(), place.y(), place.z();
    s.uncertainty = dict.get<scalar>("uncertainty");
    s.memory = dict.getOrDefault<scalar>("memory", 0);
    s.gainUncertainty = dict.getOrDefault<scalar>("gainUncertainty", 0);
    s.zeroUncertainty = dict.getOrDefault<scalar>("zeroUncertainty", 0);

    if (!findQuantity(quantity()))
    {
        FatalIOErrorInFunction(dict)
            << "The quantity " << quantity() << " of the channel " << name
            << " is not known. Valid quantities:"
            << keywords::listed(quantityNames()).c_str()
            << exit(FatalIOError);
    }
    if (s.uncertainty <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The uncertainty of the channel " << name << " is "
            << s.uncertainty << "; it must be above zero: the standard"
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

Foam::scalarList Foam::misfit::channel::sampled(const series& simulated) const
{
    scalarList means(samples_.size, 0.0);
    forAll(means, k)
    {
        for (label i = start_[k]; i < start_[k+1]; ++i)
        {
            means[k] += simulated(recorded_.x[i]);
        }
        means[k] /= samples_.readings[k];
    }
    return means;
}


Foam::scalarList Foam::misfit::channel::sampled() const
{
    return sampled(recorded_);
}
