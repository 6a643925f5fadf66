// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass at data that were held out.

#include "heldOutGates.H"
#include "degradesHeldOut.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The mean square that the best explanation may leave there
scalar heldOutLimit(const hypothesis& what, const heldOut& h)
{
    // One sensor leaves the others as they are
    if (what.isNone() || blamesOneSensor(what))
    {
        return h.limitOfNothing;
    }

    // 1 is what uncertainty alone leaves. Of the rest a third must go, as another
    // formula errs elsewhere; half where something else is missing too
    const scalar rest = max(h.squareBefore - 1, 0.0);
    const scalar share = what.fault ? 1.1 : what.unknown ? 0.5 : 2.0/3;
    return max(1 + rest*share, matchLimit(h));
}


gate heldOutGate(const hypothesis& what, const heldOut& h, const label number)
{
    gate g
    (
        gate::below
        (
            h.isHere() ? gateKind::heldOut : gateKind::transfer,
            h.squareAfter,
            heldOutLimit(what, h)
        )
    );
    g.held = number;

    // Where nothing was wrong before, what stays so confirms nothing
    const bool nothingToAsk = h.squareBefore < matchLimit(h) && g.passed;
    g.applies = what.isNone() || (!what.isOnlyUnknown() && !nothingToAsk);
    return g;
}


//- Only where the best makes held-out channels worse
gate degradesHeldOutGate
(
    const study& s,
    const models& m,
    const scored& best,
    const heldOut& h,
    const label number
)
{
    const bool worse =
        best.what.mechanisms.size() && h.squareAfter > h.squareBefore;
    gate g
    (
        gate::atLeast
        (
            gateKind::degradesHeldOut,
            worse
          ? chanceOfDegradation(m, best, h, s.set().modelDiscrepancy) : 1,
            s.set().significance
        )
    );
    g.applies = worse;
    g.held = number;
    return g;
}

} // End anonymous namespace


bool Foam::misfit::blamesOneSensor(const hypothesis& h)
{
    return h.fault && !h.fault->isRegistration();
}


bool Foam::misfit::isConfirmed(const List<heldOut>& held)
{
    bool some = false;
    for (const heldOut& h : held)
    {
        if (h.use == purpose::validation && h.squareBefore > matchLimit(h))
        {
            const scalar half = 0.5*(1 + h.squareBefore);
            if (h.squareAfter > max(half, matchLimit(h)))
            {
                return false;
            }
            some = some || h.squareAfter <= half;
        }
    }
    return some;
}


void Foam::misfit::askHeldOut
(
    const study& s,
    const models& m,
    const scored& best,
    const List<heldOut>& held,
    gateList& gates
)
{
    for (const gateKind k :
        {gateKind::heldOut, gateKind::transfer, gateKind::degradesHeldOut})
    {
        gates.addNothing(k);
    }
    forAll(held, i)
    {
        if (held[i].use == purpose::validation)
        {
            gates.add(heldOutGate(best.what, held[i], i));
        }
        if (held[i].what == heldOut::part::validation)
        {
            gates.add(degradesHeldOutGate(s, m, best, held[i], i));
        }
    }
}
