// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters chosen by response surfaces.

#include "calibration.H"
#include "scalarList.H"
#include "statisticsNames.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;
using statistics::calibration;
using statistics::calibrationTarget;
using statistics::freeParameter;
using statistics::responseSurface;

namespace
{

//- Two numbers that a run comes to under a condition c, with a viscosity given by its
//  decades and a choice k of 0 or 1
vec truth(const scalar c, const scalar decades, const scalar k)
{
    vec f(2);
    f << 1 + 2*c + decades*decades + 0.5*k, 3 - c - decades + 2*k;
    return f;
}


//- The surface of runs at three conditions, four viscosities and both choices
std::shared_ptr<const responseSurface> surfaceOfRuns()
{
    mat x(3, 24);
    mat y(2, 24);
    label run = 0;
    for (const scalar c : {-1, 0, 1})
    {
        for (const scalar decades : {0.0, 0.5, 1.5, 2.0})
        {
            for (const scalar k : {0, 1})
            {
                x.col(run) << c, decades, k;
                y.col(run++) = truth(c, decades, k);
            }
        }
    }
    vec centre(3);
    vec width(3);
    centre << 0, 1, 0.5;
    width << 1, 1, 0.5;
    return std::make_shared<const responseSurface>(x, y, centre, width);
}


std::vector<freeParameter> viscosityAndChoice()
{
    std::vector<freeParameter> parameters(2);
    parameters[0].name = "viscosity";
    parameters[0].lower = 0;
    parameters[0].upper = 2;
    parameters[0].logarithmic = true;
    parameters[1].name = "choice";
    parameters[1].levels = {0, 1};
    return parameters;
}


calibrationTarget target(const scalar c, const vec& expected)
{
    calibrationTarget t;
    t.surface = surfaceOfRuns();
    t.conditions = vec::Constant(1, c);
    t.values = expected;
    t.deviation = vec::Constant(2, 0.1);
    return t;
}

} // End anonymous namespace


TEST(misfitCalibration, theParametersThatMadeTheTargetsAreChosenAmongLevelsToo)
{
    for (const scalar k : {0, 1})
    {
        const std::vector<calibrationTarget> targets
        ({
            target(-1, truth(-1, 0.7, k)),
            target(0.5, truth(0.5, 0.7, k))
        });
        calibration calibrate(viscosityAndChoice(), targets);
        vec chosen;
        vec deviations;
        const fitResult best = calibrate.choose(chosen, deviations);

        EXPECT_NEAR(chosen[0], 0.7, 1e-6);
        EXPECT_EQ(chosen[1], k);
        EXPECT_NEAR(best.misfit, 0, 1e-9);

        // Slopes of each target over the decades: 2*0.7 and -1, with a deviation of 0.1
        EXPECT_NEAR(deviations[0], 0.1/std::sqrt(2*(sqr(1.4) + 1)), 1e-6);
        EXPECT_EQ(deviations[1], 0);
    }
}


TEST(misfitCalibration, noParameterIsBeyondItsBounds)
{
    const std::vector<calibrationTarget> targets(1, target(0, truth(0, 2.6, 1)));
    calibration calibrate(viscosityAndChoice(), targets);
    vec chosen;
    vec deviations;
    const fitResult best = calibrate.choose(chosen, deviations);

    EXPECT_NEAR(chosen[0], 2, 1e-9);
    EXPECT_EQ(deviations[0], 0);
    EXPECT_GT(best.misfit, 1);
}


TEST(misfitCalibration, aLogarithmicParameterIsItsDecades)
{
    const freeParameter viscosity(viscosityAndChoice()[0]);
    EXPECT_NEAR(viscosity.scaled(100), 2, 1e-12);
    EXPECT_NEAR(viscosity.value(2), 100, 1e-9);
}
