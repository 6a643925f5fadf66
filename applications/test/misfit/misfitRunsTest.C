// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of misfitFoam: nothing done twice, nothing that failed or was cut short taken for
// a result.

#include "fakeCase.H"
#include "terminalOutput.H"

#include "OSspecific.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitRuns, aStateIsRunAndRead)
{
    const fakeCase c;
    fakePredictor predict(c);
    const auto p(predict({withSlope(2), withSlope(3, 0.5)}));
    ASSERT_TRUE(p[0].ok() && p[1].ok());
    EXPECT_EQ(p[0].channels[0].y, scalarList({0, 2, 4}));
    EXPECT_EQ(p[1].channels[0].y, scalarList({0.5, 3.5, 6.5}));
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, aFinishedRunIsNeverDoneAgain)
{
    const fakeCase c;
    once(c, {withSlope(2), withSlope(2)});
    EXPECT_EQ(c.count(), 1);

    // By another program later
    once(c, {withSlope(2), withSlope(2, 0)});
    EXPECT_EQ(c.count(), 1);

    // A changed template is another case
    c.write("constant/other", "new");
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, aSpareDictionaryMakesNoOtherRuns)
{
    const fakeCase c;
    const std::string header("FoamFile { version 2.0; object misfitDict; }\n");
    once(c, {withSlope(2)});
    c.write("system/misfitDict.levels", header);
    c.write("system/misfitDict.spare", header);
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 1);

    // What a run reads makes others
    c.write("system/more", "deltaT 1;\n#include \"misfitDict.spare\"\n");
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 2);
    c.write("system/misfitDict.spare", header + "endTime 2;\n");
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 3);

    // As does what that may include, and another file by any name
    c.write("system/misfitDict.levels", header + "deltaT 1;\n");
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 4);
    c.write("system/misfitDict.other", "object other;\n");
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 5);
}


TEST(misfitRuns, aDictionaryOfAProgramWithACopiedHeaderIsPartOfTheRun)
{
    const fakeCase c;
    const std::string header("FoamFile { version 2.0; object misfitDict; }\n");
    c.write("system/setFieldsDict", header + "level 1;\n");
    once(c, {withSlope(2)});
    c.write("system/setFieldsDict", header + "level 2;\n");
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, aSpareDictionaryThatARunMayReadIsPartOfIt)
{
    const std::string header("FoamFile { object misfitDict; }\n");
    const auto runs = [&](const std::string& command, const std::string& more)
    {
        const fakeCase c;
        c.write("system/misfitDict.third", header);
        c.write("system/beside", more);
        const std::string commands
        (
            "commands (\"true " + command + "\" \"bash system/solver\"); "
        );
        fakePredictor(c, commands)({withSlope(2)});
        c.write("system/misfitDict.third", header + "more 1;\n");
        fakePredictor(c, commands)({withSlope(2)});
        return c.count();
    };
    for (const std::string command :
        {
            "cat system/misfitDict.third", "cp system/*", "cat system/misfit*",
            "cat system/m?sfitDict.third", "cp -r system x", "find system", "cd system/"
        })
    {
        EXPECT_EQ(runs(command, ""), 2) << command;
    }
    EXPECT_EQ(runs("", "#include \"misfitDict.$scene\"\n"), 2);
    EXPECT_EQ(runs("", "#include \"$name\"\n"), 2);
    EXPECT_EQ(runs("", "cat system/$1\n"), 2);

    // A folder in a variable, as $FOAM_CASE, hides no name
    EXPECT_EQ(runs("cat system/fvSchemes", "#include \"$FOAM_CASE/constant/chute\"\n"), 1);
}


