// SPDX-License-Identifier: GPL-3.0-or-later
// S7: what an answer must pass.

#include "diagnosis.H"
#include "StringStream.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

string number(const scalar value)
{
    OStringStream os;
    os.precision(3);
    os << value;
    return os.str();
}


//- The score that an explanation gains over the base, where that was recorded
scalar gain(const sampledModel& m, const hypothesis& h, const scalar tolerance)
{
    const weighing weigh(m.weigh(tolerance));
    const weighed base(weigh.base());
    return
        base.score
      - weigh.quickly(h, whitener(base.covariance)).score;
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


//- True if all that one has on is on in the other too
bool contains(const hypothesis& all, const hypothesis& some)
{
    for (const label m : some.mechanisms)
    {
        if (!all.mechanisms.found(m))
        {
            return false;
        }
    }
    return true;
}

} // End anonymous namespace


bool Foam::misfit::diagnosis::passed(const word& name) const
{
    // Each held-out experiment has a gate of the same name
    for (const gate& g : found_.gates)
    {
        if (g.name == name && g.applies && !g.passed)
        {
            return false;
        }
    }
    return true;
}


Foam::misfit::gate Foam::misfit::diagnosis::detectionGate() const
{
    return
    {
        "detection",
        "Chance of such a misfit if only the calibration were off",
        number(found_.detection.p),
        "below " + number(settings_.significance),
        true,
        found_.detection.p < settings_.significance
    };
}


Foam::misfit::gate Foam::misfit::diagnosis::evidenceGate() const
{
    const scalar gained = baseline().score - best().score;
    return
    {
        "evidence",
        "Score that the best explanation gains over none",
        number(gained),
        "at least " + number(settings_.evidence),
        true,
        gained >= settings_.evidence
    };
}


Foam::misfit::gate Foam::misfit::diagnosis::computedGate() const
{
    const bool computed = findComputed(best());
    return
    {
        "computed",
        "The best explanation was run in the solver as it was fitted",
        computed ? "yes" : "no: the solver failed",
        "yes",
        !best().what.isOnlyUnknown() && !best().what.isNone(),
        computed
    };
}


Foam::misfit::gate Foam::misfit::diagnosis::gapGate() const
{
    // One that has more on than the best, or less, says nothing else
    scalar lead = GREAT;
    string next("-");
    for (const weighed& w : found_.explanations)
    {
        const bool same =
            best().what.fault
          ? w.what.fault && w.what.fault->channel() == best().what.fault->channel()
          : best().what.isOnlyUnknown() ? w.what.isOnlyUnknown()
          : w.what.mechanisms.size()
         && (contains(w.what, best().what) || contains(best().what, w.what));
        if (!same && w.score - best().score < lead)
        {
            lead = w.score - best().score;
            next = told(w.what, mechanismNames());
        }
    }
    return
    {
        "gap",
        "Lead in score over the next explanation that says something else (" + next + ")",
        number(lead),
        "at least " + number(settings_.gap),
        true,
        lead >= settings_.gap
    };
}


Foam::misfit::gate Foam::misfit::diagnosis::adequacyGate()
{
    const scanned left(look(*fit_, best()));
    return
    {
        "adequacy",
        "Chance of what the best explanation leaves",
        number(left.p),
        "at least " + number(settings_.adequacy),
        !best().what.unknown,
        left.p >= settings_.adequacy
    };
}


Foam::misfit::gate Foam::misfit::diagnosis::heldOutGate
(
    const word& name,
    const heldOut& h
) const
{
    const bool physics = best().what.mechanisms.size();

    // 1 is what uncertainty alone leaves. Of the rest, half must go where
    // something else is known to be missing too.
    const scalar rest = max(h.squareBefore - 1, 0.0);
    const scalar limit = max
    (
        1 + rest*(!physics ? 1.1 : best().what.unknown ? 0.5 : 1), beyondChance
    );
    const bool holds = h.squareAfter < limit;

    // Where nothing was wrong before, what stays so confirms nothing
    const bool nothingToAsk = h.squareBefore < beyondChance && holds;
    return
    {
        name,
        "Mean square of the misfit at " + h.what + " (was "
      + number(h.squareBefore) + "), which was not used to find it",
        number(h.squareAfter),
        "below " + number(limit),
        !best().what.isOnlyUnknown() && !best().what.isNone() && !nothingToAsk,
        holds
    };
}


Foam::misfit::diagnosis::winner
Foam::misfit::diagnosis::winnerWithout(const label segment) const
{
    const auto rest(fit_->without(segment, width_));
    const wordList names(mechanismNames());
    const string here(told(best().what, names));
    const List<weighed> all
    (
        rest->weigh(settings_.formulaTolerance).all
        (
            mechanisms_,
            possibleFaults(rest->data(), settings_.faults),
            best().what.mechanisms.size() > 1
        )
    );
    scalar own = GREAT;
    for (const weighed& w : all)
    {
        if (told(w.what, names) == here)
        {
            own = w.score;
        }
    }
    for (const weighed& w : all)
    {
        const bool other =
            w.what.fault ? true
          : w.what.mechanisms.size()
         && !contains(w.what, best().what) && !contains(best().what, w.what);
        if (other && told(w.what, names) != here && w.score < own - settings_.gap)
        {
            return {told(w.what, names), w.what.mechanisms};
        }
    }
    return {here, best().what.mechanisms};
}


