// SPDX-License-Identifier: GPL-3.0-or-later
// report.html: a diagnosis for a reader who has five minutes.

#include "report.H"

#include "base64Layer.H"

#include <cmath>
#include <fstream>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

using row = std::vector<std::string>;


std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text)
    {
        safe +=
            c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;"
          : std::string(1, c);
    }
    return safe;
}


std::string table(const row& head, const std::vector<row>& rows)
{
    std::string text("<table>\n<tr>");
    for (const std::string& cell : head)
    {
        text += "<th>" + escaped(cell) + "</th>";
    }
    text += "</tr>\n";
    for (const row& r : rows)
    {
        text += "<tr>";
        for (const std::string& cell : r)
        {
            text += "<td>" + escaped(cell) + "</td>";
        }
        text += "</tr>\n";
    }
    return text + "</table>\n";
}


std::string header(const std::string& title)
{
    return
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<title>" + escaped(title) + "</title>\n<style>"
        "body{font:16px/1.5 sans-serif;max-width:62em;margin:2em auto;"
        "padding:0 1em;color:#222}"
        "table{border-collapse:collapse;margin:.5em 0}"
        "td,th{border-bottom:1px solid #ccc;padding:.2em .8em;text-align:left}"
        "img{max-width:100%}.verdict{background:#eef3f8;padding:1em;"
        "font-size:1.2em}h2{margin-top:2em}</style></head><body>\n"
        "<h1>" + escaped(title) + "</h1>\n";
}


