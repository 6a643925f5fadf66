// SPDX-License-Identifier: GPL-3.0-or-later

#include "columnFault.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace statistics
{

namespace
{

//- That at least k hold, each with a chance of its own (Poisson binomial)
double atLeast(const int k, const std::vector<double>& chances)
{
    // By the number of those that hold, one after the other
    vec p = vec::Unit(count(chances) + 1, 0);
    for (const double one : chances)
    {
        for (int n = count(chances); n > 0; --n)
        {
            p[n] = (1 - one)*p[n] + one*p[n - 1];
        }
        p[0] *= 1 - one;
    }
    return p.tail(p.size() - k).sum();
}


bool better(const columnFault& a, const columnFault& b)
{
    return
        a.match.exact != b.match.exact
      ? a.match.exact > b.match.exact
      : a.match.meanDifference < b.match.meanDifference;
}

} // End anonymous namespace


void columnFaults::checkRow(identity& law, const vec& row, const int number) const
{
    const std::string line = "line " + std::to_string(number);
    if (row[0] == 0)
    {
        throw std::invalid_argument
        (
            line + ": " + law.columns()[0] + " is 0, of which no difference is a"
            " share"
        );
    }
    if (!std::isfinite(law.value(row)))
    {
        throw std::invalid_argument
        (
            line + ": the formula has no value for its numbers"
        );
    }
}


columnFaults::columnFaults
(
    const factorialTable& factorial,
    identity& law,
    const tableRows& rows,
    const vec& roundings,
    const double tolerance
)
:
    factorial_(factorial),
    nRows_(rows.numbers.rows()),
    tolerance_(tolerance)
{
    const mat& table = rows.numbers;
    for (int i = 0; i < nRows_; ++i)
    {
        checkRow(law, table.row(i), rows.lines[i]);
    }
    for (int c = 0; c < table.cols(); ++c)
    {
        mat off(nRows_, nRows_);
        decltype(holds_)::value_type holds(nRows_, nRows_);
        for (int i = 0; i < nRows_; ++i)
        {
            for (int j = 0; j < nRows_; ++j)
            {
                vec row = table.row(i);
                row[c] = table(j, c);
                const double value = law.value(row);
                off(i, j) =
                    std::isfinite(value) && row[0] != 0
                  ? std::abs(value/row[0] - 1)
                  : large;
                holds(i, j) = law.holds(row, roundings);
            }
        }
        difference_.push_back(off);
        holds_.push_back(holds);
    }
}


identityMatch columnFaults::match
(
    const int column,
    const rowSources& sources
) const
{
    identityMatch result;
    for (int i = 0; i < nRows_; ++i)
    {
        const double off = difference_[column](i, sources[i]);
        result.exact += holds_[column](i, sources[i]);
        result.within += off <= tolerance_;
        result.meanDifference += off/nRows_;
    }
    return result;
}


columnFault columnFaults::asPrinted() const
{
    columnFault result;
    result.sources = inOrder(nRows_);
    result.match = match(0, result.sources);
    return result;
}


std::map<unsigned, double> columnFaults::sharesThatHold(const int column) const
{
    std::map<unsigned, double> nPairs;
    std::map<unsigned, double> result;
    for (int i = 0; i < nRows_; ++i)
    {
        for (int j = 0; j < nRows_; ++j)
        {
            const unsigned factors = factorial_.differing(i, j);
            ++nPairs[factors];
            result[factors] += holds_[column](i, j);
        }
    }
    for (auto& one : result)
    {
        one.second /= nPairs[one.first];
    }
    return result;
}


void columnFaults::setChances(std::vector<columnFault>& attempts) const
{
    std::vector<std::map<unsigned, double>> shares;
    for (int c = 0; c < count(holds_); ++c)
    {
        shares.push_back(sharesThatHold(c));
    }

    for (columnFault& one : attempts)
    {
        std::vector<double> chances;
        int nHold = 0;
        for (int i = 0; i < nRows_; ++i)
        {
            const int from = one.sources[i];
            if (from != i)
            {
                const unsigned factors = factorial_.differing(i, from);
                chances.push_back(shares[one.column].at(factors));
                nHold += holds_[one.column](i, from);
            }
        }
        const double alone = atLeast(nHold, chances);
        one.chance =
            alone < 1 ? -std::expm1(count(attempts)*std::log1p(-alone)) : 1;
    }
}


void columnFaults::addToColumns
(
    columnFault fault,
    std::vector<columnFault>& result
) const
{
    for (fault.column = 0; fault.column < count(holds_); ++fault.column)
    {
        fault.match = match(fault.column, fault.sources);
        result.push_back(fault);
    }
}


void columnFaults::addLabels(std::vector<columnFault>& result) const
{
    columnFault fault;
    fault.kind = columnFaultKind::labels;
    for (const labelArrangement& labels : factorial_.arrangements())
    {
        fault.labels = labels;
        fault.sources = factorial_.sources(labels);
        addToColumns(fault, result);
    }
}


void columnFaults::addRows(std::vector<columnFault>& result) const
{
    columnFault fault;
    fault.kind = columnFaultKind::rows;
    for (int i = 0; i < nRows_; ++i)
    {
        for (int j = 0; j < i; ++j)
        {
            fault.sources = inOrder(nRows_);
            std::swap(fault.sources[i], fault.sources[j]);
            addToColumns(fault, result);
        }
    }
}


std::vector<columnFault> columnFaults::attempts() const
{
    std::vector<columnFault> result;
    addLabels(result);
    addRows(result);
    setChances(result);
    std::stable_sort(result.begin(), result.end(), better);
    return result;
}


bool columnFaults::isLikely(const columnFault& fault, const double limit) const
{
    const identityMatch printed = asPrinted().match;
    return
        fault.match.exact > printed.exact
     && 2*fault.match.exact > nRows_
     && fault.match.meanDifference < printed.meanDifference
     && fault.chance < limit;
}


rowSources inverse(const rowSources& sources)
{
    rowSources result(sources.size());
    for (int i = 0; i < count(sources); ++i)
    {
        result[sources[i]] = i;
    }
    return result;
}

} // End namespace statistics
