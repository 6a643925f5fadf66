// SPDX-License-Identifier: GPL-3.0-or-later
// How sure a verdict is: the logistic function, the table of confidences, the limits
// that a diagnosis decides by.

#include "confidenceFit.H"
#include "logistic.H"
#include "terminalOutput.H"
#include "temporaryFolder.H"
#include "textFile.H"
#include "verdictKind.H"
#include "worldDiagnosis.H"

#include "IStringStream.H"

#include <random>

using namespace Foam;
using namespace Foam::misfit;
using statistics::count;

namespace
{

//- Cases of each verdict, right the more often the larger their lead is
std::vector<knownCase> drawnCases(const label each)
{
    std::mt19937 generator(7);
    std::uniform_real_distribution<scalar> any;
    std::vector<knownCase> cases;
    for (const word& verdict : verdictNames.sortedToc())
    {
        for (label i = 0; i < each; ++i)
        {
            knownCase c;
            c.verdict = verdictNames[verdict];
            c.grounds = vec::Zero(groundNames.size());
            c.grounds[0] = 4*any(generator) - 2;
            c.right = any(generator) < 1/(1 + std::exp(-c.grounds[0]));
            cases.push_back(c);
        }
    }
    return cases;
}


//- Settings whose confidences are from another file
settings withTable(const fileName& file)
{
    settings s(worldSettings());
    s.confidence = confidenceTable(file);
    return s;
}


//- A table as it is fitted, with one thing in it changed
std::string changedTable(const std::string& from, const std::string& to)
{
    std::string text(fittedTable(drawnCases(20)));
    const size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return text.replace(at, from.size(), to);
}


//- The error for a table with this text
std::string refusalOfTable(const std::string& text)
{
    const temporaryFolder scratch;
    const fileName file(fileName(scratch)/"table");
    writeWhole(file, text);
    return refusal([&]{ confidenceTable table(file); });
}


dictionary dictionaryOf(const std::string& entries)
{
    return dictionary(IStringStream(entries)());
}

} // End anonymous namespace


TEST(misfitConfidence, aKnownLogisticFunctionIsFound)
{
    std::mt19937 generator(11);
    std::normal_distribution<scalar> normal;
    std::uniform_real_distribution<scalar> any;
    const label n = 20000;
    mat x(n, 3);
    std::vector<bool> outcomes(n);
    for (label i = 0; i < n; ++i)
    {
        // Of other units; the last is the same for all
        x.row(i) << normal(generator), 5 + 100*normal(generator), 3;
        const scalar logit = 0.5 + 1.2*x(i, 0) - 0.008*x(i, 1);
        outcomes[i] = any(generator) < 1/(1 + std::exp(-logit));
    }
    const statistics::logistic found(statistics::fitLogistic(x, outcomes, 100));

    // Three standard errors of so many outcomes
    EXPECT_NEAR(found.constant, 0.5, 0.06);
    EXPECT_NEAR(found.coefficients[0], 1.2, 0.07);
    EXPECT_NEAR(found.coefficients[1], -0.008, 0.0006);
    EXPECT_EQ(found.coefficients[2], 0);
}


TEST(misfitConfidence, theFitIsTheLikeliest)
{
    // Without numbers it is the share of the outcomes and one half of either kind
    const label n = 20;
    const statistics::logistic found
    (
        statistics::fitLogistic(mat(n, 0), std::vector<bool>(n, true), 1)
    );
    EXPECT_NEAR(found(vec()), (n + 0.5)/(n + 1), 1e-6);
}


TEST(misfitConfidence, whatHoldsNothingInFewCasesIsShrunk)
{
    mat x(4, 1);
    x << 0, 1, 2, 3;
    const std::vector<bool> outcomes({false, false, true, true});
    const scalar free =
        statistics::fitLogistic(x, outcomes, 100).coefficients[0];
    const scalar shrunk =
        statistics::fitLogistic(x, outcomes, 0.1).coefficients[0];
    EXPECT_GT(free, 1);
    EXPECT_GT(shrunk, 0);
    EXPECT_LT(shrunk, 0.05);
}


TEST(misfitConfidence, withoutOutcomesThereIsNoFit)
{
    EXPECT_THROW
    (
        statistics::fitLogistic(mat(0, 2), {}, 1), std::domain_error
    );
}


TEST(misfitConfidence, theTableIsReadBackAsItWasFitted)
{
    const temporaryFolder scratch;
    const fileName file(fileName(scratch)/"table");
    const std::vector<knownCase> cases(drawnCases(400));
    writeWhole(file, fittedTable(cases, 100));
    const confidenceTable table(file);

    // That of the numbers that vary, as it is written: with four digits
    mat x(400, 1);
    std::vector<bool> right;
    for (const knownCase& c : cases)
    {
        if (c.verdict == verdictKind::set)
        {
            x(count(right), 0) = c.grounds[0];
            right.push_back(c.right);
        }
    }
    const statistics::logistic fit(statistics::fitLogistic(x, right, 100));
    vec grounds = vec::Zero(groundNames.size());
    for (const scalar lead : {-1.5, 0., 1.5})
    {
        grounds[0] = lead;
        EXPECT_NEAR(table(verdictKind::set, grounds), fit(vec::Constant(1, lead)), 1e-3);
    }

    // No case had more than that
    grounds[0] = 1e6;
    EXPECT_NEAR
    (
        table(verdictKind::set, grounds), fit(vec::Constant(1, x.maxCoeff())), 1e-3
    );
}


