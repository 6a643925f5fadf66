// SPDX-License-Identifier: GPL-3.0-or-later
// The gates of a finding in words.

#include "words.H"

Foam::misfit::json Foam::misfit::gateWords(const gate& g, const finding& f)
{
    const auto number = [](const scalar x) { return ratioWords(x, 3); };
    const bool isCounted =
        g.kind == gateKind::computed || g.kind == gateKind::stability;
    json facts =
    {
        {gateNames[g.kind], true},
        {"passed", g.passed},
        {"ofNumber", !isCounted},
        {"number", number(g.value)},
        {"limit", number(g.limit)},
        {"below", mustBeBelow(g.kind)},
        {"experiment", g.experiment},
        {"failure", g.failure},
        {"next", g.next ? describe(*g.next, f.library) : string("-")},
        {"kept", numberWords(g.value, 7)},
        {"all", numberWords(g.limit, 7)},
        {"lost", g.lost},
        {"gained", number(g.gained)},
        {"moved", g.moved}
    };
    if (g.held >= 0)
    {
        const heldOut& h = f.tests.held[g.held];
        facts["ofHeldOut"] = g.kind != gateKind::degradesHeldOut;
        facts["what"] = describe(h);
        facts["before"] = number(h.squareBefore);
        facts["after"] = number(h.squareAfter);
    }
    return
    {
        {"name", gateNames[g.kind]},
        {"question", renderTemplate("question", facts)},
        {"value", renderTemplate("value", facts)},
        {"bound", renderTemplate("bound", facts)}
    };
}
