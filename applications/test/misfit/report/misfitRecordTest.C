// SPDX-License-Identifier: GPL-3.0-or-later
// The record of a diagnosis and its summary: whole, and readable by programs.

#include "jsonSchema.H"
#include "terminalOutput.H"
#include "testFinding.H"
#include "words.H"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

using namespace Foam;
using namespace Foam::misfit;


TEST(misfitRecord, theRecordIsReadableByPrograms)
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


TEST(misfitRecord, theRecordIsOfItsSchemaAndReadsBackAsItWasFound)
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
    EXPECT_EQ(j["heldOut"][0]["experiment"], "");
    EXPECT_EQ(j["heldOut"][0]["channels"][0], f.tests.held[0].data.segments[0].name);
    EXPECT_EQ(j["heldOut"][0]["use"], purposeNames[f.tests.held[0].use]);
    EXPECT_EQ(j["heldOut"][0]["meanSquareBefore"], f.tests.held[0].squareBefore);
}


TEST(misfitRecord, theRecordOfASetHasItsExplanationsAndEachNameOnce)
{
    finding f(found());
    f.verdict.kind = verdictKind::set;
    f.verdict.names.clear();
    hypothesisFit fault;
    fault.what.fault = possibleFaults(f.detection.data, {faultKind::gain}).front();
    f.verdict.alternatives = {mechanisms({0, 1}), mechanisms({1}), fault};
    const auto j = nlohmann::json::parse(verdictJson(f, "case"));
    EXPECT_EQ(j["names"], nlohmann::json({"porePressure", "walls", "P1"}));
    const auto& all = j["alternatives"];
    ASSERT_EQ(all.size(), 3);
    EXPECT_EQ(all[0]["mechanisms"], nlohmann::json({"porePressure", "walls"}));
    EXPECT_TRUE(all[0]["fault"].is_null());
    EXPECT_TRUE(all[2]["mechanisms"].empty());
    EXPECT_EQ(all[2]["fault"]["channel"], "P1");
    EXPECT_EQ(all[2]["fault"]["kind"], "gain");
    EXPECT_TRUE(all[2]["fault"]["partner"].is_null());

    // Both channels of an exchange, and the sentence has what each explanation is called
    f.verdict.alternatives.back().what.fault =
        possibleFaults(f.detection.data, {faultKind::swapped}).front();
    EXPECT_EQ(answerOf(f), wordList({"porePressure", "walls", "P1", "P2"}));
    expectHolds(describe(f), "or swapped of P1 with P2");

    f.verdict.alternatives[1].what.unknown = true;
    const auto other = nlohmann::json::parse(verdictJson(f, "case"))["alternatives"];
    EXPECT_FALSE(other[0]["unknown"]);
    EXPECT_TRUE(other[1]["unknown"]);
}


TEST(misfitRecord, adviceHasItsKindAndWhatItIsAbout)
{
    finding f(found());
    const auto record = [&f]()
    {
        return nlohmann::json::parse(verdictJson(f, "case"))["advice"];
    };
    EXPECT_TRUE(record().is_null());

    advice& a = f.verdict.measure;
    a.what = advice::kind::measure;
    a.two = {mechanisms({0}).what, mechanisms({1}).what};
    a.channel = f.detection.data.segments[1];
    a.at = 1.5;
    a.times = 4;
    const nlohmann::json measured(record());
    EXPECT_EQ(measured["kind"], "measure");
    EXPECT_EQ(measured["explanations"][1]["mechanisms"][0], "walls");
    EXPECT_EQ(measured["channels"], nlohmann::json::array({"P2"}));
    EXPECT_EQ(measured["at"], 1.5);
    EXPECT_EQ(measured["times"], 4);
    EXPECT_EQ(measured["words"], adviceOf(f));
    expectHolds(reportHtml(f, today(), {}), "<p>Measure P2: at 1.5 s, porePressure");

    a = advice();
    a.what = advice::kind::check;
    f.tests.winners = {{"P1", mechanisms({1})}};
    const nlohmann::json checked(record());
    EXPECT_EQ(checked["kind"], "check");
    EXPECT_EQ(checked["channels"], nlohmann::json::array({"P1"}));
    EXPECT_TRUE(checked["at"].is_null());
    EXPECT_TRUE(checked["explanations"].empty());
}


TEST(misfitRecord, aNamedLawHasItsNumbers)
{
    finding f(found());
    f.correction.isRequested = true;
    fittedLaw l;
    l.law.family = elementFamily::drag;
    l.law.groups = {"Re_p"};
    l.law.functions = {0, 1};
    l.law.middle = {1, 30};
    l.coefficients = vec::Constant(2, -0.25);
    l.deviations = vec::Constant(2, 0.125);
    l.lead = 7;
    f.correction.laws.append(l);
    l.law.family = elementFamily::push;
    l.law.functions = {3};
    f.correction.laws.append(l);
    const auto laws =
        nlohmann::json::parse(verdictJson(f, "case"))["freeCorrection"]["laws"];
    const nlohmann::json& functions = laws[0]["functions"];
    ASSERT_EQ(functions.size(), 2);
    EXPECT_EQ(functions[0]["name"], "factor");
    EXPECT_EQ(functions[0]["middle"], 1);
    EXPECT_EQ(functions[1]["name"], "Re_p");
    EXPECT_EQ(functions[1]["coefficient"], -0.25);
    EXPECT_EQ(functions[1]["deviation"], 0.125);
    EXPECT_EQ(functions[1]["middle"], 30);
    EXPECT_EQ(laws[1]["functions"][0]["name"], "solid");

    f.correction.explained = true;
    f.correction.named = true;
    expectHolds(describe(f), "Left out, and in no candidate: It acts like the drag");
    expectHolds(templateText("words"), "Left out, and in no candidate: ");
}


