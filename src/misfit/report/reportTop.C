// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader of a report sees first, and the words that it uses.

#include "reportTop.H"
#include "html.H"
#include "words.H"

#include "clock.H"
#include "HashSet.H"

#include <cctype>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using namespace Foam::misfit::html;

//- The names in the answer, or of what explains it best
std::string answered(const finding& f)
{
    std::string names(describe(f.best().what, f.library));
    for (const word& name : answerOf(f))
    {
        names += ' ' + name;
    }
    return names;
}


//- True if a list of names has that one in it, not as a part of another
bool has(const std::string& names, const std::string& name)
{
    const auto isPart = [&](const size_t i)
    {
        return i < names.size() && std::isalnum(names[i]);
    };
    size_t at = names.find(name);
    while (at != std::string::npos)
    {
        if (!(at > 0 && isPart(at - 1)) && !isPart(at + name.size()))
        {
            return true;
        }
        at = names.find(name, at + 1);
    }
    return false;
}


//- What the confidence is the confidence of
std::string sureThat(const finding& f)
{
    switch (f.verdict)
    {
        case verdictKind::none:
            return
                "that nothing missing and no fault is needed to explain the"
                " recordings";
        case verdictKind::sensor:
        case verdictKind::registration:
            return "that the fault is at " + inWords(f.names, "and");
        case verdictKind::set:
            return "that one of these is at least part of what is wrong";
        case verdictKind::unknown:
            return "that no candidate and no fault of one sensor explains it";
        default:
            return
                f.correction.named ? "that what is missing follows this law"
              : f.names.size() == 1
              ? "that this is at least part of what is missing"
              : "that these are at least part of what is missing";
    }
}


//- What the number is from
std::string sureFrom(const finding& f)
{
    if (f.grounds.size() == 0)
    {
        return
            ", by its score alone: no case whose cause was known had such a law.";
    }
    const std::string known
    (
        ", the fraction of such verdicts that was right in cases whose cause was"
        " known"
    );
    const bool ofClock =
        f.verdict != verdictKind::registration
     || f.best().what.fault->kind == faultKind::clock;
    return known + (ofClock ? "." : ", in all of which it was the clock.");
}


//- What the finding does to the misfit of held-out data
std::string gone(const heldOut& h)
{
    // A mean square of 1 is chance
    if (h.squareBefore < h.limitOfMatch)
    {
        return
            h.squareAfter < h.limitOfMatch
          ? "there was no misfit beyond chance: it neither confirms nor denies"
          : "a misfit comes that was not there";
    }
    const scalar share = removed(h);
    return
        share > 0 ? percent(share) + " of the misfit is gone"
      : "the misfit does not get smaller";
}


std::string describeHeldOut(const finding& f)
{
    std::string text;
    for (const heldOut& h : f.held)
    {
        const bool faultIsShown =
            f.blamesChannel() && h.squareAfter < h.squareBefore;
        if (f.strengths.size() || faultIsShown)
        {
            text +=
                "<br>At " + escaped(describe(h) + " (" + channels(h) + ")")
              + ", not used to find it, " + gone(h)
              + " (mean square over what is uncertain: from "
              + number(h.squareBefore) + " to " + number(h.squareAfter) + ").";
        }
    }
    return text;
}


//- Candidates that were not scored, with the reason as far as it is short
std::string describeDropped(const finding& f)
{
    std::string text;
    for (const droppedCandidate& d : f.dropped)
    {
        const std::string why(describe(d));
        text +=
            (text.empty() ? "<br>Not scored: " : ", ")
          + escaped(d.name + " (" + why.substr(0, why.find(':')) + ')');
    }
    return text.empty() ? text : text + '.';
}


std::string answer(const finding& f, const origin& from)
{
    std::string text
    (
        "<div class=\"verdict\"><b>" + verdictNames[f.verdict] + ".</b> "
      + escaped(describe(f))
    );
    for (const candidate& c : from.candidates)
    {
        if (c.title != c.name && has(answered(f), c.name))
        {
            text += "<br>" + escaped(c.name + ": " + c.title) + '.';
        }
    }
    text +=
        "<br>Confidence " + percent(f.confidence) + ' ' + escaped(sureThat(f))
      + sureFrom(f)
      + describeHeldOut(f) + describeDropped(f);
    if (f.answer.size())
    {
        text +=
            "<br>The case with it switched on, ready to run: <code>misfit/"
          + std::string(correctedCase) + "</code>.";
    }
    return text + "</div>\n";
}


