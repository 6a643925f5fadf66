// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: material points in the place of grains.

#include "OFstream.H"
#include "OSspecific.H"
#include "grainSnapshot.H"
#include "otherMeshes.H"
#include "testNumber.H"
#include "testPointsPhase.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(materialPointsPhase, pointsHaveTheMassOfTheBodyAndTheRadiusOfItsSolid)
{
    testMesh box(slice());
    auto phase = points(box.mesh());

    ASSERT_EQ(phase->size(), 400);
    EXPECT_NEAR(sum(scalarField(phase->mass())), 1500*0.2*0.2*0.1, 1e-10);
    EXPECT_NEAR
    (
        4.0/3*M_PI*pow3(phase->radius()[7])*2650, phase->mass()[7], 1e-12
    );
    EXPECT_FALSE(phase->hasContactRadius());
    EXPECT_FALSE(phase->restarted());
}


TEST(materialPointsPhase, aGrainDiameterIsTheCoarseGraining)
{
    testMesh box(slice());
    const auto withGrains =
        [&](const string& first, const string& second, const string& top)
    {
        return points
        (
            box.mesh(),
            "box ((0 0 0) (0.2 1 0.2)); } " + first + " } clay { " + sand
          + second + " region { box ((0.4 0 0) (0.5 1 0.2));",
            "", top
        );
    };

    auto phase = withGrains("grainDiameter 0.001;", "", "");
    EXPECT_NEAR(phase->coarseGraining(), 2*phase->radius()[0]/0.001, 1e-9);
    EXPECT_EQ(points(box.mesh())->coarseGraining(), 1);

    const std::string none
    (
        refusal([&]() { withGrains("grainDiameter 0;", "", ""); })
    );
    EXPECT_NE(none.find("grainDiameter is 0 m"), std::string::npos) << none;

    const std::string two
    (
        refusal
        (
            [&]()
            {
                withGrains("grainDiameter 0.001;", "grainDiameter 0.002;", "");
            }
        )
    );
    EXPECT_NE(two.find("all bodies have one ratio"), std::string::npos) << two;

    const std::string both
    (
        refusal
        (
            [&]()
            {
                withGrains("grainDiameter 0.001;", "", "coarseGraining 2;");
            }
        )
    );
    EXPECT_NE(both.find("Remove coarseGraining"), std::string::npos) << both;

    // Without a fluid there is no drag that would need one ratio
    EXPECT_EQ
    (
        withGrains
        (
            "grainDiameter 0.001;", "grainDiameter 0.002;", "fluid none;"
        )->coarseGraining(),
        1
    );
}


TEST(materialPointsPhase, poresMayBeTighterThanTheirGrainsMakeThem)
{
    testMesh box(slice());
    const auto ratio = [&](const string& diameters)
    {
        return points
        (
            box.mesh(),
            "box ((0 0 0) (0.2 1 0.2)); } " + diameters
          + " settling { time 0;"
        )->coarseGraining();
    };

    EXPECT_EQ
    (
        ratio("grainDiameter 0.002; poreDiameter 0.001;"),
        ratio("grainDiameter 0.001;")
    );
    EXPECT_EQ(ratio("poreDiameter 0.001;"), ratio("grainDiameter 0.001;"));

    const std::string none(refusal([&]() { ratio("poreDiameter 0;"); }));
    EXPECT_NE(none.find("poreDiameter is 0 m"), std::string::npos) << none;
}


TEST(materialPointsPhase, theBaseBearsTheWeightAndTheSnapshotHoldsIt)
{
    testMesh box(slice());
    auto phase = points(box.mesh(), "box ((0 0 0) (1 1 0.2));");

    // Stress waves pass; their mean is the weight
    scalar mean = 0;
    const label n = 200;
    for (label i = 0; i < n; ++i)
    {
        phase->advance();
        const auto now = phase->snapshot();
        mean += sum(now->wallForce["zMin"]).z()/n;
    }
    const scalar weight = 1500*0.8*0.2*0.1*9.81;
    testNumber("mean force of the base over the weight", mean/weight);
    EXPECT_NEAR(mean, weight, 0.02*weight);

    // Pressure, half of that of the base in the mean over the bed
    const auto now = phase->snapshot();
    EXPECT_NEAR
    (
        -sum(now->stressMoment).zz(), weight*0.1, 0.3*weight*0.1
    );
    EXPECT_EQ(now->type[0], 1);
}


