// SPDX-License-Identifier: GPL-3.0-or-later
// How runs of misfitFoam end: what failed, was stopped or cut short is not taken for a
// result, and is tried again or goes on.

#include "fakeCase.H"
#include "terminalOutput.H"

#include "OSspecific.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitRunEnds, aRunThatIsStoppedReportsThatItIsGoneOnWith)
{
    const fakeCase c;
    mkDir(c.folder()/"one"/"case");
    c.write("one/commands", "sleep 9\n");
    const auto stop = [&]()
    {
        Foam::system
        (
            "cd '" + c.folder() + "' && RANKS=1 TIME_LIMIT=20 RUNS=1 STARTED=0"
            " timeout 3 \"$INTERDEMFOAM_DIR/etc/misfitRun\" one"
        );
    };
    expectHolds(outputDuring(stop), "one is stopped; the next call goes on with it");
    EXPECT_FALSE(isFile(c.folder()/"one/finished"));
}


TEST(misfitRunEnds, aRunThatWasCutShortInItsSolverGoesOn)
{
    const std::string later("startFrom latestTime; endTime 2;\n");
    const auto mark = [](const fakeCase& c)
    {
        const fileName runs(c.folder()/"misfit/runs");
        const fileName run(runs/readDir(runs, fileName::DIRECTORY).first());
        rm(run/"finished");
        writeWhole(run/"case/state", "1 s\n");
        return run;
    };
    struct cutShort
    {
        std::string control;
        std::string extra;
        bool goesOn;
    };
    for (const cutShort& run :
        {
            cutShort{later, "", true},
            cutShort{"endTime 2;\n", "", true},
            cutShort{"startFrom startTime; endTime 2;\n", "", false},
            cutShort{later, "ranks", false},
            cutShort{later, "programs", false},
            cutShort{later, "commands", false}
        })
    {
        const fakeCase c;
        c.write("system/controlDict", run.control);
        once(c, {withSlope(2)});
        const fileName folder(mark(c));
        if (run.extra == "ranks")
        {
            rm(folder/"ranks");
        }
        else if (run.extra.size())
        {
            writeWhole(folder/run.extra, "others\n");
        }
        const std::string output(outputDuring([&]() { once(c, {withSlope(2)}); }));
        EXPECT_EQ(isFile(folder/"case/state"), run.goesOn) << run.control << run.extra;
        EXPECT_EQ(output.find("1 were cut short") != std::string::npos, run.goesOn);
        EXPECT_EQ(c.count(), 2);
    }
}


TEST(misfitRunEnds, aCrashIsKeptWithItsReason)
{
    const fakeCase c;
    const auto p(once(c, {withSlope(9), withSlope(2)}));
    EXPECT_TRUE(p[1].ok());
    expectHolds(p[0].failure, "time step is too long");
}


TEST(misfitRunEnds, whatFailedIsTriedOnceMoreByANewCallOnly)
{
    const fakeCase c;
    const char* again = "1 failed in an earlier call";
    {
        fakePredictor first(c);
        first({withSlope(9), withSlope(2)});
        const std::string output(outputDuring([&]() { first({withSlope(9)}); }));
        expectLacks(output, again);
        EXPECT_EQ(c.count(), 2);
    }

    const auto callAnew = [&]()
    {
        const prediction p(once(c, {withSlope(9), withSlope(2)})[0]);
        expectHolds(p.failure, "time step is too long");
    };
    expectHolds(outputDuring(callAnew), again);
    EXPECT_EQ(c.count(), 3);
    expectLacks(outputDuring(callAnew), again);
    EXPECT_EQ(c.count(), 3);
}


TEST(misfitRunEnds, whatWasStoppedFromOutsideIsTriedByEachCall)
{
    const fakeCase c;
    for (label call = 1; call < 4; ++call)
    {
        EXPECT_FALSE(once(c, {withSlope(7)})[0].ok());
        EXPECT_EQ(c.count(), call);
    }
}


