// SPDX-License-Identifier: GPL-3.0-or-later
// A table that a function object wrote, of all its start times.

#include "writtenTable.H"

#include "DynamicList.H"
#include "quoted.H"
#include "OSspecific.H"
#include "scalar.H"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace
{

using namespace Foam;

//- Folders with the name of a time, sorted by it
List<std::pair<scalar, fileName>> timeFolders(const fileName& folder)
{
    List<std::pair<scalar, fileName>> found;
    for (const fileName& name : readDir(folder, fileName::DIRECTORY))
    {
        scalar t = 0;
        if (readScalar(name.c_str(), t))
        {
            found.append({t, folder/name});
        }
    }
    std::sort(found.begin(), found.end());

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

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::writtenTable::readComment(const std::string& line)
{
    std::istringstream is(line.substr(1));
    DynamicList<string> words;
    std::string w;
    while (is >> w)
    {
        words.append(w);
    }
    names_ = words;

    if (line.find("# Not Found") != std::string::npos && words.size() > 1)
    {
        notFound_.append(std::atoi(words[1].c_str()));
    }
}


void Foam::misfit::writtenTable::readFile(const fileName& file)
{
    std::ifstream is(file);
    std::string line;
    while (std::getline(is, line))
    {
        const auto first = line.find_first_not_of(" \t");
        if (first == std::string::npos)
        {
            continue;
        }
        if (line[first] == '#')
        {
            readComment(line.substr(first));
            continue;
        }

        std::replace(line.begin(), line.end(), '(', ' ');
        std::replace(line.begin(), line.end(), ')', ' ');
        std::istringstream numbers(line);
        DynamicList<scalar> row;
        std::string number;
        while (numbers >> number)
        {
            row.append(std::strtod(number.c_str(), nullptr));
        }
        rows_.append(scalarList(row));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::misfit::writtenTable::writtenTable
(
    const fileName& caseFolder,
    const word& functionObject,
    const fileName& file
)
:
    folder_(caseFolder/"postProcessing"/functionObject)
{
    for (const auto& start : timeFolders(folder_))
    {
        while (rows_.size() && rows_.last()[0] >= start.first)
        {
            rows_.setSize(rows_.size() - 1);
        }
        readFile(start.second/file);
    }
    if (rows_.empty())
    {
        FatalErrorInFunction
            << "The run wrote no numbers in " << folder_ << "/*/" << file.c_str()
            << exit(FatalError);
    }
}


Foam::misfit::writtenTable::writtenTable(const fileName& file)
:
    folder_(file)
{
    readFile(file);
    if (rows_.empty())
    {
        FatalErrorInFunction
            << "The run wrote no numbers in " << file << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::label Foam::misfit::writtenTable::find(const string& name) const
{
    const label i = names_.find(name);
    if (i < 0)
    {
        FatalErrorInFunction
            << "The table " << folder_ << " has no column " << name
            << ". Its columns:" << quoted(names_).c_str() << exit(FatalError);
    }
    return i;
}


Foam::scalar Foam::misfit::writtenTable::value
(
    const label row,
    const label column
) const
{
    if (column >= rows_[row].size())
    {
        FatalErrorInFunction
            << "Line " << row + 1 << " of the table " << folder_ << " has "
            << rows_[row].size() << " columns; the one with number "
            << column + 1 << " was asked for" << exit(FatalError);
    }
    return rows_[row][column];
}


Foam::fileName Foam::misfit::nearestTimeFolder
(
    const fileName& caseFolder,
    const word& functionObject,
    const scalar t
)
{
    const auto folders
    (
        timeFolders(caseFolder/"postProcessing"/functionObject)
    );
    const auto nearest = std::min_element
    (
        folders.begin(),
        folders.end(),
        [t](const auto& a, const auto& b)
        {
            return mag(a.first - t) < mag(b.first - t);
        }
    );
    if (mag(nearest->first - t) > 0.01*mag(t) + 1e-6)
    {
        FatalErrorInFunction
            << functionObject << " of " << caseFolder << " wrote nothing at "
            << t << " s; the nearest is " << nearest->first
            << " s. Let it write at the times of the channels"
            << exit(FatalError);
    }
    return nearest->second;
}
