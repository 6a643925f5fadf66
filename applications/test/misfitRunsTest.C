// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of misfitFoam: cases changed as asked, nothing done twice, nothing that
// failed or was cut short taken for a result. A few lines of shell stand for
// the solver.

#include "solverPredictor.H"
#include "saidDuring.H"
#include "temporaryFolder.H"
#include "testMesh.H"
#include "placesInMesh.H"

#include "IFstream.H"
#include "IStringStream.H"
#include "OSspecific.H"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- What is in a file
std::string content(const fileName& file)
{
    std::ifstream is(file);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}


//- A case whose "solver" writes a line: time, slope*time + lift; it counts its
//  runs in a file beside the case
class fakeCase
{
    const temporaryFolder scratch_;

    const fileName folder_ = scratch_;

public:

    fakeCase()
    {
        for (const char* part : {"0.orig", "constant", "system"})
        {
            mkDir(folder_/part);
        }
        write("0.orig/U", "uniform");
        write("system/controlDict", "#include \"more\"\nendTime 2;\n");
        write("system/more", "deltaT 1;\n");
        write("constant/model", "a { slope 2; lift { model none; } }\n");
        write("constant/script", "variable mu equal 0.5\nfix 1 mu ${mu}\n");
        write
        (
            "system/solver",
            "value() { sed -n \"s/.*$1  *\\([0-9.]*\\);.*/\\1/p\" constant/model; }\n"
            "slope=$(value slope); lift=$(value strength)\n"
            "echo x >> " + folder_ + "/count\n"
            "[ \"$slope\" != 9 ] || { echo the time step is too long; exit 3; }\n"
            "[ \"$slope\" != 8 ] || sleep 4\n"
            "[ \"$slope\" != 7 ] || kill -TERM $$\n"
            "[ \"$slope\" != 5 ] || { [ $(wc -l < " + folder_ + "/count) -gt 1 ]"
            " || kill -TERM $$; exit 3; }\n"
            "[ \"$slope\" != 6 ] || [ ! -e " + folder_ + "/full ] \\\n"
            "    || mkdir ../finished.new\n"
            "mkdir -p postProcessing/out/0 1\n"
            "awk -v k=$slope -v l=${lift:-0} 'BEGIN { print \"# Time y\";"
            " for (t = 0; t <= 2; ++t) print t, k*t + l }'"
            " > postProcessing/out/0/out.dat\n"
        );
        write("r.csv", "t_s,y_m\n0,0\n1,2\n2,4\n");
    }

    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder_/name) << text;
    }

    fileName folder() const
    {
        return folder_;
    }

    //- Number of runs that were begun
    label count() const
    {
        const std::string lines(content(folder_/"count"));
        return std::count(lines.begin(), lines.end(), '\n');
    }

    dictionary dict(const std::string& more = "") const
    {
        IStringStream is
        (
            "commands (\"true\" \"bash system/solver\"); jobs 2; " + more
          + "channels { y { file \"r.csv\"; quantity length; uncertainty 0.1;"
            " simulated { type table; function out; file out.dat; column y; } } }"
            "parameters { slope { mean 2; deviation 1; bounds (0 10);"
            " changes ( { file \"constant/model\"; entry \"a/slope\"; } ); } }"
            "candidates { lift { strengths (0.5 1); changes ("
            " { file \"constant/model\"; entry \"a/lift/model\"; value LunLiu; }"
            " { file \"constant/model\"; entry \"a/lift/strength\"; add true; }"
            " ); } }"
        );
        return dictionary(is);
    }
};


runState withSlope(const scalar slope, const scalar lift = 0)
{
    runState s;
    s.parameters.insert("slope", slope);
    s.strengths.insert("lift", lift);
    return s;
}


//- The predictor of a fake case and what it needs
struct fakePredictor
{
    dictionary dict;
    recordings recorded;
    solverPredictor predict;

    explicit fakePredictor(const fakeCase& c, const std::string& more = "")
    :
        dict(c.dict(more)),
        recorded(dict, c.folder()),
        predict(recorded, c.folder(), dict)
    {}

    List<prediction> operator()(const List<runState>& states)
    {
        return predict.predict(states);
    }
};


