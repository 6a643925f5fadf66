// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: a gate holds material points until it is drawn.

#include "terminalOutput.H"
#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A hopper of sand 0.4 m long and 0.2 m deep at a gate at x = 0.4 m
struct hopper
{
    boxOfPoints points;

    explicit hopper(const string& transfer = "")
    :
        points
        (
            boxAround(),
            down,
            body(sand, "((0 0 0) (0.4 1 0.2))", transfer)
        )
    {}

    static pointBox boxAround()
    {
        pointBox box;
        box.height = 0.4;
        box.h = 0.02;
        box.base = 0.5;
        return box;
    }

    void addGate(const vector& normal, const scalar edge)
    {
        points.addGate
        (
            point(0.4, 0, 0), normal, vector(0, 0, 1), edge, true
        );
    }

    //- Largest distance of a point beyond the gate and its height there
    scalar furthest() const
    {
        scalar x = 0;
        for (const point& p : points.points().x)
        {
            x = max(x, p.x());
        }
        return x - 0.4;
    }

    //- Mean distance of the points from the wall behind them [m]
    scalar mean() const
    {
        scalar sum = 0;
        for (const point& p : points.points().x)
        {
            sum += p.x();
        }
        return sum/points.points().size();
    }

    scalar highestBeyond() const
    {
        scalar z = 0;
        for (const point& p : points.points().x)
        {
            z = p.x() > 0.4 ? max(z, p.z()) : z;
        }
        return z;
    }
};

} // End anonymous namespace


TEST(pointGate, aClosedGateHoldsAllPointsWhicheverWayItsNormal)
{
    for (const string transfer : {"", "transfer { model FLIP; }"})
    {
        for (const scalar sign : {1, -1})
        {
            hopper behind(transfer);
            behind.addGate(vector(sign, 0, 0), 0);
            behind.points.run(0.3);

            testNumber("furthest beyond the closed gate [m]", behind.furthest());
            EXPECT_LT(behind.furthest(), 1e-6);

            // As a wall would: they do not pile up on it either
            testNumber("mean distance from the wall behind [m]", behind.mean());
            EXPECT_NEAR(behind.mean(), 0.2, 0.002);
        }
    }

    // What they would do
    hopper free;
    free.points.run(0.3);
    EXPECT_GT(free.furthest(), 0.1);
}


TEST(pointGate, pointsPassBelowItsEdgeAlone)
{
    hopper drawn;
    drawn.addGate(vector(1, 0, 0), 0.14);
    drawn.points.run(0.3);

    testNumber("highest point beyond, edge at 0.14 m [m]", drawn.highestBeyond());
    EXPECT_GT(drawn.furthest(), 0.05);
    EXPECT_LT(drawn.highestBeyond(), 0.14);
}


TEST(pointGate, oneThatIsGoneChangesNothing)
{
    hopper gone;
    gone.addGate(vector(1, 0, 0), GREAT);
    gone.points.run(0.1);
    hopper free;
    free.points.run(0.1);

    ASSERT_EQ(gone.points.points().size(), free.points.points().size());
    forAll(free.points.points().x, i)
    {
        ASSERT_EQ(gone.points.points().x[i], free.points.points().x[i]);
    }
}


TEST(pointGate, itPushesNoneBackThatLeavesIt)
{
    // Sand that flies away from the gate, and from no wall
    boxOfPoints away
    (
        hopper::boxAround(), Zero, body(sand, "((0.2 0 0) (0.4 1 0.2))")
    );
    away.addGate(point(0.4, 0, 0), vector(1, 0, 0), vector(0, 0, 1), 0, true);
    for (vector& U : away.points().U)
    {
        U = vector(-0.5, 0, 0);
    }
    const vector before(away.momentum());
    away.step(1e-4);
    EXPECT_NEAR(mag(away.momentum() - before), 0, 1e-12*mag(before));
}


TEST(pointGate, pointsOnBothSidesAreNamed)
{
    hopper both;
    const std::string message = refusal([&]()
    {
        both.points.addGate
        (
            point(0.2, 0, 0), vector(1, 0, 0), vector(0, 0, 1), 0, true
        );
    });
    expectHolds(message, "has points on both sides");
    expectHolds(message, "1.5 cellSize = 0.03 m");
    expectHolds(message, "constant/slidingGate");

    // Below its edge they are its flow
    EXPECT_EQ
    (
        refusal([&]()
        {
            both.points.addGate
            (
                point(0.2, 0, 0), vector(1, 0, 0), vector(0, 0, 1), 0.3, true
            );
        }),
        "nothing"
    );
}


TEST(ParallelPointGate, itHoldsOnAnyNumberOfRanks)
{
    hopper behind;
    behind.addGate(vector(1, 0, 0), 0);
    behind.points.run(0.2);
    EXPECT_LT(behind.furthest(), 1e-6);
}
