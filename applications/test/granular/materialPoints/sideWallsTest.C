// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: friction of the walls on both sides of a plane of material points.

#include "terminalOutput.H"
#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar friction = 0.5;
constexpr scalar width = 0.5;
constexpr scalar depth = 0.2;
constexpr scalar nu = 0.3;


//- An infinite elastic layer at rest on a smooth base, between side walls
class layerBetweenWalls
:
    public boxOfPoints
{
    static pointBox shape()
    {
        pointBox box;
        box.repeats = true;
        box.length = 0.1;
        box.height = 0.3;
        box.h = 0.0125;
        return box;
    }

public:

    explicit layerBetweenWalls(const string& transfer)
    :
        boxOfPoints
        (
            shape(),
            down,
            body
            (
                "law linearElastic; density 1000; E 1e6; nu 0.3;",
                "((0 0 0) (0.1 1 0.2))",
                transfer + " sideWalls { friction 0.5; width 0.5; }"
            )
        )
    {
        run(0.5, 20);
    }

    scalar speed() const
    {
        return momentum().x()/sum(scalarField(points().mass));
    }
};

} // End anonymous namespace


TEST(sideWalls, brakeALayerByTheLoadOnThemWithin2Percent)
{
    // Across the plane a layer bears nu/(1 - nu) of its weight
    const scalar braking = friction*nu/(1 - nu)*9.81*depth/width;

    for (const string transfer : {"", "transfer { model FLIP; share 1; }"})
    {
        layerBetweenWalls layer(transfer);
        layer.setGravity(down);
        for (vector& U : layer.points().U)
        {
            U.x() = 0.3;
        }

        const scalar t = 0.2;
        layer.run(t);
        const scalar ratio = (0.3 - layer.speed())/(braking*t);
        testNumber("braking over that of Coulomb, APIC, then FLIP", ratio);
        EXPECT_NEAR(ratio, 1, 0.02);
    }
}


TEST(sideWalls, bringALayerToRestAndHoldItThere)
{
    for (const string transfer : {"", "transfer { model FLIP; share 0.98; }"})
    {
        layerBetweenWalls layer(transfer);
        for (vector& U : layer.points().U)
        {
            U.x() = 0.1;
        }
        layer.run(0.5);
        layer.setGravity(onSlope(3));
        layer.run(0.5);
        const point before(average(vectorField(layer.points().x)));
        layer.run(0.5);
        EXPECT_LT(mag(average(vectorField(layer.points().x)) - before), 1e-5);
    }
}


TEST(sideWalls, withoutFrictionChangeNoBit)
{
    vectorField places[2];
    for (const label walls : {0, 1})
    {
        boxOfPoints column
        (
            pointBox(),
            down,
            body
            (
                sand,
                "((0 0 0) (0.3 1 0.5))",
                walls ? "sideWalls { friction 0; width 1; }" : ""
            )
        );
        column.run(0.2);
        places[walls] = vectorField(column.points().x);
    }
    EXPECT_EQ(places[0], places[1]);
}


TEST(sideWalls, areRefusedInSpaceAndWithoutTheirWidth)
{
    pointBox space;
    space.solid = true;
    const auto wordsOf = [](const pointBox& box, const string& walls)
    {
        return refusal
        (
            [&]()
            {
                boxOfPoints(box, down, body(elastic, "((0 0 0) (1 1 0.2))", walls));
            }
        );
    };
    const std::string inSpace(wordsOf(space, "sideWalls { friction 0.5; width 1; }"));
    EXPECT_NE(inSpace.find("are those of a plane"), std::string::npos) << inSpace;

    for
    (
        const string walls
      : {
            "sideWalls { friction 0.5; }", "sideWalls { width 1; }",
            "sideWalls { friction 0; width -1; }", "sideWalls { friction -1; width 1; }"
        }
    )
    {
        const std::string words(wordsOf(pointBox(), walls));
        EXPECT_NE(words.find("Give both"), std::string::npos) << words;
    }
}