//- Predictions by a program that ends then
List<prediction> once(const fakeCase& c, const List<runState>& states)
{
    fakePredictor predict(c);
    return predict(states);
}


std::string refusal(const std::function<void()>& f)
{
    try
    {
        f();
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "nothing";
}


//- The dictionary of the case with other words
dictionary dictWith
(
    const fakeCase& c,
    const std::string& old,
    const std::string& other
)
{
    OStringStream os;
    c.dict().write(os, false);
    std::string text(os.str());
    text.replace(text.find(old), old.size(), other);
    IStringStream is(text);
    return dictionary(is);
}


//- What is said of the case where its dictionary has other words
std::string refusalWith
(
    const fakeCase& c,
    const std::string& old,
    const std::string& other
)
{
    return refusal
    (
        [&]()
        {
            const dictionary dict(dictWith(c, old, other));
            const recordings r(dict, c.folder());
            solverPredictor(r, c.folder(), dict).predict({withSlope(2)});
        }
    );
}


caseChange change(const std::string& text)
{
    IStringStream is(text);
    return caseChange(dictionary(is));
}

} // End anonymous namespace


TEST(misfitRuns, anEntryIsChangedAndIncludesStay)
{
    const fakeCase c;
    change("file \"system/controlDict\"; entry endTime; scale 2; offset 1;")
        .apply(c.folder(), 3);
    const std::string text(content(c.folder()/"system/controlDict"));
    EXPECT_NE(text.find("#include"), std::string::npos) << text;
    EXPECT_NE(text.find("\"more\""), std::string::npos) << text;

    IFstream is(c.folder()/"system/controlDict");
    const dictionary dict(is);
    EXPECT_EQ(dict.get<scalar>("endTime"), 7);
    EXPECT_EQ(dict.get<scalar>("deltaT"), 1);
}


TEST(misfitRuns, aVariableOfAScriptIsChanged)
{
    const fakeCase c;
    change("file \"constant/script\"; variable mu;").apply(c.folder(), 0.25);
    EXPECT_EQ
    (
        content(c.folder()/"constant/script"),
        "variable mu equal 0.25\nfix 1 mu ${mu}\n"
    );
}


TEST(misfitRuns, whatIsNotThereCannotBeChanged)
{
    const fakeCase c;
    const auto said = [&c](const std::string& text)
    {
        return refusal([&](){ change(text).apply(c.folder(), 1); });
    };
    EXPECT_NE
    (
        said("file \"constant/model\"; entry \"a/slop\";").find("add true"),
        std::string::npos
    );
    EXPECT_NE
    (
        said("file \"constant/none\"; entry x;").find("has no file"),
        std::string::npos
    );
    EXPECT_NE
    (
        said("file \"constant/script\"; variable nu;").find("0 lines"),
        std::string::npos
    );
}


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
    const std::string told
    (
        refusal([&]() { const fakePredictor p(c, "ranks 2; "); })
    );
    EXPECT_NE(told.find("into 4 parts, and ranks"), std::string::npos) << told;
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
            content
            (
                runs/readDir(runs, fileName::DIRECTORY).first()
               /"case/system/decomposeParDict"
            )
        );
        EXPECT_EQ(cut == own, has) << cut;
        EXPECT_NE(cut.find("numberOfSubdomains 2;"), std::string::npos);
    }
}


TEST(misfitRuns, runsOfOtherProgramsAreNotUsedWithoutAWord)
{
    const fakeCase c;
    const string before(getEnv("FOAM_USER_LIBBIN"));
    mkDir(c.folder()/"lib");
    c.write("lib/libmine.so", "one");
    setEnv("FOAM_USER_LIBBIN", c.folder()/"lib", true);
    const auto told = [&](const scalar slope = 2)
    {
        return saidDuring
        (
            [&]() { EXPECT_TRUE(once(c, {withSlope(slope)}).first().ok()); }
        );
    };
    const char* changed = "libraries changed";
    EXPECT_EQ(told().find(changed), std::string::npos);
    EXPECT_EQ(told().find(changed), std::string::npos);
    c.write("lib/libmine.so", "two");
    EXPECT_EQ(told(3).find(changed), std::string::npos);
    EXPECT_NE(told().find(changed), std::string::npos);
    setEnv("FOAM_USER_LIBBIN", before, true);
}


