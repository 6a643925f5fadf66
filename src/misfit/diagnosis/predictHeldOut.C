// SPDX-License-Identifier: GPL-3.0-or-later
// Data that were not used to find an answer: predicted, and what is uncertain there.

#include "heldOutChance.H"
#include "stages.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Samples with the sensor fault that was found, where it shows
samples withFault
(
    const study& s,
    const hypothesisFit& best,
    const observation& recorded,
    samples computed
)
{
    for (const purpose use : {purpose::validation, purpose::test})
    {
        if (best.what.fault && computed.of(use).size() == recorded.of(use).size())
        {
            computed.of(use) = best.what.fault->elsewhere
            (
                recorded.of(use),
                computed.of(use),
                s.calibration.model(best.what).ofFault(best.fit.x)
            );
        }
    }
    return computed;
}


//- What one standard deviation along each axis of what the calibration leaves
//  uncertain changes in the variables, within their bounds
std::vector<vec> calibrationSteps(const study& s, const hypothesisFit& base)
{
    std::vector<vec> steps
    (
        statistics::stepsWithin
        (
            s.calibration.model(base.what), whitener(base.covariance), base.fit.x,
            s.bounds.width.head(s.bounds.nParameters)
        )
    );
    for (vec& step : steps)
    {
        step.conservativeResizeLike(vec::Zero(s.bounds.mean.size()));
    }
    return steps;
}


//- Adds what the calibration's steps change there: the states from the third on, the
//  first being calibrated
void addCalibration
(
    study& s,
    const purpose use,
    const List<runState>& states,
    const List<samples>& results,
    covariance& known
)
{
    mat changes(known.size(), 0);
    for (label k = 2; k < results.size(); ++k)
    {
        if (!results[k].ok())
        {
            s.leaveOut(states[k], results[k].failure);
        }
        else
        {
            appendColumn(changes, results[k].of(use) - results[0].of(use));
        }
    }
    known.addDirections("calibration", changes);
}


//- An experiment in which the solver fails. why: empty where what replicates and
//  numerics change there is not known
gate failureIn(const word& experiment, const string& why)
{
    gate g(gateKind::computed, 0, 1);
    g.experiment = experiment;
    g.failure = why;
    return g;
}


//- The states of another experiment: before and after, and at steps from before
List<runState> statesIn
(
    const study& s,
    const observation& other,
    const std::vector<vec>& steps,
    const explanations& e
)
{
    const vec before = e.lookUp(s, e.baseline()).variables;
    List<runState> states
    ({
        s.state(other.experiment, before),
        s.state(other.experiment, e.lookUp(s, e.best()).variables)
    });
    for (const vec& step : steps)
    {
        states.append(s.state(other.experiment, before + step));
    }
    return states;
}


//- Another experiment: its held-out data, where the solver fails, and what is uncertain
//  there. Without what replicates and numerics change where the base fails
struct experimentPrediction
{
    covariance known;

    List<heldOut> held;

    std::optional<gate> failure;
};


experimentPrediction predictIn
(
    study& s,
    const observation& other,
    const std::vector<vec>& steps,
    const explanations& e
)
{
    const bool validates = other.use == purpose::validation;
    const List<runState> states
    (
        statesIn(s, other, steps, e)
    );
    const List<samples> results(s.means(states));
    experimentPrediction r
    {
        covariance(other.of(other.use), s.set.clockUncertainty), {}, {}
    };
    if (results[0].ok())
    {
        const bool isKnown = addNumerics(s, other, r.known);
        if (validates && !isKnown)
        {
            r.failure = failureIn(other.experiment, "");
        }
        addCalibration(s, other.use, states, results, r.known);
    }

    if (!results[0].ok() || !results[1].ok())
    {
        const label failed = results[1].ok() ? 0 : 1;
        s.leaveOut(states[failed], results[failed].failure);
        if (validates && !r.failure)
        {
            r.failure = failureIn(other.experiment, results[failed].failure);
        }
        return r;
    }
    const samples after(withFault(s, e.best(), other, results[1]));
    const auto add = [&](const heldOut::part what, const covariance& known)
    {
        if (const auto one = compare(what, other, results[0], after, known, s.set))
        {
            r.held.append(*one);
        }
    };
    add(heldOut::part::experiment, r.known);
    if (validates)
    {
        add
        (
            heldOut::part::testElsewhere,
            covariance(other.test, s.set.clockUncertainty)
        );
    }
    return r;
}


//- What is uncertain in the validation channels of the experiment that is fitted, with
//  what steps from these variables change
covariance uncertainHere
(
    const study& s,
    const vec& variables,
    const std::vector<vec>& steps
)
{
    const stacked& data = s.validation.data();
    covariance known(s.validation.uncertainty());
    mat changes(data.size(), steps.size());
    for (label k = 0; data.size() && k < count(steps); ++k)
    {
        changes.col(k) = s.validation.surface().slopes(variables)*steps[k];
    }
    known.addDirections("calibration", changes);
    return known;
}

} // End anonymous namespace


Foam::misfit::heldOutPrediction Foam::misfit::predictHeldOut
(
    study& s,
    const explanations& e,
    const bool mayBeNothing
)
{
    const evaluation before(e.lookUp(s, e.baseline()));
    const std::vector<vec> steps
    (
        mayBeNothing ? calibrationSteps(s, e.baseline()) : std::vector<vec>()
    );
    heldOutPrediction all;
    all.held = compareHere
    (
        s, before.computed,
        withFault(s, e.best(), s.data(), e.lookUp(s, e.best()).computed),
        uncertainHere(s, before.variables, steps)
    );
    for (label i = 1; i < s.experiments.size(); ++i)
    {
        const observation& other = s.experiments[i];
        const experimentPrediction one(predictIn(s, other, steps, e));
        all.held.append(one.held);
        if (one.failure)
        {
            all.failures.add(*one.failure);
        }
        all.uncertainty.insert({other.experiment, one.known});
    }
    return all;
}
