// SPDX-License-Identifier: GPL-3.0-or-later
// S7: how well recordings that were not used are matched, before and after.

#include "diagnosis.H"

Foam::misfit::vec Foam::misfit::diagnosis::withFault
(
    const stacked& data,
    const vec& computed
) const
{
    if (!best().what.fault || computed.size() != data.size())
    {
        return computed;
    }
    const hypothesisModel model(fit_->surface(), bounds_, best().what);
    return
        best().what.fault->elsewhere
        (
            data, computed, model.ofFault(best().best.x)
        );
}


Foam::misfit::covariance Foam::misfit::diagnosis::errorElsewhere
(
    const stacked& data,
    const List<runState>& states,
    const List<samples>& bases
)
{
    // The mesh errs there as it does in the experiment that is fitted
    covariance known(data, settings_.trigger);
    for (label k = 1; k < bases.size(); ++k)
    {
        if (!bases[k].ok())
        {
            leaveOut(states[k], bases[k].failure);
        }
        else if (bases[0].ok())
        {
            known.addDifference
            (
                states[k].resolution, bases[k].gate - bases[0].gate
            );
        }
    }
    return known;
}


void Foam::misfit::diagnosis::addExperiment
(
    const observed& other,
    const computed& before,
    const computed& after
)
{
    const bool gates = other.use == purpose::gate;
    List<runState> states({state(before.variables), state(after.variables)});
    for (label k = 0; gates && k <= settings_.resolutions.size(); ++k)
    {
        states.append(state(bounds_.mean));
        states.last().resolution =
            k ? settings_.resolutions[k - 1] : word("base");
    }
    for (runState& s : states)
    {
        s.experiment = other.experiment;
    }
    const List<samples> given(ask(states));

    const label nBases = states.size() - 2;
    const stacked& recorded = gates ? other.gate : other.score;
    const covariance known
    (
        errorElsewhere
        (
            recorded,
            List<runState>(SubList<runState>(states, nBases, 2)),
            List<samples>(SubList<samples>(given, nBases, 2))
        )
    );
    elsewhere_.insert({other.experiment, known});

    if (given[0].ok() && given[1].ok())
    {
        addCompared
        (
            found_.held, "experiment " + other.experiment, other.use, recorded,
            gates ? given[0].gate : given[0].score,
            withFault(recorded, gates ? given[1].gate : given[1].score),
            known
        );
        if (gates)
        {
            addCompared
            (
                found_.held, "scored channels of experiment " + other.experiment,
                purpose::score, other.score, given[0].score,
                withFault(other.score, given[1].score),
                covariance(other.score, settings_.trigger)
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


void Foam::misfit::diagnosis::addHeldOut()
{
    const computed before(lookUp(baseline()));
    const computed after(lookUp(best()));
    if (gate_->size())
    {
        addCompared
        (
            found_.held, "held-out channels", purpose::gate, gate_->data(),
            before.given.gate, withFault(gate_->data(), after.given.gate),
            gate_->uncertainty()
        );
    }
    addCompared
    (
        found_.held, "scored channels", purpose::score, data().score,
        before.given.score, withFault(data().score, after.given.score),
        covariance(data().score, settings_.trigger)
    );
    for (label i = 1; i < sampler_.data().size(); ++i)
    {
        addExperiment(sampler_.data()[i], before, after);
    }
}
