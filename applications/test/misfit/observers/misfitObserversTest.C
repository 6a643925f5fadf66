// SPDX-License-Identifier: GPL-3.0-or-later
// What misfitFoam reads off a run, and what a case cannot give, which is reported
// before the first.

#include "fakeCase.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitObservers, aRunThatEndsTooEarlyIsNoPrediction)
{
    const fakeCase c;
    c.write("r.csv", "t_s,y_m\n0,0\n1,2\n2,4\n3,6\n");
    c.write("system/controlDict", "endTime 3;\n");
    expectHolds(once(c, {withSlope(2)})[0].failure, "recorded until 3");
}


//- Of a run whose solver writes these lines below the names of its table
static List<prediction> whereItWrites(const std::string& lines)
{
    const fakeCase c;
    c.write("r.csv", "t_s,y_m\n0,0\n1,2\n2,4\n");
    c.write
    (
        "system/solver",
        "mkdir -p postProcessing/out/0\n"
        "printf '# Time y\\n" + lines + "' > postProcessing/out/0/out.dat\n"
    );
    return once(c, {withSlope(2)});
}


TEST(misfitObservers, commasMayStandBetweenTheNumbersOfATable)
{
    const prediction p(whereItWrites("0, 0\\n1, 2\\n2, 4\\n")[0]);
    EXPECT_EQ(p.failure, "");
    EXPECT_EQ(p.channels[0].y.last(), 4);
}


TEST(misfitObservers, aRowThatIsShorterThanItsHeadingIsReportedByItsLine)
{
    expectHolds
    (
        refusal([]() { whereItWrites("0\\n1 2\\n2 4\\n"); }), "Line 2 of the table"
    );
}


TEST(misfitObservers, aRunThatBeginsTooLateIsNoPrediction)
{
    // From its first step on, or from amid its first cell, is early enough
    for (const bool profile : {false, true})
    {
        for (const char* from : {"0.25", "1"})
        {
            const fakeCase c;
            c.write("r.csv", "t_s,y_m\n0,0\n1,2\n2,4\n");
            if (profile)
            {
                c.write("r.csv", "x_m,y_m\n0,0\n1,2\n2,4\n");
            }
            c.write
            (
                "system/solver",
                "mkdir -p postProcessing/out/0\n"
                "awk 'BEGIN { print \"# Time y\"; for (t = " + std::string(from)
              + "; t <= 2; t += 0.25) print t, 2*t }' > postProcessing/out/0/out.dat\n"
            );
            const std::string key("quantity        length;");
            fakePredictor p(c, dictWith(c, key, (profile ? "at 0; " : "") + key));
            const std::string failure(p({withSlope(2)})[0].failure);
            if (from[0] == '0')
            {
                EXPECT_EQ(failure, "");
            }
            else
            {
                expectHolds
                (
                    failure, "begins at 1 and the channel y was recorded from 0"
                );
            }
        }
    }
}


TEST(misfitObservers, aProbeOutsideTheMeshIsRefused)
{
    testMesh m;
    const auto probe = [&m](const std::string& place)
    {
        IStringStream is
        (
            "quantity pressure; uncertainty 1; place " + place
          + "; simulated { type probe; field p; }"
        );
        const channel c("S1", dictionary(is), purpose::calibration, "", 40);
        return refusal([&](){ checkPlaces(m.mesh(), {observer(c)}, "A"); });
    };
    EXPECT_EQ(probe("(0.5 0.5 0.5)"), "nothing");
    EXPECT_EQ(probe("(1 0.5 0.3)"), "nothing");
    EXPECT_EQ(probe("(1.05 0.5 0.3)"), "nothing");
    expectHolds(probe("(1.6 0.5 0.3)"), "S1 at");
}


TEST(misfitObservers, aRunThatBeganAnewReplacesWhatItHadWrittenFromThereOn)
{
    const fakeCase c;
    for (const char* start : {"0", "0.5", "10"})
    {
        mkDir(c.folder()/"postProcessing/S1"/start);
    }
    const std::string head("# Probe 0 (0 0 0)\n# Time\n");
    c.write("postProcessing/S1/0/U", head + "0 (1 2 3)\n0.5 (4 5 6)\n1 (7 8 9)\n");
    c.write("postProcessing/S1/0.5/U", head + "0.5 (4 50 6)\n2 (7 80 9)\n");
    c.write("postProcessing/S1/10/U", head + "10 (0 1e1 0)\n");
    IStringStream is
    (
        "quantity velocity; uncertainty 1; place (0 0 0);"
        " simulated { type probe; field U; component y; scale 2; offset -1; }"
    );
    const channel recorded
    (
        "S1", dictionary(is), purpose::calibration, c.folder(), 40
    );
    const series s(observer(recorded).read(c.folder()));
    EXPECT_EQ(s.x, scalarList({0, 0.5, 2, 10}));
    EXPECT_EQ(s.y, scalarList({3, 99, 159, 19}));

    c.write("postProcessing/S1/10/U", "# Probe 0 (0 0 0)  # Not Found\n10 (0 1 0)\n");
    expectHolds
    (
        refusal([&]() { observer(recorded).read(c.folder()); }), "outside the mesh"
    );
}