TEST(misfitRuns, aCrashIsKeptWithItsReason)
{
    const fakeCase c;
    {
        fakePredictor predict(c);
        const auto p(predict({withSlope(9), withSlope(2)}));
        EXPECT_FALSE(p[0].ok());
        EXPECT_TRUE(p[1].ok());
        EXPECT_NE(p[0].failure.find("time step is too long"), std::string::npos);
    }
}


TEST(misfitRuns, whatFailedIsTriedOnceMoreByANewCallOnly)
{
    const fakeCase c;
    const char* again = "1 failed in an earlier call";
    {
        fakePredictor first(c);
        first({withSlope(9), withSlope(2)});
        const std::string said(saidDuring([&]() { first({withSlope(9)}); }));
        EXPECT_EQ(said.find(again), std::string::npos) << said;
        EXPECT_EQ(c.count(), 2);
    }

    const auto callAnew = [&]()
    {
        const prediction p(once(c, {withSlope(9), withSlope(2)})[0]);
        EXPECT_NE(p.failure.find("time step is too long"), std::string::npos);
    };
    EXPECT_NE(saidDuring(callAnew).find(again), std::string::npos);
    EXPECT_EQ(c.count(), 3);
    EXPECT_EQ(saidDuring(callAnew).find(again), std::string::npos);
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
    const std::string told
    (
        refusal([&]() { once(c, {withSlope(2), withSlope(6)}); })
    );
    EXPECT_NE(told.find("misfit/runs"), std::string::npos) << told;
    EXPECT_EQ(c.count(), 2);

    rm(c.folder()/"full");
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
    const std::string before(content(c.folder()/"constant/script"));
    {
        fakePredictor f(c);
        f({withSlope(2)});
        c.write("constant/script", before + "run 1\n");

        const std::string told(refusal([&]() { f({withSlope(3)}); }));
        EXPECT_NE(told.find("was changed"), std::string::npos) << told;
        EXPECT_NE(told.find("constant/script"), std::string::npos) << told;
        EXPECT_EQ(told.find("constant/model"), std::string::npos) << told;
        const auto makeCorrected = [&]()
        {
            f.predict.makeCase(withSlope(3), c.folder()/"misfit/corrected");
        };
        EXPECT_NE(refusal(makeCorrected).find("was changed"), std::string::npos);
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
    const auto said = [&](const std::string& words)
    {
        return saidDuring
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
        said("-e " + folder + "prepare");
        EXPECT_EQ(said("-e " + folder + "prepare").find("changed"), std::string::npos);
        c.write("prepare", "echo\n");
        EXPECT_NE(said("-e " + folder + "prepare").find("changed"), std::string::npos);
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
    EXPECT_NE(p[1].failure.find("no column"), std::string::npos) << p[1].failure;
}


TEST(misfitRuns, aMeshThatTheCommandsDoNotMakeIsPartOfTheRun)
{
    const fakeCase c;
    mkDir(c.folder()/"constant/polyMesh");
    const auto runsWith = [&c](const std::string& program)
    {
        const label before = c.count();
        OStringStream os;
        c.dict().write(os, false);
        std::string text(os.str());
        text.replace(text.find("\"true\""), 6, "\"true " + program + "\"");
        IStringStream is(text);
        const dictionary dict(is);
        const recordings r(dict, c.folder());
        solverPredictor(r, c.folder(), dict).predict({withSlope(2)});
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
    const std::string model(content(target/"constant/model"));
    EXPECT_NE(model.find("strength        0.5;"), std::string::npos) << model;
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
    EXPECT_NE(p.failure.find("longer than 1 s"), std::string::npos) << p.failure;

    // The same limit would end it again, a longer one may not
    EXPECT_FALSE(within("1").ok());
    EXPECT_EQ(c.count(), 1);
    EXPECT_TRUE(within("60").ok());
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, aRunThatWasCutShortIsDoneAnew)
{
    const fakeCase c;
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


TEST(misfitRuns, aRunThatEndsTooEarlyIsNoPrediction)
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


TEST(misfitRuns, aRunThatBeginsTooLateIsNoPrediction)
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


TEST(misfitRuns, aProbeOutsideTheMeshIsRefused)
{
    testMesh m;
    const auto probe = [&m](const std::string& place)
    {
        IStringStream is
        (
            "quantity pressure; uncertainty 1; place " + place
          + "; simulated { type probe; field p; }"
        );
        const channel c("S1", dictionary(is), purpose::fit, "", 40);
        PtrList<observer> observers;
        observers.append(observer::New(c).ptr());
        return refusal([&](){ checkPlaces(m.mesh(), observers); });
    };
    EXPECT_EQ(probe("(0.5 0.5 0.5)"), "nothing");
    EXPECT_EQ(probe("(1 0.5 0.3)"), "nothing");
    EXPECT_EQ(probe("(1.05 0.5 0.3)"), "nothing");
    EXPECT_NE(probe("(1.6 0.5 0.3)").find("S1 at"), std::string::npos);
}


TEST(misfitRuns, aNumberAloneIsTheLastLineOfItsTable)
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
        "depth", dictionary(is), purpose::fit, c.folder(), 40
    );
    const series s(observer::New(recorded)->read(c.folder()));
    EXPECT_NEAR(recorded.sampled(s)[0], 7, 1e-12);
    EXPECT_NEAR(recorded.sampled()[0], 0.003, 1e-12);
}


TEST(misfitRuns, whatAnyRunCannotHaveIsToldBeforeTheFirst)
{
    const fakeCase c;
    const auto said = [&c](const std::string& old, const std::string& wrong)
    {
        return refusalWith(c, old, wrong);
    };
    const fileName runs(c.folder()/"misfit"/"runs");

    // In the file that a person mends, not in a copy
    const std::string told(said("a/lift/model", "a/lift/modle"));
    EXPECT_NE(told.find(c.folder()/"constant/model"), std::string::npos) << told;
    EXPECT_NE(told.find("no entry a/lift/modle"), std::string::npos) << told;
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


TEST(misfitRuns, aCaseThatEndsBeforeItsRecordingIsToldOfBeforeTheFirst)
{
    const fakeCase c;
    c.write("system/controlDict", "#include \"more\"\nendTime 1.5;\n");
    fakePredictor p(c);
    const std::string told
    (
        saidDuring([&]() { p.predict.predict({withSlope(2), withSlope(3)}); })
    );
    const auto first = told.find("experiment A is 1.5 s");
    EXPECT_NE(first, std::string::npos) << told;
    EXPECT_EQ(told.find("is 1.5 s", first + 20), std::string::npos) << told;

    // A command may have set another end
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitRuns, otherWaterInAnotherMeshIsToldOfOnce)
{
    const fakeCase c;
    c.write
    (
        "system/solver",
        content(c.folder()/"system/solver")
      + "water=$(tr -dc '0-9.' < constant/water)\n"
        "echo \"Phase-1 volume fraction = $water  Min(alpha.water) = 0\"\n"
        "echo \"Phase-1 volume fraction = 0.2  Min(alpha.water) = 0\"\n"
    );
    c.write("constant/water", "water 0.3;\n");
    const auto told = [&](const std::string& inMesh)
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
    EXPECT_EQ(told("0.301").find("more water"), std::string::npos);
    const std::string more(told("0.306"));
    const auto first = more.find("2 % more water");
    EXPECT_NE(first, std::string::npos) << more;
    EXPECT_EQ(more.find("more water", first + 20), std::string::npos) << more;
}


TEST(misfitRuns, whatIsFinishedIsReadWithoutItsPrograms)
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


TEST(misfitRuns, aRehearsalLeavesTheCaseAsItIs)
{
    const fakeCase c;
    const auto all = [&c]()
    {
        std::string text;
        for (const char* f : {"constant/model", "constant/script", "system/controlDict"})
        {
            text += content(c.folder()/f);
        }
        return text;
    };
    const std::string before(all());
    fakePredictor p
    (
        c,
        "experiments { A { use fit; changes ("
        " { file \"constant/script\"; variable mu; value 0.3; } ); } }"
    );
    p.predict.predict({withSlope(2)});
    EXPECT_EQ(c.count(), 1);
    EXPECT_EQ(all(), before);
}


TEST(misfitRuns, aChannelThatNoTableMatchesIsRefused)
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
