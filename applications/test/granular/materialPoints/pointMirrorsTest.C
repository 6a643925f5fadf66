// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: nodes behind a rough wall mirror the flow of material points.

#include "testNumber.H"
#include "testPoints.H"
#include "testWalls.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const scalar h = sliceCell;


//- The node at a place
label nodeAt(const pointGrid& grid, const scalar x, const scalar z)
{
    FixedList<label, 3> at(0);
    for (label k = 0; k < 2; ++k)
    {
        at[k] = pointGrid::cell(grid.coordinate(point(x, 0.05, z), k));
    }
    return grid.node(at);
}


//- A column of three nodes over a base of some friction: behind, at and before
//  it. The node before it moves with 3 m/s, the others as given
struct column
{
    pointGrid grid;
    pointWalls walls;
    nodeLanes nodes;
    label behind;
    label at;
    label before;

    column(const scalar friction, const vector2D& moving)
    :
        grid(slice()),
        walls(grid),
        nodes(grid.nNodes(), lanes(lanes::Zero())),
        behind(nodeAt(grid, 0.5, -h)),
        at(nodeAt(grid, 0.5, 0)),
        before(nodeAt(grid, 0.5, h))
    {
        addFace
        (
            walls, walls.add("base", friction), vector2D(0, 0), vector2D(1, 0)
        );
        walls.findNodes();
        nodes[behind] = lanes(0.03, moving.x(), moving.y(), 0);
        nodes[at] = lanes(1, 0.1, -0.2, 0);
        nodes[before] = lanes(2, 3, 0.5, 0);
    }
};


//- Points of a layer without stress that is sheared at a rate [1/s]
autoPtr<boxOfPoints> sheared
(
    const pointBox& box,
    const vector& g,
    const vector& rate,
    const string& settings = body(elastic, "((0 0 0) (1 1 0.5))")
)
{
    autoPtr<boxOfPoints> layer(new boxOfPoints(box, g, settings));
    pointSet& p = layer->points();
    forAll(p.x, i)
    {
        p.U[i] = rate*p.x[i].z();
        p.gradient[i] = rate*vector(0, 0, 1);
    }
    return layer;
}


//- A box that repeats, with a rough base
pointBox rough()
{
    pointBox box;
    box.repeats = true;
    box.base = 10;
    return box;
}

} // End anonymous namespace


TEST(pointMirrors, aNodeBehindARoughWallTakesTheOppositeOfTheFlowBeforeIt)
{
    column c(10, vector2D(-1, -0.4));
    c.walls.apply(c.nodes, 0, true);

    EXPECT_NEAR(c.nodes[c.behind][1], -3, 1e-14);
    EXPECT_EQ(c.nodes[c.behind][2], 0);
    EXPECT_EQ(c.nodes[c.at][1], 0);
    EXPECT_EQ(c.nodes[c.at][2], 0);
    EXPECT_EQ(c.nodes[c.before][1], 3);

    // Both count as impulse on the wall and on the points
    const vector impulse(c.walls.impulse()[0]);
    EXPECT_NEAR(impulse.x(), 0.03*2 + 0.1, 1e-15);
    EXPECT_NEAR(impulse.z(), -0.03*0.4 - 0.2, 1e-15);
    nodeLanes atNodes(c.nodes.size(), lanes(lanes::Zero()));
    for (const auto& at : c.walls.impulses(0, 0))
    {
        atNodes[at.node] += at.impulse;
    }
    EXPECT_NEAR(atNodes[c.behind][1], -0.03*2, 1e-15);
    EXPECT_NEAR(atNodes[c.behind][2], 0.03*0.4, 1e-15);
    EXPECT_NEAR(atNodes[c.at][1], -0.1, 1e-15);
}


TEST(pointMirrors, theNodeBehindTakesNoMoreThanCoulombAllows)
{
    column c(0.3, vector2D(-1, -0.4));
    c.walls.apply(c.nodes, 0, true);
    EXPECT_NEAR(c.nodes[c.behind][1], -1 - 0.3*0.4, 1e-14);
    EXPECT_NEAR(c.nodes[c.at][1], 0.1 - 0.3*0.2, 1e-14);

    // What slides on a wall has all of Coulomb's friction at both
    const vector impulse(c.walls.impulse()[0]);
    EXPECT_NEAR(impulse.x(), -0.3*impulse.z(), 1e-15);
}


