// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: sand of material points at rest, on slopes and in a collapse.

#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Largest speed [m/s]
scalar fastest(const materialPointMethod& points)
{
    scalar U = 0;
    for (const vector& u : points.points().U)
    {
        U = max(U, mag(u));
    }
    return U;
}


pointBox layer()
{
    pointBox box;
    box.length = 0.2;
    box.height = 0.4;
    box.h = 0.02;
    return box;
}

} // End anonymous namespace


TEST(pointSand, wallsTakeTheWeight)
{
    pointBox box;
    box.length = 0.4;
    box.height = 0.5;
    box.h = 0.02;
    boxOfPoints column(box, down, body(sand, "((0 0 0) (0.4 1 0.3))"));
    column.run(0.5, 20);
    column.walls().resetImpulse();
    column.run(0.1, 20);

    const scalar weight = 1500*0.4*0.3*0.1*9.81;
    EXPECT_NEAR(column.walls().impulse()[0].z()/0.1, -weight, 1e-3*weight);
    EXPECT_NEAR(column.walls().impulse()[1].x()/0.1, 0, 1e-3*weight);
}


TEST(pointSand, stressAtRestIsThatOfTheWeightWithin1PercentSaveAtTheBase)
{
    pointBox box;
    box.length = 0.2;
    box.height = 1.4;
    box.h = 0.025;
    boxOfPoints column
    (
        box,
        down,
        body
        (
            "law softeningDruckerPrager; density 1500; E 1e7; nu 0.2;"
            " frictionAngle 32;",
            "((0 0 0) (1 1 1))"
        )
    );
    for (label i = 1; i <= 50; ++i)
    {
        column.setGravity(i/50.0*down);
        column.run(0.004, 40);
    }
    column.run(0.1, 40);

    // Mean of each layer of cells, over the stress at the base
    scalarField error(40, Zero);
    scalarField n(40, Zero);
    const pointSet& p = column.points();
    forAll(p.x, i)
    {
        const label layer = min(39, label(p.x[i].z()/0.025));
        const scalar exact = -1500*9.81*(1 - p.x[i].z());
        error[layer] += (p.stress[i].zz() - exact)/(1500*9.81);
        n[layer] += 1;
    }
    error /= n;
    testNumber
    (
        "stress in the layer at the base over that of its weight", 1 - error[0]
    );

    // Where points of one side alone reach the nodes at the base it is too high
    EXPECT_LT(mag(error[0]), 0.1);
    error[0] = 0;
    testNumber
    (
        "largest error of all other layers over the stress at the base",
        max(mag(error))
    );
    EXPECT_LT(max(mag(error)), 0.01);
}


TEST(pointSand, aSlopeOfSlopeMatchingStandsBelowItsAngleAndFlowsAbove)
{
    const string slope(sand + " matching slope;");
    const scalar at30 = speedOnSlope(30, slope, layer());
    const scalar at34 = speedOnSlope(34, slope, layer());
    testNumber("speed at 30 degrees over that without friction", at30);
    testNumber("speed at 34 degrees over that without friction", at34);

    EXPECT_LT(at30, 1e-3);

    // sin 34 - tan 32 cos 34 of sin 34
    EXPECT_GT(at34, 0.5*(1 - std::tan(32*M_PI/180)/std::tan(34*M_PI/180)));
}


TEST(pointSand, aSlopeOfPlaneStrainMatchingFailsAtTheSineOfItsAngle)
{
    // tan theta = sin 32: theta = 27.9 degrees
    const scalar at27 = speedOnSlope(27, sand, layer());
    const scalar at30 = speedOnSlope(30, sand, layer());
    testNumber("speed at 27 degrees over that without friction", at27);
    testNumber("speed at 30 degrees over that without friction", at30);

    EXPECT_LT(at27, 1e-3);
    EXPECT_GT(at30, 0.5*(1 - std::sin(32*M_PI/180)/std::tan(30*M_PI/180)));
}


TEST(pointSand, aDryColumnRunsOutAsSandDoes)
{
    pointBox box;
    box.length = 0.8;
    box.height = 0.36;
    box.h = 0.01;
    box.base = 0.6;
    boxOfPoints column
    (
        box, down, body(sand, "((0 0 0) (0.15 1 0.3))")
    );
    column.run(1);

    // Where the heap is half a cell deep: volume of a strip over its width
    scalarField depth(80, Zero);
    const pointSet& p = column.points();
    forAll(p.x, i)
    {
        depth[label(p.x[i].x()/0.01)] += p.mass[i]/1500/(0.01*0.1);
    }
    label front = 79;
    while (depth[front] < 0.005)
    {
        --front;
    }
    const scalar runOut = (0.01*(front + 1) - 0.15)/0.15;
    testNumber("run-out over width", runOut);
    testNumber("height over width", depth[0]/0.15);
    testNumber("speed left [m/s]", fastest(column));
    EXPECT_GT(runOut, 2.4);
    EXPECT_LT(runOut, 3.6);
}
