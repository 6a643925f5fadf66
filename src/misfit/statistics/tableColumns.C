// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of results with commas, in which some cells are words or empty.

#include "tableColumns.H"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace statistics
{

namespace
{

//- The cells of a line, without blanks around them
std::vector<std::string> cellsOf(const std::string& line)
{
    std::istringstream is(line + ',');
    std::vector<std::string> result;
    for (std::string cell; std::getline(is, cell, ',');)
    {
        const auto first = cell.find_first_not_of(" \t\r");
        const auto last = cell.find_last_not_of(" \t\r");
        result.push_back
        (
            first == cell.npos ? "" : cell.substr(first, last - first + 1)
        );
    }
    return result;
}

//- Takes off the mark that Excel begins a file of UTF-8 with, or it would be a part of
//  the first name
void unmark(std::string& line)
{
    const std::string mark("\xEF\xBB\xBF");
    if (line.compare(0, mark.size(), mark) == 0)
    {
        line.erase(0, mark.size());
    }
}


//- What to do where a line has more cells than there are names
const char* const tooMany =
    ". Write points, not commas, in numbers, and begin each line above the names with #";


//- Throws where the columns of the line of names are not those of a file with commas
void checkNames(const std::string& line, const std::string& of)
{
    if (line.find('\0') != line.npos)
    {
        throw std::invalid_argument
        (
            "The line of names" + of
          + " is no plain text: save the table as CSV in UTF-8, not in UTF-16"
        );
    }
    if (line.find_first_of(";\t") != line.npos)
    {
        throw std::invalid_argument
        (
            "The line of names" + of + " has semicolons or tabs. Write commas"
            " between the columns and points in the numbers: 0.5,1013"
        );
    }
}

} // End anonymous namespace


double numberIn(const std::string& cell)
{
    // What is too large must not end the program where overflow is trapped
    std::fenv_t traps;
    std::feholdexcept(&traps);
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    std::fesetenv(&traps);
    return
        cell.empty() || *end || !std::isfinite(value)
      ? std::numeric_limits<double>::quiet_NaN() : value;
}


textTable::textTable(std::istream& is, const std::string& of)
{
    std::string line;
    for (int number = 1; std::getline(is, line); ++number)
    {
        if (number == 1)
        {
            unmark(line);
        }
        const auto first = line.find_first_not_of(" \t\r");
        if (first == line.npos || line[first] == '#')
        {
            continue;
        }
        std::vector<std::string> cells = cellsOf(line);
        if (names.empty())
        {
            checkNames(line, of);
            names = std::move(cells);
            continue;
        }
        if (cells.size() != names.size())
        {
            throw std::invalid_argument
            (
                "Line " + std::to_string(number) + of + " has "
              + std::to_string(cells.size()) + " cells for "
              + std::to_string(names.size()) + " columns:" + quoted(names)
              + (cells.size() > names.size() ? tooMany : "")
            );
        }
        rows.push_back(std::move(cells));
        lines.push_back(number);
    }
    if (names.empty())
    {
        throw std::invalid_argument
        (
            (of.empty() ? "it" : "The table" + of)
          + " is empty; its first line must name its columns"
        );
    }
}


int textTable::find(const std::string& name) const
{
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end())
    {
        std::string result;
        for (const std::string& one : names)
        {
            result += (result.empty() ? "" : ", ") + one;
        }
        throw std::invalid_argument
        (
            "there is no column " + name + "; its first line names " + result
        );
    }
    return at - names.begin();
}


mat textTable::columns(const std::vector<std::string>& columnNames) const
{
    mat all(rows.size(), columnNames.size());
    for (int k = 0; k < count(columnNames); ++k)
    {
        const int c = find(columnNames[k]);
        for (int i = 0; i < count(rows); ++i)
        {
            const std::string& cell = rows[i][c];
            all(i, k) = numberIn(cell);
            if (!cell.empty() && std::isnan(all(i, k)))
            {
                throw std::invalid_argument
                (
                    '"' + cell + "\" in line " + std::to_string(lines[i])
                  + ", column " + columnNames[k] + " is no number"
                );
            }
        }
    }
    return all;
}


mat textTable::whole(const std::vector<std::string>& columnNames) const
{
    if (rows.empty())
    {
        throw std::invalid_argument("it has no row below its line of names");
    }
    const mat all = columns(columnNames);
    for (int i = 0; i < all.rows(); ++i)
    {
        for (int k = 0; k < all.cols(); ++k)
        {
            if (std::isnan(all(i, k)))
            {
                throw std::invalid_argument
                (
                    "column " + columnNames[k] + " is empty in line "
                  + std::to_string(lines[i])
                );
            }
        }
    }
    return all;
}


textTable readTable(const std::string& file)
{
    std::ifstream is(file);
    if (!is)
    {
        throw std::invalid_argument
        (
            "it cannot be read; its path is taken from where the program is started"
        );
    }
    return textTable(is);
}


mat completeRows(const mat& table)
{
    std::vector<int> complete;
    for (int i = 0; i < table.rows(); ++i)
    {
        if (!table.row(i).hasNaN())
        {
            complete.push_back(i);
        }
    }
    return table(complete, Eigen::all);
}

} // End namespace statistics
