// SPDX-License-Identifier: GPL-3.0-or-later
// What the water does to one grain alone in it.

#include "grainsInWater.H"
#include "testMesh.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- One grain alone in a box of water
struct loneGrain
{
    testMesh box;

    standingGrains phase;

    grainExchange exchange;

    solidFractionField solids;

    explicit loneGrain(const scalar d)
    :
        phase(box.mesh()),
        exchange(box.mesh()),
        solids(exchange, entries(inOneCellEach))
    {
        put(phase, pointField(1, point(0.4, 0.4, 0.4)), d);
    }

    //- Forces by these laws in water that does not accelerate
    autoPtr<interphaseForces> forces
    (
        const string& laws,
        const fluidFields& fluid,
        const vector& pressureGradient = Zero
    )
    {
        const label n = box.mesh().nCells();
        exchange.locate(phase);
        solids.update();

        auto result = autoPtr<interphaseForces>::New
        (
            exchange, solids, entries(laws), g, 1
        );
        const vectorField none(n, Zero);
        result->prepare(fluid, interval);
        result->finish
        (
            inEquation
            (
                fluidMeans
                {
                    fluid.U, none, vectorField(n, pressureGradient), none,
                    scalarField(), Zero
                },
                fluid.rho, *result, solids, box.mesh(), g
            )
        );
        EXPECT_LT(result->residual(), 1e-12);
        return result;
    }
};

} // End anonymous namespace


TEST(excessPressure, actsByItsStrengthAndBuoyancyInFull)
{
    constexpr scalar d = 0.05;
    const vector gradient(300, -200, -9000);
    const vector atRest(rhoWater*g);

    for (const scalar strength : {0.0, 0.3, 1.0})
    {
        loneGrain grain(d);
        const auto forces = grain.forces
        (
            "drag { model none; } excessPressure { strength "
          + Foam::name(strength) + "; }",
            water(grain.box.mesh().nCells()),
            gradient
        );
        const vector exact
        (
           -volumeOf(d)*(atRest + strength*(gradient - atRest))
        );
        EXPECT_LT(mag(forces->force()[0] - exact), 1e-12*mag(exact));
        EXPECT_EQ(max(mag(forces->pressureByDrag())), 0);
    }
}


TEST(excessPressure, isPassedOnAsDragWhereItMovesTheGrain)
{
    // So small that it takes on most of the water's velocity in an interval
    constexpr scalar d = 1e-4;
    const vector gradient(30000, -20000, -9000);
    const vector atRest(rhoWater*g);
    const scalar V = volumeOf(d);

    for (const scalar strength : {0.0, 0.3, 1.0})
    {
        // Share of its weight that contacts bear
        for (const scalar borne : {0.0, 0.5, 1.0})
        {
            loneGrain grain(d);
            const scalar m = grain.phase.grains.mass[0];
            const vector v(grain.phase.grains.U[0]);
            grain.phase.total = vectorField(1, (1 - borne)*m*g);

            const fluidFields fluid(water(grain.box.mesh().nCells()));
            const vector u(fluid.U[0]);
            const auto forces = grain.forces
            (
                "drag { model SchillerNaumann; } excessPressure { strength "
              + Foam::name(strength) + "; }",
                fluid,
                gradient
            );

            // m (v1 - v)/interval = K (u - v1) + weight that is not borne
            //     - V gradient
            const scalar K =
                3*constant::mathematical::pi*muWater*d
               *(1 + 0.15*Foam::pow(rhoWater*mag(u - v)*d/muWater, 0.687));
            ASSERT_GT(K*interval/m, 1.8);

            const vector pressed
            (
               -V*(atRest + strength*(gradient - atRest))
            );
            const vector v1
            (
                (m*v + interval*(K*u + (1 - borne)*m*g + pressed))
               /(m + K*interval)
            );
            const vector exact(K*(u - v1) + pressed);

            EXPECT_LT(mag(forces->force()[0] - exact), 1e-9*mag(exact))
                << "strength " << strength << ", borne " << borne;
            EXPECT_EQ(max(mag(forces->pressureByDrag())) > 0, strength > 0);
        }
    }
}


