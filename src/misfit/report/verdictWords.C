// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: the verdict.

#include "words.H"
#include "StringStream.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The gates that fail, without detection
wordList failedGates(const finding& f)
{
    wordList names;
    for (const gateKind kind : f.gates.failed())
    {
        names.append(gateNames[kind]);
    }
    return names;
}


//- True if held-out data were asked, whatever they said
bool wasTried(const finding& f)
{
    return
        f.gates.applied(gateKind::heldOut)
     || f.gates.applied(gateKind::transfer);
}


//- The explanation that is judged, as a part of a sentence
string theBest(const finding& f)
{
    const hypothesis& what = f.best().what;
    if (what.isOnlyUnknown())
    {
        return "that it is something that is not in the library";
    }
    if (what.fault)
    {
        return
            "the best explanation, a fault of " + what.fault->channel + " ("
          + kindOf(*what.fault) + ")";
    }
    for (const scored& w : f.explained.all())
    {
        const bool more =
            w.what.mechanisms.size() > what.mechanisms.size()
         && w.what.contains(what);
        if (more && w.score == f.explained.lowestScore())
        {
            return
                "the best simple explanation, " + describe(what, f.library)
              + " (" + describe(w.what, f.library)
              + " match better, but by too little to be told from it)";
        }
    }
    return "the best explanation, " + describe(what, f.library);
}


string alternatives(const finding& f)
{
    bool mixed = false;
    for (const scored& w : f.alternatives)
    {
        mixed =
            mixed || w.what.mechanisms.size() > 1
         || (w.what.unknown && w.what.mechanisms.size());
    }
    if (!mixed)
    {
        return inWords(answerOf(f), "or");
    }
    string words;
    for (const scored& w : f.alternatives)
    {
        words +=
            (words.empty() ? "" : ", or ") + describe(w.what, f.library)
          + (w.what.mechanisms.size() > 1 ? " together" : "");
    }
    return words;
}


string whatFails(const finding& f)
{
    if (f.best().what.isNone() || f.best().what.isOnlyUnknown())
    {
        return ".";
    }
    const wordList failed(failedGates(f));
    const bool agreesElsewhere =
        f.gates.passed(gateKind::heldOut) && f.gates.passed(gateKind::degradesHeldOut)
     && f.gates.passed(gateKind::transfer);
    return
        " well enough: " + theBest(f) + ", "
      + (failed.empty() ? string("leads too little")
          : "does not pass " + inWords(failed, "and"))
      + (agreesElsewhere ? ". Two faulty sensors look like that, too." : ".")
      + (
            f.gates.passed(gateKind::degradesHeldOut) ? ""
          : " It makes the match of held-out channels worse."
        );
}


string whatWasNotRun(const finding& f)
{
    return
        f.failedExperiments.empty()
      ? "It cannot be decided: the solver failed with " + theBest(f)
      + ", at the strength that was fitted."
      : "It cannot be decided: " + theBest(f)
      + ", is not confirmed, as the solver fails in experiment "
      + inWords(f.failedExperiments, "and") + ".";
}


string whatGainsTooLittle(const finding& f)
{
    string words("Recording and simulation part, but too little to say why");
    if (!f.best().what.isNone())
    {
        words +=
            ": " + theBest(f) + ", does not pass evidence";
    }
    return words + '.';
}


string whatMayBeAdded(const finding& f)
{
    // A lead of less is not worth a mention (Kass & Raftery 1995, J. Am. Stat.
    // Assoc. 90:777)
    const scalar mention = 2;
    for (const scored& w : f.explained.all())
    {
        const bool better =
            w.what.mechanisms.size() > f.best().what.mechanisms.size()
         && w.what.contains(f.best().what)
         && w.score == f.explained.lowestScore() && w.score < f.best().score - mention;
        if (better)
        {
            return
                " Together, " + describe(w.what.known(), f.library)
              + " match better, but by no more than another formula of what is"
                " named may.";
        }
    }
    return "";
}


//- True if both of a set at once are as good as one of them
bool mayBeTogether(const finding& f)
{
    std::vector<int> both;
    for (const scored& w : f.alternatives)
    {
        if (w.what.mechanisms.size() == 1)
        {
            both.push_back(w.what.mechanisms.front());
        }
    }
    if (f.alternatives.size() != 2 || both.size() != 2)
    {
        return false;
    }
    for (const scored& w : f.rivals)
    {
        const auto has = [&w](const int m)
        {
            return statistics::contains(w.what.mechanisms, m);
        };
        if (has(both[0]) && has(both[1]) && w.what.mechanisms.size() == 2)
        {
            return true;
        }
    }
    return false;
}


string strengthsInWords(const finding& f)
{
    OStringStream os;
    os.precision(3);
    string before("; strength of ");
    if (f.verdict == verdictKind::set || f.partly)
    {
        before =
            ". As fitted with " + describe(f.best().what, f.library)
          + ": strength of ";
    }
    for (const foundStrength& s : f.strengths)
    {
        os << before.c_str() << s.name << ' ' << s.value;
        before = "; strength of ";
        if (s.pinned)
        {
            os << (s.value > 0 ? ", the largest that is allowed" : ", the least");
        }
        else
        {
            os << " +- " << 2*s.deviation << " (95 %)";
        }
    }
    return os.str();
}