TEST(pointMirrors, thereIsNoneWithoutFrictionNorWhereTheNodeMovesAway)
{
    column smooth(0, vector2D(-1, -0.4));
    smooth.walls.apply(smooth.nodes, 0, true);
    EXPECT_EQ(smooth.nodes[smooth.behind][1], -1);

    column away(10, vector2D(-1, 0.4));
    away.walls.apply(away.nodes, 0, true);
    EXPECT_EQ(away.nodes[away.behind][1], -1);
    EXPECT_EQ(away.nodes[away.behind][2], 0.4);
}


TEST(pointMirrors, onlyNodesACellBehindAFaceOnALineOfTheGridMirror)
{
    // A step up at x = 0.5 that is two cells high, a wall two cells thick that
    // stands on it from x = 0.7, and sides
    const pointGrid grid(slice());
    pointWalls walls(grid);
    const label wall = walls.add("wall", 1);
    const List<vector2D> corners
    ({
        {0, 1}, {0, 0}, {0.5, 0}, {0.5, 0.1}, {0.7, 0.1}, {0.7, 0.6},
        {0.8, 0.6}, {0.8, 0.1}, {1, 0.1}, {1, 1}
    });
    for (label i = 1; i < corners.size(); ++i)
    {
        addFace(walls, wall, corners[i - 1], corners[i]);
    }
    walls.findNodes();

    const auto mirror = [&](const scalar x, const scalar z)
    {
        return walls.mirrorOf(nodeAt(grid, x, z));
    };

    // Under the low base and the high one, beside the step and the side
    EXPECT_EQ(mirror(0.25, -h), nodeAt(grid, 0.25, h));
    EXPECT_EQ(mirror(h, -h), nodeAt(grid, h, h));
    EXPECT_EQ(mirror(0.6, 0.1 - h), nodeAt(grid, 0.6, 0.1 + h));
    EXPECT_EQ(mirror(-h, 0.5), nodeAt(grid, h, 0.5));
    EXPECT_EQ(mirror(1 + h, 0.5), nodeAt(grid, 1 - h, 0.5));

    // In a corner, at an edge that stands out, in a thin wall, further behind
    EXPECT_EQ(mirror(0, -h), -1);
    EXPECT_EQ(mirror(-h, -h), -1);
    EXPECT_EQ(mirror(0.5 + h, 0.1 - h), -1);
    EXPECT_EQ(mirror(0.75, 0.4), -1);
    EXPECT_EQ(mirror(0.25, -2*h), -1);
    EXPECT_EQ(mirror(0.25, 0), -1);
    EXPECT_EQ(mirror(0.25, h), -1);
}


TEST(pointMirrors, anInclinedWallAndOneOffTheLinesBrakeAtMostToRest)
{
    for (const scalar rise : {0.3, 0.0})
    {
        const pointGrid grid(slice());
        pointWalls walls(grid);
        const label wall = walls.add("wall", 10);
        addFace(walls, wall, vector2D(0, 0.23), vector2D(1, 0.23 + rise));
        walls.findNodes();

        nodeLanes nodes(grid.nNodes(), lanes(1, 3, -0.5, 0));
        walls.apply(nodes, 0, true);
        label braked = 0;
        for (label i = 0; i < grid.nNodes(); ++i)
        {
            EXPECT_EQ(walls.mirrorOf(i), -1);
            if (walls.isHeld(i))
            {
                ++braked;
                EXPECT_EQ(nodes[i][1], 0);
            }
        }
        EXPECT_GT(braked, 20);
    }
}


