// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects among clumps of spheres.

#include "bedErosion.H"
#include "collisionLoad.H"
#include "displacedGrains.H"
#include "grainBodies.H"
#include "grainStress.H"
#include "surgeFront.H"
#include "tank.H"

using namespace Foam;

namespace
{

//- Each grain again at its place, the two as a clump of so many diameters
void doubled(grainSnapshot& grains, const scalar diameters)
{
    const grainSnapshot alone(grains);
    const label n = alone.size();
    grains = grainSnapshot(2*n);
    grains.share.setSize(2*n);
    grains.clumpDiameter.setSize(2*n);

    forAll(grains.id, i)
    {
        const label k = i % n;
        grains.id[i] = i;
        grains.type[i] = alone.type[k];
        grains.clump[i] = k + 1;
        grains.position[i] = alone.position[k];
        grains.U[i] = alone.U[k];
        grains.d[i] = alone.d[k];
        grains.clumpDiameter[i] = diameters*alone.d[k];
        grains.share[i] = i < n ? 0.3 : 0.7;
        grains.mass[i] = grains.share[i]*alone.mass[k];
    }
}

} // End anonymous namespace


// Of two spheres 0.98 m apart across a side that repeats, or 0.02 m the other way
TEST_F(tank, theCentreOfAClumpLiesBetweenItsSpheresBeyondASide)
{
    grainSnapshot two(2);
    two.id = labelList({9, 4});
    two.type = labelList({2, 1});
    two.clump = labelList({3, 3});
    two.share = scalarList({0.25, 0.75});
    two.clumpDiameter = scalarField(2, 0.03);
    two.position = List<vector>({vector(0.99, 0.5, 0.1), vector(0.01, 0.5, 0.2)});
    two.mass = scalarList({1, 3});
    two.U = List<vector>({vector(4, 0, 0), vector(0, 4, 0)});
    two.force = List<vector>({vector(1, 0, 0), vector(0, 2, 0)});

    testBox repeats;
    repeats.patches[0] = repeats.patches[1] = "cyclic";
    testMesh box(repeats);
    const auto bodies(grainBodies(two, periodicity(box.mesh())));

    ASSERT_EQ(bodies->size(), 1);
    EXPECT_EQ(bodies->id[0], 4);
    EXPECT_EQ(bodies->type[0], 1);
    EXPECT_EQ(bodies->d[0], 0.03);
    EXPECT_EQ(bodies->mass[0], 4);
    EXPECT_LT(mag(bodies->position[0] - vector(0.005, 0.5, 0.175)), 1e-12);
    EXPECT_LT(mag(bodies->U[0] - vector(1, 3, 0)), 1e-12);
    EXPECT_LT(mag(bodies->force[0] - vector(1, 2, 0)), 1e-12);
    EXPECT_FALSE(bodies->hasClumps());
}


// 96 alone, two clumps of two
TEST_F(tank, aClumpCountsOnceAmongTheGrains)
{
    labelList& clump = grains_.grains.clump;
    clump[3] = clump[70] = 4;
    clump[5] = clump[6] = 9;

    EXPECT_EQ(grains_.grains.nBodies(), 98);
    EXPECT_TRUE(grains_.grains.hasClumps());
}


TEST_F(tank, aSphereOfAClumpStandsForItsShare)
{
    doubled(grains_.grains, 1.5);
    const grainSnapshot& all = grains_.grains;
    const scalar whole = constant::mathematical::pi/6*pow3(0.03);

    EXPECT_EQ(all.bodyDiameter(3), 0.03);
    EXPECT_EQ(all.partOfBody(103), 0.7);
    EXPECT_NEAR(all.volume(3), 0.3*whole, 1e-12*whole);
    EXPECT_NEAR(all.volume(103), 0.7*whole, 1e-12*whole);
}


// Two spheres at one place are as one
TEST_F(tank, volumesAndNumbersAreThoseOfClumps)
{
    placeLattice(20);
    grains_.grains.mass = 1;
    const auto lines = [&](const word& name)
    {
        functionObjects::surgeFront front
        (
            "front" + name, box_.time(), dict("front quantile; thickness mixture;")
        );
        functionObjects::bedErosion bed
        (
            "bed" + name, box_.time(), dict("bedTypes (1);")
        );
        front.execute();
        front.write();
        bed.execute();
        bed.write();

        // But for their times
        scalarList all(lastLine("front" + name, "surgeFront"));
        scalarList ofBed(lastLine("bed" + name, "bedErosion"));
        all[0] = ofBed[0] = 0;
        all.append(ofBed);
        return all;
    };
    const auto solid = [&](const word& name)
    {
        const scalarList line(lastLine("front" + name, "surgeFront"));
        return line[9] - line[8];
    };

    const grainSnapshot lattice(grains_.grains);
    const scalarList alone(lines("Alone"));
    doubled(grains_.grains, 1);
    ++box_.time();
    const scalarList clumps(lines("Clumps"));

    ASSERT_GT(alone.size(), 20);
    ASSERT_EQ(clumps.size(), alone.size());
    for (label i = 0; i < alone.size(); ++i)
    {
        EXPECT_NEAR(clumps[i], alone[i], 1e-9*(1 + mag(alone[i]))) << i;
    }

    // Larger clumps have more volume
    grains_.grains = lattice;
    doubled(grains_.grains, 1.5);
    ++box_.time();
    lines("Large");
    EXPECT_NEAR(solid("Large"), pow3(1.5)*solid("Alone"), 1e-6*solid("Large"));
}


