// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: its parts.

#include "words.H"
#include "report.H"
#include "StringStream.H"
#include "units.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- What a fault does, after the name of its channel. u: to be read; unit: with a blank
void print(Ostream& os, const sensorFault& f, const vec& u, const char* unit)
{
    const auto way = [&u](const char* up, const char* down)
    {
        return u[0] > 0 ? up : down;
    };
    switch (f.kind)
    {
        case faultKind::clock:
            os << "'s clock is " << mag(u[0]) << " s " << way("late", "early");
            break;
        case faultKind::clogged:
            os << " is clogged: it lags by " << u[0] << " s and shows "
                << 100*(1 + u[1]) << " % of what is there";
            break;
        case faultKind::dead:
            os << " shows " << u[0] << unit
                << " throughout, whatever happens: it is dead or stuck";
            break;
        case faultKind::drift:
            os << " drifts by " << mag(u[0]) << unit << ' ' << way("up", "down")
                << " over the record";
            break;
        case faultKind::gain:
            os << " reads " << mag(100*u[0]) << " % too " << way("high", "low");
            break;
        case faultKind::lag:
            os << " lags by " << u[0] << " s";
            break;
        case faultKind::misplaced:
            os << " is not at its place but " << 100*u[0]
                << " % of the way to " << f.partner.c_str();
            break;
        case faultKind::saturated:
            os << " is saturated: it shows nothing above " << u[0] << unit;
            break;
        case faultKind::swapped:
            os << " and " << f.partner.c_str() << " are exchanged";
            break;
        case faultKind::units:
            os << " is in another unit: its values are " << f.factor
                << " times what they should be";
            break;
        case faultKind::zero:
            os << "'s zero is off: it reads " << mag(u[0]) << unit << " too "
                << way("high", "low") << " throughout";
            break;
    }
}


scalar rounded(const scalar v)
{
    const scalar last =
        std::pow(10.0, std::floor(std::log10(max(mag(v), VSMALL))) - 2);
    return mag(v) <= VSMALL ? 0 : last*std::round(v/last);
}

} // End anonymous namespace


Foam::string Foam::misfit::inWords(const wordList& list, const string& last)
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


Foam::string Foam::misfit::kindOf(const sensorFault& fault)
{
    const std::string between
    (
        fault.partner.empty() ? ""
      : fault.kind == faultKind::misplaced ? " towards " : " with "
    );
    return nameOf(fault.kind) + between + fault.partner;
}


Foam::string Foam::misfit::describe(const sensorFault& fault)
{
    const std::string kind(kindOf(fault));
    const std::string name(nameOf(fault.kind));
    return name + " of " + fault.channel + kind.substr(name.size());
}


Foam::string Foam::misfit::describe
(
    const sensorFault& fault,
    const segment& at,
    const vec& unknowns
)
{
    // Nought where it is far below its noise
    vec u = unknowns.unaryExpr(&rounded);
    if (fault.kind == faultKind::dead && mag(u[0]) <= 0.01*at.uncertainty)
    {
        u[0] = 0;
    }
    const string unit(" " + siUnit(at.quantity));
    OStringStream os;
    os.precision(7);
    os << fault.channel.c_str();
    print(os, fault, u, unit.c_str());
    return os.str();
}


Foam::string Foam::misfit::describe
(
    const hypothesis& h,
    const wordList& mechanisms
)
{
    if (h.isOnlyUnknown())
    {
        return "unknown";
    }
    string words(h.fault ? describe(*h.fault) : string());
    for (const int m : h.mechanisms)
    {
        words += (words.empty() ? "" : " and ") + mechanisms[m];
    }
    if (h.unknown)
    {
        words += " and something unknown";
    }
    return words.empty() ? string("none") : words;
}


Foam::string Foam::misfit::phaseOf
(
    const segment& s,
    const vec& y,
    const window& w
)
{
    if (!s.overTime)
    {
        return s.isNumber() ? "number" : "profile";
    }
    switch (statistics::phaseOf(s, y, w.begin, w.end))
    {
        case statistics::phase::before: return "before";
        case statistics::phase::front: return "front";
        case statistics::phase::body: return "body";
        case statistics::phase::tail: return "tail";
        default: return "after";
    }
}


Foam::string Foam::misfit::describe(const place& p, const stacked& data)
{
    const window& w = p.where;
    const segment& s = data.segments[w.segment];
    const scalar share = 100*mag(p.mean)/max(s.range(data.y), VSMALL);

    OStringStream os;
    os.precision(3);
    os << s.quantity.c_str() << ' ' << s.name.c_str();
    if (s.hasPlace)
    {
        os << " at (" << s.place.x() << ' ' << s.place.y() << ' '
            << s.place.z() << ')';
    }
    if (!s.isNumber())
    {
        os << ", " << s.x[w.begin] - 0.5*s.span << " to "
            << s.x[w.end - 1] + 0.5*s.span << (s.overTime ? " s" : " m");
    }
    os << ": the simulation is "
        << (share > 1000 ? "more than 1000" : shortNumber(share, 3).c_str())
        << (s.isNumber() ? " % too " : " % of the range too ")
        << (p.mean > 0 ? "low" : "high") << " (" << mag(w.size) << " sigma)";
    if (!s.isNumber())
    {
        os << ", " << phaseOf(s, data.y, w).c_str();
    }
    return os.str();
}


Foam::string Foam::misfit::describe(const heldOut& h)
{
    switch (h.what)
    {
        case heldOut::part::validation: return "validation channels";
        case heldOut::part::test: return "test channels";
        case heldOut::part::experiment: return "experiment " + h.experiment;
        default: return "test channels of experiment " + h.experiment;
    }
}


Foam::string Foam::misfit::describe(const droppedCandidate& d)
{
    switch (d.why)
    {
        case droppedCandidate::reason::failedAlways:
            return "the solver failed in each run with it";
        case droppedCandidate::reason::failed:
            return "the solver failed with it: " + d.failure;
        case droppedCandidate::reason::opposite:
            return "the recording differs the other way in what it changes";
        default:
            return
                "it can change at most " + Foam::name(100*d.bound)
              + " % and the misfit is " + Foam::name(100*d.misfit) + " %";
    }
}


Foam::string Foam::misfit::describe(const failedRun& r)
{
    return describe(r.state) + ": " + r.why;
}


Foam::string Foam::misfit::adviceOf(const finding& f)
{
    const advice& a = f.measure;
    std::vector<string> two;
    for (const hypothesis& h : a.two)
    {
        two.push_back(describe(h, f.library));
    }
    switch (a.what)
    {
        case advice::kind::notRun:
            return
                "Which measurement would decide it was not looked for, since "
              + two[0] + " was not run in the solver (refit in decision)";
        case advice::kind::measure:
        {
            OStringStream os;
            os.precision(3);
            os << "Measure " << a.channel.name.c_str() << ": at " << a.at
                << (a.channel.overTime ? " s" : " m") << ", "
                << two[0].c_str() << " and " << two[1].c_str()
                << " differ there by " << a.times << " times its uncertainty";
            return os.str();
        }
        case advice::kind::elsewhere:
            return
                "The channels that are there, also the possible ones that the"
                " dictionary names, do not tell " + two[0] + " from " + two[1]
              + ". Measure another quantity or nearer to where they act; name it in"
                " channels without a file, and its use is computed here";
        case advice::kind::check:
        {
            const auto channel = [](const winner& w) { return w.channel; };
            return
                "The answer hangs on " + joined(f.winners, " and ", channel)
              + ": check what was recorded there, or measure it a second time";
        }
        default:
            return "";
    }
}
