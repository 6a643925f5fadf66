// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: points do not take more room than there is.

#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- phi_m 0.64, at the start
const string debris
(
    "law dilatantMuI; density 1728; solidDensity 2700; grainDiameter 0.001;"
    " E 1e6; nu 0.3; staticFriction 0.4; limitFriction 0.8; b 0.31;"
    " maxSolidFraction 0.64; a 1.23; dilation 1; viscosity 5e-3;"
);


//- Largest solid fraction around a node that no wall is near over phi_m
scalar fullest(const boxOfPoints& method)
{
    const pointSet& p = method.points();
    const pointGrid& grid = method.grid();
    nodeLanes sum(grid.nNodes(), lanes(lanes::Zero()));
    const lanes flat[2] = {lanes::Zero(), lanes::Zero()};

    forAll(p.x, i)
    {
        splineStencil<2>(grid, p.x[i]).add
        (
            sum, lanes(p.mass[i]/1728, 0, 0, 0), flat
        );
    }

    scalar result = 0;
    for (const lanes& node : sum)
    {
        result = max(result, node[0]/grid.cubeVolume(grid.h()));
    }
    return result;
}


//- A block on a slippery base that is drawn out to 6.9 times its length; returns
//  the largest of fullest() on the way
scalar fullestOfDrawnOut(const string& settings)
{
    pointBox box;
    box.length = 5;
    box.height = 0.6;
    boxOfPoints block
    (
        box, down, body(debris, "((0 0 0) (0.5 1 0.4))", settings)
    );
    pointSet& p = block.points();
    forAll(p.x, i)
    {
        p.gradient[i].xx() = 4;
        p.U[i].x() = 4*p.x[i].x();
    }

    scalar result = 0;
    for (label n = 0; n < 8; ++n)
    {
        block.run(0.12);
        result = max(result, fullest(block));
    }

    scalar front = 0;
    for (const point& x : p.x)
    {
        front = max(front, x.x());
    }
    EXPECT_GT(front, 3.4);
    return result;
}


//- A block far from all walls whose points have been pushed together to three
//  quarters of their height, without a change of their volumes, and which moves
autoPtr<boxOfPoints> pushedTogether(const string& settings = "shifting on;")
{
    pointBox box;
    box.height = 0.8;
    autoPtr<boxOfPoints> block
    (
        new boxOfPoints
        (
            box,
            Zero,
            body(debris, "((0.3 0 0.2) (0.7 1 0.6))", settings)
        )
    );
    pointSet& p = block->points();
    forAll(p.x, i)
    {
        p.x[i].z() = 0.4 + 0.75*(p.x[i].z() - 0.4);
        p.U[i] = vector(0.3, 0, 0.1*p.x[i].x());
    }
    return block;
}

//- Each point is where it was, to the last bit, after some time; they may be sorted
void expectStays(boxOfPoints& bed)
{
    const DynamicList<point> before(bed.points().x);
    labelList where(before.size());
    forAll(bed.points().id, i)
    {
        where[bed.points().id[i]] = i;
    }

    bed.run(0.05);

    forAll(bed.points().x, i)
    {
        ASSERT_EQ(bed.points().x[i], before[where[bed.points().id[i]]]);
    }
}

} // End anonymous namespace


TEST(pointShifts, aBlockThatIsDrawnOutDoesNotOverfillTheGrid)
{
    const scalar APIC = fullestOfDrawnOut("shifting on;");
    const scalar averaged = fullestOfDrawnOut("shifting on; densityAveraging on;");
    const scalar FLIP = fullestOfDrawnOut
    (
        "shifting on; transfer { model FLIP; }"
    );
    testNumber("fullest node over the largest packing, APIC", APIC);
    testNumber("the same, densityAveraging", averaged);
    testNumber("the same, FLIP", FLIP);

    EXPECT_LT(APIC, 1.1);
    EXPECT_LT(averaged, 1.1);
    EXPECT_LT(FLIP, 1.1);

    // What this would be otherwise
    const scalar without = fullestOfDrawnOut("");
    testNumber("the same, without shifts", without);
    EXPECT_GT(without, 1.5);
}


TEST(pointShifts, pointsLeaveWhatTheyOverfillWithTheirMomentum)
{
    auto block = pushedTogether();
    const vector before(block->momentum());
    EXPECT_GT(fullest(*block), 1.3);

    block->run(0.2);

    EXPECT_LT(fullest(*block), 1.06);
    EXPECT_LT(mag(block->momentum() - before), 1e-12*mag(before));

    auto without = pushedTogether("");
    without->run(0.2);
    EXPECT_GT(fullest(*without), 1.3);
}


TEST(pointShifts, whatFillsABoxToItsWallsStaysWhereItIs)
{
    // To the base, both sides and half of the height, where half of the room of the
    // nodes at the walls is behind these
    for (const bool solid : {false, true})
    {
        pointBox box;
        box.solid = solid;
        box.width = 0.2;
        boxOfPoints bed
        (
            box, Zero, body(debris, "((0 0 0) (1 1 0.5))", "shifting on;")
        );
        expectStays(bed);
    }
}


TEST(pointShifts, aLayerAtAWallThatIsTooThinForItsPointsRises)
{
    // Two rows of points in the height of one: the nodes at the base have half of
    // the room of others
    pointBox box;
    box.repeats = true;
    boxOfPoints layer
    (
        box, Zero, body(debris, "((0 0 0) (1 1 0.1))", "shifting on;")
    );
    for (point& x : layer.points().x)
    {
        x.z() *= 0.5;
    }

    layer.run(0.3);

    scalar top = 0;
    for (const point& x : layer.points().x)
    {
        top = max(top, x.z());
    }
    testNumber("topmost point of 0.0875 m in a settled layer [m]", top);
    EXPECT_GT(top, 0.075);
    EXPECT_LT(top, 0.1);
}


TEST(pointShifts, looseMaterialTakesNoMoreRoomThanWhenItCloses)
{
    // Volumes that have grown threefold in flight: what lies below stays
    pointBox box;
    box.repeats = true;
    boxOfPoints bed
    (
        box, Zero, body(debris, "((0 0 0) (1 1 0.5))", "shifting on;")
    );
    for (scalar& V : bed.points().volume)
    {
        V *= 3;
    }
    expectStays(bed);
}


TEST(pointShifts, aBedInContactWithWhatOverfillsItselfStays)
{
    // A slab on a bed, pushed together to three quarters of its height
    pointBox box;
    box.repeats = true;
    const string ofBody(debris + " region { box ");
    boxOfPoints both
    (
        box,
        Zero,
        "shifting on; contact { friction 0.3; } bodies { bed { " + ofBody
      + "((0 0 0) (1 1 0.3)); } } slab { " + ofBody + "((0 0 0.3) (1 1 0.5)); } } }"
    );
    pointSet& p = both.points();
    List<point> before(p.size() + 1);
    forAll(p.x, i)
    {
        if (p.body[i] == 1)
        {
            p.x[i].z() = 0.3 + 0.75*(p.x[i].z() - 0.3);
        }
        before[p.id[i]] = p.x[i];
    }

    both.run(0.05);

    scalar ofBed = 0;
    scalar ofSlab = 0;
    forAll(p.x, i)
    {
        scalar& most = p.body[i] == 0 ? ofBed : ofSlab;
        most = max(most, mag(p.x[i] - before[p.id[i]]));
    }
    EXPECT_EQ(ofBed, 0);
    EXPECT_GT(ofSlab, 0.01);
}
