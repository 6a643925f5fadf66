// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: the verdict.

#include "words.H"

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


string whatCouldNotBeAsked(const finding& f)
{
    const wordList& names = f.failing;
    return
        names.empty() ? string()
      : " Not asked, as the solver failed with it: " + inWords(names, "and")
      + '.';
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
            return leftOutInWords(f);
    }
}

//- What the confidence is the confidence of
string whatIsSure(const finding& f)
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
string sureFrom(const finding& f)
{
    if (f.grounds.size() == 0)
    {
        return
            ", by its score alone: no case whose cause was known had such a law.";
    }
    const bool ofClock =
        f.verdict != verdictKind::registration
     || f.best().what.fault->kind == faultKind::clock;
    return
        ", the fraction of such verdicts that was right in cases whose cause was"
        " known" + string(ofClock ? "." : ", in all of which it was the clock.");
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


Foam::string Foam::misfit::sureThat(const finding& f)
{
    return whatIsSure(f) + sureFrom(f);
}
