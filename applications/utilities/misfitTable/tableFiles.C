// SPDX-License-Identifier: GPL-3.0-or-later

#include "tableFiles.H"
#include "tableColumns.H"
#include "tableWords.H"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace Foam::misfit
{

namespace
{

using statistics::identityMatch;

//- Of a column and kind of exchange as many are written
constexpr int nBest = 3;


nlohmann::json jsonOf(const identityMatch& match)
{
    return
    {
        {"exact", match.exact},
        {"within", match.within},
        {"meanDifference", match.meanDifference}
    };
}


nlohmann::json jsonOf(const tableCheck& check, const columnFault& fault)
{
    nlohmann::json result =
    {
        {"column", check.columns()[fault.column]},
        {"exchange", describe(check, fault)},
        {"match", jsonOf(fault.match)},
        {"chance", fault.chance}
    };
    if (check.hasStated())
    {
        result["correlations"] =
        {
            {"columnMoved", check.columnMoved(fault)},
            {"othersMoved", check.othersMoved(fault)}
        };
    }
    return result;
}


void writeLine
(
    std::ostream& os,
    const string& head,
    const identityMatch& match,
    const string& tail
)
{
    os  << head << ',' << match.exact << ',' << match.within << ','
        << match.meanDifference << ',' << tail << '\n';
}

} // End anonymous namespace


void writeJson(const tableCheck& check, std::ostream& os)
{
    nlohmann::json result =
    {
        {"schema", "misfitTable 1"},
        {"table", check.file()},
        {"rows", check.factorial().nRows()},
        {"verdict", nameOf(check.verdict())},
        {"tried", check.tried().size()},
        {"asPrinted", jsonOf(check.printed().match)},
        {"faults", nlohmann::json::array()}
    };
    if (check.verdict() == tableVerdict::registration)
    {
        for (const columnFault& fault : check.best())
        {
            result["faults"].push_back(jsonOf(check, fault));
        }
    }
    os << result.dump(4) << '\n';
}


void writeTried(const tableCheck& check, std::ostream& os)
{
    os << "column,kind,exact,within,meanDifference,chance,exchange\n";
    writeLine(os, "none,none", check.printed().match, ",");
    std::map<std::pair<int, statistics::columnFaultKind>, int> nWritten;
    for (const columnFault& one : check.tried())
    {
        if (nWritten[{one.column, one.kind}]++ < nBest)
        {
            std::ostringstream tail;
            tail << one.chance << ",\"" << describe(check, one) << '"';
            writeLine
            (
                os,
                check.columns()[one.column]
              + (
                    one.kind == statistics::columnFaultKind::labels
                  ? ",labels"
                  : ",rows"
                ),
                one.match,
                tail.str()
            );
        }
    }
}


void writeCorrected
(
    const tableCheck& check,
    const columnFault& fault,
    std::ostream& os
)
{
    std::ifstream is(check.file());
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(is, line);)
    {
        const auto cells = statistics::cellsOf(line);
        if (cells.size() > 1)
        {
            rows.push_back(cells);
        }
    }

    // Below the names the cell as printed, to its last digit, from its row
    const auto& names = rows.front();
    const label column =
        std::find(names.begin(), names.end(), check.columns()[fault.column])
      - names.begin();
    const auto printed = rows;
    for (label i = 0; i < statistics::count(fault.sources); ++i)
    {
        rows[i + 1][column] = printed[fault.sources[i] + 1][column];
    }
    for (const auto& row : rows)
    {
        for (size_t i = 0; i < row.size(); ++i)
        {
            os << (i ? "," : "") << row[i];
        }
        os << '\n';
    }
}

} // End namespace Foam::misfit
