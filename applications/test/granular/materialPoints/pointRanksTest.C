// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: material points are the same on any number of ranks.

#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const string oneBody(body(sand, "((0.1 0 0) (0.36 1 0.3))"));


const string twoBodies
(
    "contact { friction 0.3; } bodies { low { " + sand
  + "region { box ((0.1 0 0) (0.36 1 0.16)); } } high { " + sand
  + "region { box ((0.1 0 0.16) (0.36 1 0.3)); } } }"
);


//- A small column that collapses in a box
autoPtr<boxOfPoints> smallCollapse
(
    const bool cut,
    const bool repeats,
    const bool solid,
    const string& settings
)
{
    pointBox box;
    box.length = 0.8;
    box.height = 0.4;
    box.h = 0.04;
    box.base = 0.5;
    box.cut = cut;
    box.repeats = repeats;
    box.solid = solid;
    box.width = solid ? 0.16 : 0.1;

    autoPtr<boxOfPoints> column
    (
        new boxOfPoints
        (
            box,
            vector(2, 0, -9.81),
            settings
        )
    );
    column->run(solid ? 0.15 : 0.4);
    return column;
}


//- The same column pushed to seven tenths of its height, without a change of its
//  points' volumes: they shift
autoPtr<boxOfPoints> pushedTogether(const bool cut, const bool repeats)
{
    pointBox box;
    box.length = 0.8;
    box.height = 0.4;
    box.h = 0.04;
    box.cut = cut;
    box.repeats = repeats;

    autoPtr<boxOfPoints> column
    (
        new boxOfPoints(box, vector(2, 0, 0), "shifting on; " + oneBody)
    );
    for (point& x : column->points().x)
    {
        x.z() *= 0.7;
    }
    column->run(0.1);
    return column;
}


//- What many ranks compute is what each computes alone, to a rounding that
//  has grown for some hundred steps
void expectSame(const boxOfPoints& together, const boxOfPoints& alone)
{
    const pointSet& p = together.points();
    const pointSet& all = alone.points();

    EXPECT_EQ(returnReduce(p.size(), sumOp<label>()), all.size());

    labelList where(all.size());
    forAll(all.id, i)
    {
        where[all.id[i]] = i;
    }

    scalar apart = 0;
    scalar stress = 0;

    forAll(p.id, i)
    {
        const label j = where[p.id[i]];
        apart = max(apart, mag(p.x[i] - all.x[j]));
        stress = max(stress, mag(p.stress[i] - all.stress[j]));
    }
    testNumber
    (
        "largest distance from the same point on one rank [m]",
        returnReduce(apart, maxOp<scalar>())
    );
    EXPECT_LT(apart, 1e-11);
    EXPECT_LT(stress, 1e-4);

    // The impulse of each wall is counted once
    for (label wall = 0; wall < together.walls().names().size(); ++wall)
    {
        vector impulse(together.walls().impulse()[wall]);
        reduce(impulse, sumOp<vector>());
        EXPECT_NEAR
        (
            mag(impulse - alone.walls().impulse()[wall]), 0, 1e-6
        );
    }
}


void expectAsAlone
(
    const bool repeats,
    const bool solid,
    const string& settings = oneBody
)
{
    auto together = smallCollapse(true, repeats, solid, settings);
    auto alone = smallCollapse(false, repeats, solid, settings);
    expectSame(*together, *alone);

    // The column began below that
    label crossed = 0;
    for (const point& p : together->points().x)
    {
        crossed += together->grid().first() > 0 && p.x() > 0.36;
    }
    EXPECT_GT(returnReduce(crossed, sumOp<label>()), 0);
}

} // End anonymous namespace


TEST(ParallelMaterialPoints, aCollapseIsTheSameOnAnyNumberOfRanks)
{
    expectAsAlone(false, false);
}


TEST(ParallelMaterialPoints, aCollapseInABoxThatRepeatsIsTheSame)
{
    expectAsAlone(true, false);
}


TEST(ParallelMaterialPoints, aCollapseByFLIPIsTheSame)
{
    expectAsAlone(false, false, "transfer { model FLIP; }" + oneBody);
}


TEST(ParallelMaterialPoints, sandBetweenRoughSidesIsTheSameHoweverSlabsCutThem)
{
    // Boxes of 3 to 6 cells: a slab ends behind, at or before a side
    for (label cells = 3; cells < 7; ++cells)
    {
        pointBox box;
        box.h = 0.04;
        box.length = cells*box.h;
        box.height = box.length;
        box.base = 0.4;
        box.sides = 0.3;

        const string all(body(sand, "((0 0 0) (1 1 1))"));
        pointBox whole(box);
        whole.cut = false;
        boxOfPoints together(box, vector(2, 0, -9.81), all);
        boxOfPoints alone(whole, vector(2, 0, -9.81), all);
        together.run(0.1);
        alone.run(0.1);
        expectSame(together, alone);
    }
}


TEST(ParallelMaterialPoints, aCollapseInThreeDimensionsIsTheSame)
{
    expectAsAlone(false, true);
}


TEST(ParallelMaterialPoints, bodiesInContactAreTheSame)
{
    expectAsAlone(false, false, twoBodies);
    expectAsAlone(true, false, twoBodies);
}


TEST(ParallelMaterialPoints, bodiesInContactInThreeDimensionsAreTheSame)
{
    expectAsAlone(false, true, twoBodies);
}


TEST(ParallelMaterialPoints, aPointThatPassesAWholeRankIsNamed)
{
    if (Pstream::nProcs() < 4)
    {
        GTEST_SKIP() << "needs 4 ranks";
    }

    pointBox box;
    boxOfPoints block(box, Zero, body(elastic, "((0 0 0) (1 1 0.2))"));

    // From each quarter to the second next, that all ranks stop
    const scalar dt = 1e-3;
    const scalar way = Pstream::myProcNo() < 2 ? 0.5 : -0.5;
    for (vector& U : block.points().U)
    {
        U = vector(way/dt, 0, 0);
    }

    try
    {
        block.step(dt);
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        const std::string output(e.message());
        EXPECT_NE(output.find("past a whole rank"), std::string::npos) << output;
    }
}


TEST(ParallelMaterialPoints, pointsThatShiftOutOfWhatTheyOverfillAreTheSame)
{
    for (const bool repeats : {false, true})
    {
        auto together = pushedTogether(true, repeats);
        auto alone = pushedTogether(false, repeats);
        expectSame(*together, *alone);

        scalar top = 0;
        for (const point& x : alone->points().x)
        {
            top = max(top, x.z());
        }
        // From 0.2065 m
        EXPECT_GT(top, 0.22);
    }
}
