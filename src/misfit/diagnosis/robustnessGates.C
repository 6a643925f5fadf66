// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer must pass where the data are others: without a channel, without
// something unknown, reversed or moved in time.

#include "robustnessGates.H"
#include "heldOutGates.H"

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
        !isConfirmed(held, set)
     && likeness(white(effect), white(halfRoundLater(data, effect)))
      < set.lastingEffect;
    if (canMove)
    {
        copy->record(base + halfRoundLater(data, vec(y - base)));
        placebo = max(placebo, gain(*copy, best.what, set.modelDiscrepancy));
    }

    gate g(gate::below(gateKind::placebo, placebo, set.placebo*alone));
    g.applies = best.what.mechanisms.size() && alone >= set.evidence;
    g.gained = alone;
    g.moved = canMove;
    return g;
}