TEST(misfitRecord, aFailedRunHasItsStateAndWhy)
{
    finding f(found());
    runState state;
    state.experiment = "B";
    state.replicate = 2;
    state.resolution = "mesh";
    state.parameters.set("friction", 0.5);
    state.strengths.set("walls", 0.25);
    f.failedRuns.append({state, "out of memory"});
    const auto run = nlohmann::json::parse(verdictJson(f, "case"))["failedRuns"][0];
    EXPECT_EQ(run["experiment"], "B");
    EXPECT_EQ(run["replicate"], 2);
    EXPECT_EQ(run["resolution"], "mesh");
    EXPECT_EQ(run["parameters"]["friction"], 0.5);
    EXPECT_EQ(run["strengths"]["walls"], 0.25);
    EXPECT_EQ(run["why"], "out of memory");
    expectHolds
    (
        reportHtml(f, today(), {}),
        "<td>experiment B, friction 0.5, walls 0.25, replicate 2, other mesh:"
        " out of memory"
    );
}


TEST(misfitRecord, anExplanationHasItsMechanismsItsFaultAndWhetherMoreIsUnknown)
{
    finding f(found());
    hypothesisFit both(mechanisms({0, 1}));
    both.what.unknown = true;
    both.score = -1e6;
    both.probability = 0.75;
    hypothesisFit exchange;
    exchange.what.fault =
        possibleFaults(f.detection.data, {faultKind::swapped}).front();
    exchange.score = -1e5;
    exchange.probability = 0.25;
    f.explained.all().push_back(both);
    f.explained.all().push_back(exchange);
    const auto all = nlohmann::json::parse(verdictJson(f, "case"))["posterior"];
    EXPECT_EQ(all[0]["mechanisms"], nlohmann::json({"porePressure", "walls"}));
    EXPECT_TRUE(all[0]["fault"].is_null());
    EXPECT_EQ(all[0]["unknown"], true);
    EXPECT_EQ(all[0]["probability"], 0.75);
    EXPECT_TRUE(all[1]["mechanisms"].empty());
    EXPECT_EQ(all[1]["fault"]["channel"], "P1");
    EXPECT_EQ(all[1]["fault"]["kind"], "swapped");
    EXPECT_EQ(all[1]["fault"]["partner"], "P2");
    EXPECT_EQ(all[1]["unknown"], false);
}


TEST(misfitRecord, aDroppedCandidateHasItsReasonWithTheNumbersOfIt)
{
    using reason = droppedCandidate::reason;
    finding f(found());
    f.candidates.dropped =
    {
        {"gate", reason::small, "", 0.1, 0.4},
        {"lift", reason::failed, "floating point exception", 0.2, 0.4}
    };
    const auto all = nlohmann::json::parse(verdictJson(f, "case"))["dropped"];
    EXPECT_EQ(all[0]["name"], "gate");
    EXPECT_EQ(all[0]["reason"], "small");
    EXPECT_EQ(all[0]["bound"], 0.1);
    EXPECT_EQ(all[0]["misfit"], 0.4);
    EXPECT_EQ(all[0]["failure"], "");
    EXPECT_EQ(all[1]["reason"], "failed");
    EXPECT_EQ(all[1]["failure"], "floating point exception");
    EXPECT_TRUE(all[1]["bound"].is_null());
    EXPECT_TRUE(all[1]["misfit"].is_null());
}


TEST(misfitRecord, aGateOfAnotherExperimentNamesItAndItsChannels)
{
    finding f(found());
    f.tests.held[0].what = heldOut::part::experiment;
    f.tests.held[0].experiment = "B";
    gate ofHeld(gateKind::transfer, 0.5, 1);
    ofHeld.held = 0;
    gate failing(gateKind::computed, 0, 1);
    failing.experiment = "C";
    f.tests.gates = gateList();
    f.tests.gates.add(gate(gateKind::detection, 0.001, 0.01));
    f.tests.gates.add(ofHeld);
    f.tests.gates.add(failing);
    const auto j = nlohmann::json::parse(verdictJson(f, "case"));
    EXPECT_EQ(j["heldOut"][0]["experiment"], "B");
    EXPECT_EQ(j["gates"][0]["experiment"], "");
    EXPECT_TRUE(j["gates"][0]["channels"].empty());
    EXPECT_EQ(j["gates"][1]["experiment"], "B");
    EXPECT_EQ(j["gates"][1]["channels"], j["heldOut"][0]["channels"]);
    EXPECT_EQ(j["gates"][2]["experiment"], "C");
    EXPECT_TRUE(j["gates"][2]["channels"].empty());
}


TEST(misfitRecord, aNumberInASentenceHasNoExponent)
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


TEST(misfitRecord, theTerminalStatesOfWhatTheConfidenceIs)
{
    finding f(found());
    f.verdict.kind = verdictKind::registration;
    f.verdict.names = {"P1", "P2"};
    judged(f).mechanisms.clear();
    judged(f).fault = possibleFaults(f.detection.data, {faultKind::swapped}).front();
    f.explained.all().front().fit.x.resize(0);
    const std::string text(summaryOf(f, "misfit"));
    expectHolds(text, "Confidence 90 % that the fault is at P1 and P2");
    expectHolds(text, "in all of which it was the clock");
    expectHolds(text, "misfit/verdict.json");
}
