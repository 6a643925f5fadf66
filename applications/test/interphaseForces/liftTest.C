// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests of the lift laws.

#include "SubList.H"
#include "forceModels.H"
#include "forceLaws.H"
#include "testMesh.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

//- A grain that flies through still water with a velocity and a spin
grainState flying(const vector& velocity, const vector& spin)
{
    grainState state = inWater();
    state.slip = -velocity;
    state.relativeSpin = -spin;
    return state;
}


//- A grain in the flow (rate*y, 0, 0), and faster than it by lead along x
grainState inShear(const scalar rate, const scalar lead)
{
    grainState state = inWater();
    state.slip = vector(-lead, 0, 0);
    state.vorticity = vector(0, 0, -rate);
    state.relativeSpin = 0.5*state.vorticity;
    return state;
}


void expectVector(const vector& a, const vector& b, const scalar relative)
{
    EXPECT_LE(mag(a - b), relative*mag(b))
        << '(' << a.x() << ' ' << a.y() << ' ' << a.z() << ") is not ("
        << b.x() << ' ' << b.y() << ' ' << b.z() << ')';
}

} // End anonymous namespace


TEST(lift, everyLawIsThereUnderItsName)
{
    for (const std::string name : {"LunLiu", "SaffmanMei"})
    {
        EXPECT_EQ(law<liftModel>("model " + name + ";")->type(), name);
    }
    EXPECT_FALSE(law<liftModel>("model none;").valid());
}


TEST(lift, wrongInputListsWhatIsValid)
{
    expectError<liftModel>("model Lun;", {"Lun", "LunLiu", "SaffmanMei"});
    expectError<liftModel>("", {"model", "missing", "none"});
    expectError<liftModel>("model LunLiu; force 1;", {"force", "strength"});
    expectError<liftModel>("model LunLiu; base none;", {"keyword base"});
    expectError<liftModel>("model none; force 1;", {"Unknown keyword force"});
    expectScaledError<liftModel>("model LunLiu; strength 2;", {"strength"});
    expectScaledError<liftModel>("model Lun; strength 0;", {"Lun", "LunLiu"});
}


TEST(lift, aBackspunBallRises)
{
    // It flies along x; turning left about z, its top (y) moves backwards
    const vector force = law<liftModel>("model LunLiu;")->force
    (
        flying(vector(0.1, 0, 0), vector(0, 0, 50))
    );

    EXPECT_GT(force.y(), 0);
    EXPECT_EQ(force.x(), 0);
    EXPECT_EQ(force.z(), 0);
}


TEST(lift, slowSpinningGrainFollowsRubinowAndKeller)
{
    // pi a^3 rho spin x velocity, a the radius
    const vector velocity(4e-4, 1e-4, -2e-4);
    const vector spin(0.3, -2, 5);

    expectVector
    (
        law<liftModel>("model LunLiu;")->force(flying(velocity, spin)),
        M_PI*pow3(0.5e-3)*1000*(spin ^ velocity),
        1e-14
    );
}


TEST(lift, LunLiuWeakensWithReynoldsAndKeepsItsLastValue)
{
    const auto lift = law<liftModel>("model LunLiu;");
    const auto factor = [&](const scalar Re)
    {
        grainState state = atReynolds(inWater(), Re);
        state.relativeSpin = vector(0, 0, 10);
        return
            mag(lift->force(state))
           /(M_PI/8*state.rho*pow3(state.d)*10*mag(state.slip));
    };

    EXPECT_NEAR(factor(1 - 1e-9), 1, 1e-8);
    EXPECT_NEAR(factor(1 + 1e-9), 1, 1e-8);
    EXPECT_NEAR(factor(100), 0.178 + 0.822*std::pow(100.0, -0.522), 1e-12);
    EXPECT_NEAR(factor(1000), 0.2003, 1e-4);
    EXPECT_NEAR(factor(1e6), factor(1000), 1e-12);
}


TEST(lift, aGrainThatLagsIsPushedToTheFasterSide)
{
    const auto lift = law<liftModel>("model SaffmanMei;");

    const vector lagging = lift->force(inShear(10, -0.01));
    const vector leading = lift->force(inShear(10, 0.01));

    EXPECT_GT(lagging.y(), 0);
    EXPECT_EQ(lagging.x(), 0);
    expectVector(leading, -lagging, 1e-14);
}


