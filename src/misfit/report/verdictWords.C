// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: the verdict, and how sure it is.

#include "words.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The best explanation that has more on than the one that is judged; null if it does
//  not
const hypothesisFit* betterWithMore(const finding& f)
{
    for (const hypothesisFit& w : f.explained.all())
    {
        const bool more =
            w.what.mechanisms.size() > f.best().what.mechanisms.size()
         && w.what.contains(f.best().what);
        if (more && w.score == f.explained.lowestScore())
        {
            return &w;
        }
    }
    return nullptr;
}


//- The explanation that is judged, as a part of a sentence
string theBest(const finding& f)
{
    const hypothesis& what = f.best().what;
    json facts = {{"onlyUnknown", what.isOnlyUnknown()}};
    if (what.fault)
    {
        facts["fault"] =
            {{"channel", what.fault->channel}, {"kind", kindOf(*what.fault)}};
    }
    else if (!what.isOnlyUnknown())
    {
        const hypothesisFit* more = betterWithMore(f);
        facts[more ? "simple" : "alone"] = describe(what, f.library);
        facts["more"] = more ? describe(more->what, f.library) : string();
    }
    return renderTemplate("theBest", facts);
}


//- Why the cause is unknown
void addUnknown(json& facts, const finding& f)
{
    const std::vector<gateKind> failed(f.tests.gates.failed());
    const auto fails = [&failed](const gateKind kind)
    {
        return statistics::contains(failed, kind);
    };
    const bool notRun = failed == std::vector<gateKind>{gateKind::computed};
    const bool unproved = f.isUnproved();
    facts["unproved"] = unproved;
    facts["notRun"] = !unproved && notRun;
    facts["missing"] = !unproved && !notRun;
    facts["explains"] = !f.best().what.isNone() && !f.best().what.isOnlyUnknown();
    facts["agreesElsewhere"] =
        !fails(gateKind::heldOut) && !fails(gateKind::degradesHeldOut)
     && !fails(gateKind::transfer);
    facts["degrades"] = fails(gateKind::degradesHeldOut);
}


//- The fault of the best explanation with its size, and how sure that is
void addFault(json& facts, const finding& f)
{
    const sensorFault& fault = *f.best().what.fault;
    const fitResult& best = f.best().fit;
    const vec size = best.x.tail(fault.size());
    segment at(f.detection.data.segments.front());
    for (const segment& s : f.detection.data.segments)
    {
        at = s.name == fault.channel ? s : at;
    }
    facts["fault"] = describe(fault, at, size);
    if (size.size() == 1 && fault.hasSize())
    {
        const scalar deviation = best.deviation(best.x.size() - 1);
        if (deviation > 0 && mag(size[0]) > deviation)
        {
            facts["interval"] = ratioWords(200*deviation/mag(size[0]), 2);
        }
        facts["pinned"] = best.pinned.back() && mag(size[0]) > SMALL;
    }
}


string alternatives(const finding& f)
{
    const auto isMixed = [](const hypothesisFit& w)
    {
        return
            w.what.mechanisms.size() > 1
         || (w.what.unknown && w.what.mechanisms.size());
    };
    const std::vector<hypothesisFit>& all = f.verdict.alternatives;
    if (std::none_of(all.begin(), all.end(), isMixed))
    {
        wordList names;
        for (const hypothesisFit& w : all)
        {
            names.append(word(describe(w.what.known(), f.library), false));
        }
        return inWords(names, "or");
    }
    return joined(all, ", or ", [&f](const hypothesisFit& w)
    {
        return
            describe(w.what, f.library)
          + (w.what.mechanisms.size() > 1 ? " together" : "");
    });
}


//- True if both of a set at once are as good as one of them
bool mayBeTogether(const finding& f)
{
    const auto hasOne = [](const hypothesisFit& w)
    {
        return w.what.mechanisms.size() == 1;
    };
    const auto hasBoth = [&f](const hypothesisFit& w)
    {
        const auto has = [&w](const hypothesisFit& one)
        {
            return statistics::contains
            (
                w.what.mechanisms, one.what.mechanisms.front()
            );
        };
        return
            w.what.mechanisms.size() == 2
         && std::all_of
            (
                f.verdict.alternatives.begin(), f.verdict.alternatives.end(), has
            );
    };
    return
        f.verdict.alternatives.size() == 2
     && std::all_of(f.verdict.alternatives.begin(), f.verdict.alternatives.end(), hasOne)
     && std::any_of(f.verdict.rivals.begin(), f.verdict.rivals.end(), hasBoth);
}


//- The strengths. The first also names what they were fitted with, if not what is named
json strengths(const finding& f)
{
    const bool ofMore = f.verdict.kind == verdictKind::set || f.verdict.partly;
    string asFitted(ofMore ? describe(f.best().what, f.library) : string());
    return each(f.verdict.strengths, [&asFitted](const fittedStrength& s) -> json
    {
        return
        {
            {"asFitted", std::exchange(asFitted, string())},
            {"name", s.name},
            {"value", numberWords(s.value, 3)},
            {"interval", numberWords(2*s.deviation, 3)},
            {"pinned", s.pinned},
            {"up", s.value > 0}
        };
    });
}


