// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass: each gate.

#include "gates.H"
#include "detect.H"
#include "degradesHeldOut.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The score that an explanation gains over the base, where that was recorded
scalar gain(const sampledModel& m, const hypothesis& h, const scalar discrepancy)
{
    const scoring score(m.score(discrepancy));
    const scored base(score.base());
    return
        base.score
      - score.withBaseCovariance(h, whitener(base.covariance)).score;
}


//- Each channel moved round by half of its length
vec halfRoundLater(const stacked& data, const vec& v)
{
    vec moved(v.size());
    for (const segment& s : data.segments)
    {
        for (label i = 0; i < s.size; ++i)
        {
            moved[s.first + i] = v[s.first + (i + s.size/2) % s.size];
        }
    }
    return moved;
}


//- Cosine of the angle between two effects; 0 where they are against each other
scalar likeness(const vec& a, const vec& b)
{
    return max(a.dot(b), 0.0)/max(a.norm()*b.norm(), VSMALL);
}


gate of(const gateKind kind, const scalar value, const scalar limit)
{
    gate g;
    g.kind = kind;
    g.value = value;
    g.limit = limit;
    return g;
}


gate atLeast(const gateKind kind, const scalar value, const scalar limit)
{
    gate g(of(kind, value, limit));
    g.passed = value >= limit;
    return g;
}


gate below(const gateKind kind, const scalar value, const scalar limit)
{
    gate g(of(kind, value, limit));
    g.passed = value < limit;
    return g;
}


//- The answer may be that nothing, or one sensor, is to blame
bool blamesOneSensor(const hypothesis& h)
{
    return h.fault && !h.fault->isRegistration();
}


gate computedGate(const explanations& e)
{
    const hypothesis& what = e.best().what;
    gate g(of(gateKind::computed, 0, 0));
    g.applies = !what.isOnlyUnknown() && !what.isNone();
    g.passed = e.find(what);
    return g;
}


gate failedGate(const failedExperiment& failed)
{
    gate g(of(gateKind::computed, 0, 0));
    g.passed = false;
    g.experiment = failed.name;
    g.failure = failed.why;
    return g;
}


//- Both say the same: one that has more on than the other, or less, says nothing else
bool saySame(const hypothesis& best, const hypothesis& h)
{
    return
        best.fault ? h.fault && h.fault->blamesSame(*best.fault)
      : best.isOnlyUnknown() ? h.isOnlyUnknown()
      : h.mechanisms.size() && (h.contains(best) || best.contains(h));
}


gate gapGate(const explanations& e, const settings& set)
{
    // The best of those that say the same leads
    scalar own = e.best().score;
    scalar others = GREAT;
    std::optional<hypothesis> next;
    for (const scored& w : e.all())
    {
        if (saySame(e.best().what, w.what))
        {
            own = min(own, w.score);
        }
        else if (w.score < others)
        {
            others = w.score;
            next = w.what;
        }
    }
    gate g(atLeast(gateKind::gap, others - own, set.gap));
    g.next = next;
    return g;
}


//- True if something unknown beside the mechanisms of the best gains two thirds of
//  the score and more
bool isMostlyUnknown(const explanations& e, const scalar alone)
{
    const hypothesis& what = e.best().what;
    return
        what.unknown && what.mechanisms.size()
     && alone < (e.baseline().score - e.best().score)/3;
}


gate adequacyGate
(
    const study& s,
    const models& m,
    const explanations& e,
    const scalar alone
)
{
    gate g
    (
        atLeast
        (
            gateKind::adequacy,
            scanResidual(s, *m.calibration, e.best()).p,
            s.set().adequacy
        )
    );
    g.applies = !e.best().what.unknown || isMostlyUnknown(e, alone);
    return g;
}


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
        below
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
        atLeast
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


//- What wins without a channel
scored winnerWithout
(
    const study& s,
    const models& m,
    const scored& best,
    const std::vector<int>& mechanisms,
    const label channel
)
{
    const auto rest(m.calibration->without(channel, s.width()));
    const std::vector<scored> all
    (
        rest->score(s.set().modelDiscrepancy).all
        (
            mechanisms,
            possibleFaults(rest->data(), s.set().faults),
            best.what.mechanisms.size() > 1
        )
    );
    scalar own = GREAT;
    for (const scored& w : all)
    {
        // Something unknown is scored beside the best few only. It does not speak
        // for what it is beside: it may match what that does not
        const bool same = !w.what.fault && w.what.hasMechanismsOf(best.what);
        if (w.what == best.what || (same && own == GREAT))
        {
            own = w.score;
        }
    }
    for (const scored& w : all)
    {
        const bool other =
            w.what.fault ? true
          : w.what.mechanisms.size()
         && !w.what.contains(best.what) && !best.what.contains(w.what);
        if (other && !(w.what == best.what) && w.score < own - s.set().gap)
        {
            return w;
        }
    }
    return best;
}


