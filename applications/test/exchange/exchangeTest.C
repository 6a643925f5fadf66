// SPDX-License-Identifier: GPL-3.0-or-later
// Bringing grains to the ranks of their cells, and results back.

#include "foamCompatibility.H"
#include "grainExchange.H"
#include "otherMeshes.H"
#include "scatteredGrains.H"
#include "testNumber.H"

#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

testBox box()
{
    testBox b;
    b.cells = labelVector(8, 5, 6);
    return b;
}


//- Points of the unit cube, moved as skew() moves the mesh
pointField skewedPoints(const label n)
{
    pointField points(randomPoints(n));

    for (point& p : points)
    {
        p.x() += 0.4*p.z();
    }

    return points;
}


//- Every grain is on one rank, in the cell where OpenFOAM has it
void expectRightCells(testMesh& test, const pointField& places)
{
    standingGrains phase(test.mesh());
    place(phase, places, 0.01);

    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    EXPECT_EQ
    (
        returnReduce(exchange.grains().size(), sumOp<label>()),
        places.size()
    );
    EXPECT_EQ(exchange.nOutside(), 0);

    label nWrong = 0;
    for (const locatedGrain& grain : exchange.grains())
    {
        nWrong += grain.cell != test.mesh().findCell(places[grain.id]);
    }
    testNumber("grains in another cell", nWrong);
    EXPECT_EQ(nWrong, 0);
}


//- What is brought to the cells and back is what it was
void expectThereAndBack(testMesh& test)
{
    standingGrains phase(test.mesh());
    place(phase, randomPoints(500), 0.01);

    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    const List<vector> there(exchange.toCells(phase.grains.U));
    forAll(there, i)
    {
        EXPECT_EQ(there[i], exchange.grains()[i].velocity);
        EXPECT_EQ(there[i].x(), exchange.grains()[i].id);
    }

    const vectorField back
    (
        exchange.toPhase(vectorField(there), phase.size())
    );
    EXPECT_EQ(back, phase.grains.U);
}

//- Each of the places is on one rank, and in its cell or as near to it as the
//  faces are warped
void expectEachOnce(testMesh& test, const pointField& places)
{
    standingGrains phase(test.mesh());
    place(phase, places, 0.01);
    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    EXPECT_EQ(exchange.nOutside(), 0);
    EXPECT_EQ
    (
        returnReduce(exchange.grains().size(), sumOp<label>()),
        places.size()
    );

    scalar furthest = 0;
    labelList count(places.size(), Zero);

    for (const locatedGrain& grain : exchange.grains())
    {
        ++count[grain.id];
        if (!exchange.overlap().inside(grain.position, grain.cell))
        {
            furthest = max
            (
                furthest,
                exchange.walker().outside(grain.position, grain.cell)
              - exchange.walker().warp(grain.cell)
            );
        }
    }
    Pstream::listCombineGather(count, plusEqOp<label>());
    compatibility::broadcast(count);

    testNumber
    (
        "furthest from its cell, beyond the warp [m]",
        returnReduce(furthest, maxOp<scalar>())
    );
    EXPECT_LT(furthest, 1e-8);
    EXPECT_EQ(min(count), 1);
    EXPECT_EQ(max(count), 1);
}


//- Points of concave cells that the planes of their faces do not cover
void expectSliversFound()
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    movePoints
    (
        test.mesh(),
        [](const point& p) { return crumpled(p, 0.012); }
    );
    expectEachOnce(test, randomPoints(20000));
}


//- A mesh that reaches into a bin with the tip of one cell alone: places in the
//  tips of all cells, where each rank's cells end in slopes
void expectTipsFound()
{
    testBox b(box());
    b.cells = labelVector(8, 4, 4);
    testMesh test(b);
    const auto leaning = [](const point& p)
    {
        return point(p.x() + 0.37*p.y() + 0.21*p.z(), p.y() - 0.4*p.x(), p.z());
    };
    movePoints(test.mesh(), leaning);

    // Just inside of the corners of the mesh's cells
    DynamicList<point> tips;
    for (label cell = 0; cell < 8*4*4; ++cell)
    {
        const vector at(cell % 8, (cell/8) % 4, cell/32);
        for (label corner = 0; corner < 8; ++corner)
        {
            vector to;
            for (direction k = 0; k < 3; ++k)
            {
                to[k] = (at[k] + (corner & (1 << k) ? 1 - 1e-5 : 1e-5))/b.cells[k];
            }
            tips.append(leaning(to));
        }
    }
    expectEachOnce(test, pointField(std::move(tips)));
}

} // End anonymous namespace


TEST(grainExchange, findsEachPointOfConcaveCells)
{
    expectSliversFound();
}


