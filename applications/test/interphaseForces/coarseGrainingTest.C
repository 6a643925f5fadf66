// SPDX-License-Identifier: GPL-3.0-or-later
// All forces together on parcels and on the grains that they stand for.

#include "grainsInWater.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- What grains in one cell of water get, in sum
struct whole
{
    vector force;

    vector angularAcceleration;

    scalar solidFraction;

    scalar dragCoefficient;

    scalar virtualMassCoefficient;

    vector explicitForce;

    scalar residual;
};


//- n grains of diameter d at one place, computed with coarse graining N
whole inOneCell
(
    const label n,
    const scalar d,
    const scalar N,
    const string& laws,
    const scalar mu = muWater
)
{
    testMesh box;
    const fvMesh& mesh = box.mesh();
    standingGrains phase(mesh);
    put(phase, pointField(n, point(0.4, 0.4, 0.4)), d);

    grainExchange exchange(mesh);
    exchange.locate(phase);
    solidFractionField solids(exchange, entries(inOneCellEach));
    solids.update();

    interphaseForces forces(exchange, solids, entries(laws), g, N);
    const fluidFields fluid(water(mesh.nCells(), mu));
    forces.prepare(fluid, interval);
    forces.finish
    (
        inEquation
        (
            fluidMeans
            {
                fluid.U,
                vectorField(mesh.nCells(), vector(0, 2, 1)),
                vectorField(mesh.nCells(), vector(100, 0, -9810)),
                fluid.viscousForce,
                scalarField(),
                Zero
            },
            fluid.rho, forces, solids, mesh, g
        )
    );

    const label cell = exchange.grains()[0].cell;
    const scalar inertia = 0.1*phase.grains.mass[0]*sqr(d);

    return whole
    {
        sum(forces.force()),
        forces.torque()[0]/inertia,
        solids.solidFraction()[cell],
        forces.dragCoefficient()[cell],
        forces.virtualMassCoefficient()[cell],
        forces.explicitForce()[cell],
        forces.residual()
    };
}


void expectAlike(const whole& a, const whole& b, const std::string& what)
{
    const auto near = [&](const auto& x, const auto& y)
    {
        EXPECT_LT(mag(x - y), 1e-12*mag(y)) << what;
        EXPECT_GT(mag(y), 0) << what;
    };

    near(a.force, b.force);
    near(a.angularAcceleration, b.angularAcceleration);
    near(a.solidFraction, b.solidFraction);
    near(a.dragCoefficient, b.dragCoefficient);
    near(a.virtualMassCoefficient, b.virtualMassCoefficient);
    near(a.explicitForce, b.explicitForce);
    EXPECT_LT(a.residual, 1e-12) << what;
    EXPECT_LT(b.residual, 1e-12) << what;
}


string laws(const word& drag)
{
    return
        "drag { model " + drag + "; } lift { model SaffmanMei; }"
        " virtualMass { model Zuber; } viscousForce { strength 1; }"
        " rotationalDrag { model Dennis; }";
}

} // End anonymous namespace


TEST(interphaseForces, aFluidWithoutViscosityStillHasForces)
{
    for (const char* drag : {"DiFelice", "Ergun", "Gidaspow", "KochHill", "Beetstra"})
    {
        const whole none(inOneCell(3, 0.01, 1, laws(drag), 0));
        const whole thin(inOneCell(3, 0.01, 1, laws(drag), 1e-12));
        EXPECT_GT(none.dragCoefficient, 0) << drag;
        EXPECT_LT(mag(none.force), GREAT) << drag;
        EXPECT_LT(mag(none.angularAcceleration), GREAT) << drag;
        EXPECT_NEAR(none.dragCoefficient/thin.dragCoefficient, 1, 0.01) << drag;
        EXPECT_LT(none.residual, 1e-12) << drag;
    }
}


TEST(coarseGraining, aParcelGetsWhatTheGrainsGetThatItStandsFor)
{
    constexpr scalar d = 0.004;

    for (const word drag :
        {"DiFelice", "Gidaspow", "Ergun", "KochHill", "Beetstra",
         "SchillerNaumann"})
    {
        for (const label N : {2, 3})
        {
            expectAlike
            (
                inOneCell(1, N*d, N, laws(drag)),
                inOneCell(N*N*N, d, 1, laws(drag)),
                drag
            );
        }
    }
}