gate stabilityGate
(
    const study& s,
    const models& m,
    const scored& best,
    const std::vector<int>& mechanisms,
    std::vector<winner>& winners
)
{
    const std::vector<segment>& channels = m.calibration->data().segments;
    const bool applies = channels.size() > 1 && best.what.mechanisms.size();
    const label asked = applies ? count(channels) : 0;
    gate g(of(gateKind::stability, asked, asked));
    g.applies = applies;
    for (label i = 0; i < asked; ++i)
    {
        const scored w(winnerWithout(s, m, best, mechanisms, i));
        if (!(w.what == best.what))
        {
            winners.push_back({channels[i].name, w});
            g.lost.append(channels[i].name);
        }
    }
    g.value = asked - g.lost.size();
    g.passed = g.lost.empty();
    return g;
}


//- What the mechanisms of the best, or its exchange, gain with nothing unknown beside
//  them
scalar gainAlone
(
    const sampledModel& m,
    const explanations& e,
    const scalar discrepancy
)
{
    const hypothesis& what = e.best().what;
    if (what.mechanisms.size())
    {
        return gain(m, what, discrepancy);
    }
    for (const scored& w : e.all())
    {
        // Scored with the uncertainty where the exchange moves it
        if (what.fault && w.what == what.known())
        {
            return e.baseline().score - w.score;
        }
    }
    return 0;
}


//- Of a fault only where something unknown is beside it: else this is the evidence
gate aloneGate
(
    const settings& set,
    const hypothesis& what,
    const scalar alone
)
{
    gate g(atLeast(gateKind::alone, alone, set.evidence));
    g.applies = what.mechanisms.size() || (what.fault && what.unknown);
    return g;
}


gate placeboGate
(
    const settings& set,
    const models& m,
    const explanations& e,
    const List<heldOut>& held,
    const scalar alone
)
{
    const scored& best = e.best();
    const stacked& data = m.calibration->data();
    const vec y = data.y;
    const vec base = e.baseline().best.f;
    const auto copy(m.calibration->copy());

    copy->record(2*base - y);
    scalar placebo = gain(*copy, best.what, set.modelDiscrepancy);

    // An effect that lasts is much the same at another time: no placebo then. And
    // what held-out data confirm was seen at other times and places indeed
    const vec effect = best.best.f - base;
    const whitener white(e.baseline().covariance);
    const bool canMove =
        !isConfirmed(held)
     && likeness(white(effect), white(halfRoundLater(data, effect))) < 0.7;
    if (canMove)
    {
        copy->record(base + halfRoundLater(data, vec(y - base)));
        placebo = max(placebo, gain(*copy, best.what, set.modelDiscrepancy));
    }

    gate g(below(gateKind::placebo, placebo, 0.5*alone));
    g.applies = best.what.mechanisms.size() && alone >= set.evidence;
    g.gained = alone;
    g.moved = canMove;
    return g;
}


//- Of each of these for validation, and whether it degrades them
void askHeldOut
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

} // End anonymous namespace


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


std::map<Foam::word, Foam::misfit::covariance> Foam::misfit::askGates
(
    study& s,
    const models& m,
    const std::vector<int>& mechanisms,
    finding& f
)
{
    Info<< "Gates" << endl;
    const settings& set = s.set();
    explanations& e = f.explained;
    f.gates.add
    (
        below(gateKind::detection, f.detection.p, set.significance)
    );
    const bool detected = isDetected(s, f);
    f.gates.addNothing(gateKind::computed);
    scalar alone = 0;
    if (detected)
    {
        alone = gainAlone(*m.calibration, e, set.modelDiscrepancy);
        f.gates.add
        (
            atLeast
            (
                gateKind::evidence,
                e.baseline().score - e.best().score,
                set.evidence
            )
        );
        f.gates.add(computedGate(e));
        f.gates.add(gapGate(e, set));
        f.gates.add(adequacyGate(s, m, e, alone));
    }
    else
    {
        // Where the fitted channels agree, others may part all the same
        e.putFirst(hypothesis(e.baseline().what));
    }

    const scored& best = e.best();
    const heldOutTest test
    (
        testHeldOut
        (
            s, m, e,
            best.what.isNone() || blamesOneSensor(best.what)
         || !f.gates.passed(gateKind::evidence)
        )
    );
    f.tested = test.held;
    f.held = test.held;
    for (const failedExperiment& failed : test.failed)
    {
        f.failedExperiments.append(failed.name);
        f.gates.add(failedGate(failed));
    }
    askHeldOut(s, m, best, f.held, f.gates);
    if (detected)
    {
        f.gates.add(stabilityGate(s, m, best, mechanisms, f.winners));
        f.gates.add(aloneGate(set, best.what, alone));
        f.gates.add(placeboGate(set, m, e, f.held, alone));
    }
    return test.known;
}
