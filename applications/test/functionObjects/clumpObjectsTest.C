// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects among clumps of spheres.

#include "grainTrack.H"
#include "surgeFront.H"
#include "tank.H"
#include "terminalOutput.H"

using namespace Foam;


TEST_F(tank, whatTakesGrainsForSpheresRefusesClumps)
{
    functionObjects::surgeFront front("front", box_.time(), dict(""));
    functionObjects::grainTrack track("track", box_.time(), dict("ids (3);"));
    front.execute();
    track.execute();

    grains_.grains.clump[7] = 1;
    ++box_.time();
    track.execute();
    const std::string output(refusal([&]{ front.execute(); }));
    expectHolds(output, "Function object front of type surgeFront");
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
