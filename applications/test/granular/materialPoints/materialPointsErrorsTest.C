// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: what is wrong with the entries of material points is named.

#include "otherMeshes.H"
#include "testPointsPhase.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(materialPointsPhase, whatIsWrongIsNamed)
{
    testMesh box(slice());
    const fvMesh& mesh = box.mesh();
    const string here("box ((0 0 0) (0.2 1 0.2));");

    const auto output = [&](const string& region, const string& rest)
    {
        return refusal([&]() { points(mesh, region, rest); });
    };

    EXPECT_NE(output(here, "outflow (noSuch);").find("noSuch"), std::string::npos);
    EXPECT_NE(output(here, "courant 2;").find("courant is 2"), std::string::npos);
    EXPECT_NE(output(here, "cellsize 2;").find("cellsize"), std::string::npos);
    EXPECT_NE(output(here, "contact {}").find("only sand"), std::string::npos);
    EXPECT_NE
    (
        output
        (
            "box ((0 0 0) (0.2 1 0.2)); } walls { friction 1;", ""
        ).find("has walls of its own"),
        std::string::npos
    );
    EXPECT_NE
    (
        output("box ((5 5 5) (6 6 6));", "").find("holds no point"),
        std::string::npos
    );
    EXPECT_NE
    (
        output("box ((0 0 0.2) (0.2 1 0));", "").find("the lower one"),
        std::string::npos
    );
    EXPECT_NE
    (
        output(here, "transfer { model PIC; }").find("APIC FLIP"),
        std::string::npos
    );
    EXPECT_NE
    (
        output("box ((0 0 0) (0.2 1 0.2)); } } clay 5; more { none {", "")
            .find("Entry clay of bodies"),
        std::string::npos
    );
}


TEST(materialPointsPhase, stepsThatAreVeryManyAreReported)
{
    testMesh box(slice());
    const auto output = [&](const string& E, const string& rest)
    {
        return outputDuring
        (
            [&]()
            {
                points
                (
                    box.mesh(),
                    "box ((0 0 0) (0.2 1 0.2)); } " + E + " settling {",
                    rest
                );
            }
        );
    };

    // Waves of 27 m/s in cells of 20 mm
    expectLacks(output("", ""), "stable");
    expectHolds(output("", "timeStep 1e-3;"), "exchange every 10 steps = 0.01 s, in 35");
    expectHolds(output("E 1e14;", ""), "steps until endTime");
    expectLacks(output("E 1e8;", ""), "Warning");
}


TEST(materialPointsPhase, aFrictionOfWhatIsNoWallIsNamed)
{
    // zMax is a patch through which fluid flows
    testMesh box(slice());
    const auto output = [&](const string& walls)
    {
        const string text
        (
            "granularPhase materialPoints; materialPoints { cellSize 0.02;"
            " walls { frictions { " + walls + " 0.5; } }"
            " bodies { sand { " + sand
          + " region { box ((0 0 0) (0.2 1 0.2)); } } } }"
        );
        return refusal([&]()
        {
            granularPhase::New
            (
                box.mesh(), dictionary(IStringStream(text)()), down, 10
            );
        });
    };

    EXPECT_EQ(output("zMin"), "nothing");
    EXPECT_NE(output("zMax").find("zMax"), std::string::npos) << output("zMax");
}


TEST(materialPointsPhase, aNegativeFrictionOfABodyIsNamed)
{
    testMesh box(slice());
    const std::string output
    (
        refusal([&]()
        {
            points
            (
                box.mesh(),
                "box ((0 0 0) (0.2 1 0.2)); } } clay { " + sand
              + " walls { frictions { zMin -1; } }"
                " region { box ((0.4 0 0) (0.5 1 0.2));",
                "contact {}"
            );
        })
    );

    EXPECT_NE
    (
        output.find("friction of wall zMin for body clay is -1"),
        std::string::npos
    ) << output;
}
