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
    // One that has more on than the best, or less, says nothing else: the best of
    // them leads
    scalar own = best().score;
    scalar others = GREAT;
    string next("-");
    for (const weighed& w : found_.explanations)
    {
        const bool same =
            best().what.fault
          ? w.what.fault && w.what.fault->channel() == best().what.fault->channel()
          : best().what.isOnlyUnknown() ? w.what.isOnlyUnknown()
          : w.what.mechanisms.size()
         && (w.what.contains(best().what) || best().what.contains(w.what));
        if (same)
        {
            own = min(own, w.score);
        }
        else if (w.score < others)
        {
            others = w.score;
            next = told(w.what, mechanismNames());
        }
    }
    const scalar lead = others - own;
    return
    {
        "gap",
        "Lead in score of the best that says the same over the next explanation that"
        " says something else (" + next + ")",
        number(lead),
        "at least " + number(settings_.gap),
        true,
        lead >= settings_.gap
    };
}


Foam::misfit::gate
Foam::misfit::diagnosis::adequacyGate(const scalar alone)
{
    const scanned left(look(*fit_, best()));
    return
    {
        "adequacy",
        "Chance of what the best explanation leaves",
        number(left.p),
        "at least " + number(settings_.adequacy),
        !best().what.unknown || isMostlyUnknown(alone),
        left.p >= settings_.adequacy
    };
}


Foam::scalar Foam::misfit::diagnosis::limitOfNothing(const heldOut& h) const
{
    return chanceOfSquare(h.data.size(), settings_.adequacy);
}


Foam::scalar Foam::misfit::diagnosis::heldOutLimit(const heldOut& h) const
{
    // One sensor leaves the others as they are
    const hypothesis& what = best().what;
    if
    (
        what.isNone()
     || (what.fault && !what.fault->isRegistration())
    )
    {
        return limitOfNothing(h);
    }

    // 1 is what uncertainty alone leaves. Of the rest a third must go, as another
    // formula errs elsewhere; half where something else is missing too
    const scalar rest = max(h.squareBefore - 1, 0.0);
    const scalar share = what.fault ? 1.1 : what.unknown ? 0.5 : 2.0/3;
    return max(1 + rest*share, matchLimit(h));
}


Foam::misfit::gate Foam::misfit::diagnosis::heldOutGate
(
    const word& name,
    const heldOut& h
) const
{
    const scalar limit = heldOutLimit(h);
    const bool holds = h.squareAfter < limit;

    // Where nothing was wrong before, what stays so confirms nothing
    const bool nothingToAsk = h.squareBefore < matchLimit(h) && holds;
    return
    {
        name,
        "Mean square of the misfit at " + h.what + " (was "
      + number(h.squareBefore) + "), which was not used to find it",
        number(h.squareAfter),
        "below " + number(limit),
        best().what.isNone()
     || (!best().what.isOnlyUnknown() && !nothingToAsk),
        holds
    };
}


Foam::misfit::gate
Foam::misfit::diagnosis::harmGate(const heldOut& h) const
{
    const bool worse =
        best().what.mechanisms.size() && h.squareAfter > h.squareBefore;
    const scalar chance = worse ? chanceOfHarm(h) : 1;
    return
    {
        "harm",
        "Chance that " + h.what + " are matched so much worse (mean square "
      + number(h.squareBefore) + " before, " + number(h.squareAfter)
      + " after) if the best explanation is right",
        number(chance),
        "at least " + number(settings_.significance),
        worse,
        chance >= settings_.significance
    };
}


Foam::misfit::weighed
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
        // Something unknown is weighed beside the best few only. It does not speak
        // for what it is beside: it may match what that does not
        const bool same = !w.what.fault && w.what.hasMechanismsOf(best().what);
        if (told(w.what, names) == here || (same && own == GREAT))
        {
            own = w.score;
        }
    }
    for (const weighed& w : all)
    {
        const bool other =
            w.what.fault ? true
          : w.what.mechanisms.size()
         && !w.what.contains(best().what) && !best().what.contains(w.what);
        if (other && told(w.what, names) != here && w.score < own - settings_.gap)
        {
            return w;
        }
    }
    return best();
}


