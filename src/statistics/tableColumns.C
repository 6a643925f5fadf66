// SPDX-License-Identifier: GPL-3.0-or-later

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

double numberOf(const std::string& cell, const std::string& place)
{
    const double value = numberIn(cell);
    if (!cell.empty() && std::isnan(value))
    {
        throw std::invalid_argument
        (
            '"' + cell + "\" in " + place + " is no number"
        );
    }
    return value;
}


std::vector<int> placesOf
(
    const std::vector<std::string>& names,
    const std::vector<std::string>& heads
)
{
    std::vector<int> result;
    for (const std::string& name : names)
    {
        const auto at = std::find(heads.begin(), heads.end(), name);
        if (at == heads.end())
        {
            std::string found;
            for (const std::string& head : heads)
            {
                found += (found.empty() ? "" : ", ") + head;
            }
            throw std::invalid_argument
            (
                "there is no column " + name + "; its first line names " + found
            );
        }
        result.push_back(at - heads.begin());
    }
    return result;
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


std::vector<std::string> cellsOf(std::string line)
{
    if (!line.empty() && line.back() == '\r')
    {
        line.pop_back();
    }
    std::istringstream is(line + ',');
    std::vector<std::string> result;
    for (std::string cell; std::getline(is, cell, ',');)
    {
        const auto first = cell.find_first_not_of(" \t");
        const auto last = cell.find_last_not_of(" \t");
        result.push_back
        (
            first == cell.npos ? "" : cell.substr(first, last - first + 1)
        );
    }
    return result;
}


tableRows readRows(std::istream& is, const std::vector<std::string>& names)
{
    std::string line;
    if (!std::getline(is, line))
    {
        throw std::invalid_argument("it is empty; its first line must name its columns");
    }
    const std::vector<std::string> heads = cellsOf(line);
    const std::vector<int> places = placesOf(names, heads);

    tableRows result{mat(0, count(names)), {}};
    mat& numbers = result.numbers;
    for (int number = 2; std::getline(is, line); ++number)
    {
        const std::string place = "line " + std::to_string(number);
        const std::vector<std::string> cells = cellsOf(line);
        if (cells.size() == 1 && cells[0].empty() && heads.size() > 1)
        {
            continue;
        }
        if (cells.size() != heads.size())
        {
            throw std::invalid_argument
            (
                place + " has " + std::to_string(cells.size())
              + " cells, the line of names " + std::to_string(heads.size())
            );
        }
        numbers.conservativeResize(numbers.rows() + 1, Eigen::NoChange);
        result.lines.push_back(number);
        for (int i = 0; i < count(places); ++i)
        {
            numbers(numbers.rows() - 1, i) =
                numberOf(cells[places[i]], place + ", column " + names[i]);
        }
    }
    return result;
}


mat readColumns(std::istream& is, const std::vector<std::string>& names)
{
    return readRows(is, names).numbers;
}


tableRows readWhole(const std::string& file, const std::vector<std::string>& names)
{
    std::ifstream is(file);
    if (!is)
    {
        throw std::invalid_argument
        (
            "it cannot be read; its path is taken from where the program is started"
        );
    }
    const tableRows result = readRows(is, names);
    if (result.lines.empty())
    {
        throw std::invalid_argument("it has no row below its line of names");
    }
    for (int row = 0; row < count(result.lines); ++row)
    {
        for (int i = 0; i < count(names); ++i)
        {
            if (std::isnan(result.numbers(row, i)))
            {
                throw std::invalid_argument
                (
                    "column " + names[i] + " is empty in line "
                  + std::to_string(result.lines[row])
                );
            }
        }
    }
    return result;
}


mat completeRows(const mat& table)
{
    mat result(table.rows(), table.cols());
    int n = 0;
    for (int i = 0; i < table.rows(); ++i)
    {
        if (!table.row(i).hasNaN())
        {
            result.row(n++) = table.row(i);
        }
    }
    return result.topRows(n);
}

} // End namespace statistics
