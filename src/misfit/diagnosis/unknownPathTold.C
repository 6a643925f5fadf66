// SPDX-License-Identifier: GPL-3.0-or-later
// S8: how a free correction fares on held-out data, and what is said of it.

#include "unknownPath.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::unknownPath::tellParts(const fit& f)
{
    forAll(f.free, i)
    {
        const correctionElement& e = settings_.correction[f.free[i]];
        const label k = bounds_.nParameters + i;
        const scalar value = f.best.x[k];
        found_.parts.append
        ({
            e.name, misfit::told(e, value), value, f.best.deviation(k)
        });
    }
}


Foam::scalar Foam::misfit::unknownPath::left(const fit& f) const
{
    const combinedModel model(fit_->surface(), bounds_, f.combination);
    const mat slopes = model.slopes(f.best.x);
    const vec fromMean = f.best.x - model.mean();
    const whitener white
    (
        withFitted(covariance_, slopes, model.deviation())
    );
    const scan look(fit_->data(), white, settings_.draws, settings_.seed);
    return look
    (
        fit_->data().y - f.best.f + slopes*fromMean, settings_.significance
    ).p;
}


Foam::misfit::runState Foam::misfit::unknownPath::inExperiment
(
    const word& experiment,
    const fit& f,
    const dimensionlessLaw* followed,
    const samples& before
) const
{
    vec x = f.variables;
    if (followed)
    {
        const groupFunctions there
        (
            followed->family, settings_.correction, before.met
        );
        x.tail(nElements()) =
            there.combination(*followed)*f.best.x.tail(f.combination.cols());
    }
    runState s(state(x));
    s.experiment = experiment;
    return s;
}


bool Foam::misfit::unknownPath::holdsIn
(
    const observed& other,
    const fit& f,
    const dimensionlessLaw* law
)
{
    // A push that follows the flow is another one where the flow is another
    const bool follows = law && law->family == "push";
    runState base(state(base_));
    base.experiment = other.experiment;
    base.noting = follows;
    const samples before
    (
        sampler_.means(List<runState>(1, base), settings_.common).first()
    );
    found_.nRuns += settings_.common;
    if (!before.ok())
    {
        return false;
    }
    const samples after
    (
        sampler_.means
        (
            List<runState>
            (
                1,
                inExperiment(other.experiment, f, follows ? law : nullptr, before)
            ),
            settings_.common
        ).first()
    );
    found_.nRuns += settings_.common;

    const bool gates = other.use == purpose::gate;
    const stacked& recorded = gates ? other.gate : other.score;
    if (!after.ok() || !recorded.size())
    {
        return false;
    }
    addCompared
    (
        found_.held, "experiment " + other.experiment, other.use, recorded,
        gates ? before.gate : before.score,
        gates ? after.gate : after.score,
        elsewhere_.at(other.experiment)
    );
    const heldOut& h = found_.held.last();
    return h.squareAfter < max(0.5*(h.squareBefore + 1), matchLimit(h));
}


void Foam::misfit::unknownPath::holdOut
(
    const fit& f,
    const dimensionlessLaw* law
)
{
    if (gate_->size())
    {
        addCompared
        (
            found_.held, "held-out channels", purpose::gate, gate_->data(), atBase_.gate,
            f.given.gate, gate_->uncertainty()
        );
    }
    addCompared
    (
        found_.held, "scored channels", purpose::score, data().score, atBase_.score,
        f.given.score, covariance(data().score, settings_.trigger)
    );

    label asked = 0;
    label held = 0;
    for (label i = 1; i < sampler_.data().size(); ++i)
    {
        const observed& other = sampler_.data()[i];
        const bool holds = holdsIn(other, f, law);
        if (other.use == purpose::gate && other.gate.size())
        {
            ++asked;
            held += holds;
        }
    }
    found_.transfers = asked && held == asked;
}


Foam::string Foam::misfit::unknownPath::whyNoLaw() const
{
    return
        lawThatFails_.empty()
      ? "No law in one or two dimensionless numbers says as much."
      : "No law is named, since the solver fails with one that may say as much: it"
        " would act like " + lawThatFails_ + '.';
}


void Foam::misfit::unknownPath::describe(const fit& best)
{
    string gone;
    string worse;
    bool holds = true;
    for (const heldOut& h : found_.held)
    {
        if (h.squareAfter > h.squareBefore)
        {
            worse += (worse.empty() ? "" : " and ") + h.what;
            holds = holds && h.use != purpose::gate;
        }
        else
        {
            gone +=
                (gone.empty() ? "" : ", ")
              + Foam::name(std::round(100*removed(h))) + " % at " + h.what;
        }
    }

    found_.named =
        found_.explained && found_.transfers && holds
     && found_.left >= settings_.adequacy;
    if (found_.parts.empty() && !found_.explained)
    {
        found_.told =
            lawThatFails_.size() ? whyNoLaw()
          : string("No push and no factor on the drag of the free correction explains"
                " it either.");
        return;
    }
    if (found_.explained)
    {
        found_.told = "It acts like " + found_.laws.first().words;
    }
    else
    {
        found_.told = "It acts like ";
        forAll(found_.parts, i)
        {
            found_.told += (i ? ", and " : "") + found_.parts[i].words;
        }
    }
    found_.told +=
        found_.held.empty()
      ? string(". There are no held-out data to try that on.")
      : gone.empty() ? string(".")
      : ". Of the misfit, this takes away " + gone + '.';
    if (!worse.empty())
    {
        found_.told += " It does not hold at " + worse + '.';
    }
    if (best.failure.size())
    {
        found_.told +=
            " The solver fails with it: these numbers are of the response surface.";
    }
    if (!found_.named)
    {
        found_.told +=
            !found_.explained
          ? ' ' + whyNoLaw()
          : !found_.transfers
          ? " This law is not named, since no other experiment confirms it."
          : !holds
          ? " This law is not named, since held-out channels are matched worse."
          : " This law is not named, since it leaves too much.";
    }
}