TEST(misfitRuns, aCommandMayHaveAPath)
{
    const fakeCase c;
    c.write("system/prepare", "#!/bin/bash\necho y >> $PWD/../../../../count\n");
    chMod(c.folder()/"system/prepare", 0755);
    fakePredictor f
    (
        c, "commands (\"./system/prepare\" \"bash system/solver\"); "
    );
    EXPECT_TRUE(f({withSlope(3)}).first().ok());
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, aCaseThatIsCutIntoOtherPartsThanRanksIsRefused)
{
    const fakeCase c;
    c.write("system/decomposeParDict", "numberOfSubdomains 4; method scotch;\n");
    expectHolds
    (
        refusal([&]() { const fakePredictor p(c, "ranks 2; "); }),
        "into 4 parts, and ranks"
    );
    c.write
    (
        "system/decomposeParDict",
        "// Cuts along the chute\nnumberOfSubdomains 4; method simple;\n"
    );
    EXPECT_NO_THROW(fakePredictor(c, "ranks 2; "));
}


TEST(misfitRuns, whatCannotBeReadAsAFileIsNotCopied)
{
    const fakeCase c;
    ln("nowhere", c.folder()/"system"/".#misfitDict");
    c.write("constant/fixed", "as it is\n");
    chMod(c.folder()/"constant/fixed", 0444);
    fakePredictor f(c, "files (\"constant/fixed\"); ");
    EXPECT_TRUE(f({withSlope(3)}).first().ok());
}


TEST(misfitRuns, aCaseIsCutAsItSaysItself)
{
    // Without a mesh that is as far as it comes
    const std::string own("numberOfSubdomains 2; method scotch;\n");
    for (const bool has : {true, false})
    {
        const fakeCase c;
        if (has)
        {
            c.write("system/decomposeParDict", own);
        }
        fakePredictor predict(c, "ranks 2; ");
        EXPECT_FALSE(predict({withSlope(3)}).first().ok());
        const fileName runs(c.folder()/"misfit"/"runs");
        const std::string cut
        (
            contentOf
            (
                runs/readDir(runs, fileName::DIRECTORY).first()
               /"case/system/decomposeParDict"
            )
        );
        EXPECT_EQ(cut == own, has) << cut;
        expectHolds(cut, "numberOfSubdomains 2;");
    }
}


TEST(misfitRuns, runsOfOtherProgramsAreNotUsedWithoutAWord)
{
    const fakeCase c;
    const string before(getEnv("FOAM_USER_LIBBIN"));
    mkDir(c.folder()/"lib");
    c.write("lib/libmine.so", "one");
    setEnv("FOAM_USER_LIBBIN", c.folder()/"lib", true);
    const auto message = [&](const scalar slope = 2)
    {
        return outputDuring
        (
            [&]() { EXPECT_TRUE(once(c, {withSlope(slope)}).first().ok()); }
        );
    };
    const char* changed = "libraries changed";
    expectLacks(message(), changed);
    expectLacks(message(), changed);
    c.write("lib/libmine.so", "two");
    expectLacks(message(3), changed);
    expectHolds(message(), changed);
    setEnv("FOAM_USER_LIBBIN", before, true);
}


TEST(misfitRuns, theTimeThatIsLeftIsThatOfTheseRunsAndNotToldAfterTheLast)
{
    const fakeCase c;
    fakePredictor ask(c, "jobs 1; ");
    const std::string output(outputDuring([&]() { ask({withSlope(1), withSlope(2)}); }));
    expectHolds(output, "1 of 2 runs, about 0 min");
    expectHolds(output, "s left for these\n");
    expectHolds(output, "2 of 2 runs\n");
}


TEST(misfitRuns, aRunThatIsStoppedTellsThatItIsGoneOnWith)
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


TEST(misfitRuns, aRunThatWasCutShortInItsSolverGoesOn)
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


TEST(misfitRuns, aCrashIsKeptWithItsReason)
{
    const fakeCase c;
    const auto p(once(c, {withSlope(9), withSlope(2)}));
    EXPECT_TRUE(p[1].ok());
    expectHolds(p[0].failure, "time step is too long");
}


TEST(misfitRuns, whatFailedIsTriedOnceMoreByANewCallOnly)
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


TEST(misfitRuns, whatWasStoppedFromOutsideIsTriedByEachCall)
{
    const fakeCase c;
    for (label call = 1; call < 4; ++call)
    {
        EXPECT_FALSE(once(c, {withSlope(7)})[0].ok());
        EXPECT_EQ(c.count(), call);
    }
}