TEST(lift, slowGrainInShearFollowsSaffman)
{
    // 6.46 mu a^2 |slip| sqrt(rho rate/mu), a the radius
    const scalar rate = 1e-4;
    const scalar slip = 1e-8;
    const grainState state = inShear(rate, -slip);

    EXPECT_NEAR
    (
        law<liftModel>("model SaffmanMei;")->force(state).y()
       /(6.46*1e-3*sqr(0.5e-3)*slip*std::sqrt(1e3*rate/1e-3)),
        1, 1e-3
    );
}


TEST(lift, SaffmanMeiFollowsMeiOnBothSidesOfReynolds40)
{
    const auto lift = law<liftModel>("model SaffmanMei;");
    const auto f = [&](const scalar Re, const scalar a)
    {
        grainState state = atReynolds(inWater(), Re);
        const scalar slip = mag(state.slip);
        const scalar w = 2*a*slip/state.d;
        state.vorticity = vector(0, 0, w);
        return
            mag(lift->force(state))
           /(1.615*sqr(state.d)*std::sqrt(state.rho*state.mu*w)*slip);
    };

    EXPECT_NEAR(f(10, 0.1), 0.3314*std::sqrt(0.1)*(1 - std::exp(-1.0))
        + std::exp(-1.0), 1e-12);
    EXPECT_NEAR(f(90, 0.1), 0.0524*std::sqrt(0.1*90), 1e-12);

    for (const scalar a : {0.005, 0.1, 0.4})
    {
        EXPECT_NEAR(f(40 - 1e-9, a), f(40 + 1e-9, a), 0.018) << a;
    }
}


TEST(lift, isNothingWithoutSlipOrRotation)
{
    for (const std::string name : {"LunLiu", "SaffmanMei"})
    {
        const auto lift = law<liftModel>("model " + name + ";");

        EXPECT_EQ(mag(lift->force(inWater())), 0) << name;
        EXPECT_EQ(mag(lift->force(atReynolds(inWater(), 50))), 0) << name;
        EXPECT_EQ(mag(lift->force(inShear(10, 0))), 0) << name;
    }
}


TEST(lift, vanishesContinuouslyWithTheSlip)
{
    for (const std::string name : {"LunLiu", "SaffmanMei"})
    {
        const auto lift = law<liftModel>("model " + name + ";");

        EXPECT_LT
        (
            mag(lift->force(inShear(10, 1e-25))), 1e-20
        ) << name;
    }
}


TEST(lift, strengthZeroIsNothingAndBetweenIsInProportion)
{
    const grainState state = inShear(10, 0.02);
    testMesh box;

    for (const std::string name : {"LunLiu", "SaffmanMei"})
    {
        const std::string model = "lift { model " + name + "; ";
        const auto lift = [&](const std::string& strength)
        {
            vectorField forces(1, vector(1, 2, 3));
            forceModels(box.mesh(), entries(model + strength + "}"))
                .liftForces(List<grainState>(1, state), forces);
            return forces[0];
        };
        const vector full = lift("");
        const vector none = lift("strength 0;");

        EXPECT_EQ(full, law<liftModel>("model " + name + ";")->force(state));
        for (direction i = 0; i < 3; ++i)
        {
            EXPECT_EQ(none[i], 0);
            EXPECT_FALSE(std::signbit(none[i]));
        }
        EXPECT_GT(mag(full), 0);
        expectVector(lift("strength 0.3;"), 0.3*full, 1e-15);
    }
}


TEST(lift, ofAGrainIsTheSameWhereverItStandsInAList)
{
    List<grainState> states(77);
    forAll(states, i)
    {
        states[i] =
            flying(vector(1e-3*std::pow(1.1, i), 0, 0), vector(0, 0, 5));
    }

    for (const char* text : {"model LunLiu;", "model SaffmanMei;"})
    {
        const auto lift = law<liftModel>(text);

        for (label shift = 0; shift < 9; ++shift)
        {
            const label n = states.size() - shift;
            List<vector> forces(n);
            lift->force(SubList<grainState>(states, n, shift), forces);

            for (label i = 0; i < n; ++i)
            {
                ASSERT_EQ(forces[i], lift->force(states[shift + i]))
                    << text << " shifted by " << shift << ", grain " << i;
            }
        }
    }
}
