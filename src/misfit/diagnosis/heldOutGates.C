// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass at data that were held out.

#include "stages.H"
#include "elsewhere.H"

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
scalar sharedChaos(const study& s, const finding& f)
{
    if (s.ask.trainingEnsemble().empty())
    {
        return 1.0/s.set.commonRandomNumbers;
    }
    const explanations& all = f.explained;
    return s.validation.surface().chanceShared
    (
        all.lookUp(s, f.best()).variables, all.lookUp(s, all.baseline()).variables
    );
}


//- Only where the best makes held-out channels worse
gate degradesHeldOutGate
(
    const study& s,
    const finding& f,
    const heldOut& h,
    const label number
)
{
    const scored& best = f.best();
    const bool worse =
        best.what.mechanisms.size() && h.squareAfter > h.squareBefore;
    gate g
    (
        gateKind::degradesHeldOut,
        worse
      ? statistics::chanceOfDegradation
        (
            s.calibration, s.validation, best, h.before, h.after, sharedChaos(s, f)
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


void Foam::misfit::askHeldOut(const study& s, finding& f)
{
    for (const gateKind k :
        {gateKind::heldOut, gateKind::transfer, gateKind::degradesHeldOut})
    {
        f.gates.addNothing(k);
    }
    forAll(f.held, i)
    {
        if (f.held[i].use == purpose::validation)
        {
            f.gates.add(heldOutGate(s.set, f.best().what, f.held[i], i));
        }
        if (f.held[i].what == heldOut::part::validation)
        {
            f.gates.add(degradesHeldOutGate(s, f, f.held[i], i));
        }
    }
}