TEST(misfitRuns, aSolverThatWasAskedToStopHasNoResult)
{
    const fakeCase c;
    EXPECT_FALSE(once(c, {withSlope(4)})[0].ok());
    EXPECT_TRUE(once(c, {withSlope(4)})[0].ok());
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, thatItWasStoppedDoesNotCountAsItsFirstFailure)
{
    const fakeCase c;
    for (label call = 1; call < 5; ++call)
    {
        EXPECT_FALSE(once(c, {withSlope(5)})[0].ok());
        EXPECT_EQ(c.count(), min(call, 3));
    }
}


TEST(misfitRuns, aRunWhoseEndCouldNotBeWrittenIsNoResult)
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


TEST(misfitRuns, aRunWhoseEndIsEmptyOrMissingDidNotGoWell)
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


TEST(misfitRuns, aCaseThatIsEditedMeanwhileIsNotRun)
{
    const fakeCase c;
    const std::string before(contentOf(c.folder()/"constant/script"));
    {
        fakePredictor f(c);
        f({withSlope(2)});
        c.write("constant/script", before + "run 1\n");

        const std::string message(refusal([&]() { f({withSlope(3)}); }));
        expectHolds(message, "was changed");
        expectHolds(message, "constant/script");
        expectLacks(message, "constant/model");
        const auto makeCorrected = [&]()
        {
            f.predict.makeCase(withSlope(3), c.folder()/"misfit/corrected");
        };
        expectHolds(refusal(makeCorrected), "was changed");
        EXPECT_EQ(c.count(), 1);
    }

    // As it is now it is another case, and as it was it goes on
    once(c, {withSlope(2)});
    EXPECT_EQ(c.count(), 2);
    c.write("constant/script", before);
    once(c, {withSlope(2), withSlope(3)});
    EXPECT_EQ(c.count(), 3);
}


TEST(misfitRuns, aScriptOutsideTheCaseThatChangedIsToldOf)
{
    const fakeCase c;
    const auto output = [&](const std::string& words)
    {
        return outputDuring
        (
            [&]()
            {
                fakePredictor f
                (
                    c, "commands (\"bash " + words + "\" \"bash system/solver\"); "
                );
                EXPECT_TRUE(f({withSlope(2)}).first().ok());
            }
        );
    };
    for (const std::string& folder : {c.folder() + "/", std::string("../../../../")})
    {
        c.write("prepare", "true\n");
        output("-e " + folder + "prepare");
        expectLacks(output("-e " + folder + "prepare"), "changed");
        c.write("prepare", "echo\n");
        expectHolds(output("-e " + folder + "prepare"), "changed");
    }
}


TEST(misfitRuns, aRunThatCannotBeReadHasFailed)
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


TEST(misfitRuns, aMeshThatTheCommandsDoNotMakeIsPartOfTheRun)
{
    const fakeCase c;
    mkDir(c.folder()/"constant/polyMesh");
    const auto runsWith = [&c](const std::string& program)
    {
        const label before = c.count();
        const std::string command("\"true " + program + '"');
        fakePredictor(c, dictWith(c, "\"true\"", command))({withSlope(2)});
        return c.count() - before;
    };
    c.write("constant/polyMesh/points", "1");
    runsWith("checkMesh");
    runsWith("blockMesh");
    c.write("constant/polyMesh/points", "2");
    EXPECT_EQ(runsWith("checkMesh"), 1);
    EXPECT_EQ(runsWith("blockMesh"), 0);
}


TEST(misfitRuns, theCaseOfAStateIsMadeForAPerson)
{
    const fakeCase c;
    fakePredictor predict(c);
    const fileName target(c.folder()/"misfit/corrected");
    mkDir(target);
    c.write("misfit/corrected/old", "");
    predict.predict.makeCase(withSlope(3, 0.5), target);
    expectHolds(contentOf(target/"constant/model"), "strength        0.5;");
    EXPECT_TRUE(isFile(target/"0/U"));
    EXPECT_FALSE(isFile(target/"old"));
    EXPECT_EQ(c.count(), 0);
}


TEST(misfitRuns, aRunBeyondItsTimeHasFailed)
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


TEST(misfitRuns, aRunThatBeginsAtItsStartIsDoneAnew)
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
