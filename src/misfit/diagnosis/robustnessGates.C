// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass where the data are others: without a channel, without
// something unknown, reversed or moved in time.

#include "gates.H"
#include "placebo.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

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

} // End anonymous namespace


Foam::misfit::gate Foam::misfit::stabilityGate
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
    gate g(gate::at(gateKind::stability, asked, asked));
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


Foam::scalar Foam::misfit::gainAlone
(
    const sampledModel& m,
    const explanations& e,
    const scalar discrepancy
)
{
    const hypothesis& what = e.best().what;
    if (what.mechanisms.size())
    {
        return statistics::gain(m, what, discrepancy);
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


Foam::misfit::gate Foam::misfit::aloneGate
(
    const settings& set,
    const hypothesis& what,
    const scalar alone
)
{
    gate g(gate::atLeast(gateKind::alone, alone, set.evidence));
    g.applies = what.mechanisms.size() || (what.fault && what.unknown);
    return g;
}


Foam::misfit::gate Foam::misfit::placeboGate
(
    const settings& set,
    const models& m,
    const explanations& e,
    const List<heldOut>& held,
    const scalar alone
)
{
    // What held-out data confirm was seen at other times and places indeed
    const scored& best = e.best();
    const statistics::placebo placebo
    (
        *m.calibration, e.baseline(), best, set.modelDiscrepancy,
        isConfirmed(held, set) ? -1 : set.lastingEffect
    );

    gate g(gate::below(gateKind::placebo, placebo.gain, set.placebo*alone));
    g.applies = best.what.mechanisms.size() && alone >= set.evidence;
    g.gained = alone;
    g.moved = placebo.moved;
    return g;
}
