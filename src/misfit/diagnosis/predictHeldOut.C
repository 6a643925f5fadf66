// SPDX-License-Identifier: GPL-3.0-or-later
// Data that were not used to find an answer: predicted, and what is uncertain there.

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


//- Adds what the calibration's steps change there: the states from the third on, the
//  first being calibrated
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


//- An experiment in which the solver fails, once. why: empty where what replicates and
//  numerics change there is not known
void addFailure(finding& f, const word& experiment, const string& why)
{
    if (f.failedExperiments.empty() || f.failedExperiments.last() != experiment)
    {
        f.failedExperiments.append(experiment);
        gate g(gateKind::computed, 0, 1);
        g.experiment = experiment;
        g.failure = why;
        f.gates.add(g);
    }
}


//- What is uncertain in another experiment; without what replicates and numerics change
//  where it only tests, or where the base fails. Finds where the solver fails there
covariance uncertainIn
(
    study& s,
    const observed& other,
    const List<runState>& states,
    const List<samples>& given,
    finding& f
)
{
    covariance known(other.of(other.use), s.set.clockUncertainty);
    if (other.use == purpose::validation && given[0].ok())
    {
        if (!addNumerics(s, other, known))
        {
            addFailure(f, other.experiment, "");
        }
        addCalibration(s, states, given, known);
    }
    return known;
}


//- Another experiment at the variables before and after, and at steps from before;
//  returns what is uncertain there
covariance predictIn
(
    study& s,
    const observed& other,
    const std::vector<vec>& steps,
    finding& f
)
{
    const explanations& e = f.explained;
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
    covariance known(uncertainIn(s, other, states, given, f));

    if (!given[0].ok() || !given[1].ok())
    {
        const label failed = given[1].ok() ? 0 : 1;
        s.leaveOut(states[failed], given[failed].failure);
        if (validates)
        {
            addFailure(f, other.experiment, given[failed].failure);
        }
        return known;
    }
    const samples after(withFault(s, e.best(), other, given[1]));
    compare
    (
        heldOut::part::experiment, other, given[0], after, known, s.set, f.held
    );
    if (validates)
    {
        compare
        (
            heldOut::part::testElsewhere, other, given[0], after,
            covariance(other.test, s.set.clockUncertainty), s.set, f.held
        );
    }
    return known;
}

} // End anonymous namespace


std::map<Foam::word, Foam::misfit::covariance> Foam::misfit::predictHeldOut
(
    study& s,
    const bool mayBeNothing,
    finding& f
)
{
    const explanations& e = f.explained;
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
        f.held
    );
    std::map<word, covariance> elsewhere;
    for (label i = 1; i < s.experiments.size(); ++i)
    {
        const observed& other = s.experiments[i];
        elsewhere.insert({other.experiment, predictIn(s, other, steps, f)});
    }
    f.tested = f.held;
    return elsewhere;
}
