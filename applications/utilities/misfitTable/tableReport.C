// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a check of a table, for people and for programs.

#include "tableCheck.H"
#include "tableColumns.H"
#include "words.H"

#include <algorithm>
#include <map>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using statistics::columnFaultKind;
using statistics::identityMatch;

//- Largest number of exchanges written for each column and kind
constexpr int nBest = 3;


//- Largest number of rows reported that miss the identity
constexpr int nListed = 5;


//- "line 11", "lines 5 and 20", "lines 2, 3, 4, 6, 7 and others"
string inLines(const std::vector<int>& lines)
{
    wordList all;
    for (const int line : lines)
    {
        if (all.size() < nListed)
        {
            all.append(Foam::name(line));
        }
    }
    if (all.size() < count(lines))
    {
        all.append("others");
    }
    return (lines.size() == 1 ? "line " : "lines ") + inWords(all, "and");
}


string percent(const scalar share)
{
    return numberWords(100*share, 2) + " %";
}


//- "the labels D and M are exchanged; of V the levels 1 2 are taken for 2 1"
string ofLabels(const tableCheck& check, const statistics::labelArrangement& labels)
{
    wordList from;
    wordList to;
    std::vector<string> parts;
    forAll(check.factors, f)
    {
        if (labels.factors[f] != f)
        {
            from.append(check.factors[f]);
            to.append(check.factors[labels.factors[f]]);
        }
        const auto& levels = check.levels[f];
        const auto& order = labels.levels[f];
        if (!std::is_sorted(order.begin(), order.end()))
        {
            const auto level = [&](const int i) { return numberWords(levels[i], 6); };
            auto all(order);
            std::sort(all.begin(), all.end());
            parts.push_back
            (
                "of " + check.factors[f] + " the levels " + joined(all, " ", level)
              + " are taken for " + joined(order, " ", level)
            );
        }
    }
    if (from.size())
    {
        const string what
        (
            from.size() == 2
          ? string("exchanged") : "taken for " + inWords(to, "and")
        );
        parts.insert
        (
            parts.begin(), "the labels " + inWords(from, "and") + " are " + what
        );
    }
    return joined(parts, "; ");
}


//- What is exchanged, as "U: the labels D and M are exchanged"
string exchange(const tableCheck& check, const columnFault& fault)
{
    const string column(check.columns[fault.column] + ": ");
    if (fault.kind == columnFaultKind::labels)
    {
        return column + ofLabels(check, fault.labels);
    }
    std::vector<int> lines;
    for (int i = 0; i < count(fault.sources); ++i)
    {
        if (fault.sources[i] != i)
        {
            lines.push_back(check.lines[i]);
        }
    }
    const auto number = [](const int line) { return std::to_string(line); };
    return
        column + "the numbers of lines " + joined(lines, " and ", number)
      + " are exchanged";
}


string reportOne(const tableCheck& check, const explanation& one)
{
    const columnFault& fault = one.fault;
    const word& column = check.columns[fault.column];
    wordList others;
    for (const word& name : check.columns)
    {
        if (name != column)
        {
            others.append(name);
        }
    }
    std::ostringstream os;
    os  << exchange(check, fault) << '\n'
        << "    " << percent(check.printed.match.meanDifference) << " before, "
        << percent(fault.match.meanDifference) << " after, on the mean; "
        << fault.match.exact << " of " << check.lines.size()
        << " rows hold the identity as exactly as digits are printed, "
        << fault.match.within << " within the tolerance.\n"
        << "    That one of the " << check.attempts.size()
        << " exchanges tried does so by chance: " << numberWords(fault.chance, 3)
        << "\n    The identity holds as well if " << column << " stands right and "
        << inWords(others, "and") << " stand at the exchanged labels.\n";
    if (check.hasStated)
    {
        os  << "    The correlations that the source states are missed by "
            << numberWords(one.columnMoved, 2) << " at most in the first case, by "
            << numberWords(one.othersMoved, 2) << " in the second: they speak for the "
            << (one.isOfColumn() ? "first" : "second") << ".\n";
    }
    return os.str();
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


json jsonOf(const tableCheck& check, const explanation& one)
{
    json result =
    {
        {"column", check.columns[one.fault.column]},
        {"exchange", exchange(check, one.fault)},
        {"match", jsonOf(one.fault.match)},
        {"chance", one.fault.chance}
    };
    if (check.hasStated)
    {
        result["correlations"] =
        {
            {"columnMoved", one.columnMoved}, {"othersMoved", one.othersMoved}
        };
    }
    return result;
}

} // End anonymous namespace


Foam::string Foam::misfit::report(const tableCheck& check)
{
    const label n = check.lines.size();
    std::ostringstream os;
    os << verdictNames[check.verdict] << ": ";
    if (check.verdict == verdictKind::none)
    {
        os << "all " << n << " rows hold the identity\n";
    }
    else if (check.verdict == verdictKind::unknown)
    {
        const columnFault& first = check.attempts.front();
        os  << n - check.printed.match.exact << " of " << n
            << " rows miss the identity by more than"
            << " rounding (" << inLines(check.missing)
            << "), and no exchange of labels explains it. The nearest of "
            << check.attempts.size() << ", with a chance of "
            << numberWords(first.chance, 3) << ":\n    " << exchange(check, first)
            << '\n';
    }
    else
    {
        if (check.best.size() > 1)
        {
            os  << "one of " << check.best.size()
                << " exchanges that explain as many rows:\n";
        }
        for (const explanation& one : check.best)
        {
            os << reportOne(check, one);
        }
    }
    return os.str();
}


std::string Foam::misfit::tableJson(const tableCheck& check)
{
    const bool named = check.verdict == verdictKind::registration;
    const auto one = [&](const explanation& e) { return jsonOf(check, e); };
    const nlohmann::json all =
    {
        {"schema", "misfitTable 1"},
        {"table", check.file},
        {"rows", check.lines.size()},
        {"verdict", verdictNames[check.verdict]},
        {"tried", check.attempts.size()},
        {"asPrinted", jsonOf(check.printed.match)},
        {"missing", check.missing},
        {"faults", named ? each(check.best, one) : json::array()}
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
    match(check.printed.match);
    os << ",\n";
    std::map<std::pair<int, columnFaultKind>, int> nWritten;
    for (const columnFault& one : check.attempts)
    {
        if (nWritten[{one.column, one.kind}]++ < nBest)
        {
            os  << check.columns[one.column]
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
    // The cell as printed, to its last digit, from its row
    const statistics::textTable printed(statistics::readTable(check.file));
    const label column = printed.find(check.columns[fault.column]);
    auto rows = printed.rows;
    for (label i = 0; i < count(fault.sources); ++i)
    {
        rows[i][column] = printed.rows[fault.sources[i]][column];
    }
    rows.insert(rows.begin(), printed.names);
    return joined(rows, "", [](const auto& row) { return joined(row, ",") + '\n'; });
}
