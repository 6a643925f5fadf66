// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass: the gates in their order, but for held-out data.

#include "stages.H"
#include "placebo.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- What the gates are tested on
struct gateContext
{
    const study& s;

    const std::vector<int>& mechanisms;

    finding& f;

    //- Score that what is named gains with nothing unknown beside it
    scalar alone = 0;


    const settings& set() const
    {
        return s.set;
    }

    const hypothesis& what() const
    {
        return f.best().what;
    }

    scalar gain() const
    {
        return f.explained.baseline().score - f.best().score;
    }
};


//- The score that the mechanisms of the best, or its exchange, gain with nothing
//  unknown beside them
scalar gainAlone(const gateContext& a)
{
    if (a.what().mechanisms.size())
    {
        return statistics::gain(a.s.calibration, a.what());
    }
    for (const scored& w : a.f.explained.all())
    {
        // Scored with the uncertainty where the exchange moves it
        if (a.what().fault && w.what == a.what().known())
        {
            return a.f.explained.baseline().score - w.score;
        }
    }
    return 0;
}


gate computedGate(const gateContext& a)
{
    gate g(gateKind::computed, a.f.explained.find(a.what()) != nullptr, 1);
    g.applies = !a.what().isOnlyUnknown() && !a.what().isNone();
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


gate gapGate(const gateContext& a)
{
    // The best of those that say the same leads
    scalar own = a.f.best().score;
    scalar others = GREAT;
    std::optional<hypothesis> next;
    for (const scored& w : a.f.explained.all())
    {
        if (saySame(a.what(), w.what))
        {
            own = min(own, w.score);
        }
        else if (w.score < others)
        {
            others = w.score;
            next = w.what;
        }
    }
    gate g(gateKind::gap, others - own, a.set().gap);
    g.next = next;
    return g;
}


//- Beside something unknown only where that gains most of the score
gate adequacyGate(const gateContext& a)
{
    gate g
    (
        gateKind::adequacy,
        scanResidual(a.s, a.f.best()).p,
        a.set().adequacy
    );
    const bool isMostlyUnknown =
        a.what().mechanisms.size() && a.alone < a.set().ownShare*a.gain();
    g.applies = !a.what().unknown || isMostlyUnknown;
    return g;
}


//- What wins without a channel
scored winnerWithout(const gateContext& a, const label channel)
{
    const scored& best = a.f.best();
    const sampledModel rest(a.s.calibration.without(channel));
    const std::vector<scored> all
    (
        rest.score().all
        (
            a.mechanisms,
            possibleFaults(rest.data(), a.set().faults),
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
        if (other && !(w.what == best.what) && w.score < own - a.set().gap)
        {
            return w;
        }
    }
    return best;
}


//- The explanation still wins with each channel left out in turn; what wins instead
//  is one of the winners
gate stabilityGate(const gateContext& a)
{
    const std::vector<segment>& channels = a.s.calibration.data().segments;
    const bool applies = channels.size() > 1 && a.what().mechanisms.size();
    const label n = applies ? count(channels) : 0;
    wordList lost;
    for (label i = 0; i < n; ++i)
    {
        const scored w(winnerWithout(a, i));
        if (!(w.what == a.what()))
        {
            a.f.winners.push_back({channels[i].name, w});
            lost.append(channels[i].name);
        }
    }
    gate g(gateKind::stability, n - lost.size(), n);
    g.applies = applies;
    g.lost = lost;
    return g;
}


//- What is named is evidence by itself. Of a fault only where something unknown is
//  beside it: else it is the evidence
gate aloneGate(const gateContext& a)
{
    gate g(gateKind::alone, a.alone, a.set().evidence);
    g.applies = a.what().mechanisms.size() || (a.what().fault && a.what().unknown);
    return g;
}


//- A misfit with the wrong sign, or moved in time, gains less than half as much
gate placeboGate(const gateContext& a)
{
    // What held-out data confirm was seen at other times and places indeed
    const statistics::placebo placebo
    (
        a.s.calibration, a.f.explained.baseline(), a.f.best(),
        isConfirmed(a.f.held, a.set()) ? -1 : a.set().lastingEffect
    );
    gate g(gateKind::placebo, placebo.gain, a.set().placebo*a.alone);
    g.applies = a.what().mechanisms.size() && a.alone >= a.set().evidence;
    g.gained = a.alone;
    g.moved = placebo.moved;
    return g;
}

} // End anonymous namespace


std::map<Foam::word, Foam::misfit::covariance> Foam::misfit::askGates
(
    study& s,
    const std::vector<int>& mechanisms,
    finding& f
)
{
    Info<< "Gates" << endl;
    const settings& set = s.set;
    gateContext a{s, mechanisms, f};
    f.gates.add({gateKind::detection, f.detection.p, set.significance});
    f.gates.addNothing(gateKind::computed);
    const bool detected = f.gates.passed(gateKind::detection);
    if (detected)
    {
        a.alone = gainAlone(a);
        f.gates.add({gateKind::evidence, a.gain(), set.evidence});
        f.gates.add(computedGate(a));
        f.gates.add(gapGate(a));
        f.gates.add(adequacyGate(a));
    }
    else
    {
        // Where the fitted channels agree, others may part all the same
        f.explained.putFirst(hypothesis(f.explained.baseline().what));
    }

    const auto elsewhere
    (
        predictHeldOut
        (
            s,
            a.what().isNone() || blamesOneSensor(a.what())
         || !f.gates.passed(gateKind::evidence),
            f
        )
    );
    askHeldOut(s, f);
    if (detected)
    {
        f.gates.add(stabilityGate(a));
        f.gates.add(aloneGate(a));
        f.gates.add(placeboGate(a));
    }
    return elsewhere;
}
