// SPDX-License-Identifier: GPL-3.0-or-later
// One recorded series: its file, or its value, in SI units.

#include "channel.H"
#include "keywords.H"
#include "numberTable.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "recordedSource.H"
#include "units.H"

#include <algorithm>
#include <regex>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The name of a file with the variables of the environment in it put in; fatal
//  where one is not set, or where OpenFOAM cannot hold the name
fileName expanded(const dictionary& dict, const string& name)
{
    // One with a default, ${NAME:-folder}, need not be set
    const std::regex variable(R"(\$(?:(\w+)|\{(\w+)\}))");
    std::sregex_iterator match(name.begin(), name.end(), variable);
    for (; match != std::sregex_iterator(); ++match)
    {
        const word needed((*match)[1].str() + (*match)[2].str());
        if (getEnv(needed).empty())
        {
            FatalIOErrorInFunction(dict)
                << "The recording " << name << " needs the variable "
                << needed << ", which is not set. Set it to their folder:"
                << "  export " << needed << "=<folder>" << exit(FatalIOError);
        }
    }
    string file(name);
    file.expand();
    if (!string::valid<fileName>(file))
    {
        FatalIOErrorInFunction(dict)
            << "The recording " << file << " has a blank or a quotation mark in its name"
            << " or in that of a folder, which OpenFOAM does not take. Rename it"
            << exit(FatalIOError);
    }
    return file;
}


//- The name of a unit. One as m/s or 1/s is no word: its tokens are put together
word unitEntry(const dictionary& dict, const word& key)
{
    std::ostringstream name;
    for (const token& t : dict.lookup(key))
    {
        if (t.isString())
        {
            name << t.stringToken().c_str();
        }
        else
        {
            OStringStream os;
            os << t;
            name << os.str();
        }
    }
    return word(name.str(), false);
}


//- The unit of that name; fatal if it is none of the quantity. What is the
//  subject of the error that reports it
const unit& checkedUnit
(
    const dictionary& dict,
    const word& name,
    const word& quantity,
    const string& what
)
{
    const dimensionSet& expected = *findQuantity(quantity);
    const unit* known = findUnit(name);
    if (!known || known->dimensions != expected)
    {
        FatalIOErrorInFunction(dict)
            << what.c_str() << " is in " << name << ", which is no unit of "
            << quantity << ". Valid units:"
            << keywords::listed(unitsOf(expected)).c_str()
            << exit(FatalIOError);
    }
    return *known;
}


//- Fatal where a column holds a number that stands for "not recorded"
void checkMissing(const dictionary& dict, const numberTable& table, const label column)
{
    // What loggers, well logs (LAS), netCDF and satellites write. Others: missing
    const scalarList fills
    (
        dict.getOrDefault<scalarList>
        (
            "missing", {-9999, -99999, -999999, -999.25, 1e20, 9.96921e36}
        )
    );
    const scalarList values(table.column(column));
    label n = 0;
    label first = -1;
    forAll(values, i)
    {
        const auto isFill = [&](const scalar fill)
        {
            return mag(values[i] - fill) <= 1e-6*mag(fill);
        };
        if (std::any_of(fills.begin(), fills.end(), isFill))
        {
            first = n++ ? first : i;
        }
    }
    if (n)
    {
        FatalIOErrorInFunction(dict)
            << "Line " << table.lines[first] << " of " << table.file << " holds "
            << values[first] << " in the column " << table.names[column]
            << ", which stands for what was not recorded; there "
            << (n > 1 ? "are " : "is ") << n << " such line" << (n > 1 ? "s" : "")
            << ". Remove what was not recorded. If it was: missing ();"
            << exit(FatalIOError);
    }
}


