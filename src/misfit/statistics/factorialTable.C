// SPDX-License-Identifier: GPL-3.0-or-later

#include "factorialTable.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace statistics
{

namespace
{

using order = std::vector<int>;

constexpr double mostArrangements = 1e5;


std::vector<order> permutations(const int n)
{
    std::vector<order> result;
    order one = inOrder(n);
    do
    {
        result.push_back(one);
    }
    while (std::next_permutation(one.begin(), one.end()));
    return result;
}


//- Every choice of one order from each list
std::vector<std::vector<order>> choices
(
    const std::vector<std::vector<order>>& lists
)
{
    std::vector<std::vector<order>> result(1);
    for (const std::vector<order>& list : lists)
    {
        std::vector<std::vector<order>> longer;
        for (const std::vector<order>& begun : result)
        {
            for (const order& next : list)
            {
                longer.push_back(begun);
                longer.back().push_back(next);
            }
        }
        result = std::move(longer);
    }
    return result;
}


void checkNumber(const std::vector<std::vector<double>>& levels)
{
    double n = std::tgamma(count(levels) + 1.0);
    for (const std::vector<double>& one : levels)
    {
        n *= std::tgamma(count(one) + 1.0);
    }
    if (n > mostArrangements)
    {
        throw std::length_error
        (
            "its labels have more than a hundred thousand arrangements; name fewer"
            " factors, or leave levels out"
        );
    }
}

//- The first combination of levels that has not one row, as "30 0.004 0.1 has 2";
//  cells: of each row the number of its level of each factor
std::string notOnce
(
    const std::vector<std::vector<double>>& levels,
    const std::vector<order>& cells
)
{
    order cell(levels.size(), 0);
    for (int f = 0; f >= 0;)
    {
        const auto n = std::count(cells.begin(), cells.end(), cell);
        if (n != 1)
        {
            std::ostringstream os;
            for (int i = 0; i < count(cell); ++i)
            {
                os << levels[i][cell[i]] << ' ';
            }
            os << "has " << n;
            return os.str();
        }
        for (f = count(cell) - 1; f >= 0 && ++cell[f] == count(levels[f]); --f)
        {
            cell[f] = 0;
        }
    }
    return "";
}

} // End anonymous namespace


factorialTable::factorialTable(const mat& factors)
{
    size_t nCells = 1;
    for (int f = 0; f < factors.cols(); ++f)
    {
        const vec column = factors.col(f);
        std::vector<double> levels(column.begin(), column.end());
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        nCells *= levels.size();
        levels_.push_back(levels);
    }

    for (int i = 0; i < factors.rows(); ++i)
    {
        std::vector<int> cell;
        for (int f = 0; f < factors.cols(); ++f)
        {
            const std::vector<double>& of = levels_[f];
            cell.push_back
            (
                std::lower_bound(of.begin(), of.end(), factors(i, f)) - of.begin()
            );
        }
        rowOf_[cell] = i;
        cells_.push_back(cell);
    }
    if (rowOf_.size() != nCells || cells_.size() != nCells)
    {
        throw std::invalid_argument
        (
            "it has " + std::to_string(cells_.size()) + " rows, "
          + std::to_string(rowOf_.size()) + " of them different, and the levels of"
            " its factors have " + std::to_string(nCells) + " combinations, each of"
            " which needs one row; " + notOnce(levels_, cells_)
        );
    }
}


std::vector<labelArrangement> factorialTable::arrangements() const
{
    checkNumber(levels_);

    std::vector<std::vector<order>> ofLevels;
    for (const std::vector<double>& levels : levels_)
    {
        ofLevels.push_back(permutations(count(levels)));
    }
    const auto allLevels = choices(ofLevels);

    std::vector<labelArrangement> result;
    for (const order& factors : permutations(count(levels_)))
    {
        bool alike = true;
        for (int f = 0; f < count(factors); ++f)
        {
            alike = alike && levels_[f].size() == levels_[factors[f]].size();
        }
        if (!alike)
        {
            continue;
        }
        for (const std::vector<order>& levels : allLevels)
        {
            result.push_back({factors, levels});
        }
    }
    // The first of all orders is the one that changes nothing
    result.erase(result.begin());
    return result;
}


rowSources factorialTable::sources(const labelArrangement& arrangement) const
{
    rowSources result;
    for (const std::vector<int>& cell : cells_)
    {
        std::vector<int> source;
        for (int f = 0; f < count(cell); ++f)
        {
            source.push_back
            (
                arrangement.levels[f][cell[arrangement.factors[f]]]
            );
        }
        result.push_back(rowOf_.at(source));
    }
    return result;
}


unsigned factorialTable::differing(const int i, const int j) const
{
    unsigned result = 0;
    for (int f = 0; f < count(levels_); ++f)
    {
        result |= unsigned(cells_[i][f] != cells_[j][f]) << f;
    }
    return result;
}

} // End namespace statistics
