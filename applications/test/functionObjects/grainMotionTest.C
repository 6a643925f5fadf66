// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects that follow grains: tracks, and stress at a surface that moves.

#include "grainStress.H"
#include "grainTrack.H"
#include "movingLayer.H"
#include "terminalOutput.H"
#include "sphereParts.H"
#include "tank.H"

using namespace Foam;


TEST(sphereParts, theShareInADiscIsThatOfCountedPoints)
{
    constexpr label n = 1000;
    scalar most = 0;

    for (const scalar R : {0.3, 1.0, 4.0})
    {
        for (const scalar s : {0.1, 0.8, 1.2, 3.5, 4.5})
        {
            label all = 0;
            label inside = 0;
            for (label i = 0; i < n*n; ++i)
            {
                const scalar x = (2.0*(i % n) + 1)/n - 1;
                const scalar y = (2.0*(i/n) + 1)/n - 1;
                if (sqr(x) + sqr(y) <= 1)
                {
                    ++all;
                    inside += sqr(s + x) + sqr(y) <= sqr(R);
                }
            }
            most = max
            (
                most,
                mag(sphereParts::inDisc(s, 1, R) - scalar(inside)/all)
            );
        }
    }

    EXPECT_LT(most, 1e-3);
}


TEST(movingLayer, theSurfaceIsBetweenWhatRestsAndWhatMoves)
{
    movingLayer layer(0, 1, 0.01);
    for (label i = 0; i < 10; ++i)
    {
        layer.add(0.05 + 0.1*i, 0.05, 1, i >= 4);
    }
    // One that moves in the bed, one that rests on the flow
    layer.add(0.15, 0.05, 0.5, true);
    layer.add(0.85, 0.05, 0.5, false);
    layer.reduce();
    EXPECT_NEAR(layer.surface(), 0.4, 0.011);

    movingLayer atRest(0, 1, 0.01);
    atRest.add(0.3, 0.05, 1, false);
    atRest.reduce();
    EXPECT_NEAR(atRest.surface(), 0.35, 0.011);

    movingLayer flowing(0, 1, 0.01);
    flowing.add(0.3, 0.05, 1, true);
    flowing.reduce();
    EXPECT_EQ(flowing.surface(), 0);
}


TEST_F(tank, aTrackIsOfTheGrainThatWasNearestAtFirst)
{
    functionObjects::grainTrack track
    (
        "track",
        box_.time(),
        dict
        (
            "points ((0.26 0.34 0.02) (0.95 0.95 0)); downslope (0 1 0);"
            " normal (0 0 1);"
        )
    );
    ++box_.time();
    track.execute();

    grainSnapshot& g = grains_.grains;
    g.position[32] = point(0.7, 0.1, 0.3);
    g.U[32] = vector(1, 2, 3);
    g.omega[32] = vector(4, 5, 6);
    ++box_.time();
    track.execute();
    track.write();

    // x along the mesh's y, y against its x
    const scalarList line(lastLine("track", "grainTrack"));
    ASSERT_EQ(line.size(), 21);
    EXPECT_EQ(line[1], 32);
    const scalarList expected({0.1, -0.7, 0.3, 2, -1, 3, 5, -4, 6});
    forAll(expected, i)
    {
        EXPECT_NEAR(line[2 + i], expected[i], 1e-6) << i;
    }
    EXPECT_EQ(line[11], 99);
}


TEST_F(tank, aTrackBeginsWhenThereAreGrains)
{
    functionObjects::grainTrack track
    (
        "track", box_.time(), dict("points ((0.26 0.34 0.02));")
    );
    grainSnapshot& g = grains_.grains;
    g = grainSnapshot(0);
    ++box_.time();
    track.write();
    EXPECT_TRUE(table("track", "grainTrack").empty());

    placeGrains();
    ++box_.time();
    track.write();
    ASSERT_EQ(lastLine("track", "grainTrack").size(), 11);
    EXPECT_EQ(lastLine("track", "grainTrack")[1], 32);
}


TEST_F(tank, aGrainThatIsGoneIsMissingFromItsTrack)
{
    functionObjects::grainTrack track("track", box_.time(), dict("ids (7 1000);"));
    ++box_.time();
    track.write();
    EXPECT_EQ(lastLine("track", "grainTrack")[1], 7);
    EXPECT_EQ(lastLine("track", "grainTrack")[11], -1);

    EXPECT_THROW
    (
        functionObjects::grainTrack("none", box_.time(), dict("")),
        Foam::IOerror
    );
}


TEST_F(tank, anIdThatNoGrainHasIsReportedOnceThereAreGrains)
{
    functionObjects::grainTrack track
    (
        "track", box_.time(), dict("ids (7 1000 100);")
    );
    const auto output = [&]()
    {
        ++box_.time();
        return outputDuring([&]() { track.write(); });
    };

    grains_.grains = grainSnapshot(0);
    EXPECT_EQ(output(), "");

    placeGrains();
    const std::string warning(output());
    expectHolds(warning, "of the 100 grains, with ids 0 to 99");
    expectHolds(warning, "none has one of 1000 100\n");
    EXPECT_EQ(output(), "");

    // A continued run does not report it again either
    functionObjects::grainTrack again
    (
        "track", box_.time(), dict("ids (7 1000 100);")
    );
    ++box_.time();
    EXPECT_EQ(outputDuring([&]() { again.write(); }), "");

    // Whoever has found them has seen them
    functionObjects::grainTrack nearest
    (
        "nearest", box_.time(), dict("points ((0.26 0.34 0.02));")
    );
    nearest.write();
    grains_.grains.id[32] = 1000;
    ++box_.time();
    EXPECT_EQ(outputDuring([&]() { nearest.write(); }), "");
}


