// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects that follow grains: tracks, displacements, stress at a surface
// that moves.

#include "displacedGrains.H"
#include "grainStress.H"
#include "grainTrack.H"
#include "movingLayer.H"
#include "saidDuring.H"
#include "sphereParts.H"
#include "tank.H"

#include <fstream>
#include <unistd.h>

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


TEST_F(tank, anIdThatNoGrainHasIsToldOnceThereAreGrains)
{
    functionObjects::grainTrack track
    (
        "track", box_.time(), dict("ids (7 1000 100);")
    );
    const auto said = [&]()
    {
        ++box_.time();
        return saidDuring([&]() { track.write(); });
    };

    grains_.grains = grainSnapshot(0);
    EXPECT_EQ(said(), "");

    placeGrains();
    const std::string warning(said());
    expectSays(warning, "of the 100 grains, with ids 0 to 99");
    expectSays(warning, "none has one of 1000 100\n");
    EXPECT_EQ(said(), "");

    // Nor does a run that goes on tell it again
    functionObjects::grainTrack again
    (
        "track", box_.time(), dict("ids (7 1000 100);")
    );
    ++box_.time();
    EXPECT_EQ(saidDuring([&]() { again.write(); }), "");

    // Whoever has found them has seen them
    functionObjects::grainTrack nearest
    (
        "nearest", box_.time(), dict("points ((0.26 0.34 0.02));")
    );
    nearest.write();
    grains_.grains.id[32] = 1000;
    ++box_.time();
    EXPECT_EQ(saidDuring([&]() { nearest.write(); }), "");
}


TEST_F(tank, whatHasMovedHasItsVolumeVelocityAndDepth)
{
    functionObjects::displacedGrains moved
    (
        "moved",
        box_.time(),
        dict("sections (0.3 0.7); sectionWidth 0.2; packing 0.5;")
    );
    ++box_.time();
    moved.execute();
    moved.write();
    EXPECT_EQ(lastLine("moved", "displacedGrains")[1], 0);

    // Two mean diameters are 40 mm: 30 of them go farther, ten of these now rest,
    // ten others go less far
    grainSnapshot& g = grains_.grains;
    forAll(g.id, i)
    {
        const label column = i % 10;
        if (column >= 2 && column <= 4)
        {
            g.position[i].x() += 0.1;
            g.U[i] = column == 2 ? vector::zero : vector(0.5*(column - 2), 0, 0);
        }
        else if (column == 8)
        {
            g.position[i].z() += 0.03;
            g.U[i] = vector(1, 0, 0);
        }
    }
    ++box_.time();
    moved.execute();
    moved.write();

    const scalarList line(lastLine("moved", "displacedGrains"));
    const scalar V = constant::mathematical::pi*pow3(0.02)/6;
    ASSERT_EQ(line.size(), 9);
    EXPECT_EQ(line[1], 30);
    EXPECT_NEAR(line[2], 30*V, 1e-5*V*30);
    EXPECT_NEAR(line[3], 0.5, 1e-6);
    EXPECT_EQ(line[4], 20);
    EXPECT_NEAR(line[6], 0.75, 1e-6);

    // From 0.2 to 0.4 came those of columns 2 and 3
    EXPECT_NEAR(line[7], 20*V/(0.5*1*0.2), 1e-8);
    EXPECT_EQ(line[8], 0);
}


TEST_F(tank, aGrainThatHasLeftTheMeshStillCountsForTheDepth)
{
    const string settings("threshold 0.05; sections (0.5); sectionWidth 2;");
    grainSnapshot& g = grains_.grains;
    {
        functionObjects::displacedGrains moved
        (
            "moved", box_.time(), dict(settings)
        );
        ++box_.time();
        moved.execute();
        g.id[7] = 2007;
        ++box_.time();
        moved.write();
        EXPECT_EQ(lastLine("moved", "displacedGrains")[1], 0);
        EXPECT_GT(lastLine("moved", "displacedGrains")[7], 0);
    }

    // It left before the run that goes on
    const scalar depth = lastLine("moved", "displacedGrains")[7];
    functionObjects::displacedGrains moved
    (
        "moved", box_.time(), dict(settings)
    );
    ++box_.time();
    moved.write();
    EXPECT_EQ(lastLine("moved", "displacedGrains")[7], depth);
}


