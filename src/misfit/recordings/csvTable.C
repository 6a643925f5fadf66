// SPDX-License-Identifier: GPL-3.0-or-later
// A CSV file: lines of comment (#), a line of column names, lines of numbers.

#include "csvTable.H"
#include "quoted.H"
#include "tableColumns.H"
#include "IFstream.H"
#include "OSspecific.H"

#include <cmath>

void Foam::misfit::csvTable::readNames(const std::string& line)
{
    if (line.find_first_of(";\t") != std::string::npos)
    {
        FatalErrorInFunction
            << "The file " << file_ << " has semicolons or tabs. Write commas between"
            << " the columns and points in the numbers: 0.5,1013"
            << exit(FatalError);
    }

    for (const std::string& name : statistics::cellsOf(line))
    {
        names_.append(name);
        if (!std::isnan(statistics::numberIn(name)))
        {
            FatalErrorInFunction
                << "The file " << file_ << " has no line of column names"
                << " before its numbers. Give each column a name with its"
                << " unit, for instance: t_s,p_Pa" << exit(FatalError);
        }
    }
    columns_.setSize(names_.size());
}


void Foam::misfit::csvTable::readRow
(
    const std::string& line,
    const label lineNumber
)
{
    const std::vector<std::string> cells(statistics::cellsOf(line));
    if (label(cells.size()) != names_.size())
    {
        FatalErrorInFunction
            << "Line " << lineNumber << " of " << file_ << " has "
            << cells.size() << " cells for " << names_.size() << " columns:"
            << quoted(names_).c_str() << exit(FatalError);
    }

    forAll(names_, i)
    {
        const scalar value = statistics::numberIn(cells[i]);
        if (std::isnan(value))
        {
            FatalErrorInFunction
                << "Line " << lineNumber << " of " << file_ << " holds \""
                << cells[i].c_str() << "\" in the column " << names_[i]
                << ", which is no finite number. Remove the line if nothing"
                << " was recorded then" << exit(FatalError);
        }
        columns_[i].append(value);
    }
    lines_.append(lineNumber);
}


Foam::misfit::csvTable::csvTable(const fileName& file)
:
    file_(file)
{
    if (!isFile(file, false))
    {
        FatalErrorInFunction
            << "There is no file " << file << exit(FatalError);
    }

    IFstream stream(file);
    std::string line;
    for (label n = 1; std::getline(stream.stdStream(), line); ++n)
    {
        const auto first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#')
        {
            continue;
        }
        if (names_.empty())
        {
            readNames(line);
        }
        else
        {
            readRow(line, n);
        }
    }

    if (lines_.empty())
    {
        FatalErrorInFunction
            << "The file " << file << " holds no numbers" << exit(FatalError);
    }
}


Foam::label Foam::misfit::csvTable::find(const string& name) const
{
    // A whole name goes before one of which it is but the part before the unit
    const label whole = names_.find(name);
    if (whole >= 0)
    {
        return whole;
    }
    forAll(names_, i)
    {
        const std::string& full = names_[i];
        const auto end = full.find_first_of("_ [", name.size());
        if (full.substr(0, end) == name)
        {
            return i;
        }
    }

    FatalErrorInFunction
        << "The file " << file_ << " has no column " << name
        << ". Its columns:" << quoted(names_).c_str() << exit(FatalError);
    return -1;
}
