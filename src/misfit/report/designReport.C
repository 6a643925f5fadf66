// SPDX-License-Identifier: GPL-3.0-or-later
// The design of an experiment for people and programs.

#include "designReport.H"
#include "textFile.H"
#include "words.H"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Of the record: grows with each change of what its keys are or mean
constexpr label schema = 3;


//- "nothing wrong", or the mechanism
string causeOf(const designRow& r)
{
    return r.mechanism.empty() ? string("nothing wrong") : string(r.mechanism);
}


//- An answer: its mechanisms or the channel that it blames
string inWords(const std::vector<word>& answer)
{
    return answer.empty() ? string("none") : joined(answer, " and ");
}


//- What stands in answers most often besides what is right; empty: nothing
string mostOften(const designRow& r)
{
    const auto most = std::max_element
    (
        r.others.begin(), r.others.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; }
    );
    return
        most == r.others.end()
      ? string()
      : inWords(most->first) + " (" + percentWords(r.share(most->second)) + ')';
}


json rowRecord(const designRow& r)
{
    json others = json::array();
    for (const auto& [names, n] : r.others)
    {
        others.push_back({{"names", names}, {"fraction", r.share(n)}});
    }
    return
    {
        {"mechanism", r.mechanism},
        {"strength", r.strength},
        {"repeats", r.repeats},
        {"draws", r.draws},
        {"detected", r.share(r.detected)},
        {"named", r.share(r.named)},
        {"inSet", r.share(r.inSet)},
        {"wrong", r.share(r.wrong)},
        {"none", r.share(r.none)},
        {"unknown", r.share(r.unknown)},
        {"confidence", r.confidence()},
        {"BrierScore", r.BrierScore()},
        {"others", others}
    };
}


json optionRecord(const designOption& o)
{
    return
    {
        {"channel", o.channel},
        {"namedWithout", o.before},
        {"namedWith", o.after},
        {"gain", o.gain()},
        {"standardError", o.gains.size() > 1 ? json(o.standardError()) : json()},
        {"tiedForFirst", o.isTied},
        {"rows", each(o.rows, &rowRecord)}
    };
}


//- Mechanisms and strengths in their order, each once
std::vector<const designRow*> causes(const experimentDesign& d)
{
    std::vector<const designRow*> all;
    for (const designRow& r : d.rows)
    {
        if (r.mechanism.size() && r.repeats == d.rows.first().repeats)
        {
            all.push_back(&r);
        }
    }
    return all;
}


//- Largest number of repeats tried
label mostRepeats(const experimentDesign& d)
{
    return d.rows.empty() ? 0 : d.rows.last().repeats;
}


string repeatsWords(const experimentDesign& d, const designRow& r)
{
    const label n = d.repeatsNeeded(r.mechanism, r.strength);
    return n ? Foam::name(n) : "more than " + Foam::name(mostRepeats(d));
}


//- Of the rows: a row in words
json rowWords(const designRow& r, const experimentDesign& d)
{
    return
    {
        {"cause", causeOf(r)},
        {"strength", r.mechanism.empty() ? string("-") : numberWords(r.strength)},
        {"repeats", Foam::name(r.repeats)},
        {"detected", percentWords(r.share(r.detected))},
        {"named", r.mechanism.empty() ? string("-") : percentWords(r.share(r.named))},
        {"inSet", r.mechanism.empty() ? string("-") : percentWords(r.share(r.inSet))},
        {"wrong", percentWords(r.share(r.wrong))},
        {"none", percentWords(r.share(r.none))},
        {"unknown", percentWords(r.share(r.unknown))},
        {"confidence", percentWords(r.confidence())},
        {"Brier", numberWords(r.BrierScore(), 2)},
        {"others", mostOften(r)},
        {"needed", r.mechanism.empty() ? string("-") : repeatsWords(d, r)}
    };
}


//- Twice the standard deviation of a fraction of one half, in whole percent
string accuracy(const experimentDesign& d)
{
    const label n = d.rows.empty() ? 1 : d.rows.first().draws;
    return percentWords(1/std::sqrt(scalar(max(n, label(1)))));
}


//- Standard error of what a channel adds, in percentage points
string errorOf(const designOption& o)
{
    return
        o.gains.size() > 1 ? numberWords(100*o.standardError(), 2) : string("unknown");
}


