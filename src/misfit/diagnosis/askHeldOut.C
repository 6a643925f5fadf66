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


bool Foam::misfit::diagnosis::mayBeNothing() const
{
    const hypothesis& what = best().what;
    return
        what.isNone() || !passed("evidence")
     || (what.fault && !what.fault->isRegistration());
}


Foam::List<Foam::misfit::vec>
Foam::misfit::diagnosis::calibrationSteps() const
{
    const label nP = bounds_.nParameters;
    List<vec> steps;
    if (!nP || !mayBeNothing())
    {
        return steps;
    }
    // A parameter at its bound is as uncertain as the others. In widths, as the
    // units may be any.
    const weighed& base = baseline();
    const hypothesisModel model(fit_->surface(), bounds_, base.what);
    const vec width = width_.head(nP);
    const mat slopes =
        whitener(base.covariance)(model.slopes(base.best.x))*width.asDiagonal();
    const vec prior = width.cwiseQuotient(model.deviation());
    const mat curvature =
        slopes.transpose()*slopes + mat(prior.cwiseAbs2().asDiagonal());
    const Eigen::SelfAdjointEigenSolver<mat> axes(curvature);
    const vec x = base.best.x.cwiseQuotient(width);
    const vec lower = model.lower().cwiseQuotient(width);
    const vec upper = model.upper().cwiseQuotient(width);
    for (label k = 0; k < nP; ++k)
    {
        const vec step = axes.eigenvectors().col(k)/std::sqrt(axes.eigenvalues()[k]);
        const auto within = [&](const vec& at)
        {
            return vec(at.cwiseMax(lower).cwiseMin(upper) - x);
        };
        const vec up = within(x + step);
        const vec down = within(x - step);
        vec longer = vec::Zero(bounds_.mean.size());
        longer.head(nP) =
            (up.norm() < down.norm() ? down : up).cwiseProduct(width);
        if (longer.norm() > 0)
        {
            steps.append(longer);
        }
    }
    return steps;
}


void Foam::misfit::diagnosis::addNumerics
(
    covariance& known,
    const observed& other
)
{
    const List<runState> states(uncertaintyRuns(other.experiment));
    const List<samples> given(ask(states));
    mat packings(other.gate.size(), 0);
    bool confirms = true;
    forAll(given, i)
    {
        if (!given[i].ok())
        {
            leaveOut(states[i], given[i].failure);
            confirms = confirms && i > 0 && i < settings_.packings;
        }
        else if (i < settings_.packings)
        {
            appendColumn(packings, given[i].gate);
        }
        else if (given.first().ok())
        {
            known.addDifference
            (
                states[i].resolution, given[i].gate - given.first().gate
            );
        }
    }
    known.addRepeats(packings, settings_.common);
    if (!confirms || (settings_.packings > 1 && packings.cols() < 2))
    {
        addFailed(other, "what packings and numerics change there is not known");
    }
}


void Foam::misfit::diagnosis::addFailed
(
    const observed& other,
    const string& why
)
{
    if (failedExperiments_.found(other.experiment))
    {
        return;
    }
    found_.gates.append
    ({
        "computed", "The solver runs in experiment " + other.experiment, why,
        "runs", true, false
    });
    failedExperiments_.append(other.experiment);
}


void Foam::misfit::diagnosis::addCalibration
(
    covariance& known,
    const List<runState>& states,
    const List<samples>& given
)
{
    mat changes(known.size(), 0);
    for (label k = 2; k < given.size(); ++k)
    {
        if (!given[k].ok())
        {
            leaveOut(states[k], given[k].failure);
        }
        else
        {
            appendColumn(changes, given[k].gate - given[0].gate);
        }
    }
    known.addDirections("calibration", changes);
}


void Foam::misfit::diagnosis::compareElsewhere
(
    const observed& other,
    const samples& before,
    const samples& after,
    const covariance& known
)
{
    const bool gates = other.use == purpose::gate;
    const stacked& recorded = gates ? other.gate : other.score;
    addCompared
    (
        found_.held, "experiment " + other.experiment, other.use, recorded,
        gates ? before.gate : before.score,
        withFault(recorded, gates ? after.gate : after.score),
        known
    );
    if (gates)
    {
        addCompared
        (
            found_.held, "scored channels of experiment " + other.experiment,
            purpose::score, other.score, before.score,
            withFault(other.score, after.score),
            covariance(other.score, settings_.trigger)
        );
    }
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
    const List<vec> steps(gates ? calibrationSteps() : List<vec>());
    for (const vec& step : steps)
    {
        states.append(state(before.variables + step));
    }
    for (runState& s : states)
    {
        s.experiment = other.experiment;
    }
    const List<samples> given(means(states));

    covariance known(gates ? other.gate : other.score, settings_.trigger);
    if (gates && given[0].ok())
    {
        addNumerics(known, other);
        addCalibration(known, states, given);
    }
    elsewhere_.insert({other.experiment, known});

    if (given[0].ok() && given[1].ok())
    {
        compareElsewhere(other, given[0], given[1], known);
    }
    else
    {
        const label failed = given[1].ok() ? 0 : 1;
        leaveOut(states[failed], given[failed].failure);
        if (gates)
        {
            addFailed(other, given[failed].failure);
        }
    }
}


void Foam::misfit::diagnosis::addHeldOut()
{
    const computed before(lookUp(baseline()));
    const computed after(lookUp(best()));
    if (gate_->size())
    {
        covariance known(gate_->data(), gate_->uncertainty());
        const mat slopes = gate_->surface().slopes(before.variables);
        const List<vec> steps(calibrationSteps());
        mat changes(gate_->size(), steps.size());
        forAll(steps, k)
        {
            changes.col(k) = slopes*steps[k];
        }
        known.addDirections("calibration", changes);
        addCompared
        (
            found_.held, "held-out channels", purpose::gate, gate_->data(),
            before.given.gate, withFault(gate_->data(), after.given.gate), known
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