TEST(loneGrain, isLiftedBySpinAsRubinowAndKeller)
{
    constexpr scalar d = 1e-4;
    loneGrain grain(d);
    const vector slip(0.003, -0.002, 0.001);
    const vector vorticity(1, -2, 5);
    const vector omega(0.5, 3, -1);
    grain.phase.grains.omega = omega;

    fluidFields fluid(water(grain.box.mesh().nCells()));
    fluid.U = grain.phase.grains.U[0] + slip;
    fluid.vorticity = vorticity;
    ASSERT_LT(rhoWater*mag(slip)*d/muWater, 1);

    const auto forces = grain.forces
    (
        "drag { model none; } rotationalDrag { model none; }"
        " lift { model LunLiu; }",
        fluid
    );

    // pi rho a^3 omega x V of a sphere that goes at V and spins at omega in
    // fluid at rest: seen from fluid that goes along and turns with the water
    const vector exact
    (
        constant::mathematical::pi*rhoWater*pow3(d/2)
       *((omega - 0.5*vorticity) ^ -slip)
    );
    testNumber
    (
        "relative error", mag(forces->force()[0] - exact)/mag(exact)
    );
    EXPECT_LT(mag(forces->force()[0] - exact), 1e-10*mag(exact));
    EXPECT_EQ(forces->torque()[0], vector(Zero));
}


TEST(loneGrain, thatLagsInAShearIsLiftedTowardsTheFasterWater)
{
    constexpr scalar d = 1e-4;
    constexpr scalar shear = 5;

    for (const scalar lag : {1e-5, -1e-5})
    {
        // Water that goes at shear*z along x
        loneGrain grain(d);
        fluidFields fluid(water(grain.box.mesh().nCells()));
        fluid.U = grain.phase.grains.U[0] + vector(lag, 0, 0);
        fluid.vorticity = vector(0, shear, 0);

        const auto forces = grain.forces
        (
            "drag { model none; } rotationalDrag { model none; }"
            " lift { model SaffmanMei; }",
            fluid
        );

        // Saffman: 6.46 mu a^2 sqrt(shear/nu) lag
        const vector exact
        (
            0,
            0,
            6.46*muWater*sqr(d/2)*Foam::sqrt(shear*rhoWater/muWater)*lag
        );
        EXPECT_LT(mag(forces->force()[0] - exact), 1e-3*mag(exact));
        EXPECT_EQ(forces->torque()[0], vector(Zero));
    }
}


TEST(loneGrain, isTurnedUntilItSpinsWithTheWater)
{
    constexpr scalar d = 1e-4;
    const vector vorticity(1, -2, 5);
    const vector omega(0.5, 3, -1);
    const scalar c = constant::mathematical::pi*muWater*pow3(d);

    for (const bool held : {false, true})
    {
        loneGrain grain(d);
        grain.phase.grains.omega = omega;
        if (held)
        {
            grain.phase.held.insert(0);
        }

        fluidFields fluid(water(grain.box.mesh().nCells()));
        fluid.vorticity = vorticity;
        const string laws
        (
            "drag { model none; } rotationalDrag { model Dennis; }"
        );
        const auto forces = grain.forces(laws, fluid);

        // I (omega1 - omega)/interval = c (vorticity/2 - omega1)
        const scalar I = grain.phase.grains.mass[0]*sqr(d)/10;
        ASSERT_GT(c*interval/I, 1);
        const vector omega1
        (
            held
          ? omega
          : (I*omega + interval*c*vorticity/2)/(I + c*interval)
        );
        const vector exact(c*(vorticity/2 - omega1));

        testNumber
        (
            "relative error", mag(forces->torque()[0] - exact)/mag(exact)
        );
        EXPECT_LT(mag(forces->torque()[0] - exact), 1e-12*mag(exact));
        EXPECT_EQ(forces->force()[0], vector(Zero));

        // A vortex of twice the spin takes it along
        fluid.vorticity = 2*omega;
        EXPECT_LT(mag(grain.forces(laws, fluid)->torque()[0]), 1e-15*c);
    }
}