TEST(materialPointsPhase, theForceOfTheFluidMovesPoints)
{
    testMesh box(slice());
    auto phase = points(box.mesh(), "box ((0.3 0 0.1) (0.4 1 0.2));");

    // Twice the weight, upwards
    vectorField force(phase->size());
    forAll(force, i)
    {
        force[i] = -2*phase->mass()[i]*down;
    }
    phase->setFluidForce(force, vectorField(phase->size(), Zero));
    phase->advance();

    const scalar t = phase->exchangeInterval();
    EXPECT_NEAR(phase->velocity()[5].z(), 9.81*t, 1e-9);
    EXPECT_NEAR
    (
        phase->totalForce()[5].z(), 9.81*phase->mass()[5], 1e-9
    );
}


TEST(materialPointsPhase, wallsHaveAFrictionForABody)
{
    // Two blocks fly along a floor that is rough to the first alone
    testMesh box(slice());
    const string moving(sand + " U (0.5 0 0); ");
    auto phase = granularPhase::New
    (
        box.mesh(),
        dictionary
        (
            IStringStream
            (
                "granularPhase materialPoints; materialPoints { cellSize 0.02;"
                " contact {} walls { friction 0.9; } bodies { rough { " + moving
              + " region { box ((0.1 0 0) (0.2 1 0.04)); } } smooth { " + moving
              + " walls { frictions { zMin 0; } }"
                " region { box ((0.4 0 0) (0.5 1 0.04)); } } } }"
            )()
        ),
        down,
        10
    );
    for (label i = 0; i < 40; ++i)
    {
        phase->advance();
    }

    vector momentum[2] = {Zero, Zero};
    const auto now = phase->snapshot();
    forAll(now->type, i)
    {
        momentum[now->type[i] - 1] += now->mass[i]*now->U[i];
    }
    const scalar mass = 1500*0.1*0.04*0.1;
    EXPECT_LT(momentum[0].x(), 0.1*0.5*mass);
    EXPECT_NEAR(momentum[1].x(), 0.5*mass, 1e-10);
}


TEST(materialPointsPhase, aBodyIsDampedWhileItSettles)
{
    testMesh box(slice());
    auto phase = points
    (
        box.mesh(),
        "box ((0.3 0 0.2) (0.4 1 0.3)); } settling { time 0.05; damping 100;"
    );

    // Free fall against a damping of 100/s, up to g/100; then without
    const scalar t = phase->exchangeInterval();
    Time& time = box.time();
    scalar fastest = 0;
    label i = 0;
    for (; time.value() < 0.05; ++i)
    {
        time.setTime((i + 1)*t, i + 1);
        phase->advance();
        fastest = max(fastest, mag(phase->velocity()[5].z()));
    }
    EXPECT_LT(fastest, 9.81/100);
    EXPECT_GT(fastest, 0.9*9.81/100);

    const scalar before = phase->velocity()[5].z();
    phase->advance();
    EXPECT_NEAR(phase->velocity()[5].z(), before - 9.81*t, 1e-9);
}


TEST(materialPointsPhase, theGateOfTheCaseHoldsPointsUntilItIsDrawn)
{
    testMesh box(slice());
    const Time& time = box.time();
    mkDir(time.path()/time.constant());
    {
        OFstream os(time.path()/time.constant()/"slidingGate");
        os  << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object slidingGate; }" << nl
            << "point (0.4 0 0); normal (1 0 0); speed 4; start 0.05;" << nl;
    }
    auto phase = points(box.mesh(), "box ((0 0 0) (0.4 1 0.2));");
    EXPECT_TRUE(phase->activePhysics().found("gate"));

    const auto furthest = [&]()
    {
        scalar x = 0;
        for (const point& p : phase->position())
        {
            x = max(x, p.x());
        }
        return x;
    };

    const scalar interval = phase->exchangeInterval();
    scalar t = 0;
    for (; t < 0.05 - interval; t += interval)
    {
        phase->advance();
    }
    EXPECT_LT(furthest(), 0.4 + 1e-6);

    for (; t < 0.25; t += interval)
    {
        phase->advance();
    }
    EXPECT_GT(furthest(), 0.45);
}


