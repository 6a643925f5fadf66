// SPDX-License-Identifier: GPL-3.0-or-later
// report.html: a diagnosis for a reader who has five minutes. The template
// etc/misfit/report.html, filled with the record and what only a reader needs.

#include "report.H"
#include "textFile.H"
#include "words.H"

#include "base64Layer.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- True if the answer, or what explains best, has that candidate
bool isInAnswer(const finding& f, const word& name)
{
    const auto has = [&](const hypothesisFit& w)
    {
        return std::any_of
        (
            w.what.mechanisms.begin(), w.what.mechanisms.end(),
            [&](const int m) { return f.library[m] == name; }
        );
    };
    const std::vector<hypothesisFit>& others = f.verdict.alternatives;
    return
        f.verdict.names.found(name) || has(f.best())
     || std::any_of(others.begin(), others.end(), has);
}


//- What the finding does to the misfit of held-out data
string outcome(const heldOut& h)
{
    const scalar share = removed(h);
    return renderTemplate
    (
        "outcome",
        {
            {"wasOff", h.squareBefore >= h.limitOfMatch},
            {"isOff", h.squareAfter >= h.limitOfMatch},
            {"gone", share > 0 ? percentWords(share) : string()}
        }
    );
}


//- Of held-out data; showsFinding: what was found may show in them
json held(const heldOut& h, const bool showsFinding)
{
    const auto name = [](const segment& s) { return s.name; };
    return
    {
        {"data", describe(h) + " (" + joined(h.data.segments, " ", name) + ')'},
        {"before", ratioWords(h.squareBefore)},
        {"after", ratioWords(h.squareAfter)},
        {"gone", percentWords(removed(h))},
        {"outcome", outcome(h)},
        {"showsFinding", showsFinding}
    };
}


//- Adds how sure the answer is, and what stands beside it
void addAnswer(json& page, const finding& f)
{
    page["sure"] = percentWords(f.verdict.confidence) + ' ' + sureThat(f);
    page["notScored"] = joined(f.candidates.dropped, ", ", [](const droppedCandidate& d)
    {
        droppedCandidate brief(d);
        brief.failure.clear();
        return d.name + " (" + describe(brief) + ')';
    });
    page["heldOut"] = each(f.held(), [&f](const heldOut& h)
    {
        const bool isOfFault =
            f.verdict.blamesChannel() && h.squareAfter < h.squareBefore;
        return held(h, f.verdict.strengths.size() || isOfFault);
    });
}


//- The first of them, with what each is behind the best
json scoredFirst(const finding& f)
{
    std::vector<const hypothesisFit*> list(f.explained.byScore());
    const scalar best = list.front()->score;
    list.resize(std::min(list.size(), size_t(8)));

    // The same fault may be there with several sizes
    bool judged = false;
    return each(list, [&](const hypothesisFit* w) -> json
    {
        const string name(describe(w->what, f.library));
        const bool isJudged = !judged && name == describe(f.best().what, f.library);
        judged = judged || isJudged;
        return
        {
            {"name", name},
            {"isJudged", isJudged},
            {"behind", ratioWords(w->score - best)},
            {"probability", percentWords(w->probability)}
        };
    });
}


//- Why a gate was left out; empty if it was not
string causeOfNoTest(const misfit::gate& g, const hypothesis& judged)
{
    if (g.applies)
    {
        return string();
    }
    const bool isOfNothingKnown = judged.isOnlyUnknown();
    const bool isTakenUp =
        !isOfNothingKnown && g.kind == gateKind::adequacy && judged.unknown;
    return renderTemplate
    (
        "noTest",
        {
            {"nothingKnown", isOfNothingKnown},
            {"takenUp", isTakenUp},
            {"nothing", !isOfNothingKnown && !isTakenUp}
        }
    );
}


//- A gate in words, and what came of it
json gateRow(const misfit::gate& g, const finding& f)
{
    json row(gateWords(g, f));
    row["why"] = causeOfNoTest(g, f.best().what);
    row["outcome"] = renderTemplate
    (
        "gateOutcome",
        {{"passed", g.passed}, {"detection", g.kind == gateKind::detection}}
    );
    return row;
}


