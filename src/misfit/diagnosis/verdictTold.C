// SPDX-License-Identifier: GPL-3.0-or-later
// S9: the verdict in sentences.

#include "diagnosis.H"
#include "StringStream.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Words in a row: "a, b or c"
string inWords(const wordList& list, const string& last)
{
    string words;
    forAll(list, i)
    {
        words +=
            (i == 0 ? "" : i + 1 == list.size() ? ' ' + last + ' ' : ", ")
          + list[i];
    }
    return words;
}

} // End anonymous namespace


Foam::string Foam::misfit::diagnosis::theBest() const
{
    const hypothesis& what = best().what;
    if (what.isOnlyUnknown())
    {
        return "that it is something that is not in the library";
    }
    if (what.fault)
    {
        return
            "the best explanation, a fault of " + what.fault->channel() + " ("
          + what.fault->kind() + ")";
    }
    for (const weighed& w : found_.explanations)
    {
        const bool more =
            w.what.mechanisms.size() > what.mechanisms.size()
         && w.what.contains(what);
        if (more && w.score == lowestScore())
        {
            return
                "the best simple explanation, " + told(what, mechanismNames())
              + " (" + told(w.what, mechanismNames())
              + " match better, but by too little to be told from it)";
        }
    }
    return "the best explanation, " + told(what, mechanismNames());
}


Foam::string Foam::misfit::diagnosis::alternatives() const
{
    bool mixed = false;
    for (const weighed& w : set_)
    {
        mixed =
            mixed || w.what.mechanisms.size() > 1
         || (w.what.unknown && w.what.mechanisms.size());
    }
    if (!mixed)
    {
        return inWords(found_.names, "or");
    }
    string words;
    for (const weighed& w : set_)
    {
        words +=
            (words.empty() ? "" : ", or ") + told(w.what, mechanismNames())
          + (w.what.mechanisms.size() > 1 ? " together" : "");
    }
    return words;
}


Foam::string Foam::misfit::diagnosis::whatFails() const
{
    if (best().what.isNone() || best().what.isOnlyUnknown())
    {
        return ".";
    }
    const wordList failed(failedGates());
    const bool agreesElsewhere =
        passed("heldOut") && passed("harm") && passed("transfer");
    return
        " well enough: " + theBest() + ", "
      + (failed.empty() ? string("leads too little")
          : "does not pass " + inWords(failed, "and"))
      + (agreesElsewhere ? ". Two faulty sensors look like that, too." : ".")
      + (passed("harm") ? "" : " It makes the match of held-out channels worse.");
}


Foam::string Foam::misfit::diagnosis::whatWasNotRun() const
{
    return
        failedExperiments_.empty()
      ? "It cannot be decided: the solver failed with " + theBest()
      + ", at the strength that was fitted."
      : "It cannot be decided: " + theBest()
      + ", is not confirmed, as the solver fails in experiment "
      + inWords(failedExperiments_, "and") + ".";
}


Foam::string Foam::misfit::diagnosis::whatGainsTooLittle() const
{
    string words("Recording and simulation part, but too little to say why");
    if (!best().what.isNone())
    {
        words +=
            ": " + theBest() + ", does not pass evidence";
    }
    return words + '.';
}


Foam::string Foam::misfit::diagnosis::whatMayBeAdded() const
{
    // A lead of less is not worth a mention (Kass & Raftery 1995, J. Am. Stat.
    // Assoc. 90:777)
    const scalar mention = 2;
    for (const weighed& w : found_.explanations)
    {
        const bool better =
            w.what.mechanisms.size() > best().what.mechanisms.size()
         && w.what.contains(best().what)
         && w.score == lowestScore() && w.score < best().score - mention;
        if (better)
        {
            return
                " Together, " + told(w.what.known(), mechanismNames())
              + " match better, but by no more than another formula of what is"
                " named may.";
        }
    }
    return "";
}


bool Foam::misfit::diagnosis::mayBeTogether() const
{
    for (const weighed& w : rivals())
    {
        const bool all =
            hasAllThatIsNamed(w)
         && w.what.mechanisms.size() == found_.names.size();
        if (all && found_.names.size() == 2)
        {
            return true;
        }
    }
    return false;
}


