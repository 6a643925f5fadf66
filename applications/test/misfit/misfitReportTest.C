// SPDX-License-Identifier: GPL-3.0-or-later
// The record and the report of a diagnosis: whole, readable by programs, and
// with all that a reader needs in one file.

#include "report.H"
#include "jsonSchema.H"
#include "misfitWorld.H"
#include "temporaryFolder.H"
#include "terminalOutput.H"
#include "words.H"

#include "StringStream.H"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- What a diagnosis of the world could have found
finding found()
{
    world w(20);
    const vec base = w(w.bounds.mean);
    vec x = w.bounds.mean;
    x[world::nParameters] = 0.7;
    w.data.y = w(x);

    finding f;
    f.verdict.kind = verdictKind::named;
    f.verdict.names = {"porePressure"};
    f.verdict.confidence = 0.9;
    f.verdict.grounds.resize(groundNames.size());
    f.verdict.grounds << 3.5, 0.001, 2, 0.75, 1, 0;
    f.detection.calibrated = {0.001, 0.001, 0.001, 100, {{0, 5, 9, 12}}};
    f.detection.raw = f.detection.calibrated;
    f.verdict.located = {{{0, 5, 9, 12}, 50}};
    f.verdict.strengths.append({"porePressure", 0.7, 0.1, false});
    for (label kind = 0; kind <= label(gateKind::placebo); ++kind)
    {
        f.tests.gates.addNothing(gateKind(kind));
    }
    gate detection;
    detection.kind = gateKind::detection;
    detection.value = 0.001;
    detection.limit = 0.05;
    f.tests.gates.add(detection);
    f.detection.data = w.data;
    f.verdict.before = base;
    f.verdict.after = w.data.y;
    f.detection.sigma = vec::Constant(base.size(), 20);
    f.verdict.sigma = f.detection.sigma;
    f.departures = {{"A", "P1", purpose::calibration, 0.4, 0.6, 0.35}};
    f.detection.sources =
    {
        {"sensors", vec::Constant(base.size(), 12)},
        {"mesh", vec::Constant(base.size(), 16)}
    };
    f.tests.held.append
    ({
        heldOut::part::validation, "A", purpose::validation, w.data, base, w.data.y,
        f.detection.sigma, 9, 1, 1.5
    });
    hypothesisFit best;
    best.what.mechanisms = {0};
    best.score = 0;
    f.explained = explanations({best});
    f.library = {"porePressure", "walls"};
    return f;
}


//- The explanation that is judged
hypothesis& judged(finding& f)
{
    return f.explained.all().front().what;
}


hypothesisFit mechanisms(const std::vector<int>& on)
{
    hypothesisFit w;
    w.what.mechanisms = on;
    return w;
}


gate notAsked(const gateKind kind)
{
    gate g;
    g.kind = kind;
    g.applies = false;
    return g;
}


//- Where it comes from
origin today()
{
    origin from;
    from.title = "a case";
    from.date = "2026 May 03";
    from.experiments = {{"A", "P1, P2", "P3", "", "surge.csv"}};
    const dictionary changes
    (
        IStringStream
        (
            "pore { title \"water that cannot leave at once\";"
            " changes ({ file \"constant/grains\"; entry pressure; }); }"
        )()
    );
    from.candidates = readCandidates(changes);
    from.candidates[0].name = "porePressure";
    return from;
}


bool says(const std::string& page, const std::string& words)
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


TEST(misfitReport, theRecordIsReadableByPrograms)
{
    const auto j = nlohmann::json::parse(verdictJson(found(), "case"));
    EXPECT_EQ(j["verdict"], "named");
    EXPECT_EQ(j["names"][0], "porePressure");
    EXPECT_EQ(j["words"], describe(found()));
    EXPECT_EQ(j["located"][0]["channel"], "P1");
    EXPECT_EQ(j["gates"][0]["name"], "detection");
    EXPECT_EQ(j["gates"][0]["value"], 0.001);
    EXPECT_EQ(j["gates"][0]["bound"], "below");
    EXPECT_TRUE(j["gates"][0]["limit"].is_number());
    EXPECT_EQ(j["gates"][0]["result"], "passed");
    EXPECT_EQ(j["heldOut"][0]["meanSquareAfter"], 1);
    EXPECT_NEAR(j["uncertainty"]["P1"]["whole"], 20, 1e-9);
    EXPECT_NEAR(j["uncertainty"]["P1"]["mesh"], 16, 1e-9);
}


