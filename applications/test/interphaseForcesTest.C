// SPDX-License-Identifier: GPL-3.0-or-later
// All forces together on made-up grains: coarse graining, viscous force.

#include "interphaseForces.H"
#include "standingGrains.H"
#include "testMesh.H"
#include "testNumber.H"

#include "IStringStream.H"
#include "fvc.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar rhoWater = 1000;
constexpr scalar muWater = 1e-3;

//- Time between two exchanges [s]
constexpr scalar interval = 1e-3;

const vector g(0, 0, -9.81);


//- Each grain is as a whole in the cell of its centre
const char* const inOneCellEach = "model centre; smoothing { model none; }";


dictionary entries(const string& text)
{
    return dictionary(IStringStream(text)());
}


scalar volumeOf(const scalar d)
{
    return constant::mathematical::pi/6*pow3(d);
}


//- Grains of diameter d, all of which move and spin alike
void put(standingGrains& phase, const pointField& places, const scalar d)
{
    phase.grains = grainSnapshot(places.size());
    phase.grains.id = identity(places.size());
    phase.grains.position = places;
    phase.grains.mass = 2650*volumeOf(d);
    phase.grains.U = vector(0.05, 0.1, 0);
    phase.grains.omega = vector(0, 3, 0);
    phase.radii = scalarField(places.size(), 0.5*d);
}


//- Water that streams and turns
fluidFields water(const label n, const scalar mu = muWater)
{
    return fluidFields
    {
        scalarField(n, rhoWater),
        scalarField(n, mu),
        scalarField(n, 0.7),
        vectorField(n, vector(0.4, 0, 0)),
        vectorField(n, vector(0, 0, 5)),
        vectorField(n, vector(0.2, 0.1, 0)),
        vectorField(n, vector(30, 0, -7))
    };
}


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
    porosity pores(exchange, entries(inOneCellEach));
    pores.update();

    interphaseForces forces(exchange, pores, entries(laws), g, N);
    const fluidFields fluid(water(mesh.nCells(), mu));
    forces.prepare(fluid, interval);
    forces.finish
    (
        fluidMeans
        {
            fluid.U,
            vectorField(mesh.nCells(), vector(0, 2, 1)),
            vectorField(mesh.nCells(), vector(100, 0, -9810)),
            fluid.viscousForce
        }
    );

    const label cell = exchange.grains()[0].cell;
    const scalar inertia = 0.1*phase.grains.mass[0]*sqr(d);

    return whole
    {
        sum(forces.force()),
        forces.torque()[0]/inertia,
        pores.solidFraction()[cell],
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


//- Force of the viscous stress on grains where U = a (z^2, 0, 0), nothing else
//  acting; strength is that in the dictionary
vectorField viscousForces
(
    testMesh& box,
    const pointField& places,
    const scalar d,
    const scalar a,
    const word& strength
)
{
    const fvMesh& mesh = box.mesh();
    volVectorField U
    (
        IOobject("U", "0", mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        "fixedValue"
    );
    U.primitiveFieldRef() = a*sqr(mesh.C().component(vector::Z)().primitiveField())
       *vector(1, 0, 0);
    for (fvPatchVectorField& patch : U.boundaryFieldRef())
    {
        patch == a*sqr(patch.patch().Cf().component(vector::Z))*vector(1, 0, 0);
    }

    const dimensionedScalar mu("mu", dimDynamicViscosity, muWater);
    const volVectorField stress
    (
        fvc::laplacian(mu, U)
      + fvc::div
        (
            mesh.Sf()
          & fvc::interpolate(mu*dev2(T(fvc::grad(U))))
        )
    );

    standingGrains phase(mesh);
    put(phase, places, d);
    grainExchange exchange(mesh);
    exchange.locate(phase);
    porosity pores
    (
        exchange, entries("model caps; smoothing { model none; }")
    );
    pores.update();

    interphaseForces forces
    (
        exchange,
        pores,
        entries
        (
            "drag { model none; } pressureGradient { strength 0; }"
            " rotationalDrag { model none; }"
            " viscousForce { strength " + strength + "; }"
        ),
        Zero,
        1
    );

    fluidFields fluid(water(mesh.nCells()));
    fluid.viscousForce = stress.primitiveField();
    forces.prepare(fluid, interval);

    const vectorField none(mesh.nCells(), Zero);
    forces.finish(fluidMeans{none, none, none, fluid.viscousForce});

    return forces.force();
}


//- One grain alone in a box of water
struct loneGrain
{
    testMesh box;

    standingGrains phase;

    grainExchange exchange;

    porosity pores;

    explicit loneGrain(const scalar d)
    :
        phase(box.mesh()),
        exchange(box.mesh()),
        pores(exchange, entries(inOneCellEach))
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
        pores.update();

        auto result = autoPtr<interphaseForces>::New
        (
            exchange, pores, entries(laws), g, 1
        );
        const vectorField none(n, Zero);
        result->prepare(fluid, interval);
        result->finish
        (
            fluidMeans
            {
                fluid.U, none, vectorField(n, pressureGradient), none
            }
        );
        EXPECT_LT(result->residual(), 1e-12);
        return result;
    }
};

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
        porosity pores(exchange, entries(inOneCellEach));
        pores.update();

        interphaseForces forces
        (
            exchange,
            pores,
            entries("drag { model SchillerNaumann; }"),
            Zero,
            N
        );
        const vectorField rest(mesh.nCells(), Zero);
        fluidFields fluid(water(mesh.nCells()));
        fluid.U = rest;
        fluid.convection = rest;
        forces.prepare(fluid, interval);
        forces.finish(fluidMeans{rest, rest, rest, rest});

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
    porosity pores(exchange, entries(inOneCellEach));
    pores.update();

    interphaseForces forces
    (
        exchange, pores, entries("drag { model SchillerNaumann; }"), Zero, 1
    );
    const vectorField none(mesh.nCells(), Zero);
    fluidFields fluid(water(mesh.nCells()));
    fluid.convection = none;
    forces.prepare(fluid, interval);
    forces.finish(fluidMeans{fluid.U, none, none, none});

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


TEST(viscousForce, isVolumeTimesTheDivergenceOfTheStress)
{
    constexpr scalar d = 0.05;
    constexpr scalar a = 30;
    testBox cells;
    cells.cells = labelVector(4, 4, 8);
    testMesh box(cells);

    // In one cell, over the face of two, over the corner of eight
    const pointField places({{0.4, 0.4, 0.4}, {0.5, 0.4, 0.6}, {0.5, 0.5, 0.5}});

    // mu d2u/dz2 = 2 mu a
    const vector exact(volumeOf(d)*2*muWater*a, 0, 0);

    for (const vector& force : viscousForces(box, places, d, a, "1"))
    {
        testNumber("relative error", mag(force - exact)/mag(exact));
        EXPECT_LT(mag(force - exact), 1e-10*mag(exact));
    }
    for (const vector& force : viscousForces(box, places, d, a, "0.25"))
    {
        EXPECT_LT(mag(force - 0.25*exact), 1e-10*mag(exact));
    }
    for (const vector& force : viscousForces(box, places, d, a, "0"))
    {
        EXPECT_EQ(force, vector(Zero));
    }
}


TEST(excessPressure, isFeltByItsStrengthAndBuoyancyInFull)
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
        EXPECT_EQ(max(mag(forces->pressureShare())), 0);
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
            EXPECT_EQ(max(mag(forces->pressureShare())) > 0, strength > 0);
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
