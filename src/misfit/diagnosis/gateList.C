// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass, and whether it did.

#include "gateList.H"
#include "error.H"

#include <algorithm>

namespace
{

using Foam::misfit::gateKind;

//- Gates whose value must be below the limit, and gates that any answer must pass
const std::vector<gateKind> below
({
    gateKind::detection, gateKind::heldOut, gateKind::transfer, gateKind::placebo
});

const std::vector<gateKind> ofAnyAnswer
({
    gateKind::computed, gateKind::adequacy, gateKind::heldOut, gateKind::degradesHeldOut,
    gateKind::transfer, gateKind::alone, gateKind::placebo
});

} // End anonymous namespace


const Foam::Enum<Foam::misfit::gateKind> Foam::misfit::gateNames
({
    {gateKind::detection, "detection"},
    {gateKind::evidence, "evidence"},
    {gateKind::computed, "computed"},
    {gateKind::gap, "gap"},
    {gateKind::adequacy, "adequacy"},
    {gateKind::heldOut, "heldOut"},
    {gateKind::transfer, "transfer"},
    {gateKind::degradesHeldOut, "degradesHeldOut"},
    {gateKind::stability, "stability"},
    {gateKind::alone, "alone"},
    {gateKind::placebo, "placebo"}
});


bool Foam::misfit::mustBeBelow(const gateKind kind)
{
    return statistics::contains(below, kind);
}


bool Foam::misfit::gateList::passed(const gateKind kind) const
{
    if (!statistics::contains(tested_, kind))
    {
        FatalErrorInFunction
            << "The gate " << gateNames[kind] << " was never tested"
            << exit(FatalError);
    }
    const auto fails = [kind](const gate& g) { return g.kind == kind && g.fails(); };
    return std::none_of(begin(), end(), fails);
}


bool Foam::misfit::gateList::applied(const gateKind kind) const
{
    const auto applies = [kind](const gate& g) { return g.kind == kind && g.applies; };
    return std::any_of(begin(), end(), applies);
}


std::vector<Foam::misfit::gateKind> Foam::misfit::gateList::failed() const
{
    std::vector<gateKind> kinds;
    for (const gate& g : gates_)
    {
        const bool known = statistics::contains(kinds, g.kind);
        if (g.fails() && g.kind != gateKind::detection && !known)
        {
            kinds.push_back(g.kind);
        }
    }
    return kinds;
}


bool Foam::misfit::gateList::allowAnswer() const
{
    const auto passes = [this](const gateKind kind) { return passed(kind); };
    return std::all_of(ofAnyAnswer.begin(), ofAnyAnswer.end(), passes);
}


Foam::wordList Foam::misfit::gateList::failedExperiments() const
{
    wordList names;
    for (const gate& g : gates_)
    {
        if (g.experiment.size())
        {
            names.append(g.experiment);
        }
    }
    return names;
}
