// SPDX-License-Identifier: GPL-3.0-or-later
// One recorded series: where it was measured, how surely, and what it is for.

#include "channel.H"
#include "keywords.H"
#include "units.H"
#include "MinMax.H"
#include "OStringStream.H"
#include "Tuple2.H"

#include <cmath>

const Foam::Enum<Foam::misfit::purpose> Foam::misfit::purposeNames
({
    {purpose::calibration, "calibration"},
    {purpose::validation, "validation"},
    {purpose::test, "test"}
});


namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Band around the first reading that a quiet channel stays in, over its range [-]: noise
//  is mostly within, a surge leaves it at once
constexpr scalar quietBand = 0.05;

//- Share of the quiet readings that counts [-]: the last ones may rise already
constexpr scalar shareOfQuiet = 0.8;

//- Fewest quiet readings that show noise and memory: the deviation is known to a tenth
constexpr label leastQuiet = 40;

//- Largest correlation of neighbours [-]: with 1 the memory would be without end
constexpr scalar mostAlike = 0.999;


//- Divides what was recorded into about n samples
void takeSamples(channel& c, const label n)
{
    const scalarList& x = c.recorded.x;
    scalarList centre(x);
    c.start = identity(x.size() + 1);
    c.samples.span = 0;
    if (x.size() > n)
    {
        c.start.clear();
        centre.clear();
        c.samples.span = (x.last() - x.first())/n;
        label i = 0;
        for (label k = 0; k < n; ++k)
        {
            const label first = i;
            const scalar end = x.first() + (k + 1)*c.samples.span;
            while (i < x.size() && (x[i] < end || k == n - 1))
            {
                ++i;
            }
            if (i > first)
            {
                c.start.append(first);
                centre.append(end - 0.5*c.samples.span);
            }
        }
        c.start.append(x.size());
    }

    c.samples.size = centre.size();
    c.samples.x.resize(c.samples.size);
    c.samples.readings.resize(c.samples.size);
    forAll(centre, k)
    {
        c.samples.x[k] = centre[k];
        c.samples.readings[k] = c.samples.repeats*(c.start[k+1] - c.start[k]);
    }
}


//- Raises the uncertainty to what the quiet time before the arrival shows, and finds the
//  memory there
void estimateNoise(channel& c, const bool hasMemory)
{
    // Of one recording: a mean has less noise, and between readings less again
    const scalarList& x = c.files[0].readings.x;
    const scalarList& y = c.files[0].readings.y;
    const scalar range = minMax(y).span();

    // Quiet: until it first leaves the band
    label quiet = 0;
    while (quiet < y.size() && mag(y[quiet] - y[0]) < quietBand*range)
    {
        ++quiet;
    }
    quiet = label(shareOfQuiet*quiet);
    if (!c.overTime() || quiet < leastQuiet)
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

    c.samples.uncertainty = max(c.samples.uncertainty, Foam::sqrt(variance));

    // A neighbour that is alike by less than chance would make it: white
    const scalar alike = variance > 0 ? neighbours/variance : 0;
    if (!hasMemory && alike > 2/Foam::sqrt(scalar(quiet)))
    {
        c.samples.memory = -(x[1] - x[0])/std::log(min(alike, mostAlike));
    }
}


//- Warns where what was recorded does not change by more than it
void doubtUncertainty(const channel& c)
{
    const scalarList& y = c.recorded.y;
    const scalar range = minMax(y).span();
    if (y.size() > 1 && range <= c.samples.uncertainty)
    {
        WarningInFunction
            << "Channel " << c.name << " does not change by more than its uncertainty:"
            << " its range is " << range << ", its uncertainty "
            << c.samples.uncertainty
            << " (SI), so it can decide little. Is the sensor dead or dry, or the"
            << " uncertainty not in SI units?" << endl;
    }
}

} // End anonymous namespace


Foam::misfit::channel::channel
(
    const word& channelName,
    const dictionary& dict,
    const purpose channelUse,
    const fileName& folder,
    const label nSamples
)
:
    name(channelName),
    experiment(dict.getOrDefault<word>("experiment", "A")),
    use(channelUse),
    at(dict.getOrDefault<scalar>("at", dict.found("value") ? 0 : -1)),
    interval
    (
        dict.getOrDefault("interval", Tuple2<scalar, scalar>(-GREAT, GREAT))
    ),
    rate(dict.getOrDefault<scalar>("rate", 0)),
    simulated(dict.subDict("simulated"))
{
    keywords::check
    (
        dict,
        {
            "experiment", "quantity", "recorder", "at", "place", "uncertainty", "memory",
            "gainUncertainty", "zeroUncertainty", "value", "file", "repeats", "column",
            "xColumn", "unit", "scale", "offset", "xUnit", "xScale", "xOffset",
            "duplicates", "missing", "interval", "rate", "simulated"
        }
    );
    const point where(dict.getOrDefault<point>("place", Zero));
    statistics::segment& s = samples;
    s.name = name;
    s.experiment = experiment;
    s.quantity = dict.get<word>("quantity");
    s.recorder = dict.getOrDefault<word>("recorder", word());
    s.overTime = at < 0;
    s.hasPlace = dict.found("place");
    s.place << where.x(), where.y(), where.z();
    s.uncertainty = dict.get<scalar>("uncertainty");
    s.memory = dict.getOrDefault<scalar>("memory", 0);
    s.gainUncertainty = dict.getOrDefault<scalar>("gainUncertainty", 0);
    s.zeroUncertainty = dict.getOrDefault<scalar>("zeroUncertainty", 0);

    if (!findQuantity(samples.quantity))
    {
        FatalIOErrorInFunction(dict)
            << "The quantity " << samples.quantity.c_str()
            << " of the channel " << name
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
        readValue(dict);
        takeSamples(*this, 1);
    }
    else if (dict.found("file"))
    {
        readFiles(dict, folder);
        takeSamples(*this, nSamples);
        estimateNoise(*this, dict.found("memory"));
        doubtUncertainty(*this);
    }
    else if (dict.found("repeats"))
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << name
            << " has repeats of no recording: give its first one as file"
            << exit(FatalIOError);
    }
}


void Foam::misfit::channel::plan
(
    const scalar from,
    const scalar to,
    const label nSamples
)
{
    if (to <= from || rate < 0)
    {
        FatalErrorInFunction
            << "The channel " << name << " has no file, and it is not known when it would"
            << " be recorded: give it interval (from to) [s], and rate, its readings in a"
            << " second, which is above zero" << exit(FatalError);
    }
    const label most = 1000000;
    const label n = max(label(min(rate*(to - from), most - scalar(1))) + 1, nSamples);
    recorded.x.setSize(n);
    recorded.y.setSize(n, 0.0);
    forAll(recorded.x, i)
    {
        recorded.x[i] = from + i*(to - from)/(n - 1);
        recorded.y[i] = 0;
    }
    isPlanned = true;
    takeSamples(*this, nSamples);
}


Foam::scalarList Foam::misfit::channel::sampled(const series& s) const
{
    scalarList means(samples.size, 0.0);
    forAll(means, k)
    {
        for (label i = start[k]; i < start[k+1]; ++i)
        {
            means[k] += s(recorded.x[i]);
        }
        means[k] /= start[k+1] - start[k];
    }
    return means;
}