json candidates(const finding& f, const origin& from)
{
    return each(from.candidates, [&](const candidate& c) -> json
    {
        const auto set = [](const caseChange& change) { return change.describe(1); };
        const List<fittedStrength>& all = f.verdict.strengths;
        const auto strength = std::find_if
        (
            all.begin(), all.end(),
            [&](const fittedStrength& s) { return s.name == c.name; }
        );
        return
        {
            {"name", c.name},
            {"title", c.title},
            {"isMeant", c.title != c.name && isInAnswer(f, c.name)},
            {"sets", joined(c.changes, "; ", set)},
            {"found", strength == all.end() ? json() : json(strength->value)}
        };
    });
}


//- How far each of the candidates is apart from each
json distances(const finding& f)
{
    json all = json::array();
    forAll(f.apart.names, i)
    {
        all.push_back
        ({
            {"name", f.apart.names[i]}, {"to", vec(f.apart.distances.row(i).transpose())}
        });
    }
    return all;
}


//- Of a channel: its standard deviation [unit], and those that it is made of
json uncertain(const finding& f, const segment& s)
{
    json all = json::array({numberWords(s.rootMeanSquare(f.detection.sigma), 2)});
    for (const uncertaintySource& source : f.detection.sources)
    {
        all.push_back(numberWords(s.rootMeanSquare(source.second), 2));
    }
    return {{"name", s.name + ' ' + unitOf(s.quantity)}, {"deviations", all}};
}


void keepFirst(const size_t most, json& list)
{
    list.erase(list.begin() + std::min(list.size(), most), list.end());
}


//- Adds to that of the record its intervals and held-out data; no more laws than read
void addToCorrection(json& all, const correctionFit& c)
{
    for (json& e : all["elements"])
    {
        e["interval"] = 2*e["deviation"].get<scalar>();
    }
    keepFirst(5, all["laws"]);
    all["held"] = each(c.held, [](const heldOut& h) { return held(h, true); });
}


string caption(const finding& f, const figure& shown)
{
    if (shown.shows != figure::subject::heldOut)
    {
        const bool isMap = shown.shows == figure::subject::map;
        return renderTemplate("caption", {{isMap ? "map" : "fitted", true}});
    }
    const heldOut& h = f.held()[shown.held];
    const bool changes = h.squareBefore != h.squareAfter;
    return renderTemplate
    (
        "caption",
        {
            {"heldOut", describe(h)},
            {"before", ratioWords(h.squareBefore)},
            {"after", changes ? ratioWords(h.squareAfter) : string()}
        }
    );
}


//- Its caption, and its file as the page holds it
json withBytes(const finding& f, const figure& shown)
{
    const string bytes(contentOf(shown.file));
    std::ostringstream os;
    base64Layer encode(os);
    encode.write(bytes.data(), bytes.size());
    encode.close();
    return {{"caption", caption(f, shown)}, {"bytes", os.str()}};
}

} // End anonymous namespace


std::string Foam::misfit::reportHtml
(
    const finding& f,
    const origin& from,
    const std::vector<figure>& figures
)
{
    json page(recordOf(f, from.title));
    page["date"] = from.date;
    page["experiments"] = from.experiments;
    addAnswer(page, f);
    page["candidates"] = candidates(f, from);
    for (const figure& shown : figures)
    {
        const bool isMap = shown.shows == figure::subject::map;
        page[isMap ? "map" : "series"].push_back(withBytes(f, shown));
    }

    // Where mechanisms are named, what they change counts too
    page["isOfCause"] = f.verdict.strengths.size() && !f.best().what.unknown;
    keepFirst(5, page["located"]);
    if (f.correction.isRequested)
    {
        addToCorrection(page["freeCorrection"], f.correction);
    }
    page["dropped"] = each(f.candidates.dropped, [](const droppedCandidate& d) -> json
    {
        return {{"name", d.name}, {"why", describe(d)}};
    });
    page["failedRuns"] =
        each(f.failedRuns, [](const failedRun& run) { return describe(run); });
    page["explanations"] = f.explained.all().size();
    page["scored"] = scoredFirst(f);
    page["gates"] =
        each(f.tests.gates, [&f](const misfit::gate& g) { return gateRow(g, f); });
    page["distances"] = distances(f);
    page["sources"] = each(f.detection.sources, [](const auto& s) { return s.first; });
    page["uncertain"] =
        each
        (
            f.detection.data.segments,
            [&f](const segment& s) { return uncertain(f, s); }
        );

    return fillTemplate("report.html", page);
}
