// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers under names: of a recording, or of what a function object wrote.

#include "numberTable.H"
#include "tableColumns.H"

#include "OSspecific.H"
#include "TimePaths.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

using cells = std::vector<std::string>;

void addRow(numberTable& t, const cells& from, const label line)
{
    scalarList row(from.size());
    std::transform(from.begin(), from.end(), row.begin(), statistics::numberIn);
    t.rows.append(std::move(row));
    t.lines.append(line);
}


//- Fatal where a name is a number
void checkNames(const numberTable& t)
{
    for (const string& name : t.names)
    {
        if (!std::isnan(statistics::numberIn(name)))
        {
            FatalErrorInFunction
                << "The file " << t.file << " has no line of column names"
                << " before its numbers. Give each column a name with its"
                << " unit, for instance: t_s,p_Pa" << exit(FatalError);
        }
    }
}


//- Keeps what is no finite number in the last row
void keepNoNumbers(numberTable& t, const cells& row)
{
    for (label i = 0; i < statistics::count(row); ++i)
    {
        if (std::isnan(t.rows.last()[i]))
        {
            t.noNumbers[{i, t.rows.size() - 1}] = row[i];
        }
    }
}


//- Fatal if a cell of the column holds no finite number
void checkNumbers(const numberTable& t, const label column)
{
    const auto first = t.noNumbers.lower_bound({column, 0});
    const auto end = t.noNumbers.lower_bound({column + 1, 0});
    if (first != end)
    {
        const auto n = std::distance(first, end);
        FatalErrorInFunction
            << "Line " << t.lines[first->first.second] << " of " << t.file << " holds \""
            << first->second.c_str() << "\" in the column " << t.names[column]
            << ", which is no finite number. Remove the line if nothing was recorded"
            << " then";
        if (n > 1)
        {
            FatalError << "; it is the first of " << label(n) << " such lines";
        }
        FatalError << exit(FatalError);
    }
}


cells wordsOf(const std::string& text)
{
    std::istringstream is(text);
    return cells(std::istream_iterator<std::string>(is), {});
}


void addWritten(numberTable& t, const fileName& file)
{
    std::ifstream is(file);
    std::string line;
    for (label n = 1; std::getline(is, line); ++n)
    {
        const auto first = std::min(line.find_first_not_of(" \t\r"), line.size());
        if (line[first] == '#')
        {
            const cells words(wordsOf(line.substr(first + 1)));
            t.names.resize(words.size());
            std::copy(words.begin(), words.end(), t.names.begin());
            t.notFound = t.notFound || line.find("# Not Found") != std::string::npos;
            continue;
        }
        for (const char between : {'(', ')', ','})
        {
            std::replace(line.begin(), line.end(), between, ' ');
        }
        if (const cells words(wordsOf(line)); words.size())
        {
            addRow(t, words, n);
        }
    }
}


//- Appends what a start at that time [s] wrote, in place of the rows after it. The row of
//  the start itself stays unless it was written again
void addRestarted(numberTable& t, const scalar start, const fileName& file)
{
    numberTable later;
    addWritten(later, file);
    scalar from = start + 1e-6*mag(start) + VSMALL;
    if (later.rows.size())
    {
        from = min(from, later.rows[0][0]);
    }

    label kept = t.rows.size();
    while (kept && t.rows[kept-1][0] >= from)
    {
        --kept;
    }
    t.rows.resize(kept);
    t.lines.resize(kept);
    t.rows.append(later.rows);
    t.lines.append(later.lines);
    t.names = later.names;
    t.notFound = t.notFound || later.notFound;
}


//- The times of which a function object wrote folders, in their order
instantList timesIn(const fileName& folder)
{
    const instantList result(TimePaths::findTimes(folder));
    if (result.empty())
    {
        FatalErrorInFunction
            << "The run wrote nothing in " << folder
            << ". Is the function object in its system/controlDict? For a"
            << " probe or a level: has the solver a field of that name?"
            << exit(FatalError);
    }
    return result;
}