TEST_F(tank, circlesTakeGrainsAsDiscs)
{
    // One layer of discs in the plane of x and z, as thick as the mesh is wide
    grainSnapshot& g = grains_.grains;
    forAll(g.position, i)
    {
        g.position[i] = vector(0.01 + 0.02*(i % 10), 0.5, 0.01 + 0.02*(i/10));
    }

    functionObjects::grainStress stress
    (
        "stress", box_.time(), dict("circles (((0.1 0.3 0.1) 0.06));")
    );
    stress.write();

    const scalarList line(lastLine("stress", "grainStress"));
    ASSERT_EQ(line.size(), 11);

    // Squares of 20 mm hold a disc each
    const scalar area = constant::mathematical::pi*sqr(0.06);
    EXPECT_NEAR(line[1]*sqr(0.02)/area, 1, 0.02);
    EXPECT_NEAR(line[2], constant::mathematical::pi/4, 0.02);
    EXPECT_NEAR(line[3]*area/line[1], -1, 1e-6);
}


TEST_F(tank, stressInAxesOfTheFlumeIsTurned)
{
    grainSnapshot& g = grains_.grains;
    g = grainSnapshot(1);
    grains_.radii = scalarField(1, 0.01);
    g.d = 0.02;
    g.mass = 1;
    g.type = 1;
    g.position[0] = point(0.5, 0.5, 0.5);

    // Pressing along a direction 30 degrees below x
    const vector along(0.5*std::sqrt(3.0), 0, -0.5);
    g.stressMoment[0] = -3*sqr(along);

    functionObjects::grainStress stress
    (
        "stress",
        box_.time(),
        dict
        (
            "spheres (((0.5 0.5 0.5) 0.1)); axes flume;"
            " downslope (0.8660254037844386 0 -0.5);"
            " normal (0.5 0 0.8660254037844386);"
        )
    );
    stress.write();

    const scalar V = 4*constant::mathematical::pi*pow3(0.1)/3;
    const scalarList line(lastLine("stress", "grainStress"));
    EXPECT_NEAR(line[3], -3/V, 1e-3);
    EXPECT_NEAR(line[5], 0, 1e-3);
    EXPECT_NEAR(line[8], 0, 1e-3);
}


TEST_F(tank, aRegionFollowsTheSurfaceOfWhatRests)
{
    placeLattice(10);
    grainSnapshot& g = grains_.grains;
    g.mass = 1;

    // Two of five layers flow
    forAll(g.U, i)
    {
        g.U[i] = vector(g.position[i].z() > 0.06 ? 0.5 : 0, 0, 0);
    }
    functionObjects::grainStress stress
    (
        "stress",
        box_.time(),
        dict("spheres (((0.1 0.5 0) 0.04)); follow surface;")
    );
    stress.write();

    const scalarList line(lastLine("stress", "grainStress"));
    ASSERT_EQ(line.size(), 12);
    EXPECT_NEAR(line[11], 0.06, 0.0051);
    EXPECT_NEAR(line[2], constant::mathematical::pi/6, 0.03);
}


TEST_F(tank, aRegionOrAPointOutsideTheMeshIsAnError)
{
    const auto output = [&](const std::string& regions)
    {
        return refusal
        (
            [&]()
            {
                functionObjects::grainStress("stress", box_.time(), dict(regions));
            }
        );
    };

    for
    (
        const char* outside
      : {
            "spheres (((0.5 0.5 0.5) 0.1) ((0.5 500 0.5) 0.1));",
            "circles (((50 0.5 0.5) 0.1));",
            "boxes (((200 0 0) (200.5 0.5 0.5)));",
            "spheres (((50 0.5 0) 0.1)); follow surface;"
        }
    )
    {
        expectHolds(output(outside), "lies outside the mesh");
    }
    expectHolds
    (
        output("spheres (((0.5 0.5 0.5) 0.1) ((0.5 500 0.5) 0.1));"), "Region 1 "
    );
    for
    (
        const char* tooLong
      : {"spheres (((0.5 0.5 0.5) 20));", "boxes (((-100 0 0) (0.5 0.5 0.5)));"}
    )
    {
        expectHolds(output(tooLong), "is longer than the mesh");
    }

    // What any place will do for: across the flume, and the height over a surface
    EXPECT_EQ(output("circles (((0.5 -99 0.5) 0.1));"), "nothing");
    EXPECT_EQ(output("spheres (((0.5 0.5 -99) 0.1)); follow surface;"), "nothing");

    expectHolds
    (
        refusal
        (
            [&]()
            {
                functionObjects::grainTrack
                (
                    "track", box_.time(), dict("points ((0.26 0.34 0.02) (26 34 2));")
                );
            }
        ),
        "Point 1 of"
    );
}


TEST_F(tank, aTypeThatNoGrainHasIsReportedOnceThereAreGrains)
{
    grainSnapshot& g = grains_.grains;
    g = grainSnapshot(0);
    functionObjects::grainStress stress
    (
        "stress",
        box_.time(),
        dict("spheres (((0.5 0.5 0.5) 0.1)); types (1 3);")
    );
    const auto output = [&]()
    {
        ++box_.time();
        return outputDuring([&]() { stress.write(); });
    };

    EXPECT_EQ(output(), "");

    placeGrains();
    g.type = 1;
    const std::string warning(output());
    expectHolds
    (
        warning,
        "grainStress stress: no grain has a type of 3; those that are there have 1 to 1"
    );
    EXPECT_EQ(output(), "");
}