TEST_F(tank, displacementsGoOnFromTheOriginsOfTheRunBefore)
{
    const string settings("threshold 0.05;");
    {
        functionObjects::displacedGrains moved
        (
            "moved", box_.time(), dict(settings)
        );
        ++box_.time();
        moved.execute();
    }
    grains_.grains.position[5].x() += 0.06;
    ++box_.time();
    rmDir(box_.folder()/"postProcessing"/"moved"/"0");

    functionObjects::displacedGrains moved
    (
        "moved", box_.time(), dict(settings)
    );
    moved.execute();
    moved.write();

    const scalarList line(lastLine("moved", "displacedGrains"));
    ASSERT_EQ(line.size(), 7);
    EXPECT_EQ(line[1], 1);
}


TEST_F(tank, aGrainThatCameLaterKeepsItsOriginThroughARestart)
{
    const fileName origins(box_.folder()/"postProcessing"/"moved"/"origins");
    grainSnapshot& g = grains_.grains;
    {
        // A hundred grains of which one goes, and one comes in its stead
        functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
        ++box_.time();
        moved.execute();
        g.id[7] = 2007;
        ++box_.time();
        moved.execute();
        moved.end();
    }
    EXPECT_FALSE(isFile(origins + ".incomplete"));

    // Of larger grains two mean diameters would be more than it has gone
    g.position[7].x() += 0.05;
    g.d = 0.04;
    rmDir(box_.folder()/"postProcessing"/"moved"/"0");
    ++box_.time();
    functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
    moved.write();
    ASSERT_EQ(lastLine("moved", "displacedGrains").size(), 7);
    EXPECT_EQ(lastLine("moved", "displacedGrains")[1], 1);
}


TEST_F(tank, aRestartFromBeforeAGrainCameTakesItsOriginAnew)
{
    grainSnapshot& g = grains_.grains;
    {
        functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
        ++box_.time();
        moved.execute();
        g.id[7] = 2007;
        box_.time().setTime(10*box_.time().value(), 10);
        moved.execute();
        moved.end();
    }
    g.position[7].x() += 0.05;
    rmDir(box_.folder()/"postProcessing"/"moved"/"0");
    box_.time().setTime(box_.time().value()/2, 5);
    functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
    moved.write();
    EXPECT_EQ(lastLine("moved", "displacedGrains")[1], 0);
}


TEST_F(tank, originsThatWereCutOffAreAnError)
{
    const fileName origins(box_.folder()/"postProcessing"/"moved"/"origins");
    functionObjects::displacedGrains before("moved", box_.time(), dict(""));
    ++box_.time();
    before.execute();

    std::ifstream is(origins);
    std::string text((std::istreambuf_iterator<char>(is)), {});
    std::ofstream(origins) << text.substr(0, text.size()/2);
    ++box_.time();
    functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
    EXPECT_THROW(moved.execute(), Foam::error);
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


namespace
{

//- A tank on each rank, whose grains have numbers of their own
class ParallelTank
:
    public tank
{};

} // End anonymous namespace


TEST_F(ParallelTank, originsOfAllRanksAreWritten)
{
    // Ranks that wait for each other for ever shall not make the tests wait
    alarm(60);

    for (label& id : grains_.grains.id)
    {
        id += 100*Pstream::myProcNo();
    }
    functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
    ++box_.time();
    moved.execute();

    if (Pstream::master())
    {
        std::ifstream is
        (
            box_.time().globalPath()/"postProcessing"/"moved"/"origins"
        );
        scalar time = 0;
        scalar d = 0;
        label n = 0;
        is >> time >> d >> n;
        EXPECT_EQ(n, 100*Pstream::nProcs());
    }
    alarm(0);
}


TEST_F(ParallelTank, grainsOfAllRanksThatHaveLeftCountForTheDepth)
{
    alarm(60);

    labelList& ids = grains_.grains.id;
    for (label& id : ids)
    {
        id += 100*Pstream::myProcNo();
    }
    const string settings("sections (0.5); sectionWidth 2;");
    functionObjects::displacedGrains moved("moved", box_.time(), dict(settings));
    ++box_.time();
    moved.execute();

    // One of each rank leaves
    ids[7] = 1000*(1 + Pstream::myProcNo());
    ++box_.time();
    moved.write();

    if (Pstream::master())
    {
        const scalar V = constant::mathematical::pi*pow3(0.02)/6;
        EXPECT_NEAR
        (
            lastLine("moved", "displacedGrains")[7],
            Pstream::nProcs()*V/(0.6*2),
            1e-9
        );
    }
    alarm(0);
}