//- The table, fatal without numbers; files is where they should be
const numberTable& withNumbers(const numberTable& t, const fileName& files)
{
    if (t.rows.empty())
    {
        FatalErrorInFunction
            << "The run wrote no numbers in " << files.c_str() << nl
            << "    Does it reach the first time at which the function object writes?"
            << exit(FatalError);
    }
    return t;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::label Foam::misfit::numberTable::find(const string& name) const
{
    label i = names.find(name);
    const bool isNumber = name.find_first_not_of("0123456789") == string::npos;
    if (isNumber)
    {
        i = std::atoi(name.c_str()) - 1;
    }
    for (label j = 0; unitsFollow && i < 0 && j < names.size(); ++j)
    {
        const auto end = names[j].find_first_of("_ [", name.size());
        i = names[j].substr(0, end) == name ? j : -1;
    }

    // If the first row lacks a named column, column() reports the line of that row
    if (i < 0 || i >= max(names.size(), rows.first().size()))
    {
        FatalErrorInFunction
            << "The table " << file << " has no column " << name
            << (isNumber ? ", counted from 1" : "")
            << ". Its columns:" << statistics::quoted(names).c_str()
            << ". Take one of these, or its number" << exit(FatalError);
    }
    return i;
}


Foam::scalarList Foam::misfit::numberTable::column(const label i) const
{
    checkNumbers(*this, i);
    scalarList numbers(rows.size());
    forAll(rows, row)
    {
        if (i >= rows[row].size())
        {
            FatalErrorInFunction
                << "Line " << lines[row] << " of the table " << file << " has "
                << rows[row].size() << " columns, but column " << i + 1
                << " is needed: correct the line, or the column of the channel"
                << exit(FatalError);
        }
        numbers[row] = rows[row][i];
    }
    return numbers;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::string Foam::misfit::columnIn
(
    const dictionary& dict,
    const word& key,
    const string& byDefault
)
{
    if (!dict.found(key))
    {
        return byDefault;
    }
    ITstream& is = dict.lookup(key);
    const token t(is);
    if (is.nRemainingTokens())
    {
        FatalIOErrorInFunction(dict)
            << key << " is more than one word or number: a name like 1:zz needs"
            << " quotes." << exit(FatalIOError);
    }
    return
        t.isNumber() ? string(std::to_string(label(t.number())))
      : t.isString() ? t.stringToken() : string(t.wordToken());
}


Foam::misfit::numberTable Foam::misfit::csvTable(const fileName& file)
{
    numberTable t;
    t.file = file;
    t.unitsFollow = true;
    std::ifstream is(file);
    if (!is)
    {
        FatalErrorInFunction
            << "There is no file " << file << ": correct its path"
            << exit(FatalError);
    }
    try
    {
        const statistics::textTable text(is, " of " + file);
        t.names.resize(text.names.size());
        std::copy(text.names.begin(), text.names.end(), t.names.begin());
        checkNames(t);
        for (label i = 0; i < statistics::count(text.rows); ++i)
        {
            addRow(t, text.rows[i], text.lines[i]);
            keepNoNumbers(t, text.rows[i]);
        }
    }
    catch (const std::invalid_argument& e)
    {
        FatalErrorInFunction << e.what() << exit(FatalError);
    }
    if (t.rows.empty())
    {
        FatalErrorInFunction
            << "The file " << file << " holds no numbers: it needs a line of names and"
            << " rows of numbers" << exit(FatalError);
    }
    return t;
}


Foam::misfit::numberTable Foam::misfit::writtenTable(const fileName& file)
{
    numberTable t;
    t.file = file;
    addWritten(t, file);
    return withNumbers(t, file);
}


Foam::misfit::numberTable Foam::misfit::writtenTable
(
    const fileName& caseFolder,
    const word& functionObject,
    const fileName& file
)
{
    numberTable t;
    t.file = caseFolder/"postProcessing"/functionObject;
    for (const instant& start : timesIn(t.file))
    {
        // Where a run starts twice at one time, OpenFOAM puts that time into the name
        // of the second file (functionObjects::writeFile::createFile)
        const fileName first(t.file/start.name()/file);
        const fileName again(first.lessExt() + '_' + start.name() + ".dat");
        for (const fileName& written : {first, again})
        {
            if (isFile(written, false))
            {
                addRestarted(t, start.value(), written);
            }
        }
    }
    return withNumbers(t, t.file/"*"/file);
}


Foam::fileName Foam::misfit::nearestTimeFolder
(
    const fileName& caseFolder,
    const word& functionObject,
    const scalar t
)
{
    const fileName folder(caseFolder/"postProcessing"/functionObject);
    const instantList times(timesIn(folder));
    const instant& nearest = times[TimePaths::findClosestTimeIndex(times, t)];
    if (mag(nearest.value() - t) > nearEnough(t))
    {
        FatalErrorInFunction
            << functionObject << " of " << caseFolder << " wrote nothing at "
            << t << " s; the nearest is " << nearest.value()
            << " s. Let it write at the times of the channels"
            << exit(FatalError);
    }
    return folder/nearest.name();
}
