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

    // A push that follows the flow is another one where the flow is another
    const label nP = bounds_.nParameters;
    label asked = 0;
    label held = 0;
    for (label i = 1; i < sampler_.data().size(); ++i)
    {
        const observed& other = sampler_.data()[i];
        const bool gates = other.use == purpose::gate;
        const stacked& recorded = gates ? other.gate : other.score;
        runState s(state(base_));
        s.experiment = other.experiment;
        s.noting = law && law->family == "push";
        const samples before(sampler_(List<runState>(1, s)).first());

        vec x = f.variables;
        if (s.noting)
        {
            const groupFunctions there
            (
                law->family, settings_.correction, before.met
            );
            x.tail(nElements()) =
                there.combination(*law)*f.best.x.tail(f.combination.cols());
        }
        x.head(nP) = f.variables.head(nP);
        s = state(x);
        s.experiment = other.experiment;
        const samples after(sampler_(List<runState>(1, s)).first());
        found_.nRuns += 2;

        // Where the solver fails nothing is confirmed
        asked += gates && recorded.size();
        if (before.ok() && after.ok())
        {
            addCompared
            (
                found_.held, "experiment " + other.experiment, other.use, recorded,
                gates ? before.gate : before.score,
                gates ? after.gate : after.score,
                elsewhere_.at(other.experiment)
            );
            if (gates && recorded.size())
            {
                const heldOut& h = found_.held.last();
                held += h.squareAfter < max
                (
                    0.5*(h.squareBefore + 1), beyondChance
                );
            }
        }
    }
    found_.transfers = asked && held == asked;
}


void Foam::misfit::unknownPath::describe()
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
            "No push and no factor on the drag of the free correction explains"
            " it either.";
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
    if (!found_.named)
    {
        found_.told +=
            !found_.explained
          ? " No law in one or two dimensionless numbers says as much."
          : !found_.transfers
          ? " This law is not named, since no other experiment confirms it."
          : !holds
          ? " This law is not named, since held-out channels are matched worse."
          : " This law is not named, since it leaves too much.";
    }
}
