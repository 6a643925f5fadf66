// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: what is named.

#include "words.H"
#include "StringStream.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- True if held-out data were asked, whatever they said
bool wasTried(const finding& f)
{
    return
        f.gates.applied(gateKind::heldOut)
     || f.gates.applied(gateKind::transfer);
}


string alternatives(const finding& f)
{
    const auto isMixed = [](const scored& w)
    {
        return
            w.what.mechanisms.size() > 1
         || (w.what.unknown && w.what.mechanisms.size());
    };
    if (std::none_of(f.alternatives.begin(), f.alternatives.end(), isMixed))
    {
        return inWords(answerOf(f), "or");
    }
    return joined(f.alternatives, ", or ", [&f](const scored& w)
    {
        return
            describe(w.what, f.library)
          + (w.what.mechanisms.size() > 1 ? " together" : "");
    });
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
    const auto hasOne = [](const scored& w) { return w.what.mechanisms.size() == 1; };
    const auto hasBoth = [&f](const scored& w)
    {
        const auto has = [&w](const scored& one)
        {
            return statistics::contains
            (
                w.what.mechanisms, one.what.mechanisms.front()
            );
        };
        return
            w.what.mechanisms.size() == 2
         && std::all_of(f.alternatives.begin(), f.alternatives.end(), has);
    };
    return
        f.alternatives.size() == 2
     && std::all_of(f.alternatives.begin(), f.alternatives.end(), hasOne)
     && std::any_of(f.rivals.begin(), f.rivals.end(), hasBoth);
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

} // End anonymous namespace


Foam::string Foam::misfit::leftOutInWords(const finding& f)
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


Foam::string Foam::misfit::faultInWords(const finding& f)
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
