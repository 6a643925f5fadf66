// SPDX-License-Identifier: GPL-3.0-or-later
// Forces on spheres that are shares of a clump, against those on a whole grain.

#include "grainsInWater.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- All laws that depend on a grain's size
const string laws
(
    "drag { model Gidaspow; shape { model HolzerSommerfeld; sphericity 0.8; } }"
    " lift { model LunLiu; } virtualMass { model Zuber; }"
    " viscousForce { strength 1; } history { window 0.1; }"
);


//- Forces and torques in two intervals, and solid fraction, of what fill() puts into a
//  cube
struct forcesIn
{
    vectorField force;
    vectorField torque;
    scalarField solid;
    scalar volume;

    explicit forcesIn
    (
        const std::function<void(standingGrains&)>& fill,
        const string& model = "sphereCaps"
    )
    {
        testMesh box;
        standingGrains phase(box.mesh());
        fill(phase);
        grainExchange exchange(box.mesh());
        solidFractionField solids
        (
            exchange, entries("model " + model + "; smoothing { width 3; }")
        );
        interphaseForces forces
        (
            exchange, solids, entries(laws), hydrostatics(g), 1
        );
        exchange.locate(phase);
        solids.update();

        const label n = box.mesh().nCells();
        const fluidFields fluid(water(n));
        for (label k = 0; k < 2; ++k)
        {
            forces.prepare(fluid, interval);
            forces.finish
            (
                fluidMeans
                {
                    (1 + k)*fluid.U, fluid.convection,
                    vectorField(n, vector(10, 0, -9810)), fluid.viscousForce,
                    fluid.rho, Zero
                }
            );
        }
        force = forces.force();
        torque = forces.torque();
        solid = solids.solidFraction();
        volume = solids.mapping().totalVolume();
    }
};


const pointField places({point(0.3, 0.4, 0.51), point(0.6, 0.62, 0.3)});
constexpr scalar d = 0.06;

//- On its weight and a contact
const vector load(0.3, -0.1, -2);


void twoGrains(standingGrains& phase)
{
    put(phase, places, d);
    phase.grains.force = 0.1*load;
    phase.total = vectorField(2, load);
}

} // End anonymous namespace


TEST(clumpForces, aClumpOfOneSphereIsAGrainToTheLastBit)
{
    const forcesIn alone(twoGrains);
    const forcesIn clumps
    (
        [](standingGrains& phase)
        {
            twoGrains(phase);
            phase.shares = scalarField(2, 1.0);
            phase.clumpRadii = phase.radii;
        }
    );

    EXPECT_EQ(alone.force, clumps.force);
    EXPECT_EQ(alone.torque, clumps.torque);
    EXPECT_EQ(alone.solid, clumps.solid);
    EXPECT_EQ(alone.volume, clumps.volume);
    EXPECT_GT(mag(alone.force[0]), 1e-3);
}


// Each grain as three spheres of its size that stand in one place
TEST(clumpForces, sharesOfAGrainSumToIt)
{
    const scalarField shares(List<scalar>({0.5, 0.3, 0.2}));
    const forcesIn alone(twoGrains);
    const forcesIn clumps
    (
        [&](standingGrains& phase)
        {
            pointField all(6);
            phase.shares.setSize(6);
            forAll(all, i)
            {
                all[i] = places[i/3];
                phase.shares[i] = shares[i % 3];
            }
            put(phase, all, d);
            phase.clumpRadii = phase.radii;
            phase.grains.mass *= phase.shares;
            phase.grains.force = 0.1*phase.shares*load;
            phase.total = phase.shares*load;
        }
    );

    EXPECT_NEAR(clumps.volume, alone.volume, 1e-15*alone.volume);
    EXPECT_LT(max(mag(clumps.solid - alone.solid)), 1e-15);
    forAll(places, k)
    {
        vector force(Zero), torque(Zero);
        for (label i = 3*k; i < 3*k + 3; ++i)
        {
            force += clumps.force[i];
            torque += clumps.torque[i];
        }
        EXPECT_LT(mag(force - alone.force[k]), 1e-13*mag(force));
        EXPECT_LT(mag(torque - alone.torque[k]), 1e-13*mag(torque));
    }
}


// Small spheres of a large clump, in the cells of their centres
TEST(clumpForces, goByTheSizeOfTheClumpAndNotOfItsSpheres)
{
    const forcesIn alone(twoGrains, "centroid");
    const forcesIn clumps
    (
        [](standingGrains& phase)
        {
            twoGrains(phase);
            phase.shares = scalarField(2, 1.0);
            phase.clumpRadii = phase.radii;
            phase.radii *= 0.2;
        },
        "centroid"
    );

    EXPECT_EQ(clumps.force, alone.force);
    EXPECT_EQ(clumps.solid, alone.solid);
    EXPECT_EQ(clumps.volume, alone.volume);
}
