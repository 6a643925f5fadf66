// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a check of a table, for people and for programs.

#include "tableReport.H"
#include "record.H"
#include "report.H"
#include "tableColumns.H"
#include "words.H"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using statistics::columnFaultKind;
using statistics::identityMatch;

//- Of a column and kind of exchange as many are written
constexpr int nBest = 3;


string percent(const scalar share)
{
    return shortNumber(100*share, 2) + " %";
}


string ofFactors(const tableCheck& check, const std::vector<int>& factors)
{
    wordList from;
    wordList to;
    for (label f = 0; f < count(factors); ++f)
    {
        if (factors[f] != f)
        {
            from.append(check.factors()[f]);
            to.append(check.factors()[factors[f]]);
        }
    }
    return
        "the labels " + inWords(from, "and")
      + (
            from.size() == 2
          ? string(" are exchanged") : " are taken for " + inWords(to, "and")
        );
}


string ofLevels
(
    const word& factor,
    const std::vector<double>& levels,
    const std::vector<int>& order
)
{
    const auto number = [](const double level) { return shortNumber(level, 6); };
    return
        "of " + factor + " the levels " + joined(levels, " ", number)
      + " are taken for "
      + joined(order, " ", [&](const int i) { return number(levels[i]); });
}


string ofLabels(const tableCheck& check, const columnFault& fault)
{
    const auto isChanged = [](const std::vector<int>& order)
    {
        return !std::is_sorted(order.begin(), order.end());
    };
    std::vector<string> parts;
    if (isChanged(fault.labels.factors))
    {
        parts.push_back(ofFactors(check, fault.labels.factors));
    }
    forAll(check.factors(), f)
    {
        const std::vector<int>& order = fault.labels.levels[f];
        if (isChanged(order))
        {
            parts.push_back
            (
                ofLevels(check.factors()[f], check.factorial().levels()[f], order)
            );
        }
    }
    return joined(parts, "; ", [](const string& part) { return part; });
}


//- What is exchanged, as "U: the labels D and M are exchanged"
string exchange(const tableCheck& check, const columnFault& fault)
{
    const string column(check.columns()[fault.column] + ": ");
    if (fault.kind == columnFaultKind::labels)
    {
        return column + ofLabels(check, fault);
    }

    // The first line of the table is that of names
    std::vector<int> lines;
    for (int i = 0; i < count(fault.sources); ++i)
    {
        if (fault.sources[i] != i)
        {
            lines.push_back(i + 2);
        }
    }
    const auto number = [](const int line) { return std::to_string(line); };
    return
        column + "the numbers of lines " + joined(lines, " and ", number)
      + " are exchanged";
}


string reportOthers(const tableCheck& check, const columnFault& fault)
{
    const wordList columns(check.columns());
    wordList others;
    for (const word& name : columns)
    {
        if (name != columns[fault.column])
        {
            others.append(name);
        }
    }
    std::ostringstream os;
    os.precision(2);
    os << "    The identity holds as well if " << columns[fault.column]
        << " stands right and " << inWords(others, "and")
        << " stand at the exchanged labels.\n";
    if (check.hasStated())
    {
        os  << "    The correlations that the source states are missed by "
            << check.columnMoved(fault) << " at most in the first case, by "
            << check.othersMoved(fault) << " in the second: they speak for the "
            << (check.columnIsMoved(fault) ? "first" : "second") << ".\n";
    }
    return os.str();
}


string reportFault(const tableCheck& check, const columnFault& fault)
{
    std::ostringstream os;
    os.precision(3);
    os  << exchange(check, fault) << '\n'
        << "    " << percent(check.printed().match.meanDifference) << " before, "
        << percent(fault.match.meanDifference) << " after, on the mean; "
        << fault.match.exact << " of " << check.factorial().nRows()
        << " rows hold the identity as exactly as digits are printed, "
        << fault.match.within << " within the tolerance.\n"
        << "    That one of the " << check.tried().size()
        << " exchanges tried does so by chance: " << fault.chance << '\n';
    return os.str() + reportOthers(check, fault);
}


json jsonOf(const identityMatch& match)
{
    return
    {
        {"exact", match.exact},
        {"within", match.within},
        {"meanDifference", match.meanDifference}
    };
}


json jsonOf(const tableCheck& check, const columnFault& fault)
{
    json result =
    {
        {"column", check.columns()[fault.column]},
        {"exchange", exchange(check, fault)},
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

} // End anonymous namespace


Foam::string Foam::misfit::report(const tableCheck& check)
{
    const label n = check.factorial().nRows();
    std::ostringstream os;
    os.precision(3);
    os << verdictNames[check.verdict()] << ": ";
    if (check.verdict() == verdictKind::none)
    {
        os << "all " << n << " rows hold the identity\n";
        return os.str();
    }
    if (check.verdict() == verdictKind::unknown)
    {
        const columnFault& first = check.tried().front();
        os  << n - check.printed().match.exact << " of " << n
            << " rows miss the identity by more than"
            << " rounding, and no exchange of labels explains it. The nearest of "
            << check.tried().size() << ", with a chance of " << first.chance
            << ":\n    " << exchange(check, first) << '\n';
        return os.str();
    }
    const std::vector<columnFault> faults(check.best());
    if (faults.size() > 1)
    {
        os << "one of " << faults.size() << " exchanges that explain as many rows:\n";
    }
    const auto one = [&](const columnFault& f) { return reportFault(check, f); };
    return os.str() + joined(faults, "", one);
}


std::string Foam::misfit::tableJson(const tableCheck& check)
{
    const bool named = check.verdict() == verdictKind::registration;
    const auto one = [&](const columnFault& f) { return jsonOf(check, f); };
    const nlohmann::json all =
    {
        {"schema", "misfitTable 1"},
        {"table", check.file()},
        {"rows", check.factorial().nRows()},
        {"verdict", verdictNames[check.verdict()]},
        {"tried", check.tried().size()},
        {"asPrinted", jsonOf(check.printed().match)},
        {"faults", named ? each(check.best(), one) : json::array()}
    };
    return all.dump(4) + '\n';
}


std::string Foam::misfit::triedTable(const tableCheck& check)
{
    std::ostringstream os;
    const auto match = [&os](const identityMatch& m)
    {
        os << ',' << m.exact << ',' << m.within << ',' << m.meanDifference << ',';
    };
    os << "column,kind,exact,within,meanDifference,chance,exchange\nnone,none";
    match(check.printed().match);
    os << ",\n";
    std::map<std::pair<int, columnFaultKind>, int> nWritten;
    for (const columnFault& one : check.tried())
    {
        if (nWritten[{one.column, one.kind}]++ < nBest)
        {
            os  << check.columns()[one.column]
                << (one.kind == columnFaultKind::labels ? ",labels" : ",rows");
            match(one.match);
            os << one.chance << ",\"" << exchange(check, one) << "\"\n";
        }
    }
    return os.str();
}


std::string Foam::misfit::correctedTable
(
    const tableCheck& check,
    const columnFault& fault
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
    for (label i = 0; i < count(fault.sources); ++i)
    {
        rows[i + 1][column] = printed[fault.sources[i] + 1][column];
    }
    const auto cell = [](const std::string& one) { return one; };
    return joined(rows, "", [&](const auto& row) { return joined(row, ",", cell) + '\n'; });
}