TEST(grainExchange, findsPointsInTheTipsOfLeaningCells)
{
    expectTipsFound();
}


TEST(grainExchange, reportsThatAPlaceOutsideIsWithinTheBounds)
{
    testMesh test(box());
    movePoints(test.mesh(), bent);
    standingGrains phase(test.mesh());
    place(phase, pointField(1, point(0.02, 0.02, 0.5)), 0.01);
    grainExchange exchange(test.mesh());

    try
    {
        exchange.locate(phase);
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE
        (
            e.message().find("within these bounds, but in none of the cells"),
            std::string::npos
        );
    }
}


TEST(grainExchange, findsTheCellThatOpenFOAMFinds)
{
    testMesh test(box());
    expectRightCells(test, randomPoints(500));
}


TEST(grainExchange, findsTheCellInASkewedAndGradedMesh)
{
    testMesh test(box());
    skew(test.mesh());
    expectRightCells(test, skewedPoints(500));
}


TEST(grainExchange, ownsEachPointOfATwistedMesh)
{
    for (const scalar degrees : {15, 45, 90})
    {
        testMesh test(box());
        const auto twisted = [&](point p)
        {
            const scalar a = degToRad(degrees)*p.z();
            const scalar x = p.x() - 0.5;
            const scalar y = p.y() - 0.5;
            p.x() = 0.5 + Foam::cos(a)*x - Foam::sin(a)*y;
            p.y() = 0.5 + Foam::sin(a)*x + Foam::cos(a)*y;
            return p;
        };

        pointField corners(test.mesh().points());
        for (point& p : corners)
        {
            p = twisted(p);
        }
        test.mesh().movePoints(corners);

        // Inside of flat sides as well as of warped ones
        pointField places(randomPoints(20000));
        for (point& p : places)
        {
            p = twisted(point(0.5, 0.5, 0.5) + 0.9*(p - point(0.5, 0.5, 0.5)));
        }

        standingGrains phase(test.mesh());
        place(phase, places, 0.01);
        grainExchange exchange(test.mesh());
        exchange.locate(phase);

        EXPECT_EQ(exchange.grains().size(), places.size());
        EXPECT_EQ(exchange.nOutside(), 0);

        scalar furthest = 0;
        for (const locatedGrain& grain : exchange.grains())
        {
            const point& centre = test.mesh().cellCentres()[grain.cell];
            furthest = max(furthest, mag(grain.position - centre));
        }
        testNumber("largest distance from the centre of the cell", furthest);
        EXPECT_LT(furthest, 0.2);
    }
}


TEST(grainExchange, bringsValuesThereAndBack)
{
    testMesh test(box());
    expectThereAndBack(test);
}


TEST(grainExchange, aGrainOutsideIsAnErrorWithItsId)
{
    testMesh test(box());
    standingGrains phase(test.mesh());
    place(phase, pointField({{0.5, 0.5, 0.5}, {0.5, 1.2, 0.5}}), 0.01);
    grainExchange exchange(test.mesh());

    try
    {
        exchange.locate(phase);
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("Grain 1 is outside"), std::string::npos);
        EXPECT_NE(e.message().find("(0.5 1.2 0.5)"), std::string::npos);
    }
}


TEST(grainExchange, aGrainBeyondAPeriodicSideIsInTheCellOfItsImage)
{
    testBox b(box());
    b.patches = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    testMesh test(b);
    standingGrains phase(test.mesh());
    place(phase, pointField({{1.05, 0.5, 0.4}, {-2.95, 0.5, 0.4}}), 0.01);

    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    ASSERT_EQ(exchange.grains().size(), 2);
    EXPECT_NEAR(exchange.grains()[0].position.x(), 0.05, 1e-12);
    EXPECT_EQ
    (
        exchange.grains()[0].cell,
        test.mesh().findCell(point(0.05, 0.5, 0.4))
    );
    EXPECT_EQ(exchange.grains()[1].cell, exchange.grains()[0].cell);
}


TEST(ParallelGrainExchange, eachGrainIsOnOneRankInItsCell)
{
    testMesh test(box());
    expectRightCells(test, randomPoints(500));
}


TEST(ParallelGrainExchange, eachGrainIsInItsCellOfASkewedMesh)
{
    testMesh test(box());
    skew(test.mesh());
    expectRightCells(test, skewedPoints(500));
}


TEST(ParallelGrainExchange, bringsValuesThereAndBack)
{
    testMesh test(box());
    expectThereAndBack(test);
}


TEST(ParallelGrainExchange, eachPointOfConcaveCellsIsOnOneRank)
{
    expectSliversFound();
}


TEST(ParallelGrainExchange, pointsInTheTipsOfLeaningCellsAreOnOneRank)
{
    expectTipsFound();
}