TEST(materialPointsPhase, pointsLeaveThroughAnOutflowAndAreCounted)
{
    testMesh box(slice("patch"));
    auto phase = points
    (
        box.mesh(),
        "box ((0.6 0 0) (0.8 1 0.2));",
        "outflow (xMax);"
    );
    for (label i = 0; i < 150; ++i)
    {
        phase->advance();
    }

    EXPECT_GT(phase->nLeft(), 10);
    EXPECT_EQ(phase->nTotal() + phase->nLeft(), 400);
    for (const point& p : phase->position())
    {
        EXPECT_TRUE(box.mesh().bounds().contains(p));
    }
}


TEST(materialPointsPhase, pointsLeaveThroughAPatchThatLeans)
{
    // From x = 0.8 m at the base to 0.6 m at the top
    testMesh box(slice("patch"));
    movePoints(box.mesh(), [](const point& p)
    {
        return point(p.x()*(1 - 0.625*p.z()), p.y(), p.z());
    });
    auto phase = points
    (
        box.mesh(),
        "box ((0.5 0 0) (0.7 1 0.15));",
        "outflow (xMax);"
    );
    const label n = phase->nTotal();
    for (label i = 0; i < 300; ++i)
    {
        phase->advance();
        for (const point& p : phase->position())
        {
            ASSERT_LT(p.x(), 0.8*(1 - 0.625*p.z()) + 1e-5);
        }
    }

    EXPECT_GT(phase->nLeft(), 10);
    EXPECT_EQ(phase->nTotal() + phase->nLeft(), n);
}


TEST(materialPointsPhase, pointsLeaveThroughAPartOfASide)
{
    // The last face of the top turns down into the side at xMax
    testMesh box(slice("patch"));
    fvMesh& mesh = box.mesh();
    movePoints(mesh, [](const point& p)
    {
        const bool corner = p.x() > 0.79 && p.z() > 0.39;
        const bool next = p.x() > 0.74 && p.x() < 0.79 && p.z() > 0.39;
        return
            corner ? p - vector(0, 0, 0.025)
          : next ? p + vector(0.05, 0, 0)
          : p;
    });
    auto phase = points(mesh, "box ((0.6 0 0) (0.8 1 0.2));", "outflow (xMax);");
    for (label i = 0; i < 150; ++i)
    {
        phase->advance();
    }

    EXPECT_GT(phase->nLeft(), 10);
    EXPECT_EQ(phase->nTotal() + phase->nLeft(), 400);
}


TEST(materialPointsPhase, aSeedShiftsPointsAndAnotherOneOtherwise)
{
    testMesh box(slice());
    const auto placesOf = [&](const string& seed)
    {
        const string region("box ((0 0 0) (0.2 1 0.2));");
        return pointField(points(box.mesh(), region, seed)->position());
    };
    const pointField rows(placesOf(""));
    const pointField first(placesOf("seed 1;"));
    const pointField again(placesOf("seed 1;"));
    const pointField second(placesOf("seed 2;"));

    ASSERT_EQ(first.size(), rows.size());
    EXPECT_TRUE(first == again);

    // In rows of 0.01 m, by a tenth of that along x and z
    const scalarField x(mag(first.component(0) - rows.component(0)));
    EXPECT_GT(max(x), 0.9e-3);
    EXPECT_LT(max(x), 1e-3);
    EXPECT_NEAR(average(x), 0.5e-3, 0.1e-3);
    EXPECT_NEAR(average(first - rows).z(), 0, 1e-4);
    EXPECT_EQ(max(mag(first.component(1) - rows.component(1))), 0);
    EXPECT_GT(average(mag(second - first)), 0.5e-3);

    expectHolds
    (
        refusal([&]() { placesOf("seed -1;"); }), "seed is -1"
    );
}


TEST(materialPointsPhase, pointsStayWithinTheWalls)
{
    testMesh box(slice());
    auto phase = points(box.mesh(), "box ((0.6 0 0.1) (0.8 1 0.3));");
    for (label i = 0; i < 200; ++i)
    {
        phase->advance();
        ASSERT_FALSE(phase->position().empty());
        for (const point& p : phase->position())
        {
            ASSERT_TRUE(box.mesh().bounds().contains(p))
                << p.x() << ' ' << p.z();
        }
    }
}
