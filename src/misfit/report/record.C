// SPDX-License-Identifier: GPL-3.0-or-later
// The record of a diagnosis.

#include "record.H"
#include "words.H"
#include "adviceNames.H"
#include "lawFunctions.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Probability from which an explanation is in the record [-], as its schema states: the
//  sum of those below changes no digit that a reader uses
constexpr scalar leastProbability = 1e-4;


//- What is at its bound has none
json deviation(const scalar value, const bool pinned)
{
    return pinned ? json(nullptr) : json(value);
}


//- Null where there is none
json orNull(const std::string& name)
{
    return name.empty() ? json() : json(name);
}


json parameters(const finding& f)
{
    json all = json::array();
    const fitResult& with = f.best().fit;
    forAll(f.detection.parameters, i)
    {
        const calibratedParameter& p = f.detection.parameters[i];
        all.push_back
        ({
            {"name", p.name},
            {"before", p.before},
            {"priorDeviation", p.prior},
            {"value", p.value},
            {"deviation", deviation(p.deviation, p.pinned)},
            {"atBound", p.pinned}
        });
        if (answerOf(f).size() && !f.correction.named)
        {
            all.back()["valueWithFinding"] = with.x[i];
            all.back()["deviationWithFinding"] =
                deviation(with.deviation(i), with.pinned[i]);
        }
    }
    return all;
}


//- The channel or recorder that is blamed, and how, without the size
json kindOfFault(const sensorFault& fault)
{
    return
    {
        {"channel", fault.channel},
        {"experiment", fault.experiment},
        {"kind", nameOf(fault.kind)},
        {"partner", orNull(fault.partner)}
    };
}


//- The fault that is given as the answer, with its size in SI units
json fault(const finding& f)
{
    const hypothesis& what = f.best().what;
    if (!f.verdict.blamesChannel() || !what.fault)
    {
        return nullptr;
    }
    const fitResult& best = f.best().fit;
    const label n = what.fault->size();
    json deviations = json::array();
    for (label i = best.x.size() - n; i < best.x.size(); ++i)
    {
        deviations.push_back(deviation(best.deviation(i), best.pinned[i]));
    }
    json all(kindOfFault(*what.fault));
    all["values"] = vec(best.x.tail(n));
    all["deviations"] = deviations;
    return all;
}


json mechanisms(const hypothesis& h, const wordList& library)
{
    return each(h.mechanisms, [&](const int m) { return library[m]; });
}


//- An explanation: its mechanisms, the fault that it has, null for none, and whether
//  something unknown is part of it
json explanation(const hypothesis& h, const wordList& library)
{
    return
    {
        {"mechanisms", mechanisms(h, library)},
        {"fault", h.fault ? kindOfFault(*h.fault) : json()},
        {"unknown", h.unknown}
    };
}


json strength(const fittedStrength& s)
{
    return
    {
        {"name", s.name},
        {"value", s.value},
        {"deviation", deviation(s.deviation, s.pinned)},
        {"atBound", s.pinned}
    };
}


json located(const place& p, const stacked& data)
{
    const window& w = p.where;
    const segment& s = data.segments[w.segment];
    return
    {
        {"channel", s.name},
        {"from", s.x[w.begin] - 0.5*s.span},
        {"to", s.x[w.end - 1] + 0.5*s.span},
        {"sigma", w.size},
        {"phase", phaseOf(s, data.y, w)},
        {"words", describe(p, data)}
    };
}


//- Null where there is none
json timeOf(const std::optional<scalar>& time)
{
    return time ? json(*time) : json();
}


//- Times in s
json departureRecord(const departure& d)
{
    return
    {
        {"experiment", d.experiment},
        {"channel", d.channel},
        {"use", purposeNames[d.use]},
        {"arrivalRecorded", timeOf(d.recorded)},
        {"arrivalSimulated", timeOf(d.simulated)},
        {"differsFrom", timeOf(d.differs)}
    };
}


