// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of misfitFoam: nothing done twice, and what makes a run another one.

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
    EXPECT_EQ
    (
        runs("cat system/fvSchemes", "#include \"$FOAM_CASE/constant/chute\"\n"), 1
    );
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

    // The script writes its own again, and leaves that of another
    const fileName cutAlong(fileName("$INTERDEMFOAM_DIR/etc/cutAlong").expand());
    const std::string script
    (
        "cd '" + c.folder() + "' && . '" + cutAlong + "' && cutAlong 4"
    );
    ASSERT_EQ(Foam::system(script), 0);
    EXPECT_THROW(fakePredictor(c, "ranks 2; "), Foam::error);
    rm(c.folder()/"system/decomposeParDict");
    ASSERT_EQ(Foam::system(script), 0);
    expectHolds
    (
        contentOf(c.folder()/"system/decomposeParDict"), "numberOfSubdomains 4;"
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


TEST(misfitRuns, aCaseIsCutAsItStatesItself)
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


TEST(misfitRuns, theTimeThatIsLeftIsThatOfTheseRunsAndNotReportedAfterTheLast)
{
    const fakeCase c;
    fakePredictor solver(c, "jobs 1; ");
    const std::string output
    (
        outputDuring([&]() { solver({withSlope(1), withSlope(2)}); })
    );
    expectHolds(output, "1 of 2 runs, about 0 min");
    expectHolds(output, "s left for these\n");
    expectHolds(output, "2 of 2 runs\n");
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


TEST(misfitRuns, aScriptOutsideTheCaseThatChangedIsReported)
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
