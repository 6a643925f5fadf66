// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: the free correction and its laws.

#include "words.H"
#include "lawFunctions.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

string withDeviation(const scalar value, const scalar deviation)
{
    return numberWords(value, 3) + " +- " + numberWords(2*deviation, 3);
}


//- What it does to held-out data: the share of the misfit that is gone, and where none is
void addHeld(json& facts, const correctionFit& c)
{
    std::vector<string> gone;
    std::vector<string> worse;
    for (const heldOut& h : c.held)
    {
        if (h.squareAfter > h.squareBefore)
        {
            worse.push_back(describe(h));
        }
        else
        {
            gone.push_back(percentWords(removed(h)) + " at " + describe(h));
        }
    }
    facts["held"] = c.held.size() > 0;
    facts["gone"] = joined(gone, ", ");
    facts["worse"] = joined(worse, " and ");
}

} // End anonymous namespace


Foam::string Foam::misfit::describe(const correctionElement& e, const scalar value)
{
    const auto number = [](const scalar x) { return numberWords(x, 3); };
    json facts = {{familyNames[e.family], true}};
    if (e.family == elementFamily::drag)
    {
        facts["factor"] = number(std::exp(value));
        facts["voidFraction"] = number(e.voidFraction);
        facts["Reynolds"] = number(e.Reynolds);
        return renderTemplate("element", facts);
    }
    const vector& d = e.direction;
    facts["size"] = number(mag(value));
    facts["against"] = value < 0;
    facts["direction"] = number(d.x()) + ' ' + number(d.y()) + ' ' + number(d.z());
    facts["place"] = number(e.place);
    facts["from"] = number(e.place - e.reach.first());
    facts["to"] = number(e.place + e.reach.second());
    facts["time"] = number(e.time);
    facts["begin"] = number(e.time - e.lasting.first());
    facts["end"] = number(e.time + e.lasting.second());
    return renderTemplate("element", facts);
}


Foam::string Foam::misfit::describe(const fittedLaw& l)
{
    const bool drag = l.law.family == elementFamily::drag;
    const bool against =
        !drag && l.law.functions.size() == 1 && l.coefficients[0] < 0;
    json functions = json::array();
    forAll(l.law.functions, i)
    {
        const word& name = functionsOf(l.law.family)[l.law.functions[i]].name;
        const scalar c = (against ? -1 : 1)*l.coefficients[i];
        const scalar d = l.deviations[i];
        functions.push_back
        ({
            {"sum", i == 0 ? "" : drag ? " " : " plus "},
            {"coefficient", withDeviation(c, d)}
        });
        if (drag && name != "factor")
        {
            functions.back()["group"] = name;
            functions.back()["middle"] = numberWords(l.law.middle[i], 3);
        }
        functions.back()[name] =
            drag ? json(withDeviation(std::exp(c), std::exp(c)*d)) : json(true);
    }
    return renderTemplate
    (
        "law",
        {
            {familyNames[l.law.family], true},
            {"functions", functions},
            {"against", against}
        }
    );
}


Foam::string Foam::misfit::describe(const correctionFit& c)
{
    const bool acts = c.elements.size() || c.explained;
    json facts =
    {
        {"failure", c.failure},
        {"explained", c.explained},
        {"ofSurface", c.ofSurface},
        {"named", c.named},
        {"transfers", c.transfers},
        {"holds", c.holds},
        {"nothing", c.failure.empty() && !acts}
    };
    if (c.lawThatFails >= 0)
    {
        facts["lawThatFails"] = describe(c.laws[c.lawThatFails]);
    }
    facts["noLaw"] = renderTemplate("noLaw", facts);
    if (c.failure.empty() && acts)
    {
        facts["acts"] =
            c.explained ? describe(c.laws.first())
          : joined(c.elements, ", and ", [](const freeElement& e)
            {
                return describe(e.element, e.value);
            });
    }
    addHeld(facts, c);
    return renderTemplate("correction", facts);
}