json match(const heldOut& h)
{
    json all(heldOutData(h));
    all["meanSquareBefore"] = h.squareBefore;
    all["meanSquareAfter"] = h.squareAfter;
    return all;
}


json element(const freeElement& e)
{
    return
    {
        {"name", e.element.name},
        {"words", describe(e.element, e.value)},
        {"value", e.value},
        {"deviation", e.deviation}
    };
}


//- The functions of a law, with the middle of their groups
json functions(const fittedLaw& l)
{
    json all = json::array();
    forAll(l.law.functions, i)
    {
        all.push_back
        ({
            {"name", functionsOf(l.law.family)[l.law.functions[i]].name},
            {"coefficient", l.coefficients[i]},
            {"deviation", l.deviations[i]},
            {"middle", l.law.middle[i]}
        });
    }
    return all;
}


json law(const fittedLaw& l)
{
    return
    {
        {"family", familyNames[l.law.family]},
        {"groups", l.law.groups},
        {"functions", functions(l)},
        {"words", describe(l)},
        {"lead", l.lead}
    };
}


json freeCorrection(const correctionFit& c)
{
    return
    {
        {"words", describe(c)},
        {"gain", c.gain},
        {"elements", each(c.elements, &element)},
        {"laws", each(c.laws, &law)},
        {"explainedByFirstLaw", c.explained},
        {"transfers", c.transfers},
        {"named", c.named},
        {"chanceOfWhatIsLeft", c.left},
        {"failed", c.failed}
    };
}


//- Standard deviations by channel and by what they come from, in SI units
json uncertainty(const finding& f)
{
    json all = json::object();
    for (const segment& s : f.detection.data.segments)
    {
        all[s.name]["whole"] = s.rootMeanSquare(f.detection.sigma);
        for (const uncertaintySource& source : f.detection.sources)
        {
            all[s.name][source.first] = s.rootMeanSquare(source.second);
        }
    }
    return all;
}


//- Of each explanation, the likeliest first
json posterior(const finding& f)
{
    json all = json::array();
    for (const hypothesisFit* w : f.explained.byScore())
    {
        if (w->probability > leastProbability)
        {
            all.push_back(explanation(w->what, f.library));
            all.back()["probability"] = w->probability;
        }
    }
    return all;
}


//- Null where no case of the table is like it
json grounds(const finding& f)
{
    json all = nullptr;
    for (label i = 0; i < f.verdict.grounds.size(); ++i)
    {
        all[groundNames[i]] = f.verdict.grounds[i];
    }
    return all;
}


json apart(const finding& f)
{
    json all = json::object();
    forAll(f.apart.names, i)
    {
        all[f.apart.names[i]] = vec(f.apart.distances.row(i).transpose());
    }
    return all;
}


//- A candidate without a score. Of one that can change too little: how much it can, and
//  the misfit, as shares of the range of a channel
json droppedRecord(const droppedCandidate& d)
{
    const bool isSmall = d.why == droppedCandidate::reason::small;
    return
    {
        {"name", d.name},
        {"reason", dropReasonNames[d.why]},
        {"failure", d.failure},
        {"bound", isSmall ? json(d.bound) : json()},
        {"misfit", isSmall ? json(d.misfit) : json()}
    };
}


json numbersOf(const HashTable<scalar>& table)
{
    json all = json::object();
    for (const word& name : table.sortedToc())
    {
        all[name] = table[name];
    }
    return all;
}


json failure(const failedRun& run)
{
    const runState& state = run.state;
    return
    {
        {"experiment", state.experiment},
        {"replicate", state.replicate},
        {"resolution", state.resolution},
        {"parameters", numbersOf(state.parameters)},
        {"strengths", numbersOf(state.strengths)},
        {"why", run.why}
    };
}


