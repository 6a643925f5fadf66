// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: what the drag laws give where the answer is known.

#include "SubList.H"
#include "forceModels.H"
#include "forceLaws.H"
#include "testMesh.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

constexpr scalar pi = M_PI;

const char* const laws[]
{
    "model DiFelice;",
    "model DiFelice; formulation asPrinted;",
    "model Gidaspow;",
    "model Gidaspow; transition smooth;",
    "model KochHill;",
    "model Beetstra;",
    "model SchillerNaumann;"
};


//- Pressure drop per length [Pa/m] that a law implies for the superficial
//  velocity U [m/s] through a resting packing
scalar pressureDrop
(
    const dragModel& drag,
    grainState state,
    const scalar U
)
{
    const scalar e = state.voidFraction;
    state.slip = vector(U/e, 0, 0);
    return (1 - e)/volume(state)*drag.K(state)*mag(state.slip)/e;
}


//- Ergun (1952), with the superficial velocity, as textbooks print it [Pa/m]
scalar ErgunDrop(const grainState& state, const scalar U)
{
    const scalar e = state.voidFraction;

    return
        150*state.mu*sqr(1 - e)*U/(pow3(e)*sqr(state.d))
      + 1.75*state.rho*(1 - e)*sqr(U)/(pow3(e)*state.d);
}


//- The grains of the Ergun column: 1 mm, fluid of 10 kg/m3 and 1.5e-4 m2/s
grainState ErgunColumn()
{
    grainState state = inWater();
    state.rho = 10;
    state.mu = 1.5e-3;
    state.voidFraction = 0.4513;
    return state;
}

} // End anonymous namespace


TEST(drag, isStokesForASingleGrainAtRest)
{
    for (const char* text : laws)
    {
        // The smooth transition keeps 0.6 % of Ergun, which is 0 here
        const scalar expected =
            std::string(text).find("smooth") == std::string::npos
          ? 1
          : 0.5 + std::atan(52.5)/pi;

        for (const scalar Re : {0.0, 1e-12})
        {
            const grainState state = atReynolds(inWater(), Re);
            const scalar ratio =
                law<dragModel>(text)->K(state)/(3*pi*state.mu*state.d);

            EXPECT_NEAR(ratio, expected, 1e-8) << text << " Re " << Re;
        }
    }
}


TEST(drag, isNewtonForASingleGrainAtLargeReynolds)
{
    for (const std::string name : {"DiFelice", "Gidaspow", "SchillerNaumann"})
    {
        const grainState state = atReynolds(inWater(), 1e5);
        const scalar slip = mag(state.slip);
        const scalar Newton = 0.5*0.44*state.rho*pi/4*sqr(state.d)*slip;

        EXPECT_NEAR
        (
            law<dragModel>("model " + name + ";")->K(state)/Newton, 1, 1e-12
        ) << name;
    }
}


TEST(drag, sandGrainOfOneMillimetreSettlesAt155MillimetresPerSecond)
{
    const grainState state = inWater();
    const scalar weight = 1650*9.81*volume(state);

    for (const std::string name : {"DiFelice", "Gidaspow", "SchillerNaumann"})
    {
        EXPECT_NEAR
        (
            settlingVelocity
            (
                law<dragModel>("model " + name + ";")(), state, weight
            ),
            0.155, 0.0005
        ) << name;
    }
}


TEST(drag, isFiniteAndContinuousAtRest)
{
    for (const char* text : laws)
    {
        const auto drag = law<dragModel>(text);

        for (const scalar e : {0.05, 0.3, 0.6, 0.8, 0.95, 1.0, 1 + 1e-12})
        {
            for (const scalar mu : {1e-3, 1.8e-5})
            {
                grainState state = inWater();
                state.voidFraction = e;
                state.mu = mu;
                state.rho = mu < 1e-4 ? 1.2 : 1000;

                const scalar atRest = drag->K(state);

                EXPECT_TRUE(std::isfinite(atRest) && atRest > 0) << text;
                EXPECT_NEAR
                (
                    drag->K(atReynolds(state, 1e-9))/atRest, 1, 1e-6
                ) << text << " e " << e;
                EXPECT_NEAR
                (
                    drag->K(atReynolds(state, 1e-200))/atRest, 1, 1e-12
                ) << text << " e " << e;
            }
        }
    }
}


TEST(drag, isContinuousTowardsTheSingleGrain)
{
    for (const char* text : laws)
    {
        const auto drag = law<dragModel>(text);
        grainState state = atReynolds(inWater(), 20);
        const scalar single = drag->K(state);

        // Koch & Hill and Beetstra rise with the root of the solid fraction
        state.voidFraction = 1 - 1e-12;
        EXPECT_NEAR(drag->K(state)/single, 1, 1e-5) << text;
    }
}