string whatElsewhereSays(const finding& f)
{
    for (const heldOut& h : f.tested)
    {
        if (h.use == purpose::validation && h.squareBefore >= h.limitOfNothing)
        {
            return
                "held-out ones do not (they do not pass "
              + inWords(failedGates(f), "and") + "). Fit those too to learn why.";
        }
    }
    return
        "but the solver fails in experiment " + inWords(f.failedExperiments, "and")
      + ", which should confirm it.";
}


string whatIsStillOff(const finding& f)
{
    OStringStream os;
    os.precision(3);
    for (const heldOut& h : f.tested)
    {
        if (h.use == purpose::validation && h.squareAfter > h.limitOfMatch)
        {
            os  << " It does not yet match " << describe(h).c_str()
                << ": mean square " << h.squareAfter << ", a match is 1.";
        }
    }
    return os.str();
}


string whatCouldNotBeAsked(const finding& f)
{
    const wordList& names = f.failing;
    return
        names.empty() ? string()
      : " Not asked, as the solver failed with it: " + inWords(names, "and")
      + '.';
}


string whatWinsWithout(const finding& f)
{
    string words;
    for (const scored& one : f.alternatives)
    {
        wordList channels;
        for (const winner& w : f.winners)
        {
            const hypothesis& other = w.what.what;
            if (other.fault == one.what.fault && other.hasMechanismsOf(one.what))
            {
                channels.append(w.channel);
            }
        }
        if (channels.size())
        {
            words +=
                (words.empty() ? " Without " : "; without ")
              + inWords(channels, "or") + " a better match is "
              + describe(one.what, f.library);
        }
    }
    return words + (words.empty() ? "" : ".");
}


string whatIsLeftOut(const finding& f)
{
    const bool named = f.verdict == verdictKind::named;
    string words
    (
        named
      ? "Left out: " + inWords(f.names, "and")
      : "Left out is one of these"
      + string(f.weakened ? ": " : ", which these channels cannot tell apart: ")
      + alternatives(f) + (mayBeTogether(f) ? ", or both" : "")
    );
    words += strengthsInWords(f) + '.' + whatWinsWithout(f);
    if (named && f.hasMore())
    {
        words += " There is more to it, which these channels do not settle.";
    }
    words += named ? whatMayBeAdded(f) : string();
    words += whatIsStillOff(f);
    if (!wasTried(f))
    {
        words += " No held-out data had a misfit that could confirm it.";
    }
    return words;
}


//- The fault of the best with its size, and how sure that is
string faultInWords(const finding& f)
{
    const sensorFault& fault = *f.best().what.fault;
    const fitted& best = f.best().best;
    const vec size = best.x.tail(fault.size());
    segment at(f.data.segments.front());
    for (const segment& s : f.data.segments)
    {
        at = s.name == fault.channel ? s : at;
    }
    OStringStream os;
    os.precision(2);
    os << describe(fault, at, size).c_str();
    if (size.size() != 1 || !fault.hasSize())
    {
        return os.str();
    }
    const scalar deviation = best.deviation(best.x.size() - 1);
    if (deviation > 0 && mag(size[0]) > deviation)
    {
        os << ", +- " << 200*deviation/mag(size[0]) << " % of that (95 %)";
    }
    if (best.pinned.back() && mag(size[0]) > SMALL)
    {
        os << ", the largest that is looked for";
    }
    return os.str();
}


string ofNone(const finding& f)
{
    return
        f.gates.passed(gateKind::detection) ? whatGainsTooLittle(f)
      : string("Recording and calibrated simulation agree within what is"
            " uncertain.");
}


string ofUnknown(const finding& f)
{
    if (f.isUnproved())
    {
        return
            "It cannot be decided: " + theBest(f) + ", leads something that is not"
            " in the library by too little to be sure.";
    }
    if (failedGates(f) == wordList({gateNames[gateKind::computed]}))
    {
        return whatWasNotRun(f);
    }
    return
        "Something is missing, and nothing in the library explains it"
      + whatFails(f)
      + (
            f.failedExperiments.empty() ? string()
          : " The solver fails in experiment "
          + inWords(f.failedExperiments, "and") + '.'
        );
}


//- Without what the free correction says
string describeVerdict(const finding& f)
{
    const bool detected = f.gates.passed(gateKind::detection);
    if (f.verdict != verdictKind::none && !detected)
    {
        return
            "The channels that were fitted agree with the calibrated simulation, "
          + whatElsewhereSays(f);
    }
    switch (f.verdict)
    {
        case verdictKind::none:
            return ofNone(f);
        case verdictKind::unknown:
            return ofUnknown(f);
        case verdictKind::sensor:
            return
                "A sensor, or something that no other channel sees: "
              + faultInWords(f) + '.';
        case verdictKind::registration:
            return
                "Not physics: " + faultInWords(f) + '.'
              + (
                    f.hasMore()
                  ? " There is more to it, which these channels do not settle."
                  : ""
                );
        default:
            return whatIsLeftOut(f);
    }
}

} // End anonymous namespace


Foam::wordList Foam::misfit::answerOf(const finding& f)
{
    wordList names(f.names);
    for (const scored& w : f.alternatives)
    {
        // As where one is named, names are of mechanisms and faults
        names.append(word(describe(w.what.known(), f.library), false));
    }
    return names;
}


Foam::string Foam::misfit::describe(const finding& f)
{
    const correctionFound& c = f.correction;
    return
        c.named ? "Left out, and in no candidate: " + describe(c)
      : describeVerdict(f) + whatCouldNotBeAsked(f)
      + (c.asked ? ' ' + describe(c) : string());
}