//- Adds to a list of words with commas
void addWord(string& list, const string& name)
{
    list += (list.empty() ? "" : ", ") + name;
}


//- An experiment, its channels by their use, and the files they came from
stringList experimentRow(const recordings& all, const word& name)
{
    stringList row(5);
    row[0] = name;
    wordHashSet files;
    for (const channel& c : all.channels())
    {
        if (c.experiment() == name && c.isRecorded())
        {
            addWord(row[1 + label(c.use())], c.name());
            const size_t end = c.source().rfind(':');
            const fileName file
            (
                end == std::string::npos ? string() : c.source().substr(0, end)
            );
            if (file.size() && files.insert(file.name()))
            {
                addWord(row[4], file.name());
            }
        }
    }
    return row;
}

} // End anonymous namespace


Foam::misfit::origin Foam::misfit::originOf
(
    const string& title,
    const recordings& recorded,
    const List<candidate>& candidates
)
{
    origin from;
    from.title = title;
    from.date = clock::date();
    from.candidates = candidates;
    for (const word& name : recorded.experiments())
    {
        from.experiments.append(experimentRow(recorded, name));
    }
    return from;
}


std::string Foam::misfit::channels(const heldOut& h)
{
    std::string names;
    for (const segment& s : h.data.segments)
    {
        names += (names.empty() ? "" : " ") + s.name;
    }
    return names;
}


std::string Foam::misfit::reportTop(const finding& f, const origin& from)
{
    return
        header("Simulation against recordings: " + from.title)
      + (from.date.empty() ? std::string()
          : "<p>Written by misfitFoam on " + escaped(from.date) + ".</p>\n")
      + answer(f, from)
      + tableOf
        (
            {"experiment", "calibration", "validation", "test", "recorded in"},
            from.experiments,
            [](const stringList& cells) { return row(cells.begin(), cells.end()); }
        )
      + "<p>Words are explained <a href=\"#words\">at the end</a>.</p>\n";
}


std::string Foam::misfit::describeCandidates(const finding& f, const origin& from)
{
    std::vector<row> rows;
    for (const candidate& c : from.candidates)
    {
        std::string sets;
        for (const caseChange& change : c.changes)
        {
            sets += (sets.empty() ? "" : "; ") + change.describe(1);
        }
        std::string found;
        for (const foundStrength& s : f.strengths)
        {
            found = s.name == c.name ? shortNumber(s.value) : found;
        }
        rows.push_back({c.name, c.title, sets, found});
    }
    return
        rows.empty() ? std::string()
      : "<h2>What the case may lack</h2>\n"
      + table({"candidate", "what it is", "set at strength 1", "found"}, rows);
}


std::string Foam::misfit::glossary()
{
    return
        "<h2 id=\"words\">Words</h2>\n"
      + table
        (
            {"word", "meaning"},
            {
                {"calibration, validation, test", "channels that are fitted; that are"
                    " held out and must be predicted; that are held out and only"
                    " reported"},
                {"sigma", "one standard deviation of all that is uncertain between"
                    " recording and simulation; beyond 3 is hardly chance"},
                {"mean square", "of the misfit in sigma: 1 is a match, 4 is off by"
                    " twice what is uncertain"},
                {"score", "how badly an explanation fits, plus a charge for each of"
                    " its unknowns; the lowest is the best"},
                {"something unknown", "a smooth misfit of any shape that no candidate"
                    " makes; it is scored like the others"},
                {"evidence", "how much better the best explanation scores than none"},
                {"gap", "how far it leads the next one that says something else"},
                {"detection", "whether recording and simulation part beyond chance"},
                {"computed", "whether the solver ran what was to be judged"},
                {"adequacy", "whether what it leaves can be chance"},
                {"alone", "whether what is named explains something by itself, with"
                    " nothing unknown beside it"},
                {"heldOut, transfer", "whether it improves channels, and experiments,"
                    " that were not used to find it"},
                {"degradesHeldOut", "whether it makes held-out channels worse than a"
                    " right explanation can"},
                {"stability", "whether it still wins when a channel is left out"},
                {"placebo", "whether it fits a false misfit, reversed or moved in"
                    " time, nearly as well: then it fits anything. Not moved where"
                    " held-out data confirm it"},
                {"clock, replicates, mesh, step", "what is uncertain: the common start of"
                    " time; runs with other packings of the grains; what a finer mesh"
                    " and a smaller step change"},
                {"before, front, body, tail, after", "parts of a recording: until it"
                    " arrives, until its peak, the first half of the way down, the"
                    " second, the rest"}
            }
        );
}