//- A column in SI units; fatal without the unit, or with another one
scalarList readColumn
(
    const dictionary& dict,
    const numberTable& table,
    const label column,
    const word& quantity,
    const word& prefix
)
{
    const string& header = table.names[column];
    const word key(prefix.empty() ? "unit" : prefix + "Unit");
    const word written(unitInName(header));
    const word name(dict.found(key) ? unitEntry(dict, key) : written);
    const string what("The column \"" + header + "\" of " + table.file);

    if (name.empty())
    {
        FatalIOErrorInFunction(dict)
            << what.c_str() << " has no known unit. Name it as "
            << (quantity == "time" ? "t_s or \"t [s]\"" : "p_Pa or \"p [Pa]\"")
            << " in the file, or give " << key << " here. Units of " << quantity << ":"
            << keywords::listed(unitsOf(*findQuantity(quantity))).c_str()
            << exit(FatalIOError);
    }
    if (!written.empty() && written != name)
    {
        FatalIOErrorInFunction(dict)
            << what.c_str() << " is in " << written << ", but " << key << " is " << name
            << ". Remove one of them" << exit(FatalIOError);
    }

    const scalar scale =
        checkedUnit(dict, name, quantity, what).size
       *dict.getOrDefault<scalar>(prefix.empty() ? "scale" : prefix + "Scale", 1);
    const scalar offset =
        dict.getOrDefault<scalar>(prefix.empty() ? "offset" : prefix + "Offset", 0);

    checkMissing(dict, table, column);
    scalarList values(table.column(column));
    for (scalar& v : values)
    {
        v = scale*v + offset;
    }
    return values;
}


//- Fatal unless x rises; may average readings at the same x
series inOrder
(
    const dictionary& dict,
    const numberTable& table,
    const series& recorded
)
{
    const word duplicates
    (
        keywords::choice
        (
            dict, "duplicates", "way with readings at one time",
            wordList({"refuse", "average"}), "refuse"
        )
    );

    series kept;
    label n = 1;
    forAll(recorded.x, i)
    {
        const scalar x = recorded.x[i];
        if (i && x < recorded.x[i-1])
        {
            FatalIOErrorInFunction(dict)
                << "Line " << table.lines[i] << " of " << table.file
                << " goes back to " << x << " from " << recorded.x[i-1]
                << ". Sort the file by its first column" << exit(FatalIOError);
        }
        if (!i || x > recorded.x[i-1])
        {
            kept.x.append(x);
            kept.y.append(recorded.y[i]);
            n = 1;
        }
        else if (duplicates == "average")
        {
            ++n;
            kept.y.last() += (recorded.y[i] - kept.y.last())/n;
        }
        else
        {
            FatalIOErrorInFunction(dict)
                << "Lines " << table.lines[i-1] << " and " << table.lines[i]
                << " of " << table.file << " are both at " << x
                << ". Remove one, or have them averaged: duplicates average;"
                << exit(FatalIOError);
        }
    }
    return kept;
}

} // End anonymous namespace


Foam::misfit::recordedFile Foam::misfit::channel::readFile
(
    const dictionary& dict,
    const fileName& folder,
    const string& fileGiven
) const
{
    const fileName path(expanded(dict, fileGiven));
    const fileName file(path.isAbsolute() ? path : folder/path);
    if (!isFile(file, false))
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << name << " has no recording: there is no file " << file
            << ". Correct file or repeats, relative to the folder of the case, or"
            << " remove it: a channel without a file is a possible measurement"
            << exit(FatalIOError);
    }
    const numberTable table(csvTable(file));

    const label yColumn = table.find(columnIn(dict, "column", "2"));
    const label xColumn = table.find(columnIn(dict, "xColumn", "1"));

    series all;
    all.x = readColumn(dict, table, xColumn, overTime() ? "time" : "length", "x");
    all.y = readColumn(dict, table, yColumn, samples.quantity, "");
    return {sourceOf(table.file, table.names[yColumn]), inOrder(dict, table, all)};
}


void Foam::misfit::channel::readValue(const dictionary& dict)
{
    if (dict.found("file") || dict.found("repeats") || !dict.found("unit"))
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << name << " has a value, a number alone. It"
            << " needs its unit, no file and no repeats. Units of "
            << samples.quantity.c_str() << ":"
            << keywords::listed(unitsOf(*findQuantity(samples.quantity))).c_str()
            << exit(FatalIOError);
    }
    const scalar size =
        checkedUnit
        (
            dict, unitEntry(dict, "unit"), samples.quantity,
            "The value of the channel " + name
        ).size;
    recorded.x = scalarList(1, scalar(0));
    recorded.y = scalarList(1, size*dict.get<scalar>("value"));
    files = List<recordedFile>(1, {"the value of " + name, recorded});
}
