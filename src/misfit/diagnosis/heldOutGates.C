// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass at data that were held out.

#include "stages.H"
#include "heldOutChance.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The mean square that the best explanation may leave there
scalar heldOutLimit
(
    const rules& limits,
    const hypothesis& what,
    const heldOut& h
)
{
    // One sensor leaves the others as they are
    if (what.isNone() || blamesOneSensor(what))
    {
        return h.limitOfNothing;
    }

    // 1 is what uncertainty alone leaves. Of the rest not all must go, as another
    // formula errs elsewhere
    const scalar rest = max(h.squareBefore - 1, 0.0);
    const scalar share =
        what.fault ? limits.leftByRegistration
      : what.unknown ? limits.leftBesideUnknown : limits.leftOfMisfit;
    return max(1 + rest*share, h.limitOfMatch);
}


gate heldOutGate
(
    const rules& limits,
    const hypothesis& what,
    const heldOut& h,
    const label number
)
{
    gate g
    (
        h.isHere() ? gateKind::heldOut : gateKind::transfer,
        h.squareAfter,
        heldOutLimit(limits, what, h)
    );
    g.held = number;

    // Where nothing was wrong before, what stays so confirms nothing
    const bool nothingToAsk = h.squareBefore < h.limitOfMatch && g.passed;
    g.applies = what.isNone() || (!what.isOnlyUnknown() && !nothingToAsk);
    return g;
}


//- Covariance that chaos gives what the best predicts and what that is more than what
//  nothing does, over the variance of a run: of values of the surface, or of two runs
scalar sharedChaos(const study& s, const explanations& all)
{
    if (s.simulation.trainingEnsemble().empty())
    {
        return 1.0/s.set.commonRandomNumbers;
    }
    return s.validation.surface().chanceShared
    (
        all.lookUp(s, all.best()).variables, all.lookUp(s, all.baseline()).variables
    );
}


//- Only where the best makes held-out channels worse
gate degradesHeldOutGate
(
    const study& s,
    const explanations& explained,
    const heldOut& h,
    const label number
)
{
    const hypothesisFit& best = explained.best();
    const bool worse =
        best.what.mechanisms.size() && h.squareAfter > h.squareBefore;
    gate g
    (
        gateKind::degradesHeldOut,
        worse
      ? statistics::chanceOfDegradation
        (
            s.calibration, s.validation, best, h.before, h.after,
            sharedChaos(s, explained)
        )
      : 1,
        s.set.significance
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


bool Foam::misfit::isConfirmed(const List<heldOut>& held, const rules& limits)
{
    bool some = false;
    for (const heldOut& h : held)
    {
        if (h.use == purpose::validation && h.squareBefore > h.limitOfMatch)
        {
            const scalar left = confirmingSquare(h, limits);
            if (h.squareAfter > max(left, h.limitOfMatch))
            {
                return false;
            }
            some = some || h.squareAfter <= left;
        }
    }
    return some;
}


Foam::misfit::gateList Foam::misfit::heldOutGates
(
    const study& s,
    const explanations& explained,
    const List<heldOut>& held
)
{
    gateList gates;
    for (const gateKind k :
        {gateKind::heldOut, gateKind::transfer, gateKind::degradesHeldOut})
    {
        gates.addNothing(k);
    }
    forAll(held, i)
    {
        if (held[i].use == purpose::validation)
        {
            gates.add(heldOutGate(s.set, explained.best().what, held[i], i));
        }
        if (held[i].what == heldOut::part::validation)
        {
            gates.add(degradesHeldOutGate(s, explained, held[i], i));
        }
    }
    return gates;
}
