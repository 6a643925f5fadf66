// SPDX-License-Identifier: GPL-3.0-or-later
// The mean velocity of the grains around a grain.

#include "grainsInWater.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(meanGrainVelocity, isByMassWhereGrainsAreInOneCell)
{
    testMesh box;
    standingGrains phase(box.mesh());
    put
    (
        phase,
        pointField({{0.4, 0.4, 0.4}, {0.3, 0.4, 0.4}, {0.9, 0.9, 0.9}}),
        0.02
    );
    phase.grains.mass = scalarField({1, 3, 1});
    phase.grains.U = vectorField({{1, 0, 0}, {0, 2, 0}, {5, 5, 5}});

    grainExchange exchange(box.mesh());
    exchange.locate(phase);
    solidFractionField solids(exchange, entries(inOneCellEach));
    solids.update();
    meanGrainVelocity mean(exchange, solids.mapping());

    // Each grain has its own velocity until update() is called
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_EQ(mean[i], exchange.grains()[i].velocity);
    }

    mean.update();
    EXPECT_LT(mag(mean[0] - vector(0.25, 1.5, 0)), 1e-14);
    EXPECT_LT(mag(mean[1] - vector(0.25, 1.5, 0)), 1e-14);
    EXPECT_LT(mag(mean[2] - vector(5, 5, 5)), 1e-14);
}