TEST(drag, growsWithSlipAndWithSolidFraction)
{
    for (const char* text : laws)
    {
        const auto drag = law<dragModel>(text);

        for (const scalar e : {0.4, 0.5, 0.7, 0.9})
        {
            grainState state = inWater();
            state.voidFraction = e;
            const scalar slow = drag->K(atReynolds(state, 10));
            const scalar fast = drag->K(atReynolds(state, 1e4));
            state.voidFraction = e - 0.05;

            EXPECT_GT(fast, slow) << text << " e " << e;
            EXPECT_GE(drag->K(atReynolds(state, 10)), slow)
                << text << " e " << e;
        }
    }
}


TEST(drag, stepsWherePublishedStepsAreAndNoLarger)
{
    const auto ratio = []
    (
        const char* text, const scalar e0, const scalar e1, const scalar Re0,
        const scalar Re1
    )
    {
        const auto drag = law<dragModel>(text);
        grainState before = atReynolds(inWater(), Re0);
        grainState after = atReynolds(inWater(), Re1);
        before.voidFraction = e0;
        after.voidFraction = e1;
        return drag->K(after)/drag->K(before);
    };
    const scalar tiny = 1e-12;

    // Schiller & Naumann's curve ends at 0.4383, Newton's value is 0.44
    EXPECT_NEAR
    (
        ratio("model SchillerNaumann;", 1, 1, 1000 - tiny, 1000 + tiny),
        1.0039, 1e-4
    );
    // Hill, Koch & Ladd's two branches at a solid fraction of 0.4
    EXPECT_NEAR
    (
        ratio("model KochHill;", 0.6 + tiny, 0.6 - tiny, 0, 0), 1.0105, 1e-4
    );
    // Wen & Yu over Ergun at 0.8: at rest, and at large Re
    EXPECT_NEAR
    (
        ratio("model Gidaspow;", 0.8 - tiny, 0.8 + tiny, 0, 0),
        std::pow(0.8, -2.65)/(150*0.25/18), 1e-6
    );
    EXPECT_NEAR
    (
        ratio("model Gidaspow;", 0.8 - tiny, 0.8 + tiny, 1e8, 1e8),
        0.75*0.44*std::pow(0.8, -1.65)/1.75, 1e-6
    );
    // The smooth transition has none
    EXPECT_NEAR
    (
        ratio
        (
            "model Gidaspow; transition smooth;", 0.8 - tiny, 0.8 + tiny, 50, 50
        ),
        1, 1e-9
    );
}


TEST(drag, GidaspowIsErgunInAPacking)
{
    const auto drag = law<dragModel>("model Gidaspow;");
    const grainState column = ErgunColumn();

    for (const scalar U : {1e-4, 1e-2, 1.0})
    {
        EXPECT_NEAR
        (
            pressureDrop(drag(), column, U)/ErgunDrop(column, U), 1, 1e-12
        ) << U;
    }
}


TEST(drag, ErgunHasTheCoefficientsThatItIsGiven)
{
    const grainState column = ErgunColumn();
    const auto plain = law<dragModel>("model Ergun;");
    const auto Darcy = law<dragModel>("model Ergun; inertial 0;");
    const auto inertia = law<dragModel>("model Ergun; viscous 0; inertial 3.5;");

    for (const scalar U : {1e-4, 1e-2, 1.0})
    {
        const scalar whole = ErgunDrop(column, U);
        const scalar linear = 1e9*ErgunDrop(column, 1e-9*U);

        EXPECT_NEAR(pressureDrop(plain(), column, U)/whole, 1, 1e-12) << U;
        EXPECT_NEAR(pressureDrop(Darcy(), column, U)/linear, 1, 1e-6) << U;
        EXPECT_NEAR
        (
            pressureDrop(inertia(), column, U)/(2*(whole - linear)), 1, 1e-6
        ) << U;
    }
}


TEST(drag, ErgunIsNothingWithoutAPacking)
{
    const auto Darcy = law<dragModel>("model Ergun; inertial 0;");

    for (const scalar e : {1.0, 1 + 1e-12})
    {
        grainState state = atReynolds(inWater(), 100);
        state.voidFraction = e;
        EXPECT_EQ(Darcy->K(state), 0) << e;
    }
}