TEST(misfitConfidence, scoredCasesAreReadByTheirColumns)
{
    const temporaryFolder scratch;
    const fileName file(fileName(scratch)/"cases.csv");
    std::string heads("case,verdict,right");
    for (const word& name : groundNames)
    {
        heads += ',' + name;
    }
    writeWhole
    (
        file, heads + "\n0001,named,1,2,0.01,3,1,1,0\n0002,none,0,-1,1,0,0.5,0,0\n"
    );
    const std::vector<knownCase> cases(readKnownCases(file));
    ASSERT_EQ(cases.size(), 2);
    EXPECT_EQ(cases[0].verdict, verdictKind::named);
    EXPECT_TRUE(cases[0].right);
    EXPECT_EQ(cases[0].grounds[2], 3);
    EXPECT_EQ(cases[1].verdict, verdictKind::none);
    EXPECT_FALSE(cases[1].right);
    EXPECT_EQ(cases[1].grounds[0], -1);

    writeWhole(file, "case,verdict,right\n0001,named,1\n");
    EXPECT_NE
    (
        refusal([&]{ readKnownCases(file); }).find("no column lead"),
        std::string::npos
    );
    EXPECT_NE
    (
        refusal([&]{ readKnownCases(file + "2"); }).find("no scored cases"),
        std::string::npos
    );
}


TEST(misfitConfidence, aVerdictThatNoCaseHasCannotBeFitted)
{
    std::vector<knownCase> cases(drawnCases(5));
    for (knownCase& c : cases)
    {
        c.verdict = c.verdict == verdictKind::set ? verdictKind::named : c.verdict;
    }
    EXPECT_NE
    (
        refusal([&]{ fittedTable(cases); }).find("No case has the verdict set"),
        std::string::npos
    );
}


TEST(misfitConfidence, anotherTableGivesAnotherConfidenceAndTheSameVerdict)
{
    const temporaryFolder scratch;
    const fileName file(fileName(scratch)/"table");
    std::vector<knownCase> cases(drawnCases(40));
    for (knownCase& c : cases)
    {
        c.right = false;
    }
    writeWhole(file, fittedTable(cases));
    worldSampler one(truth(0, 0.7), 200, vec());
    worldSampler other(truth(0, 0.7), 200, vec());
    const finding f(diagnose(one));
    const finding g(diagnose(other, withTable(file)));
    EXPECT_EQ(f.verdict.kind, g.verdict.kind);
    EXPECT_EQ(f.verdict.names, g.verdict.names);
    EXPECT_EQ(f.verdict.grounds, g.verdict.grounds);
    EXPECT_GE(f.verdict.confidence, leastOfAName());
    EXPECT_LT(g.verdict.confidence, 0.1);
}


TEST(misfitConfidence, aTableThatIsMissingOrBrokenIsAnErrorThatStatesWhatToDo)
{
    const std::string missing
    (
        refusal([]{ settings s(dictionaryOf("confidence \"/none/table\";")); })
    );
    EXPECT_NE(missing.find("no table of confidences \"/none/table\""), missing.npos)
        << missing;
    EXPECT_NE(missing.find("misfitConceal -calibrate"), missing.npos) << missing;

    const std::pair<std::string, std::string> broken[] =
    {
        {changedTable("unknown\n", "unheard\n"), "Unknown keyword unheard"},
        {changedTable("    lead ", "    load "), "Unknown keyword load"},
        {changedTable("    SNR         (0 0 0);\n", ""), "There is no SNR"},
        {changedTable("(0 0 0)", "(0 1 0)"), "least value"}
    };
    for (const auto& b : broken)
    {
        const std::string output(refusalOfTable(b.first));
        EXPECT_NE(output.find(b.second), output.npos) << output;
        EXPECT_NE(output.find("misfitConceal -calibrate"), output.npos) << output;
    }
}


TEST(misfitConfidence, aVerdictWithoutSomeOfItsRunsIsNoSurerThanItsScores)
{
    worldSampler s(truth(-1, 0), 100, vec());
    s.failAlwaysIn("B");
    const finding f(diagnose(s));
    ASSERT_EQ(f.verdict.kind, verdictKind::unknown);
    scalar unknown = 0;
    for (const hypothesisFit& w : f.explained.all())
    {
        unknown += w.what.isOnlyUnknown() ? w.probability : 0;
    }
    EXPECT_LE(f.verdict.confidence, unknown);
}


TEST(misfitRules, eachMayBeAnotherInACase)
{
    const settings standard;
    const settings s
    (
        dictionaryOf("significance 0.02; placebo 0.4; refit 5; pairs no;")
    );
    EXPECT_EQ(s.significance, 0.02);
    EXPECT_EQ(s.placebo, 0.4);
    EXPECT_EQ(s.refit, 5);
    EXPECT_FALSE(s.pairs);
    EXPECT_EQ(s.adequacy, standard.adequacy);
    EXPECT_EQ(standard.significance, 0.05);
    EXPECT_TRUE(standard.pairs);
}


TEST(misfitRules, aWrongOneIsRefused)
{
    EXPECT_NE
    (
        refusal([]{ settings s(dictionaryOf("placeboes 0.4;")); }).find
        (
            "Unknown keyword placeboes"
        ),
        std::string::npos
    );
    for (const char* wrong : {"adequacy 1.5;", "largestUncalibrated 1;"})
    {
        const std::string output
        (
            refusal([wrong]{ settings s(dictionaryOf(wrong)); })
        );
        EXPECT_NE(output.find("probabilities between 0 and 1"), output.npos) << output;
    }
}


TEST(misfitRules, whereTheyAreNotFoundItStatesWhatToDo)
{
    const string before(getEnv("INTERDEMFOAM_DIR"));
    setEnv("INTERDEMFOAM_DIR", "/none", true);
    const std::string output(refusal([]{ settings s; }));
    setEnv("INTERDEMFOAM_DIR", before, true);
    EXPECT_NE(output.find("source etc/bashrc"), output.npos) << output;
}
