// SPDX-License-Identifier: GPL-3.0-or-later
// Grains at the start, and those that come in: they carry water along at once.

#include "boxOfWater.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Of grains of a density in water, with the mass that they carry along [m/s2]
scalar riseOf(const scalar density)
{
    return (1000 - density)/(density + 0.5*1000)*mag(g);
}


const std::string carryingWater
(
    "interphaseForces { drag { model none; } virtualMass { model constant; } }"
);

} // End anonymous namespace


TEST(demCoupling, grainsCarryWaterAlongFromTheFirstIntervalOn)
{
    for (const scalar density : {5.0, 100.0, 2500.0})
    {
        boxOfWater w(carryingWater);
        w.placeGrains(0.5, 0.02, density);
        demCoupling coupling(w.box().mesh(), hydrostatics(g));
        coupling.start(w.water());
        coupling.moveGrains();

        const auto& phase =
            w.box().mesh().lookupObject<granularPhase>(granularPhase::typeName);
        const scalar speed = riseOf(density)*interval;
        EXPECT_NEAR(phase.velocity()[0].z(), speed, 1e-9*mag(speed)) << density;
    }
}


TEST(demCoupling, theWaterActsOnAGrainThatComesInAtOnce)
{
    for (const scalar density : {5.0, 100.0, 2500.0})
    {
        boxOfWater w(carryingWater);
        w.insertGrain(density);
        demCoupling coupling(w.box().mesh(), hydrostatics(g));
        coupling.start(w.water());
        coupling.moveGrains([&]{ return w.water(); });

        const auto& phase =
            w.box().mesh().lookupObject<granularPhase>(granularPhase::typeName);
        ASSERT_EQ(phase.size(), 5);
        const label last = findMax(phase.id());

        // It comes in during the first of the 50 steps
        const scalar speed = riseOf(density)*interval;
        EXPECT_NEAR(phase.velocity()[last].z(), speed, 0.03*mag(speed)) << density;
    }
}


TEST(demCoupling, goesOnWithoutGrainsAndTakesThoseThatComeIn)
{
    for (const bool enters : {false, true})
    {
        boxOfWater w;
        w.writeInitial(1, "");
        if (enters)
        {
            w.insertGrain(2500);
        }
        demCoupling coupling(w.box().mesh(), hydrostatics(g));
        coupling.start(w.water());
        exchangeOnce(coupling, w);
        EXPECT_TRUE(coupling.write());
        exchangeOnce(coupling, w);

        EXPECT_EQ(coupling.forces().force().size(), enters ? 1 : 0);
        EXPECT_TRUE(std::isfinite(coupling.forces().residual()));
    }
}
