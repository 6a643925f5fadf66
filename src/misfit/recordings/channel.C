// SPDX-License-Identifier: GPL-3.0-or-later
// One recorded series: where it was measured, how surely, and what it is for.

#include "channel.H"
#include "csvTable.H"
#include "keywords.H"
#include "quoted.H"
#include "OSspecific.H"
#include "units.H"
#include "Tuple2.H"

#include <algorithm>
#include <cmath>
#include <regex>

const Foam::Enum<Foam::misfit::purpose> Foam::misfit::purposeNames
({
    {purpose::calibration, "calibration"},
    {purpose::validation, "validation"},
    {purpose::test, "test"}
});


namespace
{

//- Number of the column that an entry names, as a word or in quotes
Foam::label columnNumber
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::misfit::csvTable& table,
    const Foam::label byDefault
)
{
    if (!dict.found(key))
    {
        return byDefault;
    }
    const Foam::token name(dict.lookup(key));
    return table.find
    (
        name.isString() ? name.stringToken() : name.wordToken()
    );
}


//- The name of a file with the variables of the environment in it put in; fatal
//  where one is not set
Foam::fileName expanded(const Foam::dictionary& dict, const Foam::fileName& name)
{
    using namespace Foam;
    // One with a default, ${NAME:-folder}, need not be set
    const std::regex variable(R"(\$(?:(\w+)|\{(\w+)\}))");
    std::sregex_iterator found(name.begin(), name.end(), variable);
    for (; found != std::sregex_iterator(); ++found)
    {
        const word needed((*found)[1].str() + (*found)[2].str());
        if (getEnv(needed).empty())
        {
            FatalIOErrorInFunction(dict)
                << "The recording " << name.c_str() << " needs the variable "
                << needed << ", which is not set. Say where the recordings are:"
                << "  export " << needed << "=<folder>" << exit(FatalIOError);
        }
    }
    fileName file(name);
    file.expand();
    return file;
}


//- The unit of that name; fatal if it is none of the quantity. What is the
//  subject of the sentence that says so
const Foam::misfit::unit& checkedUnit
(
    const Foam::dictionary& dict,
    const Foam::word& name,
    const Foam::word& quantity,
    const Foam::string& what
)
{
    using namespace Foam;
    const dimensionSet& wanted = *misfit::findQuantity(quantity);
    const misfit::unit* found = misfit::findUnit(name);
    if (!found || found->dimensions != wanted)
    {
        FatalIOErrorInFunction(dict)
            << what.c_str() << " is in " << name << ", which is no unit of "
            << quantity << ". Valid units:"
            << keywords::listed(misfit::unitsOf(wanted)).c_str()
            << exit(FatalIOError);
    }
    return *found;
}


Foam::scalar rangeOf(const Foam::scalarList& y)
{
    return
        *std::max_element(y.cbegin(), y.cend())
      - *std::min_element(y.cbegin(), y.cend());
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::misfit::channel::readColumn
(
    const dictionary& dict,
    const csvTable& table,
    const label column,
    const word& quantity,
    const word& prefix
) const
{
    const string& header = table.names()[column];
    const word key(prefix.empty() ? "unit" : prefix + "Unit");
    const word written(unitInName(header));
    const word name(dict.getOrDefault<word>(key, written));

    if (name.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The column \"" << header.c_str() << "\" of " << table.file()
            << " has no known unit. Name it as "
            << (quantity == "time" ? "t_s or \"t [s]\"" : "p_Pa or \"p [Pa]\"")
            << " in the file, or give " << key << " here. Units of " << quantity << ":"
            << keywords::listed(unitsOf(*findQuantity(quantity))).c_str()
            << exit(FatalIOError);
    }
    if (!written.empty() && written != name)
    {
        FatalIOErrorInFunction(dict)
            << "The column \"" << header.c_str() << "\" of " << table.file()
            << " is in " << written << ", but " << key << " says " << name
            << ". Remove one of them" << exit(FatalIOError);
    }

    const scalar scale =
        checkedUnit
        (
            dict, name, quantity,
            "The column \"" + header + "\" of " + table.file()
        ).size
       *dict.getOrDefault<scalar>(prefix.empty() ? "scale" : prefix + "Scale", 1);
    const scalar offset =
        dict.getOrDefault<scalar>(prefix.empty() ? "offset" : prefix + "Offset", 0);

    scalarList values(table.column(column));
    for (scalar& v : values)
    {
        v = scale*v + offset;
    }
    return values;
}


void Foam::misfit::channel::readRecorded
(
    const dictionary& dict,
    const fileName& folder
)
{
    const fileName file(expanded(dict, dict.get<fileName>("file")));
    const csvTable table(file.isAbsolute() ? file : folder/file);

    const label yColumn = columnNumber(dict, "column", table, 1);
    const label xColumn = columnNumber(dict, "xColumn", table, 0);

    if (yColumn >= table.names().size())
    {
        FatalIOErrorInFunction(dict)
            << "The file " << table.file() << " has one column only:"
            << quoted(table.names()).c_str()
            << ". It needs one of time and one of values"
            << exit(FatalIOError);
    }

    recorded_.x =
        readColumn(dict, table, xColumn, overTime() ? "time" : "length", "x");
    recorded_.y = readColumn(dict, table, yColumn, quantity_, "");
    source_ = table.file() + ':' + table.names()[yColumn];
    checkOrder(dict, table);
}


void Foam::misfit::channel::readNumber(const dictionary& dict)
{
    if (dict.found("file") || !dict.found("unit"))
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << name_ << " has a value, a number alone. It"
            << " needs its unit and no file. Units of " << quantity_ << ":"
            << keywords::listed(unitsOf(*findQuantity(quantity_))).c_str()
            << exit(FatalIOError);
    }
    const scalar size =
        checkedUnit
        (
            dict, dict.get<word>("unit"), quantity_,
            "The value of the channel " + name_
        ).size;
    recorded_.x = scalarList(1, scalar(0));
    recorded_.y = scalarList(1, size*dict.get<scalar>("value"));
    source_ = "the value of " + name_;
    divide(1);
}


void Foam::misfit::channel::checkOrder
(
    const dictionary& dict,
    const csvTable& table
)
{
    const word duplicates(dict.getOrDefault<word>("duplicates", "refuse"));
    if (duplicates != "refuse" && duplicates != "average")
    {
        FatalIOErrorInFunction(dict)
            << "duplicates is " << duplicates
            << "; valid choices: refuse, average" << exit(FatalIOError);
    }

    series kept;
    label n = 1;
    forAll(recorded_.x, i)
    {
        const scalar x = recorded_.x[i];
        if (i && x < recorded_.x[i-1])
        {
            FatalIOErrorInFunction(dict)
                << "Line " << table.line(i) << " of " << table.file()
                << " goes back to " << x << " from " << recorded_.x[i-1]
                << ". Sort the file by its first column" << exit(FatalIOError);
        }
        if (!i || x > recorded_.x[i-1])
        {
            kept.x.append(x);
            kept.y.append(recorded_.y[i]);
            n = 1;
        }
        else if (duplicates == "average")
        {
            ++n;
            kept.y.last() += (recorded_.y[i] - kept.y.last())/n;
        }
        else
        {
            FatalIOErrorInFunction(dict)
                << "Lines " << table.line(i-1) << " and " << table.line(i)
                << " of " << table.file() << " are both at " << x
                << ". Remove one, or have them averaged: duplicates average;"
                << exit(FatalIOError);
        }
    }
    recorded_ = kept;
}


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