std::string figure(const fileName& file, const std::string& words)
{
    std::ifstream is(file, std::ios::binary);
    const std::string bytes
    (
        (std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>()
    );
    std::ostringstream os;
    base64Layer encode(os);
    encode.write(bytes.data(), bytes.size());
    encode.close();
    return
        "<p><img alt=\"" + escaped(words) + "\" src=\"data:image/png;base64,"
      + os.str() + "\"><br>" + escaped(words) + "</p>\n";
}


std::string percent(const scalar share)
{
    return shortNumber(std::round(100*share)) + " %";
}


std::string channels(const heldOut& h)
{
    std::string names;
    for (const segment& s : h.data.segments)
    {
        names += (names.empty() ? "" : " ") + s.name;
    }
    return names;
}


//- What the finding does to the misfit of held-out data
std::string gone(const heldOut& h)
{
    // A mean square of 1 is chance
    if (h.squareBefore < beyondChance)
    {
        return
            h.squareAfter < beyondChance
          ? "there was no misfit beyond chance: it neither confirms nor denies"
          : "a misfit comes that was not there";
    }
    const scalar share = removed(h);
    return
        share > 0 ? percent(share) + " of the misfit is gone"
      : "the misfit does not get smaller";
}


std::string verdict(const finding& f)
{
    std::string text
    (
        "<div class=\"verdict\"><b>" + escaped(f.verdict) + ".</b> "
      + escaped(f.told) + "<br>Confidence " + percent(f.confidence)
    );
    for (const heldOut& h : f.held)
    {
        const bool faultIsShown =
            f.blamesChannel() && h.squareAfter < h.squareBefore;
        if (f.strengths.size() || faultIsShown)
        {
            text +=
                "<br>At " + escaped(h.what + " (" + channels(h) + ")")
              + ", not used to find it, " + gone(h)
              + " (mean square over what is uncertain: from "
              + shortNumber(h.squareBefore) + " to "
              + shortNumber(h.squareAfter) + ").";
        }
    }
    if (f.answer.size())
    {
        text +=
            "<br>The case with it switched on, ready to run: <code>misfit/"
          + std::string(correctedCase) + "</code>.";
    }
    return text + "</div>\n";
}


std::string where(const finding& f)
{
    std::string text("<h2>Where and when they part</h2>\n");
    if (f.located.empty())
    {
        return text + "<p>Nowhere beyond what is uncertain.</p>\n";
    }
    // Where mechanisms are named, what they change counts too
    text +=
        f.strengths.size() && !f.explanations.first().what.unknown
      ? "<p>Where what was found acts, the clearest first; the sizes are those of"
        " the calibrated simulation against the recording:</p>\n<ol>\n"
      : "<p>Calibrated simulation against recording, the clearest first:"
        "</p>\n<ol>\n";
    forAll(f.located, i)
    {
        if (i < 5)
        {
            text += "<li>" + escaped(f.located[i]) + "</li>\n";
        }
    }
    return text + "</ol>\n";
}


//- What is at its bound has no deviation
std::string within(const scalar value, const scalar deviation, const bool pinned)
{
    return
        shortNumber(value)
      + (pinned ? " (bound)" : " +- " + shortNumber(deviation));
}


std::string calibration(const finding& f)
{
    std::vector<row> rows;
    const bool changed = f.names.size() && !f.correction.named;
    const fitted& with = f.explanations.first().best;
    forAll(f.parameters, i)
    {
        const calibrated& p = f.parameters[i];
        rows.push_back
        ({
            p.name,
            shortNumber(p.before) + " +- " + shortNumber(p.prior),
            within(p.value, p.deviation, p.pinned),
            p.pinned ? "at its bound: the base model strains" : "",
            changed
          ? within(with.x[i], with.deviation(i), with.pinned[i])
          : ""
        });
    }
    return
        "<h2>Calibration before blame</h2>\n<p>What the base model may set by"
        " itself was fitted first. The chance of such a misfit by accident was "
      + shortNumber(f.raw.p) + " before and is " + shortNumber(f.detection.p)
      + " after.</p>\n"
      + (rows.empty() ? std::string("<p>It has no such parameter.</p>\n")
          : table
            (
                {
                    "parameter (+- one standard deviation)", "expected",
                    "fitted by itself", "", "fitted with what was found"
                },
                rows
            ));
}


std::string two(const scalar value)
{
    std::ostringstream os;
    os.precision(2);
    os << value;
    return os.str();
}


//- What is uncertain at each channel, and where that comes from
std::string uncertain(const finding& f)
{
    row head{"channel", "whole"};
    for (const uncertaintySource& source : f.sources)
    {
        head.push_back(source.first());
    }
    std::vector<row> rows;
    for (const segment& s : f.data.segments)
    {
        row r{s.name + " " + unitOf(s.quantity), two(s.rootMeanSquare(f.sigma))};
        for (const uncertaintySource& source : f.sources)
        {
            r.push_back(two(s.rootMeanSquare(source.second())));
        }
        rows.push_back(r);
    }
    return
        "<h2>What is uncertain</h2>\n<p>One standard deviation between recording and"
        " simulation with nothing wrong, root mean square over the record, and what"
        " it is made of (between the runs: of states that lie between those that were"
        " computed). Where a mesh outweighs the sensors, a finer one sees more, or places"
        " amid cells of both; where packings do, more of them.</p>\n"
      + table(head, rows);
}


std::string explanations(const finding& f, const wordList& names)
{
    std::vector<row> rows;
    const std::string answer = told(f.explanations.first().what, names);
    List<weighed> list(f.explanations);
    sortByScore(list);

    // The same fault may be there with several sizes
    bool judged = false;
    for (const weighed& w : list)
    {
        const std::string name = told(w.what, names);
        if (rows.size() < 8)
        {
            rows.push_back
            ({
                name + (name == answer && !judged ? " (judged below)" : ""),
                shortNumber(w.score - list.first().score),
                percent(w.probability)
            });
            judged = judged || name == answer;
        }
    }
    return
        "<h2>Explanations that were weighed</h2>\n<p>"
      + std::to_string(f.explanations.size()) + " were fitted in the same way."
        " The score behind the best counts misfit, and each further unknown"
        " against it; 6 behind is 20 times less likely.</p>\n"
      + table({"explanation", "score behind the best", "probability"}, rows);
}


std::string gates(const finding& f)
{
    std::vector<row> rows;
    for (const misfit::gate& g : f.gates)
    {
        rows.push_back
        ({
            g.name, g.asked, g.applies ? g.value : "", g.applies ? g.bound : "",
            !g.applies ? "nothing to ask"
          : g.passed ? "passed"
          : g.name == "detection" ? "no misfit beyond chance" : "failed"
        });
    }
    return
        "<h2>What the answer had to pass</h2>\n"
      + table({"gate", "asked", "value", "must be", ""}, rows);
}


std::string apart(const finding& f)
{
    if (f.candidates.empty())
    {
        return "";
    }
    row head(1, "");
    head.insert(head.end(), f.candidates.begin(), f.candidates.end());
    std::vector<row> rows;
    forAll(f.candidates, i)
    {
        row r(1, f.candidates[i]);
        for (label j = 0; j < f.apart.cols(); ++j)
        {
            r.push_back(shortNumber(f.apart(i, j)));
        }
        rows.push_back(r);
    }
    return
        "<h2>What these channels can tell apart</h2>\n<p>Effect of each"
        " mechanism, at the second of its strengths, that the one of the column, at whatever"
        " strength, cannot imitate, in standard deviations. On the diagonal the"
        " whole effect. Below 3: not to be told apart. A diagonal"
        " below 1: these channels do not see it, or the solver does not read"
        " what it changes. A mechanism that does the opposite imitates nothing.</p>\n"
      + table(head, rows);
}


std::string freeCorrection(const correctionFound& c)
{
    if (!c.asked)
    {
        return "";
    }
    std::string text
    (
        "<h2>A free correction</h2>\n<p>No candidate explains what is missing, so"
        " a correction without a mechanism was fitted: " + escaped(c.told)
      + " It gains " + shortNumber(c.gain) + " in score.</p>\n"
    );
    std::vector<row> rows;
    for (const correctionFound::part& p : c.parts)
    {
        rows.push_back
        ({
            p.words, shortNumber(p.value) + " +- " + shortNumber(2*p.deviation)
        });
    }
    text += rows.empty() ? "" : table({"what it acts like", "value (95 %)"}, rows);
    rows.clear();
    for (const correctionFound::law& l : c.laws)
    {
        if (rows.size() < 5)
        {
            rows.push_back({l.words, shortNumber(l.lead)});
        }
    }
    text +=
        rows.empty() ? ""
      : table({"laws in dimensionless numbers", "score ahead of it"}, rows);
    rows.clear();
    for (const heldOut& h : c.held)
    {
        rows.push_back
        ({
            h.what + " (" + channels(h) + ")", shortNumber(h.squareBefore),
            shortNumber(h.squareAfter), percent(removed(h))
        });
    }
    return
        text
      + (rows.empty() ? std::string()
          : table({"not used to find it", "mean square before", "after", "gone"}, rows));
}


std::string rest(const finding& f)
{
    std::string text;
    if (f.failedRuns.size())
    {
        std::vector<row> rows;
        for (const string& run : f.failedRuns)
        {
            rows.push_back({run});
        }
        text +=
            "<h2>Runs that failed</h2>\n<p>They are not in what is uncertain, or in"
            " the effect of a parameter.</p>\n" + table({"run, and why"}, rows);
    }
    if (f.dropped.size())
    {
        std::vector<row> rows;
        for (const auto& d : f.dropped)
        {
            rows.push_back({d.first(), d.second()});
        }
        text +=
            "<h2>Not compared</h2>\n" + table({"candidate", "why"}, rows);
    }
    if (f.advice.size())
    {
        text +=
            "<h2>What would settle it</h2>\n<p>" + escaped(f.advice)
          + ".</p>\n";
    }
    return text;
}


//- What a picture shows, by the name of its file
std::string caption(const finding& f, const fileName& file)
{
    const std::string name(file.nameLessExt());
    if (name == "map")
    {
        return
            "Each channel over time: red where the recording is higher than the"
            " simulation, blue where it is lower, in standard deviations.";
    }
    if (name == "fitted")
    {
        return "The channels that were fitted.";
    }
    const heldOut& h = f.held[std::stoi(name.substr(7)) - 1];
    return
        "Not used to find it: " + h.what + ". Mean square of the misfit "
      + shortNumber(h.squareBefore)
      + (h.squareBefore == h.squareAfter ? std::string()
          : " before, " + shortNumber(h.squareAfter) + " after")
      + " (1: as good as it can be).";
}

} // End anonymous namespace


std::string Foam::misfit::reportHtml
(
    const finding& f,
    const string& title,
    const List<fileName>& figures
)
{
    std::string series;
    std::string map;
    for (const fileName& file : figures)
    {
        (file.nameLessExt() == "map" ? map : series) +=
            figure(file, caption(f, file));
    }
    return
        header(title) + verdict(f) + "<h2>Before and after</h2>\n" + series
      + where(f) + map + freeCorrection(f.correction) + calibration(f)
      + uncertain(f) + explanations(f, f.library) + gates(f) + apart(f) + rest(f)
      + "<p>States asked for: " + std::to_string(f.nRuns)
      + ". The same in numbers: verdict.json.</p>\n</body></html>\n";
}
