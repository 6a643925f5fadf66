// SPDX-License-Identifier: GPL-3.0-or-later
// verdict.json: the record of a diagnosis.

#include "report.H"
#include "words.H"
#include "textFile.H"

#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using json = nlohmann::ordered_json;

//- Of the record: grows with each change of what its keys are or mean
constexpr label schema = 4;


//- An array with what a function makes of each
template<class Container, class Function>
json each(const Container& things, const Function& written)
{
    json all = json::array();
    for (const auto& thing : things)
    {
        all.push_back(written(thing));
    }
    return all;
}


json list(const wordList& names)
{
    return each(names, [](const word& name) { return json(name); });
}


json numbers(const vec& v)
{
    return each(v, [](const scalar value) { return json(value); });
}


//- What is at its bound has none
json deviation(const scalar value, const bool pinned)
{
    return pinned ? json(nullptr) : json(value);
}


json gates(const finding& f)
{
    json all = json::array();
    for (const misfit::gate& g : f.gates)
    {
        const gateWords words(describe(g, f));
        all.push_back
        ({
            {"name", gateNames[g.kind]},
            {"asked", words.asked},
            {"value", words.value},
            {"bound", words.bound},
            {"result", g.applies ? g.passed ? "passed" : "failed" : "none"}
        });
    }
    return all;
}


json parameters(const finding& f)
{
    json all = json::array();
    const fitted& with = f.best().best;
    forAll(f.parameters, i)
    {
        const calibrated& p = f.parameters[i];
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


//- The fault that is given as the answer, with its size in SI units
json fault(const finding& f)
{
    const hypothesis& what = f.best().what;
    if (!f.blamesChannel() || !what.fault)
    {
        return nullptr;
    }
    const fitted& best = f.best().best;
    const label n = what.fault->size();
    json deviations = json::array();
    for (label i = best.x.size() - n; i < best.x.size(); ++i)
    {
        deviations.push_back(deviation(best.deviation(i), best.pinned[i]));
    }
    return
    {
        {"channel", what.fault->channel},
        {"kind", kindOf(*what.fault)},
        {"values", numbers(best.x.tail(n))},
        {"deviations", deviations}
    };
}


json strength(const foundStrength& s)
{
    return
    {
        {"name", s.name},
        {"value", s.value},
        {"deviation", deviation(s.deviation, s.pinned)},
        {"atBound", s.pinned}
    };
}


json located(const finding& f)
{
    json all = json::array();
    for (const place& p : f.located)
    {
        const window& w = p.where;
        const segment& s = f.data.segments[w.segment];
        all.push_back
        ({
            {"channel", s.name},
            {"from", s.x[w.begin] - 0.5*s.span},
            {"to", s.x[w.end - 1] + 0.5*s.span},
            {"sigma", w.size},
            {"phase", phaseOf(s, f.data.y, w)},
            {"words", describe(p, f.data)}
        });
    }
    return all;
}


json match(const heldOut& h)
{
    return
    {
        {"what", describe(h)},
        {"use", purposeNames[h.use]},
        {"meanSquareBefore", h.squareBefore},
        {"meanSquareAfter", h.squareAfter}
    };
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


json law(const fittedLaw& l)
{
    return
    {
        {"family", l.law.family},
        {"groups", list(l.law.groups)},
        {"words", describe(l)},
        {"lead", l.lead}
    };
}


//- Null where it was not asked for
json freeCorrection(const correctionFound& c)
{
    if (!c.asked)
    {
        return nullptr;
    }
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
        {"failed", list(c.failed)}
    };
}


//- Standard deviations by channel and by what they come from, in SI units
json uncertainty(const finding& f)
{
    json all = json::object();
    for (const segment& s : f.data.segments)
    {
        all[s.name]["whole"] = s.rootMeanSquare(f.sigma);
        for (const uncertaintySource& source : f.sources)
        {
            all[s.name][source.first] = s.rootMeanSquare(source.second);
        }
    }
    return all;
}


json posterior(const finding& f)
{
    json all = json::array();
    for (const auto& p : f.posterior)
    {
        if (p.second > 1e-4)
        {
            all.push_back
            ({
                {"explanation", describe(p.first, f.library)},
                {"probability", p.second}
            });
        }
    }
    return all;
}


//- Null where no case of the table is like it
json grounds(const finding& f)
{
    json all = nullptr;
    for (label i = 0; i < f.grounds.size(); ++i)
    {
        all[groundNames[i]] = f.grounds[i];
    }
    return all;
}


json dropped(const droppedCandidate& d)
{
    return {{"name", d.name}, {"why", describe(d)}};
}


json failed(const failedRun& run)
{
    return describe(run);
}


json apart(const finding& f)
{
    json all = json::object();
    forAll(f.candidates, i)
    {
        all[f.candidates[i]] = numbers(f.apart.row(i).transpose());
    }
    return all;
}

} // End anonymous namespace


std::string Foam::misfit::shortNumber(const scalar value)
{
    std::ostringstream os;
    os << std::setprecision(4) << value;
    return os.str();
}


std::string Foam::misfit::verdictJson(const finding& f, const string& title)
{
    return json
    ({
        {"schema", schema},
        {"case", title},
        {"verdict", verdictNames[f.verdict]},
        {"names", list(answerOf(f))},
        {"words", describe(f)},
        {"confidence", std::round(1000*f.confidence)/1000},
        {"confidenceFrom", grounds(f)},
        {"strengths", each(f.strengths, &strength)},
        {"fault", fault(f)},
        {"detection", {{"pRaw", f.raw.p}, {"p", f.detection.p}}},
        {"located", located(f)},
        {"calibration", parameters(f)},
        {"uncertainty", uncertainty(f)},
        {"gates", gates(f)},
        {"heldOut", each(f.held, &match)},
        {"freeCorrection", freeCorrection(f.correction)},
        {"posterior", posterior(f)},
        {"dropped", each(f.dropped, &dropped)},
        {"failedRuns", each(f.failedRuns, &failed)},
        {"correctedCase", f.answer.size() ? json(correctedCase) : json(nullptr)},
        {"apart", apart(f)},
        {"advice", adviceOf(f)},
        {"statesAskedFor", f.nRuns}
    }).dump(2) + '\n';
}


void Foam::misfit::writeReport
(
    const finding& f,
    const fileName& folder,
    const origin& from
)
{
    const List<fileName> figures(drawFigures(f, folder/"plots"));
    writeWhole(folder/"report.html", reportHtml(f, from, figures));
    writeWhole(folder/"verdict.json", verdictJson(f, from.title));
}