Foam::string Foam::misfit::diagnosis::strengthsInWords() const
{
    OStringStream os;
    os.precision(3);
    string before("; strength of ");
    if (found_.verdict == "set" || partly_)
    {
        before =
            ". As fitted with " + told(best().what, mechanismNames())
          + ": strength of ";
    }
    for (const foundStrength& s : found_.strengths)
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


Foam::string Foam::misfit::diagnosis::whatElsewhereSays() const
{
    for (const heldOut& h : found_.held)
    {
        if (h.use == purpose::gate && h.squareBefore >= limitOfNothing(h))
        {
            return
                "held-out ones do not (they do not pass "
              + inWords(failedGates(), "and") + "). Fit those too to learn why.";
        }
    }
    return
        "but the solver fails in experiment " + inWords(failedExperiments_, "and")
      + ", which should confirm it.";
}


Foam::string Foam::misfit::diagnosis::whatIsStillOff() const
{
    OStringStream os;
    os.precision(3);
    for (const heldOut& h : found_.held)
    {
        if (h.use == purpose::gate && h.squareAfter > matchLimit(h))
        {
            os  << " It does not yet match " << h.what.c_str() << ": mean square "
                << h.squareAfter << ", a match is 1.";
        }
    }
    return os.str();
}


Foam::string Foam::misfit::diagnosis::whatCouldNotBeAsked() const
{
    const wordList names(namesOf(never_));
    return
        names.empty() ? string()
      : " Not asked, as the solver failed with it: " + inWords(names, "and")
      + '.';
}


Foam::string Foam::misfit::diagnosis::whatWinsWithout() const
{
    string words;
    for (const weighed& one : set_)
    {
        wordList channels;
        for (const Tuple2<word, weighed>& w : winners_)
        {
            const hypothesis& other = w.second().what;
            if (other.fault == one.what.fault && other.hasMechanismsOf(one.what))
            {
                channels.append(w.first());
            }
        }
        if (channels.size())
        {
            words +=
                (words.empty() ? " Without " : "; without ")
              + inWords(channels, "or") + " a better match is "
              + told(one.what, mechanismNames());
        }
    }
    return words + (words.empty() ? "" : ".");
}


Foam::string Foam::misfit::diagnosis::whatIsLeftOut() const
{
    const bool named = found_.verdict == "named";
    string words
    (
        named
      ? "Left out: " + inWords(found_.names, "and")
      : "Left out is one of these"
      + string(weakened_ ? ": " : ", which these channels cannot tell apart: ")
      + alternatives() + (mayBeTogether() ? ", or both" : "")
    );
    words += strengthsInWords() + '.' + whatWinsWithout();
    if (named && hasMore())
    {
        words += " There is more to it, which these channels do not settle.";
    }
    words += named ? whatMayBeAdded() : string();
    words += whatIsStillOff();
    if (!wasTried())
    {
        words += " No held-out data had a misfit that could confirm it.";
    }
    return words;
}


Foam::string Foam::misfit::diagnosis::faultInWords() const
{
    const hypothesisModel model(fit_->surface(), bounds_, best().what);
    const vec size = model.ofFault(best().best.x);
    OStringStream os;
    os.precision(2);
    os << best().what.fault->told(size).c_str();
    if (size.size() != 1 || !best().what.fault->hasSize())
    {
        return os.str();
    }
    const scalar deviation = best().best.deviation(best().best.x.size() - 1);
    if (deviation > 0 && mag(size[0]) > deviation)
    {
        os << ", +- " << 200*deviation/mag(size[0]) << " % of that (95 %)";
    }
    if (best().best.pinned.last() && mag(size[0]) > SMALL)
    {
        os << ", the largest that is looked for";
    }
    return os.str();
}


void Foam::misfit::diagnosis::describe()
{
    const word& v = found_.verdict;
    if (v == "none")
    {
        found_.told =
            passed("detection") ? whatGainsTooLittle()
          : string("Recording and calibrated simulation agree within what is"
                " uncertain.");
    }
    else if (!passed("detection"))
    {
        found_.told =
            "The channels that were fitted agree with the calibrated simulation, "
          + whatElsewhereSays();
    }
    else if (isUnproved())
    {
        found_.told =
            "It cannot be decided: " + theBest() + ", leads something that is not"
            " in the library by too little to be sure.";
    }
    else if (v == "unknown" && failedGates() == wordList({"computed"}))
    {
        found_.told = whatWasNotRun();
    }
    else if (v == "unknown")
    {
        found_.told =
            "Something is missing, and nothing in the library explains it"
          + whatFails();
        if (failedExperiments_.size())
        {
            found_.told +=
                " The solver fails in experiment "
              + inWords(failedExperiments_, "and") + '.';
        }
    }
    else if (found_.blamesChannel())
    {
        found_.told =
            (
                v == "sensor"
              ? "A sensor, or something that no other channel sees: "
              : "Not physics: "
            )
          + faultInWords() + '.';
    }
    else
    {
        found_.told = whatIsLeftOut();
    }
    found_.told += whatCouldNotBeAsked();
}
