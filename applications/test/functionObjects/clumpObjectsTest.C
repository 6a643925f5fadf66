// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects among clumps of spheres.

#include "bedErosion.H"
#include "displacedGrains.H"
#include "grainTrack.H"
#include "surgeFront.H"
#include "tank.H"
#include "terminalOutput.H"

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
