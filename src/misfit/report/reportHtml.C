// SPDX-License-Identifier: GPL-3.0-or-later
// report.html: a diagnosis for a reader who has five minutes; below the answer.

#include "html.H"
#include "report.H"
#include "reportTop.H"
#include "words.H"

#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using namespace Foam::misfit::html;

std::string where(const finding& f)
{
    std::string text("<h2>Where and when they part</h2>\n");
    if (f.located.empty())
    {
        return text + "<p>Nowhere beyond what is uncertain.</p>\n";
    }
    // Where mechanisms are named, what they change counts too
    text +=
        f.strengths.size() && !f.best().what.unknown
      ? "<p>Where what was found acts, the clearest first; the sizes are those of"
        " the calibrated simulation against the recording:</p>\n<ol>\n"
      : "<p>Calibrated simulation against recording, the clearest first:"
        "</p>\n<ol>\n";
    for (label i = 0; i < count(f.located); ++i)
    {
        if (i < 5)
        {
            text += "<li>" + escaped(describe(f.located[i], f.data)) + "</li>\n";
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
    const bool changed = answerOf(f).size() && !f.correction.named;
    const fitted& with = f.best().best;
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
        "<h2>Calibration</h2>\n<p>What the base model may set by"
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
        head.push_back(source.first);
    }
    std::vector<row> rows;
    for (const segment& s : f.data.segments)
    {
        row r{s.name + " " + unitOf(s.quantity), two(s.rootMeanSquare(f.sigma))};
        for (const uncertaintySource& source : f.sources)
        {
            r.push_back(two(s.rootMeanSquare(source.second)));
        }
        rows.push_back(r);
    }
    return
        "<h2>What is uncertain</h2>\n<p>One standard deviation between recording and"
        " simulation with nothing wrong, root mean square over the record, and what"
        " it is made of (between the runs: of states that lie between those that were"
        " computed). Where a mesh outweighs the sensors, a finer one sees more, or places"
        " amid cells of both; where replicates do, more of them.</p>\n"
      + table(head, rows);
}


std::string describeScored(const finding& f, const wordList& names)
{
    std::vector<row> rows;
    const std::string answer = describe(f.best().what, names);
    std::vector<scored> list(f.explained.all());
    sortByScore(list);

    // The same fault may be there with several sizes
    bool judged = false;
    for (const scored& w : list)
    {
        const std::string name = describe(w.what, names);
        if (rows.size() < 8)
        {
            rows.push_back
            ({
                name + (name == answer && !judged ? " (judged below)" : ""),
                number(w.score - list.front().score),
                percent(w.probability)
            });
            judged = judged || name == answer;
        }
    }
    return
        "<h2>Explanations, by score</h2>\n<p>"
      + std::to_string(f.explained.all().size()) + " were fitted in the same way."
        " The score behind the best counts misfit, and each further unknown"
        " against it; 6 behind is 20 times less likely.</p>\n"
      + table({"explanation", "score behind the best", "probability"}, rows);
}


//- Why a gate was left out
std::string notAsked(const misfit::gate& g, const hypothesis& judged)
{
    return
        judged.isOnlyUnknown() ? "not asked: nothing that is known is judged"
      : g.kind == gateKind::adequacy && judged.unknown
      ? "not asked: the answer has something unknown, which takes up what is left"
      : "nothing to ask";
}


std::string gates(const finding& f)
{
    const auto rowOf = [&f](const misfit::gate& g)
    {
        const gateWords words(describe(g, f));
        return row
        ({
            gateNames[g.kind], words.asked, g.applies ? words.value : string(),
            g.applies ? words.bound : string(),
            !g.applies ? notAsked(g, f.best().what)
          : g.passed ? "passed"
          : g.kind == gateKind::detection ? "no misfit beyond chance" : "failed"
        });
    };
    return
        "<h2>Gates: what the answer had to pass</h2>\n"
      + tableOf({"gate", "asked", "value", "must be", ""}, f.gates, rowOf);
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
    return
        "<h2>A free correction</h2>\n<p>No candidate explains what is missing, so"
        " a correction without a mechanism was fitted: " + escaped(describe(c))
      + " It gains " + shortNumber(c.gain) + " in score.</p>\n"
      + tableOf
        (
            {"what it acts like", "value (95 %)"},
            c.elements,
            [](const freeElement& p)
            {
                return row
                ({
                    describe(p.element, p.value),
                    shortNumber(p.value) + " +- " + shortNumber(2*p.deviation)
                });
            }
        )
      + tableOf
        (
            {"laws in dimensionless numbers", "score ahead of it"},
            c.laws,
            [](const fittedLaw& l) { return row({describe(l), shortNumber(l.lead)}); },
            5
        )
      + tableOf
        (
            {"not used to find it", "mean square before", "after", "gone"},
            c.held,
            [](const heldOut& h)
            {
                return row
                ({
                    describe(h) + " (" + channels(h) + ")", number(h.squareBefore),
                    number(h.squareAfter), percent(removed(h))
                });
            }
        );
}


std::string dropped(const finding& f)
{
    return
        f.dropped.empty() ? std::string()
      : "<h2>Not scored</h2>\n"
      + tableOf
        (
            {"candidate", "why"},
            f.dropped,
            [](const droppedCandidate& d) { return row({d.name, describe(d)}); }
        );
}


std::string rest(const finding& f)
{
    std::string text;
    if (f.failedRuns.size())
    {
        text +=
            "<h2>Runs that failed</h2>\n<p>They are not in what is uncertain, or in"
            " the effect of a parameter.</p>\n"
          + tableOf
            (
                {"run, and why"},
                f.failedRuns,
                [](const failedRun& run) { return row({describe(run)}); }
            );
    }
    const string advice(adviceOf(f));
    if (advice.size())
    {
        text +=
            "<h2>What would settle it</h2>\n<p>" + escaped(advice)
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
            "Each channel over time or distance: red where the recording is higher than the"
            " simulation, blue where it is lower, in standard deviations.";
    }
    if (name == "fitted")
    {
        return "The channels that were fitted.";
    }
    const heldOut& h = f.held[std::stoi(name.substr(7)) - 1];
    return
        "Not used to find it: " + describe(h) + ". Mean square of the misfit "
      + number(h.squareBefore)
      + (h.squareBefore == h.squareAfter ? std::string()
          : " before, " + number(h.squareAfter) + " after")
      + " (1: as good as it can be).";
}

} // End anonymous namespace


std::string Foam::misfit::reportHtml
(
    const finding& f,
    const origin& from,
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
        reportTop(f, from) + "<h2>Before and after</h2>\n" + series
      + where(f) + map + freeCorrection(f.correction) + describeCandidates(f, from)
      + describeScored(f, f.library) + dropped(f) + gates(f) + apart(f) + rest(f)
      + calibration(f) + uncertain(f) + glossary()
      + "<p>States asked for: " + std::to_string(f.nRuns)
      + ". The same in numbers: verdict.json.</p>\n</body></html>\n";
}
