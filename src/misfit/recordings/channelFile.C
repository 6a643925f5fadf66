// SPDX-License-Identifier: GPL-3.0-or-later
// One recorded series: its file, or its value, in SI units.

#include "channel.H"
#include "csvTable.H"
#include "keywords.H"
#include "quoted.H"
#include "OSspecific.H"
#include "units.H"

#include <regex>

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
    recorded_.y = readColumn(dict, table, yColumn, quantity(), "");
    source_ = table.file() + ':' + table.names()[yColumn];
    checkOrder(dict, table);
}


void Foam::misfit::channel::readNumber(const dictionary& dict)
{
    if (dict.found("file") || !dict.found("unit"))
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << name_ << " has a value, a number alone. It"
            << " needs its unit and no file. Units of " << quantity() << ":"
            << keywords::listed(unitsOf(*findQuantity(quantity()))).c_str()
            << exit(FatalIOError);
    }
    const scalar size =
        checkedUnit
        (
            dict, dict.get<word>("unit"), quantity(),
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