TEST(coarseGraining, withoutItAParcelIsOneLargeGrain)
{
    const whole parcel(inOneCell(1, 0.008, 1, laws("DiFelice")));
    const whole grains(inOneCell(8, 0.004, 1, laws("DiFelice")));

    EXPECT_NEAR(parcel.solidFraction, grains.solidFraction, 1e-15);
    EXPECT_LT(parcel.dragCoefficient, 0.6*grains.dragCoefficient);
}


TEST(coarseGraining, parcelsThatPassEachOtherFeelDragOverNSquared)
{
    constexpr scalar d = 0.004;
    const vector v(0.01, 0, 0);

    for (const label N : {1, 2, 4})
    {
        testMesh box;
        const fvMesh& mesh = box.mesh();
        standingGrains phase(mesh);
        put(phase, pointField(2, point(0.4, 0.4, 0.4)), N*d);
        phase.grains.U[0] = v;
        phase.grains.U[1] = -v;

        grainExchange exchange(mesh);
        exchange.locate(phase);
        solidFractionField solids(exchange, entries(inOneCellEach));
        solids.update();

        interphaseForces forces
        (
            exchange,
            solids,
            entries("drag { model SchillerNaumann; }"),
            vector(Zero),
            N
        );
        const vectorField rest(mesh.nCells(), Zero);
        fluidFields fluid(water(mesh.nCells()));
        fluid.U = rest;
        fluid.convection = rest;
        forces.prepare(fluid, interval);
        forces.finish(fluidMeans{rest, rest, rest, rest, fluid.rho, Zero});

        // Stokes: the mean slip is none. Of the N^3 grains' drag 1/N^2, with
        // the velocity at the end of the interval; one grain has all of its own
        const scalar Re = rhoWater*mag(v)*d/muWater;
        const scalar stokes = 3*constant::mathematical::pi*muWater*d;
        const scalar K =
            N == 1 ? stokes*(1 + 0.15*Foam::pow(Re, 0.687)) : N*stokes;
        const scalar m = phase.grains.mass[0];
        const vector exact(-K*m/(m + K*interval)*v);

        EXPECT_LT(mag(forces.force()[0] - exact), 1e-9*mag(exact)) << N;
        EXPECT_LT(mag(forces.force()[1] + exact), 1e-9*mag(exact)) << N;
        EXPECT_LT(mag(sum(forces.force())), 1e-12*mag(exact)) << N;
    }
}


TEST(obstacle, aHeldGrainGetsAllOfTheDragBesideOneThatMoves)
{
    // So small that it would take on the water's velocity in an interval
    constexpr scalar d = 1e-4;
    testMesh box;
    const fvMesh& mesh = box.mesh();
    standingGrains phase(mesh);
    put(phase, pointField({point(0.2, 0.4, 0.4), point(0.6, 0.4, 0.4)}), d);
    phase.grains.U = vector(Zero);
    phase.grains.omega = vector(Zero);
    phase.held.insert(1);

    grainExchange exchange(mesh);
    exchange.locate(phase);
    solidFractionField solids(exchange, entries(inOneCellEach));
    solids.update();

    interphaseForces forces
    (
        exchange, solids, entries("drag { model SchillerNaumann; }"), vector(Zero), 1
    );
    const vectorField none(mesh.nCells(), Zero);
    fluidFields fluid(water(mesh.nCells()));
    fluid.convection = none;
    forces.prepare(fluid, interval);
    forces.finish(fluidMeans{fluid.U, none, none, none, fluid.rho, Zero});

    const scalar slip = mag(fluid.U[0]);
    const scalar K =
        3*constant::mathematical::pi*muWater*d
       *(1 + 0.15*Foam::pow(rhoWater*slip*d/muWater, 0.687));
    const scalar m = phase.grains.mass[0];
    ASSERT_GT(K*interval/m, 1);

    const scalar moving = mag(exchange.toPhase(forces.force(), 2)[0]);
    const scalar held = mag(exchange.toPhase(forces.force(), 2)[1]);
    EXPECT_NEAR(moving/(m/(m + K*interval)*K*slip), 1, 1e-9);
    EXPECT_NEAR(held/(K*slip), 1, 1e-9);
    EXPECT_LT(forces.residual(), 1e-12);
}