TEST(misfitRunEnds, aSolverThatWasRequestedToStopHasNoResult)
{
    const fakeCase c;
    EXPECT_FALSE(once(c, {withSlope(4)})[0].ok());
    EXPECT_TRUE(once(c, {withSlope(4)})[0].ok());
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRunEnds, thatItWasStoppedDoesNotCountAsItsFirstFailure)
{
    const fakeCase c;
    for (label call = 1; call < 5; ++call)
    {
        EXPECT_FALSE(once(c, {withSlope(5)})[0].ok());
        EXPECT_EQ(c.count(), min(call, 3));
    }
}


TEST(misfitRunEnds, aRunWhoseEndCouldNotBeWrittenIsNoResult)
{
    // As on a full disk
    const fakeCase c;
    c.write("full", "");
    expectHolds
    (
        refusal([&]() { once(c, {withSlope(2), withSlope(6)}); }), "misfit/runs"
    );
    EXPECT_EQ(c.count(), 2);

    rm(c.folder()/"full");
    const fileName runs(c.folder()/"misfit/runs");
    for (const fileName& run : readDir(runs, fileName::DIRECTORY))
    {
        rmDir(runs/run/"finished.new", true);
    }
    const auto p(once(c, {withSlope(2), withSlope(6)}));
    EXPECT_TRUE(p[0].ok() && p[1].ok());
    EXPECT_EQ(p[1].channels[0].y, scalarList({0, 6, 12}));
    EXPECT_EQ(c.count(), 3);
}


TEST(misfitRunEnds, aRunWhoseEndIsEmptyOrMissingDidNotGoWell)
{
    const fakeCase c;
    once(c, {withSlope(2)});
    const fileName runs(c.folder()/"misfit/runs");
    const fileName run(runs/readDir(runs, fileName::DIRECTORY).first());
    std::ofstream(run/"finished").close();
    EXPECT_TRUE(once(c, {withSlope(2)})[0].ok());
    EXPECT_EQ(c.count(), 2);

    const runStore store(c.folder(), c.dict());
    EXPECT_NE(store.failure({"never done", nullptr}), "");
}


TEST(misfitRunEnds, aRunThatCannotBeReadHasFailed)
{
    const fakeCase c;
    c.write
    (
        "system/solver",
        "slope=$(sed -n 's/.*slope  *\\([0-9.]*\\);.*/\\1/p' constant/model)\n"
        "mkdir -p postProcessing/out/0\n"
        "[ $slope = 2 ] && y=y || y=z\n"
        "printf \"# Time $y\n0 1\n1 1\n2 1\n\" > postProcessing/out/0/out.dat\n"
    );
    const auto p(once(c, {withSlope(2), withSlope(3)}));
    EXPECT_TRUE(p[0].ok());
    expectHolds(p[1].failure, "no column");
}


TEST(misfitRunEnds, aRunBeyondItsTimeHasFailed)
{
    const fakeCase c;
    const auto within = [&](const std::string& limit)
    {
        fakePredictor predict(c, "timeLimit " + limit + "; ");
        return predict({withSlope(8)})[0];
    };
    const prediction p(within("1"));
    expectHolds(p.failure, "longer than 1 s");

    // The same limit would end it again, a longer one may not
    EXPECT_FALSE(within("1").ok());
    EXPECT_EQ(c.count(), 1);
    EXPECT_TRUE(within("60").ok());
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRunEnds, aRunThatBeginsAtItsStartIsDoneAnew)
{
    const fakeCase c;
    c.write("system/controlDict", "startFrom startTime; endTime 2;\n");
    once(c, {withSlope(2)});
    const fileName runs(c.folder()/"misfit/runs");
    for (const fileName& run : readDir(runs, fileName::DIRECTORY))
    {
        rm(runs/run/"finished");
        std::ofstream(runs/run/"case/postProcessing/out/0/out.dat") << "half";
    }
    fakePredictor predict(c);
    EXPECT_EQ(predict({withSlope(2)})[0].channels[0].y, scalarList({0, 2, 4}));
    EXPECT_EQ(c.count(), 2);
}