//- Of a set: what wins without which channels
json winsWithout(const finding& f)
{
    json all = json::array();
    for (const hypothesisFit& one : f.verdict.alternatives)
    {
        wordList channels;
        for (const winner& w : f.tests.winners)
        {
            const hypothesis& other = w.explanation.what;
            if (other.fault == one.what.fault && other.hasMechanismsOf(one.what))
            {
                channels.append(w.channel);
            }
        }
        if (channels.size())
        {
            all.push_back
            ({
                {"first", all.empty()},
                {"channels", inWords(channels, "or")},
                {"name", describe(one.what, f.library)}
            });
        }
    }
    return all;
}


//- Mechanisms, or a set
void addLeftOut(json& facts, const finding& f)
{
    facts["leftOut"] = true;
    facts["names"] = inWords(f.verdict.names, "and");
    facts["weakened"] = f.verdict.weakened;
    facts["alternatives"] = alternatives(f);
    facts["mayBeTogether"] = mayBeTogether(f);
    facts["strengths"] = strengths(f);
    facts["winsWithout"] = winsWithout(f);
    const gateList& gates = f.tests.gates;
    facts["tried"] =
        gates.applied(gateKind::heldOut) || gates.applied(gateKind::transfer);

    // A lead of less is not worth a mention (Kass & Raftery 1995, J. Am. Stat.
    // Assoc. 90:777)
    const scalar mention = 2;
    const hypothesisFit* more = betterWithMore(f);
    const bool leads = more && more->score < f.best().score - mention;
    if (f.verdict.kind == verdictKind::named && leads)
    {
        facts["mayBeAdded"] = describe(more->what.known(), f.library);
    }
    facts["stillOff"] = json::array();
    for (const heldOut& h : f.tests.held)
    {
        if (h.use == purpose::validation && h.squareAfter > h.limitOfMatch)
        {
            facts["stillOff"].push_back
            ({
                {"what", describe(h)}, {"square", ratioWords(h.squareAfter, 3)}
            });
        }
    }
}

} // End anonymous namespace


Foam::wordList Foam::misfit::answerOf(const finding& f)
{
    wordList names(f.verdict.names);
    const auto add = [&names](const word& name)
    {
        if (!names.found(name))
        {
            names.append(name);
        }
    };
    for (const hypothesisFit& w : f.verdict.alternatives)
    {
        const hypothesis& h = w.what;
        for (const int m : h.mechanisms)
        {
            add(f.library[m]);
        }
        if (h.fault)
        {
            add(h.fault->channel);
        }
        if (h.fault && h.fault->kind == faultKind::swapped)
        {
            add(h.fault->partner);
        }
    }
    return names;
}


Foam::string Foam::misfit::describe(const finding& f)
{
    const correctionFit& c = f.correction;
    if (c.named)
    {
        return renderTemplate("namedLaw", {{"correction", describe(c)}});
    }
    const bool detected = f.tests.gates.passed(gateKind::detection);
    const bool isNamed = f.verdict.kind == verdictKind::named;
    wordList failed;
    for (const gateKind kind : f.tests.gates.failed())
    {
        failed.append(gateNames[kind]);
    }
    const auto parts = [](const heldOut& h)
    {
        return h.use == purpose::validation && h.squareBefore >= h.limitOfNothing;
    };
    json facts =
    {
        {verdictNames[f.verdict.kind], true},
        {"detected", detected},
        {"elsewhere", f.verdict.kind != verdictKind::none && !detected},
        {"partsElsewhere", std::any_of(f.tests.held.begin(), f.tests.held.end(), parts)},
        {"failed", inWords(failed, "and")},
        {"failedExperiments", inWords(f.tests.gates.failedExperiments(), "and")},
        {"failing", inWords(f.failing(), "and")},
        {"best", theBest(f)},
        {"bestIsNone", f.best().what.isNone()},
        {
            "hasMore",
            (isNamed || f.verdict.kind == verdictKind::registration) && f.hasMore()
        }
    };
    if (f.verdict.kind == verdictKind::unknown)
    {
        addUnknown(facts, f);
    }
    else if (f.verdict.blamesChannel())
    {
        addFault(facts, f);
    }
    else if (f.verdict.kind != verdictKind::none)
    {
        addLeftOut(facts, f);
    }
    const string correction(c.isRequested ? ' ' + describe(c) : string());
    return renderTemplate("verdict", facts) + correction;
}


Foam::string Foam::misfit::sureThat(const finding& f)
{
    return renderTemplate
    (
        "sure",
        {
            {verdictNames[f.verdict.kind], true},
            {"ofFault", f.verdict.blamesChannel()},
            {"names", inWords(f.verdict.names, "and")},
            {"one", f.verdict.names.size() == 1},
            {"law", f.correction.named},
            {"grounds", f.verdict.grounds.size() > 0},
            {
                "ofClock",
                f.verdict.kind != verdictKind::registration
             || f.best().what.fault->kind == faultKind::clock
            }
        }
    );
}