TEST(misfitObservers, aLevelIsTheShareOfWaterAlongItsLineTimesTheLength)
{
    const fakeCase c;
    mkDir(c.folder()/"postProcessing/H1/0");
    c.write("postProcessing/H1/0/alpha.water", "# Time\n0 0 0 0 0\n1 1 1 0.5 0\n");
    IStringStream is
    (
        "quantity length; uncertainty 1; place (1 0 0);"
        " simulated { type level; end (1 0 2); points 4; interval 5; }"
    );
    const channel recorded
    (
        "H1", dictionary(is), purpose::calibration, c.folder(), 40
    );
    const observer level(recorded);
    EXPECT_EQ(level.places[1], point(1, 0, 0.75));
    EXPECT_EQ(level.measured.get<label>("writeInterval"), 5);
    EXPECT_EQ(level.measured.get<pointField>("probeLocations"), level.places);
    EXPECT_EQ(level.read(c.folder()).y, scalarList({0, 1.25}));
}


TEST(misfitObservers, aNumberAloneIsTheLastLineOfItsTable)
{
    const fakeCase c;
    mkDir(c.folder()/"postProcessing/out/0");
    c.write("postProcessing/out/0/out.dat", "# Time y\n0 5\n1 6\n2 7\n");
    IStringStream is
    (
        "quantity length; uncertainty 1; value 3; unit mm;"
        " simulated { type table; function out; file out.dat; column y; }"
    );
    const channel recorded
    (
        "depth", dictionary(is), purpose::calibration, c.folder(), 40
    );
    const series s(observer(recorded).read(c.folder()));
    EXPECT_NEAR(recorded.sampled(s)[0], 7, 1e-12);
    EXPECT_NEAR(recorded.sampled(recorded.recorded)[0], 0.003, 1e-12);
}


TEST(misfitObservers, aProfileIsTheShareOfWaterInEachColumnOfCellsTimesTheHeight)
{
    // A column of two cells, the upper one of half the size, and one of a single cell
    const fakeCase c;
    mkDir(c.folder()/"postProcessing/view/0.5");
    c.write
    (
        "postProcessing/view/0.5/cells.dat",
        "# x y z size alpha speed\n"
        "0.1 0 0.1 0.2 1 0\n0.1 0 0.25 0.1 0.25 0\n0.3 0 0.1 0.2 0.5 0\n"
    );
    const auto profile = [&c](const std::string& height)
    {
        IStringStream is
        (
            "quantity length; uncertainty 0.01; at 0.5; file \"p.csv\";"
            " simulated { type profile; function view; height " + height + "; }"
        );
        c.write("p.csv", "x_m,y_m\n0.1,0.2\n0.2,0.15\n0.3,0.1\n");
        return channel("surface", dictionary(is), purpose::calibration, c.folder(), 40);
    };
    const channel recorded(profile("0.4"));
    const series s(observer(recorded).read(c.folder()));
    ASSERT_EQ(s.x.size(), 2);
    EXPECT_NEAR(s.x[0], 0.1, 1e-12);
    EXPECT_NEAR(s.y[0], 0.4*(8 + 0.25)/9, 1e-12);
    EXPECT_NEAR(s.x[1], 0.3, 1e-12);
    EXPECT_NEAR(s.y[1], 0.4*0.5, 1e-12);

    const channel low(profile("0"));
    expectHolds(refusal([&](){ observer o(low); }), "height");
}


TEST(misfitObservers, whatAnyRunCannotHaveIsReportedBeforeTheFirst)
{
    const fakeCase c;
    const fileName runs(c.folder()/"misfit"/"runs");

    // The error names the file that a person edits, not a copy
    const std::string message(refusalWith(c, "a/lift/model", "a/lift/modle"));
    expectHolds(message, c.folder()/"constant/model");
    expectHolds(message, "no entry a/lift/modle");
    EXPECT_TRUE(readDir(runs, fileName::DIRECTORY).empty());

    expectHolds
    (
        refusalWith(c, "\"true\"", "\"noSuchMesher\""), "no program 'noSuchMesher"
    );

    // A file that cannot be read has its name and line, and is the one in 0.orig
    c.write("0.orig/U", "internalField\n{\n    uniform\n");
    expectHolds
    (
        refusalWith(c, "constant/model", "0/U"), c.folder() + "/0.orig/U at line "
    );

    EXPECT_EQ(c.count(), 0);
    EXPECT_TRUE(readDir(runs, fileName::DIRECTORY).empty());
}


