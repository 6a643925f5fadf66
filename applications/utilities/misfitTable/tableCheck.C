// SPDX-License-Identifier: GPL-3.0-or-later
// What a table of published results is checked by, and what comes of it.

#include "tableCheck.H"

#include "keywords.H"
#include "Pair.H"
#include "rankCorrelation.H"
#include "scalarList.H"
#include "tableColumns.H"

#include <stdexcept>

namespace Foam::misfit
{

namespace
{

//- Half of the last printed digit of each column
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


//- Correlations of pairs of columns that the source of the table states
struct statedCorrelations
{
    List<Pair<word>> pairs;

    scalarList values;
};


statedCorrelations readStated(const dictionary& dict)
{
    keywords::check(dict, {"columns", "values"});
    const statedCorrelations stated
    {
        dict.getOrDefault("columns", List<Pair<word>>()),
        dict.getOrDefault("values", scalarList())
    };
    if (stated.pairs.size() != stated.values.size())
    {
        FatalIOErrorInFunction(dict)
            << "correlations: " << stated.values.size() << " values for "
            << stated.pairs.size() << " pairs of columns; give one for each"
            << exit(FatalIOError);
    }
    return stated;
}


//- Largest difference from them of a table with columns of these names
scalar missed
(
    const statedCorrelations& stated,
    const mat& table,
    const wordList& names
)
{
    scalar most = 0;
    forAll(stated.pairs, i)
    {
        const scalar r = statistics::correlation
        (
            table.col(names.find(stated.pairs[i].first())),
            table.col(names.find(stated.pairs[i].second()))
        );
        most = max(most, mag(r - stated.values[i]));
    }
    return most;
}


//- The first so many columns are those of the identity
explanation explained
(
    const columnFault& fault,
    const statedCorrelations& stated,
    const mat& table,
    const wordList& names,
    const label nOfIdentity
)
{
    const statistics::rowSources back(statistics::inverse(fault.sources));
    mat column(table);
    mat others(table);
    for (label c = 0; c < nOfIdentity; ++c)
    {
        const bool isIt = c == fault.column;
        (isIt ? column : others).col(c) =
            table.col(c)(isIt ? fault.sources : back);
    }
    return {fault, missed(stated, column, names), missed(stated, others, names)};
}


//- The identity; all other keywords are checked, too
statistics::identity readIdentity(const dictionary& dict)
{
    keywords::check
    (
        dict,
        {
            "FoamFile", "table", "factors", "identity", "roundings", "tolerance",
            "chance", "correlations"
        }
    );
    const dictionary& identity = dict.subDict("identity");
    keywords::check(identity, {"quantity", "formula"});
    return {identity.get<word>("quantity"), identity.get<string>("formula")};
}


//- Largest chance at which an exchange is named
scalar readChance(const dictionary& dict)
{
    const scalar chance = dict.getOrDefault<scalar>("chance", 0.001);
    if (chance <= 0 || chance > 1)
    {
        FatalIOErrorInFunction(dict)
            << "chance is " << chance << "; it is a probability, above 0 and at"
            << " most 1" << exit(FatalIOError);
    }
    return chance;
}


//- Lines of the rows that miss the identity
std::vector<int> linesOfMissing
(
    const statistics::columnFaults& faults,
    const std::vector<int>& lines,
    const label nRows
)
{
    std::vector<int> missing;
    for (label i = 0; i < nRows; ++i)
    {
        if (!faults.holds(i))
        {
            missing.push_back(lines[i]);
        }
    }
    return missing;
}

} // End anonymous namespace


tableCheck::tableCheck(const dictionary& dict)
{
    statistics::identity law(readIdentity(dict));
    const scalar limit = readChance(dict);
    file = dict.get<fileName>("table");
    factors = dict.get<wordList>("factors");
    for (const std::string& name : law.columns())
    {
        columns.append(name);
    }
    const statedCorrelations stated(readStated(keywords::sub(dict, "correlations")));
    hasStated = stated.pairs.size();

    wordList names(columns);
    for (const Pair<word>& pair : stated.pairs)
    {
        names.append(pair.first());
        names.append(pair.second());
    }
    names.append(factors);
    const statistics::textTable text(statistics::readTable(file));
    const mat numbers = text.whole({names.begin(), names.end()});
    lines = text.lines;
    const statistics::factorialTable factorial
    (
        numbers.rightCols(factors.size())
    );
    levels = factorial.levels();
    const statistics::columnFaults faults
    (
        factorial,
        law,
        {numbers.leftCols(columns.size()), lines},
        readRoundings(dict.subDict("roundings"), columns),
        dict.getOrDefault<scalar>("tolerance", 0.01)
    );
    missing = linesOfMissing(faults, lines, factorial.nRows());
    printed = faults.asPrinted();
    attempts = faults.attempts();
    if (attempts.empty())
    {
        throw std::invalid_argument("it has one row alone; an exchange takes two");
    }
    verdict =
        printed.match.exact == factorial.nRows() ? verdictKind::none
      : faults.isLikely(attempts.front(), limit) ? verdictKind::registration
      : verdictKind::unknown;
    for (const columnFault& fault : attempts)
    {
        if (fault.match.exact == attempts.front().match.exact)
        {
            best.push_back
            (
                explained(fault, stated, numbers, names, columns.size())
            );
        }
    }
}

} // End namespace Foam::misfit
