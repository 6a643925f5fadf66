// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass, and whether it did.

#include "gateList.H"
#include "error.H"

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


bool Foam::misfit::gateList::passed(const gateKind kind) const
{
    if (!statistics::contains(asked_, kind))
    {
        FatalErrorInFunction
            << "The gate " << gateNames[kind] << " was never asked"
            << exit(FatalError);
    }
    for (const gate& g : gates_)
    {
        if (g.kind == kind && g.applies && !g.passed)
        {
            return false;
        }
    }
    return true;
}


bool Foam::misfit::gateList::applied(const gateKind kind) const
{
    for (const gate& g : gates_)
    {
        if (g.kind == kind && g.applies)
        {
            return true;
        }
    }
    return false;
}


std::vector<Foam::misfit::gateKind> Foam::misfit::gateList::failed() const
{
    std::vector<gateKind> kinds;
    for (const gate& g : gates_)
    {
        const bool fails =
            g.applies && !g.passed && g.kind != gateKind::detection;
        if (fails && !statistics::contains(kinds, g.kind))
        {
            kinds.push_back(g.kind);
        }
    }
    return kinds;
}


bool Foam::misfit::gateList::allowAnswer() const
{
    for
    (
        const gateKind kind :
        {
            gateKind::computed, gateKind::adequacy, gateKind::heldOut,
            gateKind::degradesHeldOut, gateKind::transfer, gateKind::alone,
            gateKind::placebo
        }
    )
    {
        if (!passed(kind))
        {
            return false;
        }
    }
    return true;
}