Foam::misfit::gate Foam::misfit::diagnosis::stabilityGate()
{
    const List<segment>& channels = fit_->data().segments;
    label held = 0;
    label asked = 0;
    string lost;
    const bool applies =
        channels.size() > 1 && best().what.mechanisms.size();
    stable_ = best().what.mechanisms;
    forAll(channels, i)
    {
        if (applies)
        {
            const winner w(winnerWithout(i));
            const bool stable = w.name == told(best().what, mechanismNames());
            ++asked;
            held += stable;
            lost += stable ? "" : " " + channels[i].name;
            labelList both;
            for (const label m : w.mechanisms)
            {
                if (stable_.found(m))
                {
                    both.append(m);
                }
            }
            stable_ = both;
            const word name(w.name, false);
            if (!stable && !winners_.found(name))
            {
                winners_.append(name);
            }
        }
    }
    return
    {
        "stability",
        "Channels that can be left out without another explanation winning",
        Foam::name(held) + " of " + Foam::name(asked)
      + (lost.empty() ? "" : " (not" + lost + ")"),
        "all",
        applies,
        held == asked
    };
}


Foam::misfit::gate Foam::misfit::diagnosis::placeboGate() const
{
    const stacked& data = fit_->data();
    const vec y = data.y;
    const vec base = baseline().best.f;
    const scalar tolerance = settings_.formulaTolerance;
    const auto copy(fit_->copy());
    const scalar real = gain(*copy, best().what, tolerance);

    copy->record(2*base - y);
    scalar placebo = gain(*copy, best().what, tolerance);

    // An effect that lasts is much the same at another time: no placebo then
    const vec effect = best().best.f - base;
    const whitener white(baseline().covariance);
    const bool canMove =
        likeness(white(effect), white(halfRoundLater(data, effect))) < 0.7;
    if (canMove)
    {
        copy->record(base + halfRoundLater(data, vec(y - base)));
        placebo = max(placebo, gain(*copy, best().what, tolerance));
    }
    const scalar limit = 0.5*real;
    return
    {
        "placebo",
        string("Gain where the misfit has the wrong sign")
      + (canMove ? " or is moved in time" : ", not moved in time as the effect lasts")
      + " (really " + number(real) + ", which must be " + number(settings_.evidence)
      + " or more)",
        number(placebo),
        "below " + number(limit),
        best().what.mechanisms.size() > 0,
        real >= settings_.evidence && placebo < limit
    };
}


void Foam::misfit::diagnosis::addHeldOut()
{
    const computed before(lookUp(baseline()));
    const computed after(lookUp(best()));
    const vec ofFault =
        hypothesisModel(fit_->surface(), bounds_, best().what).ofFault
        (
            best().best.x
        );
    const auto add = [&]
    (
        const string& what,
        const purpose use,
        const stacked& data,
        const vec& a,
        const vec& computedAfter,
        const covariance* known
    )
    {
        if (data.size() && a.size() == data.size() && computedAfter.size() == a.size())
        {
            const vec b =
                best().what.fault
              ? best().what.fault->elsewhere(data, computedAfter, ofFault)
              : computedAfter;
            const mat c =
                known
              ? known->at(b) : covariance(data, settings_.trigger).at(b);
            found_.held.append(compared(what, use, data, a, b, c));
        }
    };

    if (gate_->size())
    {
        add
        (
            "held-out channels", purpose::gate, gate_->data(),
            before.given.gate, after.given.gate, &gate_->uncertainty()
        );
    }
    add
    (
        "scored channels", purpose::score, data().score,
        before.given.score, after.given.score, nullptr
    );

    for (label i = 1; i < sampler_.data().size(); ++i)
    {
        const observed& other = sampler_.data()[i];
        List<runState> states
        ({
            state(before.variables), state(after.variables)
        });
        const bool gates = other.use == purpose::gate;
        for (label k = 0; gates && k <= settings_.resolutions.size(); ++k)
        {
            states.append(state(bounds_.mean));
            states.last().resolution =
                k ? settings_.resolutions[k-1] : word("base");
        }
        for (runState& s : states)
        {
            s.experiment = other.experiment;
        }
        const List<samples> given(ask(states));

        // The mesh errs there as it does in the experiment that is fitted
        covariance known(gates ? other.gate : other.score, settings_.trigger);
        for (label k = 3; k < given.size(); ++k)
        {
            if (given[2].ok() && given[k].ok())
            {
                known.addDifference(given[k].gate - given[2].gate);
            }
            else if (!given[k].ok())
            {
                leaveOut(states[k], given[k].failure);
            }
        }
        elsewhere_.insert({other.experiment, known});
        if (given[0].ok() && given[1].ok())
        {
            add
            (
                "experiment " + other.experiment, other.use,
                gates ? other.gate : other.score,
                gates ? given[0].gate : given[0].score,
                gates ? given[1].gate : given[1].score,
                &known
            );
            if (gates && other.score.size())
            {
                add
                (
                    "scored channels of experiment " + other.experiment,
                    purpose::score, other.score, given[0].score,
                    given[1].score, nullptr
                );
            }
        }
        else if (gates)
        {
            found_.gates.append
            ({
                "transfer",
                "The solver runs in experiment " + other.experiment,
                given[1].ok() ? given[0].failure : given[1].failure,
                "runs",
                true,
                false
            });
        }
    }
}


void Foam::misfit::diagnosis::askGates()
{
    found_.gates.append(detectionGate());
    if (!found_.gates.last().passed)
    {
        return;
    }
    found_.gates.append(evidenceGate());
    found_.gates.append(computedGate());
    found_.gates.append(gapGate());
    found_.gates.append(adequacyGate());
    addHeldOut();
    for (const heldOut& h : found_.held)
    {
        if (h.use == purpose::gate)
        {
            found_.gates.append
            (
                heldOutGate
                (
                    h.what == "held-out channels" ? "heldOut" : "transfer", h
                )
            );
        }
    }
    found_.gates.append(stabilityGate());
    found_.gates.append(placeboGate());
}
