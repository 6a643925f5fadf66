// SPDX-License-Identifier: GPL-3.0-or-later

#include "tableWords.H"

#include <algorithm>
#include <sstream>

namespace Foam::misfit
{

namespace
{

using statistics::identityMatch;

string percent(const scalar share)
{
    std::ostringstream os;
    os.precision(2);
    os << 100*share << " %";
    return os.str();
}


// Numbers of levels or factors in their order
bool isUnchanged(const std::vector<int>& order)
{
    return std::is_sorted(order.begin(), order.end());
}


// "D and M", or "D, M and V"
string listed(const wordList& names)
{
    string result;
    forAll(names, i)
    {
        result += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    }
    return result;
}


string ofFactors(const tableCheck& check, const std::vector<int>& factors)
{
    wordList from;
    wordList to;
    for (label f = 0; f < statistics::count(factors); ++f)
    {
        if (factors[f] != f)
        {
            from.append(check.factors()[f]);
            to.append(check.factors()[factors[f]]);
        }
    }
    return
        from.size() == 2
      ? "the labels " + listed(from) + " are exchanged"
      : "the labels " + listed(from) + " are taken for " + listed(to);
}


string ofLevels
(
    const word& factor,
    const std::vector<double>& levels,
    const std::vector<int>& order
)
{
    std::ostringstream os;
    os << "of " << factor << " the levels";
    for (const double level : levels)
    {
        os << ' ' << level;
    }
    os << " are taken for";
    for (const int i : order)
    {
        os << ' ' << levels[i];
    }
    return os.str();
}


string ofLabels(const tableCheck& check, const columnFault& fault)
{
    std::vector<string> parts;
    if (!isUnchanged(fault.labels.factors))
    {
        parts.push_back(ofFactors(check, fault.labels.factors));
    }
    forAll(check.factors(), f)
    {
        if (!isUnchanged(fault.labels.levels[f]))
        {
            parts.push_back
            (
                ofLevels
                (
                    check.factors()[f],
                    check.factorial().levels()[f],
                    fault.labels.levels[f]
                )
            );
        }
    }
    string result;
    for (const string& part : parts)
    {
        result += (result.empty() ? "" : "; ") + part;
    }
    return result;
}


// The first line of the table is that of names
string ofRows(const columnFault& fault)
{
    std::ostringstream os;
    os << "the numbers of lines";
    bool first = true;
    for (int i = 0; i < statistics::count(fault.sources); ++i)
    {
        if (fault.sources[i] != i)
        {
            os << (first ? " " : " and ") << i + 2;
            first = false;
        }
    }
    os << " are exchanged";
    return os.str();
}


wordList otherColumns(const tableCheck& check, const columnFault& fault)
{
    const wordList columns(check.columns());
    wordList others;
    forAll(columns, i)
    {
        if (i != fault.column)
        {
            others.append(columns[i]);
        }
    }
    return others;
}


string reportOthers(const tableCheck& check, const columnFault& fault)
{
    std::ostringstream os;
    os.precision(2);
    os << "    The identity holds as well if " << check.columns()[fault.column]
        << " stands right and " << listed(otherColumns(check, fault))
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
    os  << describe(check, fault) << '\n'
        << "    " << percent(check.printed().match.meanDifference) << " before, "
        << percent(fault.match.meanDifference) << " after, on the mean; "
        << fault.match.exact << " of " << check.factorial().nRows()
        << " rows hold the identity as exactly as digits are printed, "
        << fault.match.within << " within the tolerance.\n"
        << "    That one of the " << check.tried().size()
        << " exchanges tried does so by chance: " << fault.chance << '\n';
    return os.str() + reportOthers(check, fault);
}


} // End anonymous namespace


const char* nameOf(const tableVerdict verdict)
{
    switch (verdict)
    {
        case tableVerdict::none: return "none";
        case tableVerdict::registration: return "registration";
        case tableVerdict::unknown: break;
    }
    return "unknown";
}


string describe(const tableCheck& check, const columnFault& fault)
{
    return
        check.columns()[fault.column] + ": "
      + (
            fault.kind == statistics::columnFaultKind::labels
          ? ofLabels(check, fault)
          : ofRows(fault)
        );
}


string report(const tableCheck& check)
{
    const identityMatch& printed = check.printed().match;
    std::ostringstream os;
    os.precision(3);
    os << nameOf(check.verdict()) << ": ";
    if (check.verdict() == tableVerdict::none)
    {
        os << "all " << check.factorial().nRows() << " rows hold the identity\n";
        return os.str();
    }
    if (check.verdict() == tableVerdict::unknown)
    {
        const columnFault& first = check.tried().front();
        os  << check.factorial().nRows() - printed.exact << " of "
            << check.factorial().nRows() << " rows miss the identity by more than"
            << " rounding, and no exchange of labels explains it. The nearest of "
            << check.tried().size() << ", with a chance of " << first.chance
            << ":\n    " << describe(check, first) << '\n';
        return os.str();
    }
    const std::vector<columnFault> faults = check.best();
    if (faults.size() > 1)
    {
        os << "one of " << faults.size() << " exchanges that explain as many rows:\n";
    }
    for (const columnFault& fault : faults)
    {
        os << reportFault(check, fault);
    }
    return os.str();
}

} // End namespace Foam::misfit
