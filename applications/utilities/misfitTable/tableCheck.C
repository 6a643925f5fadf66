// SPDX-License-Identifier: GPL-3.0-or-later

#include "tableCheck.H"

#include "error.H"
#include "keywords.H"
#include "rankCorrelation.H"
#include "tableColumns.H"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace Foam::misfit
{

namespace
{

statistics::identity readIdentity(const dictionary& dict)
{
    keywords::check(dict, {"quantity", "formula"});
    return
        statistics::identity
        (
            dict.get<word>("quantity"),
            dict.get<string>("formula")
        );
}


// Half of the last printed digit of each column
vec readRoundings(const dictionary& dict, const wordList& columns)
{
    keywords::check(dict, columns);
    vec result(columns.size());
    forAll(columns, i)
    {
        result[i] = dict.get<scalar>(columns[i]);
        if (result[i] <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "The rounding of " << columns[i] << " is " << result[i]
                << "; it is half of the last printed digit, above zero"
                << exit(FatalIOError);
        }
    }
    return result;
}

} // End anonymous namespace


mat tableCheck::read(const wordList& names) const
{
    std::ifstream is(file_);
    if (!is)
    {
        throw std::invalid_argument("it cannot be read");
    }
    const mat result =
        statistics::readColumns(is, {names.begin(), names.end()});
    for (label row = 0; row < result.rows(); ++row)
    {
        for (label i = 0; i < result.cols(); ++i)
        {
            if (std::isnan(result(row, i)))
            {
                throw std::invalid_argument
                (
                    "column " + names[i] + " is empty in line "
                  + std::to_string(row + 2)
                );
            }
        }
    }
    return result;
}


std::vector<statedCorrelation> tableCheck::readStated(const dictionary& dict)
{
    keywords::check(dict, {"columns", "values"});
    const auto pairs = dict.lookupOrDefault("columns", List<Pair<word>>());
    const auto values = dict.lookupOrDefault("values", scalarList());
    if (pairs.size() != values.size())
    {
        FatalIOErrorInFunction(dict)
            << "correlations: " << values.size() << " values for " << pairs.size()
            << " pairs of columns; give one for each" << exit(FatalIOError);
    }
    std::vector<statedCorrelation> result;
    forAll(pairs, i)
    {
        result.push_back({pairs[i], values[i]});
    }
    return result;
}


tableCheck::tableCheck(const dictionary& dict)
:
    file_(dict.get<fileName>("table")),
    law_(readIdentity(dict.subDict("identity"))),
    factorNames_(dict.get<wordList>("factors")),
    factorial_(read(factorNames_)),
    table_(read(columns())),
    limit_(dict.lookupOrDefault<scalar>("chance", 0.001)),
    stated_(readStated(keywords::sub(dict, "correlations")))
{
    keywords::check
    (
        dict,
        {
            "FoamFile", "table", "factors", "identity", "roundings", "tolerance",
            "chance", "correlations"
        }
    );
    if (limit_ <= 0 || limit_ > 1)
    {
        FatalIOErrorInFunction(dict)
            << "chance is " << limit_ << "; it is a probability, above 0 and at"
            << " most 1" << exit(FatalIOError);
    }
    const statistics::columnFaults faults
    (
        factorial_,
        law_,
        table_,
        readRoundings(dict.subDict("roundings"), columns()),
        dict.lookupOrDefault<scalar>("tolerance", 0.01)
    );
    printed_ = faults.asPrinted();
    tried_ = faults.tried();
    likely_ = faults.isLikely(tried_.front(), limit_);
}


wordList tableCheck::columns() const
{
    wordList names(law_.columns().size());
    std::copy(law_.columns().begin(), law_.columns().end(), names.begin());
    return names;
}


std::vector<columnFault> tableCheck::best() const
{
    std::vector<columnFault> result;
    for (const columnFault& one : tried_)
    {
        if (one.match.exact < tried_.front().match.exact)
        {
            break;
        }
        result.push_back(one);
    }
    return result;
}


verdictKind tableCheck::verdict() const
{
    if (printed_.match.exact == factorial_.nRows())
    {
        return verdictKind::none;
    }
    return likely_ ? verdictKind::registration : verdictKind::unknown;
}


scalar tableCheck::fromStated(const mat& columns) const
{
    const wordList names = this->columns();
    const auto numbers = [&](const word& name) -> vec
    {
        const label i = names.find(name);
        return i < 0 ? vec(read({name})) : vec(columns.col(i));
    };

    scalar most = 0;
    for (const statedCorrelation& one : stated_)
    {
        const scalar r = statistics::correlation
        (
            numbers(one.columns.first()),
            numbers(one.columns.second())
        );
        most = max(most, mag(r - one.value));
    }
    return most;
}


scalar tableCheck::columnMoved(const columnFault& fault) const
{
    mat columns = table_;
    columns.col(fault.column) =
        statistics::moved(table_.col(fault.column), fault.sources);
    return fromStated(columns);
}


scalar tableCheck::othersMoved(const columnFault& fault) const
{
    const statistics::rowSources back = statistics::inverse(fault.sources);
    mat columns = table_;
    for (label c = 0; c < columns.cols(); ++c)
    {
        if (c != fault.column)
        {
            columns.col(c) = statistics::moved(table_.col(c), back);
        }
    }
    return fromStated(columns);
}


bool tableCheck::columnIsMoved(const columnFault& fault) const
{
    return !hasStated() || columnMoved(fault) <= othersMoved(fault);
}

} // End namespace Foam::misfit