Foam::misfit::gate Foam::misfit::diagnosis::stabilityGate()
{
    const List<segment>& channels = fit_->data().segments;
    const bool applies =
        channels.size() > 1 && best().what.mechanisms.size();
    const label asked = applies ? channels.size() : 0;
    string lost;
    for (label i = 0; i < asked; ++i)
    {
        const weighed w(winnerWithout(i));
        if (!isAmong({best()}, w))
        {
            winners_.append({channels[i].name, w});
            lost += ' ' + channels[i].name;
        }
    }
    return
    {
        "stability",
        "Channels that can be left out without another explanation winning",
        Foam::name(asked - winners_.size()) + " of " + Foam::name(asked)
      + (lost.empty() ? "" : " (not" + lost + ")"),
        "all",
        applies,
        winners_.empty()
    };
}


Foam::scalar Foam::misfit::diagnosis::gainAlone() const
{
    return
        best().what.mechanisms.empty() ? 0
      : gain(*fit_, best().what, settings_.formulaTolerance);
}


bool Foam::misfit::diagnosis::isMostlyUnknown(const scalar alone) const
{
    return
        best().what.unknown && best().what.mechanisms.size()
     && alone < (baseline().score - best().score)/3;
}


Foam::misfit::gate
Foam::misfit::diagnosis::aloneGate(const scalar alone) const
{
    return
    {
        "alone",
        "Score that what is named gains with nothing unknown beside it",
        number(alone),
        "at least " + number(settings_.evidence),
        best().what.mechanisms.size() > 0,
        alone >= settings_.evidence
    };
}


bool Foam::misfit::diagnosis::isConfirmed() const
{
    bool some = false;
    for (const heldOut& h : found_.held)
    {
        if (h.use == purpose::gate && h.squareBefore > matchLimit(h))
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


Foam::misfit::gate
Foam::misfit::diagnosis::placeboGate(const scalar alone) const
{
    const stacked& data = fit_->data();
    const vec y = data.y;
    const vec base = baseline().best.f;
    const scalar tolerance = settings_.formulaTolerance;
    const auto copy(fit_->copy());

    copy->record(2*base - y);
    scalar placebo = gain(*copy, best().what, tolerance);

    // An effect that lasts is much the same at another time: no placebo then. And
    // what held-out data confirm was seen at other times and places indeed
    const vec effect = best().best.f - base;
    const whitener white(baseline().covariance);
    const bool canMove =
        !isConfirmed()
     && likeness(white(effect), white(halfRoundLater(data, effect))) < 0.7;
    if (canMove)
    {
        copy->record(base + halfRoundLater(data, vec(y - base)));
        placebo = max(placebo, gain(*copy, best().what, tolerance));
    }
    const scalar limit = 0.5*alone;
    return
    {
        "placebo",
        "Score that the best explanation gains, " + number(alone)
      + ": what it still gains where the misfit has the wrong sign"
      + (canMove ? " or is moved in time" : ""),
        number(placebo),
        "below " + number(limit),
        best().what.mechanisms.size() && alone >= settings_.evidence,
        placebo < limit
    };
}


void Foam::misfit::diagnosis::askGates()
{
    found_.gates.append(detectionGate());
    const bool detected = found_.gates.last().passed;
    const scalar alone = detected ? gainAlone() : 0;
    if (detected)
    {
        found_.gates.append(evidenceGate());
        found_.gates.append(computedGate());
        found_.gates.append(gapGate());
        found_.gates.append(adequacyGate(alone));
    }
    else
    {
        // Where the fitted channels agree, others may part all the same
        putFirst(told(baseline().what, mechanismNames()));
    }
    addHeldOut();
    for (const heldOut& h : found_.held)
    {
        const bool here = h.what == "held-out channels";
        if (h.use == purpose::gate)
        {
            found_.gates.append
            (
                heldOutGate(here ? "heldOut" : "transfer", h)
            );
        }
        if (here)
        {
            found_.gates.append(harmGate(h));
        }
    }
    if (detected)
    {
        found_.gates.append(stabilityGate());
        found_.gates.append(aloneGate(alone));
        found_.gates.append(placeboGate(alone));
    }
}
