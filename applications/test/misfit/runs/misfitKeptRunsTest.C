// SPDX-License-Identifier: GPL-3.0-or-later
// Files of runs that grow: what is there is not run again, and half a run or a killed one
// is never taken for a result.

#include "fakeCase.H"
#include "keptRuns.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;


//- Runs of a fake case with these slopes
struct fakeRuns
{
    const fakeCase& of;

    List<runState> states;

    fakePredictor solver;

    keptRuns kept;


    fakeRuns
    (
        const fakeCase& c,
        const scalarList& slopes,
        const string& head = "as now",
        const std::string& more = ""
    )
    :
        of(c),
        solver(c, "jobs 1; " + more),
        kept{c.folder()/"kept/runs.txt", head, solver.recorded, states, {}, 0.5}
    {
        for (const scalar s : slopes)
        {
            states.append(withSlope(s));
            kept.names.append(describe(states.last()));
        }
    }

    List<prediction> predictions(const label most = labelMax, const label batch = 2)
    {
        return kept.predictions(solver.predict, most, batch);
    }

    std::string text() const
    {
        return contentOf(kept.file);
    }
};


TEST(misfitKeptRuns, aFileHoldsRunsInWordsAndFourDigits)
{
    const fakeCase c;
    fakeRuns runs(c, {1.23456, 9});
    const List<prediction> p(runs.predictions());
    EXPECT_EQ
    (
        runs.text(),
        "as now\nexperiment A, slope 1.23456\ny 0 0.5 0 0.6173 1.235 1.852 2.469\n"
        "experiment A, slope 9\nfailed\n"
    );
    EXPECT_EQ(p[0].channels[0].y, scalarList({0, 0.6173, 1.235, 1.852, 2.469}));
    EXPECT_FALSE(p[1].ok());
    const List<prediction> again(runs.predictions());
    EXPECT_EQ(again[0].channels[0].y, p[0].channels[0].y);
    EXPECT_EQ(again[0].channels[0].x, p[0].channels[0].x);
    EXPECT_FALSE(again[1].ok());
}


TEST(misfitKeptRuns, itIsGoneOnWithWhereItWasStopped)
{
    const fakeCase whole;
    const fakeCase c;
    const scalarList slopes({1, 2, 3, 4, 1.5});
    fakeRuns all(whole, slopes);
    all.predictions();
    EXPECT_EQ(fakeRuns(c, slopes).predictions(3).size(), 3);
    EXPECT_EQ(c.count(), 3);

    // Only the file is left
    rmDir(c.folder()/"misfit");
    fakeRuns more(c, slopes);
    const std::string output
    (
        outputDuring([&]() { EXPECT_EQ(more.predictions().size(), 5); })
    );
    expectHolds(output, "runs.txt has 3 of 5 runs");
    expectHolds(output, "runs.txt has 5 of 5 runs");
    EXPECT_EQ(c.count(), 5);
    EXPECT_EQ(more.text(), all.text());

    more.predictions();
    EXPECT_EQ(c.count(), 5);
}


TEST(misfitKeptRuns, eachBatchIsInTheFileBeforeTheNextBegins)
{
    const fakeCase c;
    c.write("full", "");
    fakeRuns runs(c, {1, 2, 3, 6, 4});
    const std::string output
    (
        outputDuring([&]()
        {
            expectHolds(refusal([&]() { runs.predictions(); }), "misfit/runs");
        })
    );
    expectHolds(output, "has 2 of 5 runs, about 1 min for the 3 to do");
    EXPECT_EQ(runs.kept.read().size(), 2);
}


TEST(misfitKeptRuns, aRunThatWasKilledOrOutOfTimeIsNoFailure)
{
    const fakeCase killed;
    const fakeCase slow;
    fakeRuns few(killed, {1, 7, 2});
    fakeRuns late(slow, {1, 8, 2}, "as now", "timeLimit 2; ");
    for (fakeRuns* runs : {&few, &late})
    {
        expectHolds
        (
            refusal([&]() { runs->predictions(labelMax, 3); }), "has those that ended"
        );
        EXPECT_EQ(runs->kept.read().size(), 2);
        expectLacks(runs->text(), "failed");
    }
}


TEST(misfitKeptRuns, halfARunIsNotTakenForAWholeOne)
{
    const fakeCase c;
    fakeRuns runs(c, {1, 2});
    runs.predictions();
    const std::string text(runs.text());
    const auto second = text.find("experiment", text.find("experiment") + 1);
    for (auto size = text.size() - 1; size > second; --size)
    {
        writeWhole(runs.kept.file, text.substr(0, size));
        expectHolds(refusal([&]() { runs.kept.read(); }), "ends within a run");
    }
    writeWhole(runs.kept.file, text.substr(0, second));
    EXPECT_EQ(runs.kept.read().size(), 1);
}


TEST(misfitKeptRuns, runsOfOtherFormulasAreRefused)
{
    const fakeCase c;
    fakeRuns(c, {1, 2, 3}).predictions(2);
    expectHolds
    (
        refusal([&]() { fakeRuns(c, {1, 2}, "before").predictions(); }), "other formulas"
    );
    EXPECT_EQ(c.count(), 2);
}


TEST(misfitKeptRuns, thoseOfAnotherDesignStayAndWhatBothHaveIsNotRunAgain)
{
    const fakeCase c;
    fakeRuns(c, {1, 2}).predictions();
    const List<prediction> p(fakeRuns(c, {3, 2, 3, 1}).predictions());
    EXPECT_EQ(c.count(), 3);
    ASSERT_EQ(p.size(), 4);
    EXPECT_EQ(p[0].channels[0].y.last(), 6);
    EXPECT_EQ(p[1].channels[0].y.last(), 4);
    EXPECT_EQ(p[3].channels[0].y.last(), 2);
    EXPECT_EQ(fakeRuns(c, {1, 2}).predictions().size(), 2);
    EXPECT_EQ(c.count(), 3);
}