TEST(misfitReport, theRecordIsOfItsSchemaAndReadsBackAsItWasFound)
{
    const finding f(found());
    const auto j = nlohmann::json::parse(verdictJson(f, "case"));
    expectOfSchema("verdict.schema.json", j);
    EXPECT_EQ(j["departures"][0]["differsFrom"], 0.35);
    EXPECT_EQ(verdictNames[word(j["verdict"].get<std::string>())], f.verdict.kind);
    EXPECT_EQ(j["names"].get<std::vector<std::string>>().front(), f.verdict.names[0]);
    EXPECT_EQ(j["confidence"], f.verdict.confidence);
    EXPECT_EQ(j["confidenceFrom"].size(), groundNames.size());
    EXPECT_EQ(j["confidenceFrom"]["lead"], 3.5);
    EXPECT_EQ(j["confidenceFrom"]["more"], 0);
    EXPECT_EQ(j["strengths"][0]["name"], f.verdict.strengths[0].name);
    EXPECT_EQ(j["strengths"][0]["value"], f.verdict.strengths[0].value);
    EXPECT_EQ(j["detection"]["p"], f.detection.calibrated.p);
    EXPECT_EQ(j["heldOut"][0]["what"], describe(f.tests.held[0]));
    EXPECT_EQ(j["heldOut"][0]["use"], purposeNames[f.tests.held[0].use]);
    EXPECT_EQ(j["heldOut"][0]["meanSquareBefore"], f.tests.held[0].squareBefore);
}


TEST(misfitReport, theRecordOfASetHasTheMembersOfEach)
{
    finding f(found());
    f.verdict.kind = verdictKind::set;
    f.verdict.names.clear();
    hypothesisFit fault;
    fault.what.fault = possibleFaults(f.detection.data, {faultKind::gain}).front();
    f.verdict.alternatives = {mechanisms({0, 1}), fault};
    const auto all = nlohmann::json::parse(verdictJson(f, "case"))["alternatives"];
    ASSERT_EQ(all.size(), 2);
    EXPECT_EQ(all[0]["mechanisms"], nlohmann::json({"porePressure", "walls"}));
    EXPECT_TRUE(all[0]["channel"].is_null());
    EXPECT_TRUE(all[1]["mechanisms"].empty());
    EXPECT_EQ(all[1]["channel"], "P1");
    EXPECT_TRUE(all[1]["partner"].is_null());
}


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


TEST(misfitReport, theTopSaysWhichCaseWhenAndWhatWasRecorded)
{
    const std::string page(reportHtml(found(), today(), {}));
    EXPECT_TRUE(says(page, "<h1>Simulation against recordings: a case</h1>"));
    EXPECT_TRUE(says(page, "2026 May 03"));
    EXPECT_TRUE
    (
        says
        (
            page,
            "<td>A</td><td>P1, P2</td><td>P3</td><td></td><td>surge.csv</td>"
        )
    );
}


TEST(misfitReport, aCandidateIsToldByItsTitleAndWhatItSets)
{
    EXPECT_TRUE
    (
        says
        (
            reportHtml(found(), today(), {}),
            "<td>porePressure</td><td>water that cannot leave at once</td>"
            "<td>constant/grains pressure = 1</td><td>0.7</td>"
        )
    );

    finding f(found());
    EXPECT_TRUE(says(box(f), "porePressure: water that cannot leave at once."));

    // One that is called as a part of another name is not meant by it
    f.verdict.names = {"porePressures"};
    judged(f).mechanisms.clear();
    EXPECT_FALSE(says(box(f), "water that cannot leave"));
    f.verdict.kind = verdictKind::set;
    f.verdict.names.clear();
    f.verdict.alternatives = {mechanisms({1}), mechanisms({0, 1})};
    EXPECT_TRUE(says(box(f), "porePressure: water that cannot leave at once."));
}


TEST(misfitReport, theConfidenceSaysOfWhat)
{
    finding f(found());
    EXPECT_TRUE
    (
        says
        (
            box(f),
            "Confidence 90 % that this is at least part of what is missing, the"
            " fraction of such verdicts that were right in cases whose cause was known. The"
            " cases of etc/misfit/confidence are water without grains: for a case with"
            " grains the confidence is not calibrated."
        )
    );
    finding uncounted(f);
    uncounted.verdict.grounds.resize(0);
    EXPECT_TRUE(says(box(uncounted), "missing, by its score alone: no case"));
    f.verdict.kind = verdictKind::set;
    f.verdict.names.clear();
    f.verdict.alternatives = {mechanisms({0}), mechanisms({1})};
    EXPECT_TRUE(says(box(f), "90 % that one of these is at least part"));
    f.verdict.alternatives.clear();
    f.verdict.kind = verdictKind::sensor;
    f.verdict.names = {"P1"};
    judged(f).mechanisms.clear();
    judged(f).fault = possibleFaults(f.detection.data, {faultKind::gain}).front();
    f.explained.all().front().best.x = vec::Constant(1, 0.2);
    f.explained.all().front().best.pinned = {false};
    f.explained.all().front().best.covariance = mat::Zero(1, 1);
    EXPECT_TRUE(says(box(f), "P1 reads 20 % too high"));
    EXPECT_TRUE(says(box(f), "90 % that the fault is at P1"));
    EXPECT_FALSE(says(box(f), "in all of which it was the clock"));
    f.verdict.kind = verdictKind::registration;
    EXPECT_TRUE(says(box(f), "in all of which it was the clock"));
    f.verdict.names.clear();
    f.verdict.kind = verdictKind::unknown;
    EXPECT_TRUE(says(box(f), "90 % that no candidate and no fault of one sensor"));
    f.verdict.kind = verdictKind::none;
    EXPECT_TRUE(says(box(f), "90 % that nothing missing and no fault is needed"));
}


