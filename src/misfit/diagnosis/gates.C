// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass: the gates in their order, and those of the fit itself.

#include "gates.H"
#include "detect.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

gate computedGate(const explanations& e)
{
    const hypothesis& what = e.best().what;
    gate g(gate::at(gateKind::computed, 0, 0));
    g.applies = !what.isOnlyUnknown() && !what.isNone();
    g.passed = e.find(what);
    return g;
}


gate failedGate(const failedExperiment& failed)
{
    gate g(gate::at(gateKind::computed, 0, 0));
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
    gate g(gate::atLeast(gateKind::gap, others - own, set.gap));
    g.next = next;
    return g;
}


//- True if something unknown beside the mechanisms of the best gains most of the score
bool isMostlyUnknown
(
    const rules& limits,
    const explanations& e,
    const scalar alone
)
{
    const hypothesis& what = e.best().what;
    return
        what.unknown && what.mechanisms.size()
     && alone < limits.ownShare*(e.baseline().score - e.best().score);
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
        gate::atLeast
        (
            gateKind::adequacy,
            scanResidual(s, *m.calibration, e.best()).p,
            s.set().adequacy
        )
    );
    g.applies = !e.best().what.unknown || isMostlyUnknown(s.set(), e, alone);
    return g;
}


} // End anonymous namespace


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
        gate::below(gateKind::detection, f.detection.p, set.significance)
    );
    const bool detected = isDetected(s, f);
    f.gates.addNothing(gateKind::computed);
    scalar alone = 0;
    if (detected)
    {
        alone = gainAlone(*m.calibration, e, set.modelDiscrepancy);
        f.gates.add
        (
            gate::atLeast
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
    const heldOutPredictions predicted
    (
        predictHeldOut
        (
            s, m, e,
            best.what.isNone() || blamesOneSensor(best.what)
         || !f.gates.passed(gateKind::evidence)
        )
    );
    f.tested = predicted.held;
    f.held = predicted.held;
    for (const failedExperiment& failed : predicted.failed)
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
    return predicted.known;
}
