// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a diagnosis: with all that a reader needs in one file.

#include "temporaryFolder.H"
#include "terminalOutput.H"
#include "testFinding.H"
#include "words.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

gate notApplicable(const gateKind kind)
{
    gate g;
    g.kind = kind;
    g.applies = false;
    return g;
}


bool contains(const std::string& page, const std::string& words)
{
    return page.find(words) != std::string::npos;
}


//- The box at the top
std::string box(const finding& f)
{
    const std::string page(reportHtml(f, today(), {}));
    const size_t from = page.find("<div class=\"verdict\">");
    return page.substr(from, page.find("</div>", from) - from);
}

} // End anonymous namespace


TEST(misfitReport, oneFileHoldsWordsAndPictures)
{
    const temporaryFolder scratch;
    const fileName folder(scratch);
    writeReport(found(), folder, today());

    std::ifstream is(folder/"report.html");
    const std::string html
    (
        (std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>()
    );
    EXPECT_NE(html.find("Left out: porePressure"), std::string::npos);
    label pictures = 0;
    for
    (
        size_t at = html.find("base64,iVBOR");
        at != std::string::npos;
        at = html.find("base64,iVBOR", at + 1)
    )
    {
        ++pictures;
    }
    EXPECT_EQ(pictures, 3);
    EXPECT_NE(html.find("100 % of the misfit is gone"), std::string::npos);
    EXPECT_NE
    (
        html.find("<td>P1 [Pa]</td><td>20</td><td>12</td><td>16</td>"),
        std::string::npos
    );
    EXPECT_TRUE(isFile(folder/"verdict.json"));
    EXPECT_FALSE(isFile(folder/"verdict.json.new"));
}


TEST(misfitReport, theTopStatesWhichCaseWhenAndWhatWasRecorded)
{
    const std::string page(reportHtml(found(), today(), {}));
    EXPECT_TRUE(contains(page, "<h1>Simulation against recordings: a case</h1>"));
    EXPECT_TRUE(contains(page, "2026 May 03"));
    EXPECT_TRUE
    (
        contains
        (
            page,
            "<td>A</td><td>P1, P2</td><td>P3</td><td></td><td>surge.csv</td>"
        )
    );
}


TEST(misfitReport, aCandidateIsReportedByItsTitleAndWhatItSets)
{
    EXPECT_TRUE
    (
        contains
        (
            reportHtml(found(), today(), {}),
            "<td>porePressure</td><td>water that cannot leave at once</td>"
            "<td>constant/grains pressure = 1</td><td>0.7</td>"
        )
    );

    finding f(found());
    EXPECT_TRUE(contains(box(f), "porePressure: water that cannot leave at once."));

    // One that is called as a part of another name is not meant by it
    f.verdict.names = {"porePressures"};
    judged(f).mechanisms.clear();
    EXPECT_FALSE(contains(box(f), "water that cannot leave"));
    f.verdict.kind = verdictKind::set;
    f.verdict.names.clear();
    f.verdict.alternatives = {mechanisms({1}), mechanisms({0, 1})};
    EXPECT_TRUE(contains(box(f), "porePressure: water that cannot leave at once."));
}


TEST(misfitReport, theConfidenceStatesOfWhat)
{
    finding f(found());
    EXPECT_TRUE
    (
        contains
        (
            box(f),
            "Confidence 90 % that this is at least part of what is missing, the"
            " fraction of such verdicts that were right in cases whose cause was known."
            " The cases of etc/misfit/confidence are water without grains: for a case"
            " with grains the confidence is not calibrated."
        )
    );
    finding uncounted(f);
    uncounted.verdict.grounds.resize(0);
    EXPECT_TRUE(contains(box(uncounted), "missing, by its score alone: no case"));
    f.verdict.kind = verdictKind::set;
    f.verdict.names.clear();
    f.verdict.alternatives = {mechanisms({0}), mechanisms({1})};
    EXPECT_TRUE(contains(box(f), "90 % that one of these is at least part"));
    f.verdict.alternatives.clear();
    f.verdict.kind = verdictKind::sensor;
    f.verdict.names = {"P1"};
    judged(f).mechanisms.clear();
    judged(f).fault = possibleFaults(f.detection.data, {faultKind::gain}).front();
    f.explained.all().front().fit.x = vec::Constant(1, 0.2);
    f.explained.all().front().fit.pinned = {false};
    f.explained.all().front().fit.covariance = mat::Zero(1, 1);
    EXPECT_TRUE(contains(box(f), "P1 reads 20 % too high"));
    EXPECT_TRUE(contains(box(f), "90 % that the fault is at P1"));
    EXPECT_FALSE(contains(box(f), "in all of which it was the clock"));
    f.verdict.kind = verdictKind::registration;
    EXPECT_TRUE(contains(box(f), "in all of which it was the clock"));
    f.verdict.names.clear();
    f.verdict.kind = verdictKind::unknown;
    EXPECT_TRUE(contains(box(f), "90 % that no candidate and no fault of one sensor"));
    f.verdict.kind = verdictKind::none;
    EXPECT_TRUE(contains(box(f), "90 % that nothing missing and no fault is needed"));
}


TEST(misfitReport, theTopStatesWhatWasNotScored)
{
    finding f(found());
    EXPECT_FALSE(contains(box(f), "Not scored"));

    f.candidates.dropped =
    {
        {
            "lift", droppedCandidate::reason::failed, "floating point exception",
            0, 0
        },
        {"gate", droppedCandidate::reason::opposite, "", 0, 0}
    };
    EXPECT_TRUE
    (
        contains
        (
            box(f),
            "Not scored: lift (the solver failed with it), gate (the recording"
            " differs the other way in what it changes)."
        )
    );
    f.candidates.dropped[0].failure.clear();
    EXPECT_EQ(describe(f.candidates.dropped[0]), "the solver failed with it");
}


TEST(misfitReport, aGateThatCouldNotBeEvaluatedDiffersFromOneWithNothingToEvaluate)
{
    finding f(found());
    f.tests.gates = gateList();
    for (label kind = 0; kind <= label(gateKind::placebo); ++kind)
    {
        f.tests.gates.addNothing(gateKind(kind));
    }
    f.tests.gates.add(notApplicable(gateKind::adequacy));
    f.tests.gates.add(notApplicable(gateKind::stability));
    const std::string known(reportHtml(f, today(), {}));
    EXPECT_TRUE(contains(known, "nothing to test"));
    EXPECT_FALSE(contains(known, "not tested"));

    judged(f).unknown = true;
    const std::string partly(reportHtml(f, today(), {}));
    EXPECT_TRUE(contains(partly, "not tested: the answer has something unknown"));
    EXPECT_TRUE(contains(partly, "nothing to test"));

    judged(f).mechanisms.clear();
    const std::string unknown(reportHtml(f, today(), {}));
    EXPECT_TRUE(contains(unknown, "not tested: the answer has no known cause"));
    EXPECT_FALSE(contains(unknown, "nothing to test"));

    // Who edits sentences finds all of them in one file
    const std::string sentences(templateText("words"));
    for (const char* words : {"not tested: ", "nothing to test", "no misfit beyond"})
    {
        expectHolds(sentences, words);
    }
}


TEST(misfitReport, noNumberIsTooLargeToRead)
{
    finding f(found());
    f.tests.held[0].use = purpose::test;
    f.tests.held[0].squareBefore = 2;
    f.tests.held[0].squareAfter = 1e17;
    hypothesisFit far(f.best());
    far.what.mechanisms.clear();
    far.score = 1.3e297;
    f.explained.all().push_back(far);
    f.correction.isRequested = true;
    f.correction.held = f.tests.held;
    const std::string page(reportHtml(f, today(), {}));
    EXPECT_FALSE(contains(page, "e+"));
    EXPECT_TRUE(contains(page, "more than 100000"));

    // In sentences too
    f.tests.held[0].use = purpose::validation;
    f.verdict.strengths = {{"porePressure", 1234567, 23456, false}};
    f.verdict.alternatives.clear();
    expectHolds(describe(f), "mean square more than 100000");
    expectLacks(describe(f), "e+");
    expectHolds(describe(f), "1230000");
    expectLacks
    (
        describe(droppedCandidate{"a", droppedCandidate::reason::small, "", 0.1, 1e20}),
        "e+"
    );
    gate wide(gateKind::evidence, 12345, 10);
    expectHolds(gateWords(wide, f).dump(), "12300");
    EXPECT_TRUE(contains(page, "less than -1000 %"));

    // Of a channel that shows nothing the range is nought
    stacked data(f.detection.data);
    data.segments[0].of(data.y).setZero();
    const place p{{0, 5, 9, 12}, 700};
    EXPECT_TRUE
    (
        contains(describe(p, data), "the simulation is more than 1000 % of the range")
    );
}


TEST(misfitReport, theMapHasTheUncertaintyThatEachSideHas)
{
    const temporaryFolder scratch;
    finding f(found());
    f.verdict.after = f.detection.data.y.array() - 60;
    f.verdict.sigma = 3*f.detection.sigma;
    drawFigures(f, fileName(scratch));
    std::ifstream map(fileName(scratch)/"map.dat");
    scalar from, to, row, before, after;
    map >> from >> to >> row >> before >> after;
    EXPECT_NEAR(before, (f.detection.data.y[0] - f.verdict.before[0])/20, 1e-3);
    EXPECT_NEAR(after, 1, 1e-3);
}


TEST(misfitReport, theOrderInWhichChannelsDifferIsOnThePage)
{
    expectHolds
    (
        reportHtml(found(), today(), {}),
        "<td>A</td><td>P1</td><td>calibration</td><td>0.35</td><td>0.4</td><td>0.6</td>"
    );
}


TEST(misfitReport, aShareThatRoundsToNoughtHasNoSign)
{
    finding f(found());
    f.tests.held[0].squareBefore = 10;
    f.tests.held[0].squareAfter = 10.02;
    f.correction.isRequested = true;
    f.correction.held = f.tests.held;
    const std::string page(reportHtml(f, today(), {}));
    EXPECT_TRUE(contains(page, ">0 %<"));
    EXPECT_FALSE(contains(page, "-0 %"));
}


TEST(misfitReport, itsWordsAreExplained)
{
    const std::string page(reportHtml(found(), today(), {}));
    const std::string words(page.substr(page.find("id=\"words\"")));
    for
    (
        const char* word :
        {
            "sigma", "score", "mean square", "evidence", "adequacy", "placebo",
            "front, body, tail"
        }
    )
    {
        EXPECT_TRUE(contains(words, word)) << word;
    }
}