TEST(misfitReport, theTopSaysWhatWasNotScored)
{
    finding f(found());
    EXPECT_FALSE(says(box(f), "Not scored"));

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
        says
        (
            box(f),
            "Not scored: lift (the solver failed with it), gate (the recording"
            " differs the other way in what it changes)."
        )
    );
}


TEST(misfitReport, aGateThatCouldNotBeAskedIsToldFromOneWithNothingToAsk)
{
    finding f(found());
    f.tests.gates = gateList();
    for (label kind = 0; kind <= label(gateKind::placebo); ++kind)
    {
        f.tests.gates.addNothing(gateKind(kind));
    }
    f.tests.gates.add(notAsked(gateKind::adequacy));
    f.tests.gates.add(notAsked(gateKind::stability));
    const std::string known(reportHtml(f, today(), {}));
    EXPECT_TRUE(says(known, "nothing to test"));
    EXPECT_FALSE(says(known, "not tested"));

    judged(f).unknown = true;
    const std::string partly(reportHtml(f, today(), {}));
    EXPECT_TRUE(says(partly, "not tested: the answer has something unknown"));
    EXPECT_TRUE(says(partly, "nothing to test"));

    judged(f).mechanisms.clear();
    const std::string unknown(reportHtml(f, today(), {}));
    EXPECT_TRUE(says(unknown, "not tested: the answer has no known cause"));
    EXPECT_FALSE(says(unknown, "nothing to test"));
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
    EXPECT_FALSE(says(page, "e+"));
    EXPECT_TRUE(says(page, "more than 100000"));

    // In sentences too
    f.tests.held[0].use = purpose::validation;
    f.verdict.strengths = {{"porePressure", 1234567, 23456, false}};
    f.verdict.alternatives.clear();
    expectHolds(describe(f), "mean square more than 100000");
    expectLacks(describe(f), "e+");
    expectHolds(describe(f), "1230000");
    expectLacks(describe(droppedCandidate{"a", droppedCandidate::reason::small, "", 0.1, 1e20}), "e+");
    gate wide(gateKind::evidence, 12345, 10);
    expectHolds(gateWords(wide, f).dump(), "12300");
    EXPECT_TRUE(says(page, "less than -1000 %"));

    // Of a channel that shows nothing the range is nought
    stacked data(f.detection.data);
    data.segments[0].of(data.y).setZero();
    const place p{{0, 5, 9, 12}, 700};
    EXPECT_TRUE
    (
        says(describe(p, data), "the simulation is more than 1000 % of the range")
    );
}


TEST(misfitReport, aNumberInASentenceHasNoExponent)
{
    EXPECT_EQ(numberWords(0.125), "0.125");
    EXPECT_EQ(numberWords(1.5e-6), "1.5e-06");
    EXPECT_EQ(numberWords(9999.6), "10000");
    EXPECT_EQ(numberWords(123456, 3), "123000");
    EXPECT_EQ(numberWords(-123456, 2), "-120000");
    EXPECT_EQ(numberWords(2e17), "more than 1000000000");
    EXPECT_EQ(ratioWords(-1e6), "less than -100000");
    EXPECT_EQ(ratioWords(99999, 3), "100000");
    EXPECT_EQ(percentWords(-0.001), "0 %");
    EXPECT_EQ(percentWords(11), "more than 1000 %");
    EXPECT_EQ(percentWords(0), "0 %");
    EXPECT_EQ(percentWords(1), "100 %");
    EXPECT_EQ(percentWords(0.004), "less than 1 %");
    EXPECT_EQ(percentWords(0.006), "1 %");
    EXPECT_EQ(percentWords(0.994), "99 %");
    EXPECT_EQ(percentWords(0.9996), "more than 99 %");
    EXPECT_EQ(percentWords(1.004), "100 %");
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    EXPECT_EQ(percentWords(nan), "not known");
    EXPECT_EQ(numberWords(nan), "not known");
    EXPECT_EQ(ratioWords(-std::numeric_limits<scalar>::infinity()), "less than -100000");
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


TEST(misfitReport, theTerminalSaysOfWhatTheConfidenceIs)
{
    finding f(found());
    f.verdict.kind = verdictKind::registration;
    f.verdict.names = {"P1", "P2"};
    judged(f).mechanisms.clear();
    judged(f).fault = possibleFaults(f.detection.data, {faultKind::swapped}).front();
    f.explained.all().front().best.x.resize(0);
    const std::string text(summaryOf(f, "misfit"));
    expectHolds(text, "Confidence 90 % that the fault is at P1 and P2");
    expectHolds(text, "in all of which it was the clock");
    expectHolds(text, "misfit/verdict.json");
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
    EXPECT_TRUE(says(page, ">0 %<"));
    EXPECT_FALSE(says(page, "-0 %"));
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
        EXPECT_TRUE(says(words, word)) << word;
    }
}
