// SPDX-License-Identifier: GPL-3.0-or-later
// Which data were not used to find an answer, and what is uncertain there.

#include "heldOut.H"
#include "uncertainty.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Samples with the sensor fault that was found, where it shows
vec withFault
(
    const models& m,
    const scored& best,
    const stacked& data,
    const vec& computed
)
{
    if (!best.what.fault || computed.size() != data.size())
    {
        return computed;
    }
    return
        best.what.fault->elsewhere
        (
            data, computed, m.calibration->model(best.what).ofFault(best.best.x)
        );
}


//- What one standard deviation along each axis of what the calibration leaves
//  uncertain changes in the variables, within their bounds
std::vector<vec> calibrationSteps
(
    const study& s,
    const models& m,
    const scored& base
)
{
    const label nP = s.bounds().nParameters;
    std::vector<vec> steps;
    if (!nP)
    {
        return steps;
    }

    // A parameter at its bound is as uncertain as the others. In widths, as the
    // units may be any.
    const hypothesisModel model(m.calibration->model(base.what));
    const vec width = s.width().head(nP);
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
        const vec step =
            axes.eigenvectors().col(k)/std::sqrt(axes.eigenvalues()[k]);
        const auto within = [&](const vec& at)
        {
            return vec(at.cwiseMax(lower).cwiseMin(upper) - x);
        };
        const vec up = within(x + step);
        const vec down = within(x - step);
        vec longer = vec::Zero(s.bounds().mean.size());
        longer.head(nP) =
            (up.norm() < down.norm() ? down : up).cwiseProduct(width);
        if (longer.norm() > 0)
        {
            steps.push_back(longer);
        }
    }
    return steps;
}


//- Adds what replicates and numerics change in another experiment; false if it is not
//  known
bool addNumerics(study& s, const observed& other, covariance& known)
{
    const label replicates = s.set().replicates;
    const List<runState> states(uncertaintyRuns(s, other.experiment));
    const List<samples> given(s.run(states));
    mat repeats(other.validation.size(), 0);
    bool confirms = true;
    forAll(given, i)
    {
        if (!given[i].ok())
        {
            s.leaveOut(states[i], given[i].failure);
            confirms = confirms && i > 0 && i < replicates;
        }
        else if (i < replicates)
        {
            appendColumn(repeats, given[i].validation);
        }
        else if (given.first().ok())
        {
            known.addDifference
            (
                states[i].resolution, given[i].validation - given.first().validation
            );
        }
    }
    known.addRepeats(repeats, s.set().commonRandomNumbers);
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


//- Recordings of other experiments, one by one
class otherExperiments
{
    study& s_;

    const models& m_;

    const scored& best_;

    const computed before_;

    const computed after_;

    const std::vector<vec>& steps_;

    heldOutTest& test_;


    //- What is recorded there, before and after
    void compare
    (
        const observed& other,
        const samples& before,
        const samples& after,
        const covariance& known
    )
    {
        const auto add = [&]
        (
            const heldOut::part what,
            const purpose use,
            const stacked& data,
            const vec& from,
            const vec& to,
            const covariance& c
        )
        {
            test_.held.append
            (
                compared
                (
                    what, other.experiment, use, data, from,
                    withFault(m_, best_, data, to), c, s_.set()
                )
            );
        };
        using part = heldOut::part;
        if (other.use != purpose::validation)
        {
            add
            (
                part::experiment, other.use, other.test, before.test,
                after.test, known
            );
            return;
        }
        add
        (
            part::experiment, other.use, other.validation, before.validation,
            after.validation, known
        );
        add
        (
            part::testElsewhere, purpose::test, other.test, before.test,
            after.test, covariance(other.test, s_.set().clockUncertainty)
        );
    }


    //- Once for each experiment
    void fail(const observed& other, const string& why)
    {
        if (test_.failed.empty() || test_.failed.last().name != other.experiment)
        {
            test_.failed.append({other.experiment, why});
        }
    }


public:

    otherExperiments
    (
        study& s,
        const models& m,
        const explanations& e,
        const std::vector<vec>& steps,
        heldOutTest& test
    )
    :
        s_(s),
        m_(m),
        best_(e.best()),
        before_(e.lookUp(m, e.baseline())),
        after_(e.lookUp(m, e.best())),
        steps_(steps),
        test_(test)
    {}

    void test(const observed& other)
    {
        const bool validates = other.use == purpose::validation;
        List<runState> states
        ({
            s_.state(other.experiment, before_.variables),
            s_.state(other.experiment, after_.variables)
        });
        for (label k = 0; validates && k < count(steps_); ++k)
        {
            states.append
            (
                s_.state(other.experiment, before_.variables + steps_[k])
            );
        }
        const List<samples> given(s_.means(states));

        covariance known
        (
            validates ? other.validation : other.test, s_.set().clockUncertainty
        );
        if (validates && given[0].ok())
        {
            if (!addNumerics(s_, other, known))
            {
                fail(other, "");
            }
            addCalibration(s_, states, given, known);
        }
        test_.known.insert({other.experiment, known});

        if (given[0].ok() && given[1].ok())
        {
            compare(other, given[0], given[1], known);
            return;
        }
        const label failed = given[1].ok() ? 0 : 1;
        s_.leaveOut(states[failed], given[failed].failure);
        if (validates)
        {
            fail(other, given[failed].failure);
        }
    }
};

} // End anonymous namespace


Foam::misfit::heldOutTest Foam::misfit::testHeldOut
(
    study& s,
    const models& m,
    const explanations& e,
    const bool mayBeNothing
)
{
    heldOutTest test;
    const computed before(e.lookUp(m, e.baseline()));
    const computed after(e.lookUp(m, e.best()));
    const std::vector<vec> steps
    (
        mayBeNothing ? calibrationSteps(s, m, e.baseline()) : std::vector<vec>()
    );
    const word& here = s.data().experiment;
    if (m.validation->size())
    {
        const stacked& data = m.validation->data();
        covariance known(data, m.validation->uncertainty());
        const mat slopes = m.validation->surface().slopes(before.variables);
        mat changes(data.size(), steps.size());
        for (label k = 0; k < count(steps); ++k)
        {
            changes.col(k) = slopes*steps[k];
        }
        known.addDirections("calibration", changes);
        test.held.append
        (
            compared
            (
                heldOut::part::validation, here, purpose::validation, data,
                before.given.validation,
                withFault(m, e.best(), data, after.given.validation),
                known, s.set()
            )
        );
    }
    const stacked& testData = s.data().test;
    test.held.append
    (
        compared
        (
            heldOut::part::test, here, purpose::test, testData,
            before.given.test,
            withFault(m, e.best(), testData, after.given.test),
            covariance(testData, s.set().clockUncertainty), s.set()
        )
    );

    otherExperiments others(s, m, e, steps, test);
    for (label i = 1; i < s.experiments().size(); ++i)
    {
        others.test(s.experiments()[i]);
    }
    return test;
}
