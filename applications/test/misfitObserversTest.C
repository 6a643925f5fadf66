// SPDX-License-Identifier: GPL-3.0-or-later
// What misfitFoam reads off a run, and what a case cannot give, which is reported
// before the first.

#include "fakeCase.H"
#include "placesInMesh.H"
#include "saidDuring.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitObservers, aRunThatEndsTooEarlyIsNoPrediction)
{
    const fakeCase c;
    c.write("r.csv", "t_s,y_m\n0,0\n1,2\n2,4\n3,6\n");
    c.write("system/controlDict", "endTime 3;\n");
    fakePredictor predict(c);
    EXPECT_NE
    (
        predict({withSlope(2)})[0].failure.find("recorded until 3"),
        std::string::npos
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
            const dictionary dict(dictWith(c, key, (profile ? "at 0; " : "") + key));
            const recordings r(dict, c.folder());
            solverPredictor p(r, c.folder(), dict);
            const std::string failure(p.predict({withSlope(2)})[0].failure);
            EXPECT_EQ(failure.empty(), from[0] == '0') << failure;
            EXPECT_TRUE
            (
                failure.empty()
             || failure.find("begins at 1 and the channel y was recorded from 0")
             != std::string::npos
            ) << failure;
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
    EXPECT_NE(probe("(1.6 0.5 0.3)").find("S1 at"), std::string::npos);
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

    const std::string message
    (
        refusal([&](){ const channel low(profile("0")); observer o(low); })
    );
    EXPECT_NE(message.find("height"), std::string::npos) << message;
}


TEST(misfitObservers, whatAnyRunCannotHaveIsToldBeforeTheFirst)
{
    const fakeCase c;
    const auto said = [&c](const std::string& old, const std::string& wrong)
    {
        return refusalWith(c, old, wrong);
    };
    const fileName runs(c.folder()/"misfit"/"runs");

    // In the file that a person mends, not in a copy
    const std::string message(said("a/lift/model", "a/lift/modle"));
    EXPECT_NE(message.find(c.folder()/"constant/model"), std::string::npos)
        << message;
    EXPECT_NE(message.find("no entry a/lift/modle"), std::string::npos) << message;
    EXPECT_TRUE(readDir(runs, fileName::DIRECTORY).empty());

    EXPECT_NE
    (
        said("\"true\"", "\"noSuchMesher\"").find("no program 'noSuchMesher"),
        std::string::npos
    );

    // A file that cannot be read has its name and line, and is the one in 0.orig
    c.write("0.orig/U", "internalField\n{\n    uniform\n");
    const std::string file(c.folder() + "/0.orig/U at line ");
    const std::string unread(said("constant/model", "0/U"));
    EXPECT_NE(unread.find(file), std::string::npos) << unread;

    EXPECT_EQ(c.count(), 0);
    EXPECT_TRUE(readDir(runs, fileName::DIRECTORY).empty());
}


TEST(misfitObservers, aCaseThatEndsBeforeItsRecordingIsToldOfBeforeTheFirst)
{
    const fakeCase c;
    c.write("system/controlDict", "#include \"more\"\nendTime 1.5;\n");
    fakePredictor p(c);
    const std::string message
    (
        saidDuring([&]() { p.predict.predict({withSlope(2), withSlope(3)}); })
    );
    const auto first = message.find("experiment A is 1.5 s");
    EXPECT_NE(first, std::string::npos) << message;
    EXPECT_EQ(message.find("is 1.5 s", first + 20), std::string::npos) << message;

    // A command may have set another end
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitObservers, otherWaterInAnotherMeshIsToldOfOnce)
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
        return saidDuring
        (
            [&]() { p.predict.predict({withSlope(2), finer, finer}); }
        );
    };
    EXPECT_EQ(message("0.301").find("more water"), std::string::npos);
    const std::string more(message("0.306"));
    const auto first = more.find("2 % more water");
    EXPECT_NE(first, std::string::npos) << more;
    EXPECT_EQ(more.find("more water", first + 20), std::string::npos) << more;
}


TEST(misfitObservers, whatIsFinishedIsReadWithoutItsPrograms)
{
    const fakeCase c;
    c.write("mesher", "#!/bin/sh\n");
    chMod(c.folder()/"mesher", 0755);
    const std::string path(getEnv("PATH"));
    setEnv("PATH", c.folder() + ":" + path, true);

    OStringStream os;
    c.dict().write(os, false);
    std::string text(os.str());
    text.replace(text.find("\"true\""), 6, "\"\tmesher -all\"");
    IStringStream is(text);
    const dictionary dict(is);
    const recordings recorded(dict, c.folder());
    const auto ends = [&]()
    {
        return solverPredictor(recorded, c.folder(), dict)
            .predict({withSlope(2)}).first().channels[0].y.last();
    };
    EXPECT_EQ(ends(), 4);
    rm(c.folder()/"mesher");
    EXPECT_EQ(ends(), 4);
    setEnv("PATH", path, true);
    EXPECT_EQ(c.count(), 1);
}


TEST(misfitObservers, aRehearsalLeavesTheCaseAsItIs)
{
    const fakeCase c;
    const auto all = [&c]()
    {
        std::string text;
        for (const char* f : {"constant/model", "constant/script", "system/controlDict"})
        {
            text += contentOf(c.folder()/f);
        }
        return text;
    };
    const std::string before(all());
    fakePredictor p
    (
        c,
        "experiments { A { use calibration; changes ("
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
        const std::string message(refusalWith(c, a, b));
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    expect("out.dat", "no.dat", "wrote no numbers");
    expect("function        out", "function ou", "wrote nothing");
    expect("column          y", "column z", "no column \"z\"");
    expect("type            table", "type tabel", "table");
}
