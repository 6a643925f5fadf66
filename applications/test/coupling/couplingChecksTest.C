// SPDX-License-Identifier: GPL-3.0-or-later
// Errors, warnings and reports of grains beside the fluid.

#include "boxOfWater.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;


TEST(granularProperties, warnsOfDragThatIsSmoothedForMaterialPoints)
{
    const std::string points
    (
        "#remove (LIGGGHTS granularPhase)\ngranularPhase materialPoints;\n"
        "materialPoints { cellSize 0.1; bodies { sand { law linearElastic;"
        " density 1500; E 1e6; nu 0.2; region { box ((0.2 0.2 0.2) (0.4 0.4 0.4)); }"
        " } } }\n"
    );
    const auto output = [&](const std::string& smoothing, const std::string& drag)
    {
        boxOfWater w
        (
            points + "voidFraction { smoothing { " + smoothing + " } }\n"
            "interphaseForces { drag { model " + drag + "; } }"
        );
        return outputDuring([&]{ demCoupling(w.box().mesh(), hydrostatics(g)); });
    };
    const std::string remedy("Write  drag off;");

    expectHolds(output("", "Beetstra"), remedy);
    expectHolds(output("width 2;", "Beetstra"), remedy);
    expectLacks(output("drag off;", "Beetstra"), remedy);
    expectLacks(output("drag on;", "Beetstra"), remedy);
    expectLacks(output("model none;", "Beetstra"), remedy);
    expectLacks(output("", "none"), remedy);

    boxOfWater byDefault(points);
    expectHolds
    (
        outputDuring([&]{ demCoupling(byDefault.box().mesh(), hydrostatics(g)); }), remedy
    );

    boxOfWater ofGrains("interphaseForces { drag { model Beetstra; } }");
    expectLacks
    (
        outputDuring([&]{ demCoupling(ofGrains.box().mesh(), hydrostatics(g)); }), remedy
    );
}


TEST(demCoupling, grainsThatAllStartOutsideAreAnErrorAlsoWhereTheyMayLeave)
{
    boxOfWater w("LIGGGHTS { walls { patches (zMin); } outflow (zMax); }");
    w.placeGrains(5);
    EXPECT_THROW(demCoupling(w.box().mesh(), hydrostatics(g)), Foam::error);
    EXPECT_THROW(demCoupling(w.box().mesh(), g), Foam::error);
}


TEST(demCoupling, grainsAloneReportTheirNumberAtEachTimeWritten)
{
    boxOfWater w;
    const demCoupling coupling(w.box().mesh(), g);
    const std::string output(outputDuring([&]{ coupling.report(); }));

    EXPECT_NE(output.find("Grains: 4 = 4 located + 0 outside"), std::string::npos)
        << output;
    EXPECT_EQ(output.find("Exchange"), std::string::npos) << output;
}


TEST(demCoupling, refusesFormerAndUnknownKeysOfItsDictionary)
{
    const auto error = [](const std::string& entry)
    {
        boxOfWater w(entry);
        return refusal
        (
            [&]{ demCoupling(w.box().mesh(), hydrostatics(g)); }
        );
    };

    EXPECT_NE
    (
        error("porosity { model caps; }").find("Write voidFraction"),
        std::string::npos
    );
    EXPECT_NE(error("poresity { }").find("Valid keywords"), std::string::npos);
    EXPECT_NE
    (
        error("exchange { interval 0; }").find("1 or more"), std::string::npos
    );
}


TEST(demCoupling, warnsOfLoneSlowGrainsThatDragTheirCellAlong)
{
    const auto output = [](const scalar mu, const std::string& smoothing)
    {
        boxOfWater w("voidFraction { smoothing { " + smoothing + " } }");
        demCoupling coupling(w.box().mesh(), hydrostatics(g));
        fluidFields fluid(w.water());
        fluid.mu = mu;
        return outputDuring([&]{ coupling.start(fluid); });
    };

    // 1.59 d over a cell of 0.25 m, and the bell of 60 mm
    expectHolds(output(100, ""), "move up to 9.2");
    expectLacks(output(100, "width 60;"), "too fast");
    expectLacks(output(1e-3, ""), "too fast");
}
