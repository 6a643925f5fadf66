// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: its parts.

#include "words.H"
#include "adviceNames.H"
#include "shortNumber.H"
#include "units.H"

#include "Enum.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

const Enum<statistics::phase> phaseNames
({
    {statistics::phase::before, "before"},
    {statistics::phase::front, "front"},
    {statistics::phase::body, "body"},
    {statistics::phase::tail, "tail"},
    {statistics::phase::after, "after"}
});


const char* axisOf(const segment& s)
{
    return s.overTime ? "s" : "m";
}


//- Of a recorder of several experiments: in which of them
std::string inOneOf(const sensorFault& fault)
{
    return fault.isInSeveral ? " in experiment " + fault.experiment : "";
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


std::string Foam::misfit::unitOf(const word& quantity)
{
    const word unit(siUnit(quantity));
    return unit.empty() ? "" : '[' + unit + ']';
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
    return name + " of " + fault.channel + kind.substr(name.size()) + inOneOf(fault);
}


Foam::string Foam::misfit::describe
(
    const sensorFault& fault,
    const segment& at,
    const vec& unknowns
)
{
    // Nought where it is far below its noise
    vec u = unknowns.unaryExpr([](const scalar x) { return rounded(x, 3); });
    if (fault.kind == faultKind::dead && mag(u[0]) <= 0.01*at.uncertainty)
    {
        u[0] = 0;
    }
    const auto number = [](const scalar x) { return numberWords(x, 7); };
    json facts =
    {
        {nameOf(fault.kind), true},
        {"channel", fault.channel},
        {"partner", fault.partner},
        {"factor", number(fault.factor)},
        {"unit", " " + siUnit(at.quantity)}
    };
    if (u.size())
    {
        facts["value"] = number(u[0]);
        facts["size"] = number(mag(u[0]));
        facts["percent"] = number(mag(100*u[0]));
        facts["left"] = number(100*(1 + u[u.size() - 1]));
        facts["up"] = u[0] > 0;
    }
    return renderTemplate("fault", facts) + inOneOf(fault);
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
    return
        s.overTime ? phaseNames[statistics::phaseOf(s, y, w.begin, w.end)]
      : word(s.isNumber() ? "number" : "profile");
}


Foam::string Foam::misfit::describe(const place& p, const stacked& data)
{
    const window& w = p.where;
    const segment& s = data.segments[w.segment];
    const scalar share = 100*mag(p.mean)/max(s.range(data.y), VSMALL);
    const auto number = [](const scalar x) { return numberWords(x, 3); };
    json facts =
    {
        {"quantity", s.quantity},
        {"channel", s.name},
        {"share", share > 1000 ? "more than 1000" : number(share)},
        {"low", p.mean > 0},
        {"size", ratioWords(mag(w.size), 3)}
    };
    if (s.hasPlace)
    {
        facts["at"] =
            number(s.place.x()) + ' ' + number(s.place.y()) + ' '
          + number(s.place.z());
    }
    if (!s.isNumber())
    {
        facts["from"] = number(s.x[w.begin] - 0.5*s.span);
        facts["to"] = number(s.x[w.end - 1] + 0.5*s.span);
        facts["axis"] = axisOf(s);
        facts["phase"] = phaseOf(s, data.y, w);
    }
    return renderTemplate("place", facts);
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
    return renderTemplate
    (
        "dropped",
        {
            {dropReasonNames[d.why], true},
            {"failure", d.failure},
            {"bound", ratioWords(100*d.bound)},
            {"misfit", ratioWords(100*d.misfit)}
        }
    );
}


Foam::string Foam::misfit::describe(const failedRun& r)
{
    return describe(r.state) + ": " + r.why;
}


Foam::string Foam::misfit::adviceOf(const finding& f)
{
    const advice& a = f.verdict.measure;
    const auto name = [&](const label i)
    {
        return i < count(a.two) ? describe(a.two[i], f.library) : string();
    };
    return renderTemplate
    (
        "advice",
        {
            {adviceNames[a.what], true},
            {"one", name(0)},
            {"other", name(1)},
            {"channel", a.channel.name},
            {"at", numberWords(a.at, 3)},
            {"axis", axisOf(a.channel)},
            {"times", ratioWords(a.times, 3)},
            {"channels", joined(f.tests.winners, " and ", [](const winner& w)
            {
                return w.channel;
            })}
        }
    );
}
