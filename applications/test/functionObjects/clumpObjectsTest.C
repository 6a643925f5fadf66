// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects among clumps of spheres.

#include "bedErosion.H"
#include "displacedGrains.H"
#include "grainTrack.H"
#include "overflow.H"
#include "surgeFront.H"
#include "tank.H"
#include "terminalOutput.H"

using namespace Foam;

namespace
{

//- Each grain again at its place, the two as a clump of that volume
void doubled(grainSnapshot& grains)
{
    const grainSnapshot alone(grains);
    const label n = alone.size();
    grains = grainSnapshot(2*n);
    grains.share = scalarField(2*n, 0.5);
    grains.clumpDiameter.setSize(2*n);

    forAll(grains.id, i)
    {
        const label k = i % n;
        grains.id[i] = i;
        grains.type[i] = alone.type[k];
        grains.clump[i] = k + 1;
        grains.position[i] = alone.position[k];
        grains.U[i] = alone.U[k];
        grains.d[i] = grains.clumpDiameter[i] = alone.d[k];
        grains.mass[i] = 0.5*alone.mass[k];
    }
}

} // End anonymous namespace


TEST_F(tank, whatTakesGrainsForSpheresRefusesClumps)
{
    functionObjects::displacedGrains moved("moved", box_.time(), dict("sections (0.5);"));
    functionObjects::grainTrack track("track", box_.time(), dict("ids (3);"));
    moved.execute();
    track.execute();

    grains_.grains.clump[7] = 1;
    ++box_.time();
    track.execute();
    const std::string output(refusal([&]{ moved.execute(); }));
    expectHolds(output, "Function object moved of type displacedGrains");
    expectHolds(output, "Take it out of system/controlDict");
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


// Two spheres at one place are as one, for what takes volumes and numbers
TEST_F(tank, volumesAndNumbersAreThoseOfClumps)
{
    placeLattice(20);
    grains_.grains.mass = 1;
    grains_.grains.U = vector(0.5, 0, 0);
    const auto lines = [&](const word& name)
    {
        functionObjects::surgeFront front
        (
            "front" + name, box_.time(), dict("front quantile; thickness mixture;")
        );
        functionObjects::bedErosion bed("bed" + name, box_.time(), dict("types (1);"));
        functionObjects::overflow over("over" + name, box_.time(), dict("x 0.2;"));
        for
        (
            functionObject* one :
            {(functionObject*)&front, (functionObject*)&bed, (functionObject*)&over}
        )
        {
            one->execute();
            one->write();
        }
        scalarList all(lastLine("front" + name, "surgeFront"));
        all.append(lastLine("bed" + name, "bedErosion"));
        all.append(lastLine("over" + name, "overflow"));
        return all;
    };

    const scalarList alone(lines("Alone"));
    doubled(grains_.grains);
    grains_.radii = scalarField(grains_.grains.size(), 0.01);
    ++box_.time();
    const scalarList clumps(lines("Clumps"));

    ASSERT_GT(alone.size(), 20);
    ASSERT_EQ(clumps.size(), alone.size());
    for (label i = 0; i < alone.size(); ++i)
    {
        EXPECT_NEAR(clumps[i], alone[i], 1e-9*(1 + mag(alone[i]))) << i;
    }
}
