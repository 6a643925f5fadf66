// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers under names: of a recording, or of what a function object wrote.

#include "numberTable.H"
#include "quoted.H"
#include "tableColumns.H"

#include "OSspecific.H"
#include "TimePaths.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

using cells = std::vector<std::string>;

//- Calls with each line that holds something, without blanks before it, and its number
void eachLine
(
    const fileName& file,
    const std::function<void(const std::string&, label)>& take
)
{
    std::ifstream is(file);
    std::string line;
    for (label n = 1; std::getline(is, line); ++n)
    {
        const auto first = line.find_first_not_of(" \t\r");
        if (first != std::string::npos)
        {
            take(line.substr(first), n);
        }
    }
}


void addRow(numberTable& t, const cells& from, const label line)
{
    scalarList row(from.size());
    std::transform(from.begin(), from.end(), row.begin(), statistics::numberIn);
    t.rows.append(std::move(row));
    t.lines.append(line);
}


void readNames(numberTable& t, const std::string& line)
{
    if (line.find_first_of(";\t") != std::string::npos)
    {
        FatalErrorInFunction
            << "The file " << t.file << " has semicolons or tabs. Write commas between"
            << " the columns and points in the numbers: 0.5,1013"
            << exit(FatalError);
    }
    for (const std::string& name : statistics::cellsOf(line))
    {
        t.names.append(name);
        if (!std::isnan(statistics::numberIn(name)))
        {
            FatalErrorInFunction
                << "The file " << t.file << " has no line of column names"
                << " before its numbers. Give each column a name with its"
                << " unit, for instance: t_s,p_Pa" << exit(FatalError);
        }
    }
}


//- Fatal unless the cells are as many finite numbers as there are names
void check(const numberTable& t, const cells& row, const label line)
{
    if (label(row.size()) != t.names.size())
    {
        FatalErrorInFunction
            << "Line " << line << " of " << t.file << " has "
            << row.size() << " cells for " << t.names.size() << " columns:"
            << quoted(t.names).c_str() << exit(FatalError);
    }
    const auto bad = std::find_if
    (
        row.begin(), row.end(),
        [](const std::string& c) { return std::isnan(statistics::numberIn(c)); }
    );
    if (bad != row.end())
    {
        FatalErrorInFunction
            << "Line " << line << " of " << t.file << " holds \"" << bad->c_str()
            << "\" in the column " << t.names[bad - row.begin()]
            << ", which is no finite number. Remove the line if nothing"
            << " was recorded then" << exit(FatalError);
    }
}


cells wordsOf(const std::string& text)
{
    std::istringstream is(text);
    return cells(std::istream_iterator<std::string>(is), {});
}


void addWritten(numberTable& t, const fileName& file)
{
    const auto take = [&t](std::string line, const label n)
    {
        if (line[0] != '#')
        {
            for (const char between : {'(', ')', ','})
            {
                std::replace(line.begin(), line.end(), between, ' ');
            }
            addRow(t, wordsOf(line), n);
            return;
        }
        const cells words(wordsOf(line.substr(1)));
        t.names.resize(words.size());
        std::copy(words.begin(), words.end(), t.names.begin());
        if (line.find("# Not Found") != std::string::npos && words.size() > 1)
        {
            t.notFound.append(std::atoi(words[1].c_str()));
        }
    };
    eachLine(file, take);
}


//- The times of which a function object wrote folders, in their order
instantList timesIn(const fileName& folder)
{
    const instantList found(TimePaths::findTimes(folder));
    if (found.empty())
    {
        FatalErrorInFunction
            << "The run wrote nothing in " << folder
            << ". Is the function object in its system/controlDict? For a"
            << " probe or a level: has the solver a field of that name?"
            << exit(FatalError);
    }
    return found;
}


//- The table, fatal without numbers; files is where they should be
const numberTable& withNumbers(const numberTable& t, const fileName& files)
{
    if (t.rows.empty())
    {
        FatalErrorInFunction
            << "The run wrote no numbers in " << files.c_str() << exit(FatalError);
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

    // What is named, and not in the first row, column() tells with the row's line
    if (i < 0 || i >= max(names.size(), rows.first().size()))
    {
        FatalErrorInFunction
            << "The table " << file << " has no column " << name
            << (isNumber ? ", counted from 1" : "")
            << ". Its columns:" << quoted(names).c_str()
            << ". Take one of these, or its number" << exit(FatalError);
    }
    return i;
}


Foam::scalarList Foam::misfit::numberTable::column(const label i) const
{
    scalarList numbers(rows.size());
    forAll(rows, row)
    {
        if (i >= rows[row].size())
        {
            FatalErrorInFunction
                << "Line " << lines[row] << " of the table " << file << " has "
                << rows[row].size() << " columns; the one with number " << i + 1
                << " was asked for" << exit(FatalError);
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
    const token t(dict.lookup(key));
    return
        t.isNumber() ? string(std::to_string(label(t.number())))
      : t.isString() ? t.stringToken() : string(t.wordToken());
}


Foam::misfit::numberTable Foam::misfit::csvTable(const fileName& file)
{
    if (!isFile(file, false))
    {
        FatalErrorInFunction
            << "There is no file " << file << exit(FatalError);
    }

    numberTable t;
    t.file = file;
    t.unitsFollow = true;
    const auto take = [&t](const std::string& line, const label n)
    {
        if (line[0] == '#')
        {
            return;
        }
        if (t.names.empty())
        {
            readNames(t, line);
            return;
        }
        const cells row(statistics::cellsOf(line));
        check(t, row, n);
        addRow(t, row, n);
    };
    eachLine(file, take);

    if (t.rows.empty())
    {
        FatalErrorInFunction
            << "The file " << file << " holds no numbers" << exit(FatalError);
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
        label kept = t.rows.size();
        while (kept && t.rows[kept-1][0] >= start.value())
        {
            --kept;
        }
        t.rows.resize(kept);
        t.lines.resize(kept);
        addWritten(t, t.file/start.name()/file);
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