TEST(pointMirrors, aLayerThatIsShearedOverARoughBaseKeepsItsRateDownToTheBase)
{
    const string one(body(elastic, "((0 0 0) (1 1 0.5))"));

    // Side by side; each body mirrors its own flow
    const string two
    (
        "contact {} bodies { a { " + elastic
      + "region { box ((0 0 0) (0.5 1 0.5)); } } b { " + elastic
      + "region { box ((0.5 0 0) (1 1 0.5)); } } }"
    );

    for (const label kind : {0, 1, 2})
    {
        pointBox box(rough());
        box.solid = kind == 2;
        box.h = kind == 2 ? 0.1 : h;
        box.width = kind == 2 ? 0.3 : 0.1;
        const vector rate(7, kind == 2 ? -3 : 0, 0);

        auto layer = sheared(box, down, rate, kind == 1 ? two : one);
        const pointSet& p = layer->points();
        const scalar whole = mag(layer->momentum());
        layer->step(1e-5);

        scalar off = 0;
        forAll(p.x, i)
        {
            const tensor& L = p.gradient[i];
            off = max(off, mag(vector(L.xz(), L.yz(), 0) - rate)/mag(rate));
        }
        testNumber("largest error of the rate of shear after a step", off);
        EXPECT_LT(off, 1e-12);

        // There is no stress yet, and so no force along the base
        const vector impulse(layer->walls().impulse()[0]);
        EXPECT_LT(mag(vector(impulse.x(), impulse.y(), 0)), 1e-12*whole);
    }
}


TEST(pointMirrors, theLowestCellOfAFlowOverARoughBaseShearsAsThoseAboveIt)
{
    // mu(I) on a chute of 24 degrees, 10 cells deep, after half a second
    pointBox box;
    box.repeats = true;
    box.h = 0.02;
    box.length = 0.08;
    box.height = 0.3;
    box.base = 10;
    boxOfPoints layer
    (
        box,
        onSlope(24),
        body
        (
            "law dilatantMuI; density 1484; solidDensity 2650;"
            " grainDiameter 0.01; E 1e6; nu 0.2; staticFriction 0.382;"
            " limitFriction 0.643; b 0.31; maxSolidFraction 0.5; a 1.23;"
            " dilation 0; U (0.84 0 0);",
            "((0 0 0) (1 1 0.2))"
        )
    );
    layer.run(0.5);

    scalarField rate(10, Zero);
    forAll(layer.points().x, i)
    {
        const label cell = min(label(layer.points().x[i].z()/box.h), 9);
        rate[cell] += layer.points().gradient[i].xz();
    }
    // In Bagnold's profile it rises with the root of the depth
    const scalar ratio = rate[0]/rate[2]*std::sqrt(15.0/19.0);
    testNumber("shear of the lowest cell over that of Bagnold", ratio);
    EXPECT_NEAR(ratio, 1, 0.05);
}


TEST(pointMirrors, aLayerThatSlidesHasTheFrictionOfCoulomb)
{
    pointBox box;
    box.repeats = true;
    box.base = 0.3;
    boxOfPoints layer
    (
        box, onSlope(24), body(sand, "((0 0 0) (1 1 0.3))")
    );
    layer.run(0.2, 20);
    layer.walls().resetImpulse();
    layer.run(0.3);

    const vector impulse(layer.walls().impulse()[0]);
    const scalar ratio = mag(impulse.x()/impulse.z())/0.3;
    testNumber("friction over that of Coulomb", ratio);
    EXPECT_NEAR(ratio, 1, 1e-3);
}


TEST(pointMirrors, momentumIsThatOfWeightAndWallsWhileALayerIsSheared)
{
    for (const scalar friction : {0.05, 10.0})
    {
        pointBox box(rough());
        box.base = friction;
        auto layer = sheared
        (
            box,
            onSlope(20),
            vector(2, 0, 0),
            body(sand, "((0 0 0) (1 1 0.5))")
        );
        const pointSet& p = layer->points();
        scalar mass = 0;
        for (const scalar m : p.mass)
        {
            mass += m;
        }

        vector expected(layer->momentum());
        scalar most = 0;
        const scalar dt = layer->stableStep();
        for (label i = 0; i < 200; ++i)
        {
            layer->walls().resetImpulse();
            layer->step(dt);
            const vector impulse(layer->walls().impulse()[0]);
            expected += dt*mass*onSlope(20) - impulse;
            most = max(most, mag(layer->momentum() - expected));

            // In all no more than Coulomb, and the points know of all
            EXPECT_LE(mag(impulse.x()), -friction*impulse.z()*(1 + 1e-12));
        }
        testNumber("momentum that is not accounted for", most/mag(expected));
        EXPECT_LT(most, 1e-12*mag(expected));
    }
}