TEST(drag, GidaspowFluidisesTheErgunColumnWhereErgunDoes)
{
    // Published with the column: it floats at 0.01454 m/s, carried by 167 Pa
    // over a height of 15.6 mm
    const auto drag = law<dragModel>("model Gidaspow;");
    const grainState column = ErgunColumn();
    const scalar weight = (2000 - column.rho)*9.81*volume(column);

    EXPECT_NEAR
    (
        settlingVelocity(drag(), column, weight)/0.01454, 1, 0.005
    );
    EXPECT_NEAR
    (
        pressureDrop(drag(), column, 0.01454)*0.0156/167, 1, 0.005
    );
}


TEST(drag, DiFeliceModelAHindersSettlingAsRichardsonAndZakiSaw)
{
    const auto drag = law<dragModel>("model DiFelice;");

    for (const scalar e : {0.6, 0.8, 0.95})
    {
        EXPECT_NEAR(hinderedExponent(drag(), e, 1e-4), 4.7, 0.005) << e;
        EXPECT_NEAR(hinderedExponent(drag(), e, 1e8), 2.35, 0.005) << e;
    }
}


TEST(drag, DiFeliceHasItsLeastExponentAtReynolds32)
{
    // chi = 3.7 - 0.65 at log10 Re = 1.5, the Re of the superficial slip
    const auto drag = law<dragModel>("model DiFelice;");
    const scalar Re = std::pow(10.0, 1.5);
    const scalar single = drag->K(atReynolds(inWater(), Re));

    for (const scalar e : {0.4, 0.7})
    {
        grainState state = atReynolds(inWater(), Re/e);
        state.voidFraction = e;

        EXPECT_NEAR(drag->K(state)/single, std::pow(e, 1 - 3.05), 1e-12) << e;
    }
}


TEST(drag, DiFeliceAsPrintedHindersTooMuchAtLargeReynolds)
{
    const auto drag = law<dragModel>
    (
        "model DiFelice; formulation asPrinted;"
    );

    for (const scalar e : {0.6, 0.8, 0.95})
    {
        EXPECT_NEAR(hinderedExponent(drag(), e, 1e-4), 4.7, 0.005) << e;
        EXPECT_NEAR(hinderedExponent(drag(), e, 1e8), 2.85, 0.005) << e;
    }
}


TEST(drag, asPrintedIsStrongerThanModelAByOneOverVoidFraction)
{
    const auto modelA = law<dragModel>("model DiFelice;");
    const auto asPrinted = law<dragModel>
    (
        "model DiFelice; formulation asPrinted;"
    );
    grainState state = inWater();
    state.voidFraction = 0.5;

    const auto ratio = [&](const scalar Re)
    {
        const grainState s = atReynolds(state, Re);
        return asPrinted->K(s)/modelA->K(s);
    };

    EXPECT_NEAR(ratio(1e-6), 1, 1e-3);
    EXPECT_NEAR(ratio(1e9), 2, 1e-3);
}


TEST(drag, WenAndYuHinderSettlingByTheirOwnExponents)
{
    const auto drag = law<dragModel>("model Gidaspow;");

    for (const scalar e : {0.85, 0.95})
    {
        EXPECT_NEAR(hinderedExponent(drag(), e, 1e-5), 4.65, 0.002) << e;
        EXPECT_NEAR(hinderedExponent(drag(), e, 1e7), 2.325, 0.002) << e;
    }
}


TEST(drag, SchillerNaumannDoesNotSeeTheNeighbours)
{
    const auto drag = law<dragModel>("model SchillerNaumann;");
    grainState state = atReynolds(inWater(), 40);
    const scalar alone = drag->K(state);
    state.voidFraction = 0.4;

    EXPECT_EQ(drag->K(state), alone);
}


TEST(drag, noneIsNothing)
{
    testMesh box;
    scalarField K(3, 1);
    forceModels(box.mesh(), entries("drag { model none; }"))
        .dragCoefficients(List<grainState>(3, atReynolds(inWater(), 9)), K);

    EXPECT_EQ(K, scalarField(3, Zero));
}


TEST(drag, ofAGrainIsTheSameWhereverItStandsInAListAndInMemory)
{
    List<grainState> states(77, inWater());
    forAll(states, i)
    {
        states[i] = atReynolds(inWater(), std::pow(10.0, -2 + 0.08*i));
        states[i].voidFraction = 0.3 + 0.009*i;
    }

    for (const char* text : laws)
    {
        const auto drag = law<dragModel>(text);

        for (label shift = 0; shift < 9; ++shift)
        {
            List<scalar> memory(states.size());
            const label n = states.size() - shift;
            SubList<scalar> K(memory, n, shift);
            drag->K(SubList<grainState>(states, n, shift), K);

            for (label i = 0; i < n; ++i)
            {
                ASSERT_EQ(K[i], drag->K(states[shift + i]))
                    << text << " shifted by " << shift << ", grain " << i;
            }
        }
    }
}