// The forces on the spheres of a clump balance: nothing hits the clump
TEST_F(tank, theLoadOfAClumpIsTheSumOverItsSpheres)
{
    const auto line = [&](const word& name)
    {
        functionObjects::collisionLoad load
        (
            name, box_.time(), dict("types (1); range (0.2 0.4); window (0 1);")
        );
        load.execute();
        load.write();
        return lastLine(name, "collisionLoad");
    };

    const scalarList alone(line("alone"));
    doubled(grains_.grains, 1);
    ++box_.time();
    EXPECT_EQ(line("none")[1], 0);

    forAll(grains_.grains.id, i)
    {
        grains_.grains.contactForce[i] = i < 100 ? vector(3, 1, 0) : vector(0, -1, 4);
    }
    ++box_.time();
    const scalarList clumps(line("clumps"));

    ASSERT_EQ(clumps.size(), alone.size());
    for (label i = 1; i < alone.size(); ++i)
    {
        EXPECT_NEAR(clumps[i], alone[i], 1e-9) << i;
    }
}


// It turns about its centre by half a turn, then goes 0.05 m
TEST_F(tank, aClumpIsDisplacedWithItsCentre)
{
    grainSnapshot& g = grains_.grains;
    doubled(g, 2);
    g.share = 0.5;
    const vector aside(0.03, 0, 0);
    const auto spread = [&](const scalar sign)
    {
        forAll(g.id, i)
        {
            g.position[i] += i < 100 ? sign*aside : -sign*aside;
        }
    };

    spread(1);
    functionObjects::displacedGrains moved
    (
        "moved", box_.time(), dict("threshold 0.04; speed 0.1;")
    );
    ++box_.time();
    moved.execute();
    spread(-2);
    ++box_.time();
    moved.execute();
    moved.write();
    EXPECT_EQ(lastLine("moved", "displacedGrains")[1], 0);

    for (label clump = 1; clump <= 7; ++clump)
    {
        for (const label i : {clump - 1, clump + 99})
        {
            g.position[i].x() += 0.05;
            g.U[i] = vector(0.5, 0, 0);
        }
    }
    ++box_.time();
    moved.execute();
    moved.write();

    const scalarList line(lastLine("moved", "displacedGrains"));
    const scalar V = constant::mathematical::pi*pow3(0.04)/6;
    EXPECT_EQ(line[1], 7);
    EXPECT_NEAR(line[2], 7*V, 1e-5*7*V);
    EXPECT_NEAR(line[6], 0.5, 1e-6);
}


TEST_F(tank, theStressOfClumpsCountsEachOnce)
{
    const auto line = [&](const word& name)
    {
        functionObjects::grainStress stress
        (
            name, box_.time(), dict("boxes ( ((0 0 0) (1 1 0.5)) ); kinetic true;")
        );
        stress.write();
        return lastLine(name, "grainStress");
    };
    forAll(grains_.grains.id, i)
    {
        grains_.grains.U[i] = vector(i % 3, 0, 1);
    }

    const scalarList alone(line("alone"));
    const symmTensor moment(grains_.grains.stressMoment[0]);
    doubled(grains_.grains, 1);
    forAll(grains_.grains.id, i)
    {
        grains_.grains.stressMoment[i] = i < 100 ? 0.2*moment : 0.8*moment;
    }
    ++box_.time();
    const scalarList clumps(line("clumps"));

    ASSERT_GT(alone.size(), 10);
    EXPECT_EQ(clumps[1], 100);
    for (label i = 1; i < alone.size(); ++i)
    {
        EXPECT_NEAR(clumps[i], alone[i], 1e-9*(1 + mag(alone[i]))) << i;
    }
}


TEST(ParallelGrainBodies, aClumpOnTwoRanksIsOneGrain)
{
    testMesh box;
    const label rank = Pstream::myProcNo();
    grainSnapshot mine(rank < 2 ? 1 : 0);
    mine.share.setSize(mine.size(), 0.5);
    mine.clumpDiameter.setSize(mine.size(), 0.03);
    if (mine.size())
    {
        mine.id[0] = 7 - rank;
        mine.type[0] = 3;
        mine.clump[0] = 5;
        mine.position[0] = vector(0.4 + 0.2*rank, 0.5, 0.5);
        mine.mass[0] = 2;
        mine.U[0] = vector(rank, 1, 0);
        mine.contactForce[0] = vector(rank, 0, 1);
    }

    const auto bodies(grainBodies(mine, periodicity(box.mesh())));

    EXPECT_EQ(returnReduce(bodies->size(), sumOp<label>()), 1);
    if (bodies->size())
    {
        EXPECT_EQ(bodies->id[0], 6);
        EXPECT_EQ(bodies->mass[0], 4);
        EXPECT_LT(mag(bodies->position[0] - vector(0.5, 0.5, 0.5)), 1e-12);
        EXPECT_LT(mag(bodies->U[0] - vector(0.5, 1, 0)), 1e-12);
        EXPECT_EQ(bodies->contactForce[0], vector(1, 0, 2));
    }
}