//- What measurement would settle what is open: null where there is none. Channels: the
//  one to record, or those that the answer depends on
json adviceRecord(const finding& f)
{
    const advice& a = f.verdict.measure;
    if (a.what == advice::kind::nothing)
    {
        return nullptr;
    }
    const bool isMeasure = a.what == advice::kind::measure;
    json channels = json::array();
    if (isMeasure)
    {
        channels.push_back(a.channel.name);
    }
    else if (a.what == advice::kind::check)
    {
        channels = each(f.tests.winners, [](const winner& w) { return w.channel; });
    }
    const auto described = [&f](const hypothesis& h)
    {
        return explanation(h, f.library);
    };
    return
    {
        {"kind", adviceNames[a.what]},
        {"explanations", each(a.two, described)},
        {"channels", channels},
        {"at", isMeasure ? json(a.at) : json()},
        {"times", isMeasure ? json(a.times) : json()},
        {"words", adviceOf(f)}
    };
}


//- A gate: what it is about, its number, and whether that must be below the limit or at
//  least as large; channels without which another explanation wins; why a run failed.
//  Numbers are in the unit of the gate, most of them without one
json gateNumbers(const gate& g, const finding& f)
{
    const bool isOfHeldOut = g.held >= 0;
    const json data(isOfHeldOut ? heldOutData(f.tests.held[g.held]) : json());
    return
    {
        {"name", gateNames[g.kind]},
        {"experiment", isOfHeldOut ? data["experiment"] : json(g.experiment)},
        {"channels", isOfHeldOut ? data["channels"] : json::array()},
        {"value", g.value},
        {"limit", g.limit},
        {"bound", mustBeBelow(g.kind) ? "below" : "atLeast"},
        {"without", each(g.lost, [](const word& channel) { return channel; })},
        {"failure", g.failure},
        {"result", g.applies ? g.passed ? "passed" : "failed" : "none"}
    };
}

} // End anonymous namespace


Foam::misfit::json Foam::misfit::heldOutData(const heldOut& h)
{
    return
    {
        {"experiment", h.isHere() ? word() : h.experiment},
        {"use", purposeNames[h.use]},
        {"channels", each(h.data.segments, [](const segment& s) { return s.name; })}
    };
}


Foam::misfit::json
Foam::misfit::recordOf(const finding& f, const string& title)
{
    const auto where = [&f](const place& p) { return located(p, f.detection.data); };
    const auto members = [&f](const hypothesisFit& w)
    {
        return explanation(w.what, f.library);
    };
    const auto numbers = [&f](const gate& g) { return gateNumbers(g, f); };
    return
    {
        {"schema", recordSchema},
        {"case", title},
        {"verdict", verdictNames[f.verdict.kind]},
        {"names", answerOf(f)},
        {"alternatives", each(f.verdict.alternatives, members)},
        {"words", describe(f)},
        {"confidence", std::round(1000*f.verdict.confidence)/1000},
        {"confidenceFrom", grounds(f)},
        {"strengths", each(f.verdict.strengths, &strength)},
        {"fault", fault(f)},
        {"detection", {{"pRaw", f.detection.raw.p}, {"p", f.detection.calibrated.p}}},
        {"located", each(f.verdict.located, where)},
        {"departures", each(f.departures, &departureRecord)},
        {"calibration", parameters(f)},
        {"uncertainty", uncertainty(f)},
        {"gates", each(f.tests.gates, numbers)},
        {"heldOut", each(f.held(), &match)},
        {
            "freeCorrection",
            f.correction.isRequested ? freeCorrection(f.correction) : json()
        },
        {"posterior", posterior(f)},
        {"dropped", each(f.candidates.dropped, &droppedRecord)},
        {"failedRuns", each(f.failedRuns, &failure)},
        {"correctedCase", f.verdict.state ? json(correctedCase) : json()},
        {"apart", apart(f)},
        {"advice", adviceRecord(f)},
        {"statesRequested", f.nRuns}
    };
}
