// SPDX-License-Identifier: GPL-3.0-or-later

#include "columnFault.H"

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace statistics
{

namespace
{

rowSources unmoved(const int nRows)
{
    rowSources result(nRows);
    std::iota(result.begin(), result.end(), 0);
    return result;
}


//- That at least k of n hold, each with a chance of p
double atLeast(const int k, const int n, const double p)
{
    if (k <= 0)
    {
        return 1;
    }
    return cdf(complement(boost::math::binomial(n, p), k - 1));
}


bool better(const columnFault& a, const columnFault& b)
{
    return
        a.match.exact != b.match.exact
      ? a.match.exact > b.match.exact
      : a.match.meanDifference < b.match.meanDifference;
}

} // End anonymous namespace


columnFaults::columnFaults
(
    identity& law,
    const mat& table,
    const vec& roundings,
    const double tolerance
)
:
    nRows_(table.rows()),
    tolerance_(tolerance)
{
    for (int c = 0; c < table.cols(); ++c)
    {
        mat off(nRows_, nRows_);
        mat holds(nRows_, nRows_);
        for (int i = 0; i < nRows_; ++i)
        {
            for (int j = 0; j < nRows_; ++j)
            {
                vec row = table.row(i);
                row[c] = table(j, c);
                off(i, j) = std::abs(law.value(row)/row[0] - 1);
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
        result.exact += holds_[column](i, sources[i]) > 0;
        result.within += off <= tolerance_;
        result.meanDifference += off/nRows_;
    }
    return result;
}


columnFault columnFaults::asPrinted() const
{
    columnFault result;
    result.sources = unmoved(nRows_);
    result.match = match(0, result.sources);
    return result;
}


void columnFaults::setChances(std::vector<columnFault>& tried) const
{
    // Share of the numbers of other rows that would hold in a row
    vec share(count(holds_));
    for (int c = 0; c < count(holds_); ++c)
    {
        share[c] =
            (holds_[c].sum() - holds_[c].diagonal().sum())
           /(nRows_*(nRows_ - 1.0));
    }

    for (columnFault& one : tried)
    {
        int nMoved = 0;
        int nHold = 0;
        for (int i = 0; i < nRows_; ++i)
        {
            if (one.sources[i] != i)
            {
                ++nMoved;
                nHold += holds_[one.column](i, one.sources[i]) > 0;
            }
        }
        const double alone = atLeast(nHold, nMoved, share[one.column]);
        one.chance =
            alone < 1 ? -std::expm1(count(tried)*std::log1p(-alone)) : 1;
    }
}


void columnFaults::addLabels
(
    const factorialTable& factorial,
    std::vector<columnFault>& result
) const
{
    for (const labelArrangement& labels : factorial.arrangements())
    {
        const rowSources sources = factorial.sources(labels);
        for (int c = 0; c < count(holds_); ++c)
        {
            columnFault one;
            one.kind = columnFaultKind::labels;
            one.column = c;
            one.labels = labels;
            one.sources = sources;
            one.match = match(c, sources);
            result.push_back(one);
        }
    }
}


void columnFaults::addRows(std::vector<columnFault>& result) const
{
    for (int i = 0; i < nRows_; ++i)
    {
        for (int j = 0; j < i; ++j)
        {
            rowSources sources = unmoved(nRows_);
            std::swap(sources[i], sources[j]);
            for (int c = 0; c < count(holds_); ++c)
            {
                columnFault one;
                one.kind = columnFaultKind::rows;
                one.column = c;
                one.sources = sources;
                one.match = match(c, sources);
                result.push_back(one);
            }
        }
    }
}


std::vector<columnFault> columnFaults::tried
(
    const factorialTable& factorial
) const
{
    std::vector<columnFault> result;
    addLabels(factorial, result);
    addRows(result);
    setChances(result);
    std::stable_sort(result.begin(), result.end(), better);
    return result;
}


vec moved(const vec& column, const rowSources& sources)
{
    vec result(column.size());
    for (int i = 0; i < count(sources); ++i)
    {
        result[i] = column[sources[i]];
    }
    return result;
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
