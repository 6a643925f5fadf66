// SPDX-License-Identifier: GPL-3.0-or-later
// The function object displacedGrains: what has left its place, and where it came from.

#include "displacedGrains.H"
#include "tank.H"

#include <fstream>
#include <unistd.h>

using namespace Foam;


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

    // It left before the run that goes on, and then did all others
    const scalar depth = lastLine("moved", "displacedGrains")[7];
    const auto depthOfTheNextRun = [&]()
    {
        rmDir(box_.folder()/"postProcessing"/"moved"/"0");
        functionObjects::displacedGrains moved
        (
            "moved", box_.time(), dict(settings)
        );
        ++box_.time();
        moved.write();
        return lastLine("moved", "displacedGrains")[7];
    };
    EXPECT_EQ(depthOfTheNextRun(), depth);

    // With it and the one that came in its stead
    g = grainSnapshot(0);
    EXPECT_NEAR(depthOfTheNextRun(), 101*depth, 1e-3*depth);
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


TEST_F(tank, grainsThatComeLaterThanInARunBeforeHaveTheirOriginWhereTheyCome)
{
    const scalar start = box_.time().value();
    box_.time().setTime(start + 1, 1);
    functionObjects::displacedGrains("moved", box_.time(), dict("")).execute();

    // The same case once more, whose grains come elsewhere and later
    grainSnapshot& g = grains_.grains;
    const grainSnapshot all(g);
    g = grainSnapshot(0);
    rmDir(box_.folder()/"postProcessing"/"moved"/"0");
    box_.time().setTime(start + 0.5, 1);
    functionObjects::displacedGrains moved("moved", box_.time(), dict(""));
    moved.execute();
    g = all;
    forAll(g.position, i)
    {
        g.position[i].z() += 0.5;
    }
    box_.time().setTime(start + 2, 2);
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
