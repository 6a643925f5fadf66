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

    const explanations& explained;

    //- Score that what is named gains with nothing unknown beside it
    scalar alone = 0;


    const settings& set() const
    {
        return s.set;
    }

    const hypothesisFit& best() const
    {
        return explained.best();
    }

    const hypothesis& what() const
    {
        return best().what;
    }

    scalar gain() const
    {
        return explained.baseline().score - best().score;
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
    for (const hypothesisFit& w : a.explained.all())
    {
        // Scored with the uncertainty where the exchange moves it
        if (a.what().fault && w.what == a.what().known())
        {
            return a.explained.baseline().score - w.score;
        }
    }
    return 0;
}


gate computedGate(const gateContext& a)
{
    gate g(gateKind::computed, a.explained.find(a.what()) != nullptr, 1);
    g.applies = !a.what().isOnlyUnknown() && !a.what().isNone();
    return g;
}


//- Both name the same: one that has more on than the other, or less, names nothing else
bool nameSame(const hypothesis& best, const hypothesis& h)
{
    return
        best.fault ? h.fault && h.fault->blamesSame(*best.fault)
      : best.isOnlyUnknown() ? h.isOnlyUnknown()
      : h.mechanisms.size() && (h.contains(best) || best.contains(h));
}


gate gapGate(const gateContext& a)
{
    // The best of those that name the same leads
    scalar own = a.best().score;
    scalar others = GREAT;
    std::optional<hypothesis> next;
    for (const hypothesisFit& w : a.explained.all())
    {
        if (nameSame(a.what(), w.what))
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
        scanResidual(a.s, a.best()).p,
        a.set().adequacy
    );
    const bool isMostlyUnknown =
        a.what().mechanisms.size() && a.alone < a.set().ownShare*a.gain();
    g.applies = !a.what().unknown || isMostlyUnknown;
    return g;
}


//- What wins without a channel
hypothesisFit winnerWithout(const gateContext& a, const label channel)
{
    const hypothesisFit& best = a.best();
    const sampledModel rest(a.s.calibration.without(channel));
    const std::vector<hypothesisFit> all
    (
        rest.score().all
        (
            a.mechanisms,
            possibleFaults(rest.data(), a.set().faults),
            best.what.mechanisms.size() > 1
        )
    );
    scalar own = GREAT;
    for (const hypothesisFit& w : all)
    {
        // Something unknown is scored beside the best few only. It does not speak
        // for what it is beside: it may match what that does not
        const bool same = !w.what.fault && w.what.hasMechanismsOf(best.what);
        if (w.what == best.what || (same && own == GREAT))
        {
            own = w.score;
        }
    }
    for (const hypothesisFit& w : all)
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


//- A mechanism is tested with each channel left out in turn
bool isOfSeveralChannels(const gateContext& a)
{
    return
        a.s.calibration.data().segments.size() > 1 && a.what().mechanisms.size();
}


//- What else wins as each channel is left out in turn
std::vector<winner> winnersWithoutChannels(const gateContext& a)
{
    const std::vector<segment>& channels = a.s.calibration.data().segments;
    const label n = isOfSeveralChannels(a) ? count(channels) : 0;
    std::vector<winner> winners;
    for (label i = 0; i < n; ++i)
    {
        const hypothesisFit w(winnerWithout(a, i));
        if (!(w.what == a.what()))
        {
            winners.push_back({channels[i].name, w});
        }
    }
    return winners;
}


//- The explanation still wins without each of the channels
gate stabilityGate(const gateContext& a, const std::vector<winner>& others)
{
    const bool applies = isOfSeveralChannels(a);
    const label n = applies ? count(a.s.calibration.data().segments) : 0;
    gate g(gateKind::stability, n - count(others), n);
    g.applies = applies;
    for (const winner& other : others)
    {
        g.lost.append(other.channel);
    }
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
gate placeboGate(const gateContext& a, const List<heldOut>& held)
{
    // What held-out data confirm was seen at other times and places indeed
    const statistics::placebo placebo
    (
        a.s.calibration, a.explained.baseline(), a.best(),
        isConfirmed(held, a.set()) ? -1 : a.set().lastingEffect
    );
    gate g(gateKind::placebo, placebo.gain, a.set().placebo*a.alone);
    g.applies = a.what().mechanisms.size() && a.alone >= a.set().evidence;
    g.gained = a.alone;
    g.moved = placebo.moved;
    return g;
}

} // End anonymous namespace


Foam::misfit::gateTests Foam::misfit::testGates
(
    study& s,
    const std::vector<int>& mechanisms,
    const misfitDetection& detection,
    const explanations& explained
)
{
    Info<< "Gates" << endl;
    gateContext a{s, mechanisms, explained};
    gateList gates;
    gates.add({gateKind::detection, detection.calibrated.p, s.set.significance});
    gates.addNothing(gateKind::computed);
    const bool detected = gates.passed(gateKind::detection);
    if (detected)
    {
        a.alone = gainAlone(a);
        gates.add({gateKind::evidence, a.gain(), s.set.evidence});
        gates.add(computedGate(a));
        gates.add(gapGate(a));
        gates.add(adequacyGate(a));
    }

    const bool mayBeNothing =
        a.what().isNone() || blamesOneSensor(a.what())
     || !gates.passed(gateKind::evidence);
    const heldOutPrediction predicted(predictHeldOut(s, explained, mayBeNothing));
    gates.add(predicted.failures);
    gates.add(heldOutGates(s, explained, predicted.held));
    std::vector<winner> winners;
    if (detected)
    {
        winners = winnersWithoutChannels(a);
        gates.add(stabilityGate(a, winners));
        gates.add(aloneGate(a));
        gates.add(placeboGate(a, predicted.held));
    }
    return {gates, winners, predicted.held, predicted.uncertainty};
}
