// SPDX-License-Identifier: GPL-3.0-or-later
// Data that were not used to find an answer: predicted, and what is uncertain there.

#include "heldOut.H"
#include "elsewhere.H"
#include "stages.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Samples with the sensor fault that was found, where it shows
samples withFault
(
    const study& s,
    const scored& best,
    const observed& recorded,
    samples given
)
{
    for (const purpose use : {purpose::validation, purpose::test})
    {
        if (best.what.fault && given.of(use).size() == recorded.of(use).size())
        {
            given.of(use) = best.what.fault->elsewhere
            (
                recorded.of(use),
                given.of(use),
                s.calibration.model(best.what).ofFault(best.best.x)
            );
        }
    }
    return given;
}


//- What one standard deviation along each axis of what the calibration leaves
//  uncertain changes in the variables, within their bounds
std::vector<vec> calibrationSteps(const study& s, const scored& base)
{
    std::vector<vec> steps
    (
        statistics::stepsWithin
        (
            s.calibration.model(base.what), whitener(base.covariance), base.best.x,
            s.bounds.width.head(s.bounds.nParameters)
        )
    );
    for (vec& step : steps)
    {
        step.conservativeResizeLike(vec::Zero(s.bounds.mean.size()));
    }
    return steps;
}


//- Adds what replicates and numerics change in another experiment; false if it is not
//  known
bool addNumerics(study& s, const observed& other, covariance& known)
{
    const label replicates = s.set.replicates;
    const List<runState> states(uncertaintyRuns(s, other.experiment));
    const List<samples> given(s.run(states));
    bool confirms = given.first().ok();
    forAll(given, i)
    {
        if (!given[i].ok())
        {
            s.leaveOut(states[i], given[i].failure);
        }
    }
    const purpose held = purpose::validation;
    const mat repeats(samplesOf("base", states, given, held));
    for (const word& name : s.set.resolutions)
    {
        const mat changes(changesBy(name, states, given, held));
        confirms = confirms && changes.cols();
        if (changes.cols())
        {
            known.addResolution
            (
                name, changes, repeats, s.set.chaotic && repeats.cols() > 1
            );
        }
    }
    known.addRepeats(repeats, s.set.commonRandomNumbers);
    return confirms && (replicates < 2 || repeats.cols() > 1);
}


//- The same for what the calibration's steps change: the states from the third on,
//  the first being calibrated
void addCalibration
(
    study& s,
    const List<runState>& states,
    const List<samples>& given,
    covariance& known
)
{
    mat changes(known.size(), 0);
    for (label k = 2; k < given.size(); ++k)
    {
        if (!given[k].ok())
        {
            s.leaveOut(states[k], given[k].failure);
        }
        else
        {
            appendColumn(changes, given[k].validation - given[0].validation);
        }
    }
    known.addDirections("calibration", changes);
}


//- An experiment in which the solver fails, once
void addFailure(heldOutPredictions& all, const word& experiment, const string& why)
{
    if (all.failed.empty() || all.failed.last().name != experiment)
    {
        all.failed.append({experiment, why});
    }
}


//- What is uncertain in another experiment; without what replicates and numerics change
//  where it only tests, or where the base fails
covariance uncertainIn
(
    study& s,
    const observed& other,
    const List<runState>& states,
    const List<samples>& given,
    heldOutPredictions& all
)
{
    covariance known(other.of(other.use), s.set.clockUncertainty);
    if (other.use == purpose::validation && given[0].ok())
    {
        if (!addNumerics(s, other, known))
        {
            addFailure(all, other.experiment, "");
        }
        addCalibration(s, states, given, known);
    }
    return known;
}


//- Another experiment at the variables before and after, and at steps from before
void predictIn
(
    study& s,
    const explanations& e,
    const observed& other,
    const std::vector<vec>& steps,
    heldOutPredictions& all
)
{
    const vec before = e.lookUp(s, e.baseline()).variables;
    const bool validates = other.use == purpose::validation;
    List<runState> states
    ({
        s.state(other.experiment, before),
        s.state(other.experiment, e.lookUp(s, e.best()).variables)
    });
    for (label k = 0; validates && k < count(steps); ++k)
    {
        states.append(s.state(other.experiment, before + steps[k]));
    }
    const List<samples> given(s.means(states));
    const covariance known(uncertainIn(s, other, states, given, all));
    all.known.insert({other.experiment, known});

    if (!given[0].ok() || !given[1].ok())
    {
        const label failed = given[1].ok() ? 0 : 1;
        s.leaveOut(states[failed], given[failed].failure);
        if (validates)
        {
            addFailure(all, other.experiment, given[failed].failure);
        }
        return;
    }
    const samples after(withFault(s, e.best(), other, given[1]));
    compare
    (
        heldOut::part::experiment, other, given[0], after, known, s.set, all.held
    );
    if (validates)
    {
        compare
        (
            heldOut::part::testElsewhere, other, given[0], after,
            covariance(other.test, s.set.clockUncertainty), s.set, all.held
        );
    }
}

} // End anonymous namespace


Foam::misfit::heldOutPredictions Foam::misfit::predictHeldOut
(
    study& s,
    const explanations& e,
    const bool mayBeNothing
)
{
    heldOutPredictions all;
    const computed before(e.lookUp(s, e.baseline()));
    const std::vector<vec> steps
    (
        mayBeNothing ? calibrationSteps(s, e.baseline()) : std::vector<vec>()
    );
    const stacked& data = s.validation.data();
    covariance known(s.validation.uncertainty());
    mat changes(data.size(), steps.size());
    for (label k = 0; data.size() && k < count(steps); ++k)
    {
        changes.col(k) =
            s.validation.surface().slopes(before.variables)*steps[k];
    }
    known.addDirections("calibration", changes);
    compareHere
    (
        s, before.given,
        withFault(s, e.best(), s.data(), e.lookUp(s, e.best()).given), known,
        all.held
    );
    for (label i = 1; i < s.experiments.size(); ++i)
    {
        predictIn(s, e, s.experiments[i], steps, all);
    }
    return all;
}