//- What a channel adds, and whether others are as good
string gainWords(const designOption& o)
{
    return
        " (" + numberWords(100*o.gain(), 2) + " +- " + errorOf(o) + " points)"
      + (o.isTied ? ", tied for the first" : "");
}


//- A cell of a table on the terminal
void writeCell(std::ostream& os, const std::string& text, const int width)
{
    os << std::left << std::setw(width) << text << ' ';
}

} // End anonymous namespace


Foam::misfit::json
Foam::misfit::designRecord(const experimentDesign& d, const string& title)
{
    json needed = json::array();
    for (const designRow* r : causes(d))
    {
        const label n = d.repeatsNeeded(r->mechanism, r->strength);
        needed.push_back
        ({
            {"mechanism", r->mechanism},
            {"strength", r->strength},
            {"repeats", n ? json(n) : json()}
        });
    }
    return
    {
        {"schema", schema},
        {"case", title},
        {"channels", d.channels},
        {"probability", d.probability},
        {"rows", each(d.rows, &rowRecord)},
        {"repeatsNeeded", needed},
        {"options", each(d.options, &optionRecord)},
        {"failing", each(d.failing, [](const word& name) { return name; })}
    };
}


std::string Foam::misfit::designTable(const experimentDesign& d)
{
    std::ostringstream os;
    const int widths[] = {16, 9, 8, 9, 7, 8, 7, 7, 8, 11, 6, 11};
    const auto line = [&](const std::vector<std::string>& cells)
    {
        for (size_t i = 0; i < cells.size(); ++i)
        {
            writeCell(os, cells[i], i < std::size(widths) ? widths[i] : 0);
        }
        os << '\n';
    };
    os << "Recorded channels: " << joined(d.channels, " ") << ". Fractions are +- "
        << accuracy(d) << " (95 %).\n";
    line
    ({
        "cause", "strength", "repeats", "detected", "named", "in a set", "wrong", "none",
        "unknown", "confidence", "Brier", "needed", "other answer"
    });
    for (const designRow& r : d.rows)
    {
        const json w(rowWords(r, d));
        std::vector<std::string> cells;
        for
        (
            const char* key :
            {
                "cause", "strength", "repeats", "detected", "named", "inSet", "wrong",
                "none", "unknown", "confidence", "Brier", "needed", "others"
            }
        )
        {
            cells.push_back(w[key].get<std::string>());
        }
        line(cells);
    }
    os << "needed: fewest repeats that were tried and give the right name with"
        << " probability " << numberWords(d.probability) << '\n';
    for (const designOption& o : d.options)
    {
        os << "Adding the channel " << o.channel << " changes right names from "
            << percentWords(o.before) << " to " << percentWords(o.after)
            << gainWords(o) << '\n';
    }
    if (d.failing.size())
    {
        os << "No rows, as each run with them failed: " << joined(d.failing, ", ")
            << ". Correct these candidates and start again\n";
    }
    return os.str();
}


std::string
Foam::misfit::designHtml(const experimentDesign& d, const string& title)
{
    json page =
    {
        {"case", title},
        {"channels", joined(d.channels, ", ")},
        {"accuracy", accuracy(d)},
        {"draws", Foam::name(d.rows.empty() ? 0 : d.rows.first().draws)},
        {"probability", percentWords(d.probability)},
        {"rows", each(d.rows, [&d](const designRow& r) { return rowWords(r, d); })}
    };
    page["options"] = each(d.options, [](const designOption& o) -> json
    {
        return
        {
            {"channel", o.channel},
            {"before", percentWords(o.before)},
            {"after", percentWords(o.after)},
            {"gain", numberWords(100*o.gain(), 2)},
            {"error", errorOf(o)},
            {"tied", o.isTied}
        };
    });
    page["failing"] = joined(d.failing, ", ");
    return fillTemplate("design.html", page);
}


void Foam::misfit::writeDesign
(
    const experimentDesign& d,
    const fileName& folder,
    const string& title
)
{
    writeWhole(folder/"design.html", designHtml(d, title));
    writeWhole(folder/"design.json", designRecord(d, title).dump(2) + '\n');
}