TEST(misfitObservers, aCaseThatEndsBeforeItsRecordingIsReportedBeforeTheFirst)
{
    const fakeCase c;
    c.write("system/controlDict", "#include \"more\"\nendTime 1.5;\n");
    fakePredictor p(c);
    const std::string message
    (
        outputDuring([&]() { p.predict.predict({withSlope(2), withSlope(3)}); })
    );
    expectHolds(message, "experiment A is 1.5 s");
    EXPECT_EQ(message.find("is 1.5 s"), message.rfind("is 1.5 s")) << message;

    // A command may have set another end
    EXPECT_EQ(c.count(), 2);

    // As the solver reads it
    const fakeCase other;
    other.write
    (
        "system/controlDict", "#include \"more\"\nendTime $deltaT;\n"
    );
    fakePredictor expanded(other);
    expectHolds
    (
        outputDuring([&]() { expanded.predict.predict({withSlope(2)}); }),
        "experiment A is 1 s"
    );

    // A command may put a number in the place of a word
    const fakeCase word;
    word.write("system/controlDict", "#include \"more\"\nendTime END;\n");
    fakePredictor later(word);
    const std::string output
    (
        outputDuring([&]() { later.predict.predict({withSlope(2)}); })
    );
    EXPECT_EQ(output.find("endTime"), std::string::npos) << output;
    EXPECT_EQ(word.count(), 1);
}


TEST(misfitObservers, otherWaterInAnotherMeshIsReportedOnce)
{
    const fakeCase c;
    c.write
    (
        "system/solver",
        contentOf(c.folder()/"system/solver")
      + "water=$(tr -dc '0-9.' < constant/water)\n"
        "echo \"Phase-1 volume fraction = $water  Min(alpha.water) = 0\"\n"
        "echo \"Phase-1 volume fraction = 0.2  Min(alpha.water) = 0\"\n"
    );
    c.write("constant/water", "water 0.3;\n");
    const auto message = [&](const std::string& inMesh)
    {
        fakePredictor p
        (
            c,
            "resolution { mesh ( { file \"constant/water\"; entry water; value "
          + inMesh + "; } ); } "
        );
        runState finer(withSlope(2));
        finer.resolution = "mesh";
        return outputDuring
        (
            [&]() { p.predict.predict({withSlope(2), finer, finer}); }
        );
    };
    expectLacks(message("0.301"), "more water");
    const std::string more(message("0.306"));
    expectHolds(more, "2 % more water");
    EXPECT_EQ(more.find("more water"), more.rfind("more water")) << more;
}


TEST(misfitObservers, whatIsFinishedIsReadWithoutItsPrograms)
{
    const fakeCase c;
    c.write("mesher", "#!/bin/sh\n");
    chMod(c.folder()/"mesher", 0755);
    const std::string path(getEnv("PATH"));
    setEnv("PATH", c.folder() + ":" + path, true);

    const dictionary dict(dictWith(c, "\"true\"", "\"\tmesher -all\""));
    const auto ends = [&]()
    {
        return fakePredictor(c, dict)({withSlope(2)})[0].channels[0].y.last();
    };
    EXPECT_EQ(ends(), 4);
    rm(c.folder()/"mesher");
    EXPECT_EQ(ends(), 4);
    setEnv("PATH", path, true);
    EXPECT_EQ(c.count(), 1);
}


TEST(misfitObservers, aRehearsalLeavesTheCaseAsItIs)
{
    // Both of its files U are 0/U in a run
    const fakeCase c;
    mkDir(c.folder()/"0");
    c.write("0/U", "other");
    const auto all = [&c]()
    {
        std::string text;
        for
        (
            const char* f :
            {"0.orig/U", "constant/model", "constant/script", "system/controlDict"}
        )
        {
            text += contentOf(c.folder()/f);
        }
        return text;
    };
    const std::string before(all());
    fakePredictor p
    (
        c,
        "files (\"0\"); experiments { A { use calibration; changes ("
        " { file \"constant/script\"; variable mu; value 0.3; } ); } }"
    );
    p.predict.predict({withSlope(2)});
    EXPECT_EQ(c.count(), 1);
    EXPECT_EQ(all(), before);
}


TEST(misfitObservers, aChannelThatNoTableMatchesIsRefused)
{
    const fakeCase c;
    const auto expect = [&c](const char* a, const char* b, const char* words)
    {
        expectHolds(refusalWith(c, a, b), words);
    };
    expect("out.dat", "no.dat", "wrote no numbers");
    expect("function        out", "function ou", "wrote nothing");
    expect("column          y", "column z", "no column \"z\"");
    expect("type            table", "type tabel", "table");
}
