// SPDX-License-Identifier: GPL-3.0-or-later
// Tables for pictures of grains and water.

#include "sideView.H"
#include "tank.H"

using namespace Foam;

namespace
{

void expectRow(const scalarList& row, const scalarList& expected)
{
    ASSERT_EQ(row.size(), expected.size());
    forAll(row, i)
    {
        EXPECT_NEAR(row[i], expected[i], 1e-6) << "column " << i;
    }
}

} // End anonymous namespace



TEST_F(tank, theTablesForPicturesHoldEveryGrainAndCell)
{
    volVectorField U
    (
        IOobject("U", box_.time().timeName(), box_.mesh()),
        box_.mesh(),
        dimensionedVector("U", dimVelocity, vector(0, 3, 4))
    );
    grains_.grains.U = vector(1, 2, 2);
    grains_.grains.type[7] = 2;
    grains_.grains.id[7] = 42;

    functionObjects::sideView view("view", box_.time(), dict(""));
    view.write();

    const List<scalarList> grains(table("view", "grains"));
    ASSERT_EQ(grains.size(), 100);
    expectRow(grains[7], {0.75, 0.05, 0.01, 0.02, 3, 2, 42});

    const List<scalarList> cells(table("view", "cells"));
    ASSERT_EQ(cells.size(), 64);
    expectRow(cells[0], {0.125, 0.125, 0.125, 0.25, 1, 5});
    expectRow(cells[63], {0.875, 0.875, 0.875, 0.25, 0, 5});
}


TEST_F(tank, aSideViewTakesGrainsNearTheSideInFlumeCoordinates)
{
    volVectorField U
    (
        IOobject("U", box_.time().timeName(), box_.mesh()),
        box_.mesh(),
        dimensionedVector(dimVelocity, Zero)
    );

    // x of the flume along y of the mesh: across it is -x, its side at x = 1
    functionObjects::sideView view
    (
        "view",
        box_.time(),
        dict("nearest 0.2; downslope (0 1 0); origin (0 0.5 0);")
    );
    view.write();

    const List<scalarList> grains(table("view", "grains"));
    ASSERT_EQ(grains.size(), 20);
    expectRow(grains[0], {-0.45, -0.85, 0.01, 0.02, 0, 1, 8});
    for (const scalarList& row : grains)
    {
        EXPECT_LT(row[1], -0.8);
    }

    EXPECT_THROW
    (
        functionObjects::sideView("view", box_.time(), dict("near 0.2;")),
        Foam::IOerror
    );
}
