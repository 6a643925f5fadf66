// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: what was asked at the gates.

#include "words.H"
#include "report.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

gateWords ofComputed(const gate& g)
{
    if (g.experiment.empty())
    {
        return
        {
            "The best explanation was run in the solver as it was fitted",
            g.passed ? "yes" : "no: the solver failed",
            "yes"
        };
    }
    return
    {
        "The solver runs in experiment " + g.experiment,
        g.failure.size() ? g.failure
      : string("what replicates and numerics change there is not known"),
        "runs"
    };
}


gateWords ofStability(const gate& g)
{
    string lost;
    for (const word& channel : g.lost)
    {
        lost += ' ' + channel;
    }
    return
    {
        "Channels that can be left out without another explanation winning",
        Foam::name(label(g.value)) + " of " + Foam::name(label(g.limit))
      + (lost.empty() ? "" : " (not" + lost + ")"),
        "all"
    };
}


//- What is asked where a number must be above or below another
string question(const gate& g, const finding& f)
{
    switch (g.kind)
    {
        case gateKind::detection:
            return "Chance of such a misfit if only the calibration were off";
        case gateKind::evidence:
            return "Score that the best explanation gains over none";
        case gateKind::gap:
            return
                "Lead in score of the best that says the same over the next"
                " explanation that says something else ("
              + (g.next ? describe(*g.next, f.library) : string("-")) + ")";
        case gateKind::adequacy:
            return "Chance of what the best explanation leaves";
        case gateKind::heldOut:
        case gateKind::transfer:
            return
                "Mean square of the misfit at " + describe(f.tested[g.held])
              + " (was " + shortNumber(f.tested[g.held].squareBefore, 3)
              + "), which was not used to find it";
        case gateKind::degradesHeldOut:
            return
                "Chance that " + describe(f.tested[g.held])
              + " are matched so much worse (mean square "
              + shortNumber(f.tested[g.held].squareBefore, 3) + " before, "
              + shortNumber(f.tested[g.held].squareAfter, 3)
              + " after) if the best explanation is right";
        case gateKind::alone:
            return
                "Score that what is named gains with nothing unknown beside it";
        default:
            return
                "Score that the best explanation gains, " + shortNumber(g.gained, 3)
              + ": what it still gains where the misfit has the wrong sign"
              + (g.moved ? " or is moved in time" : "");
    }
}

} // End anonymous namespace


Foam::misfit::gateWords
Foam::misfit::describe(const gate& g, const finding& f)
{
    switch (g.kind)
    {
        case gateKind::computed: return ofComputed(g);
        case gateKind::stability: return ofStability(g);
        default: break;
    }
    const string side(mustBeBelow(g.kind) ? "below " : "at least ");
    return {question(g, f), shortNumber(g.value, 3), side + shortNumber(g.limit, 3)};
}
