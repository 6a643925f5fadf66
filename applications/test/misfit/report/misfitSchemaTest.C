// SPDX-License-Identifier: GPL-3.0-or-later
// verdict.json of each kind of verdict is as its schema states, and the schema refuses
// what is wrong.

#include "adviceNames.H"
#include "correctedWorld.H"
#include "jsonSchema.H"
#include "lawFunctions.H"
#include "report.H"
#include "worldDiagnosis.H"

#include <gtest/gtest.h>

#include <algorithm>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

constexpr const char* ofVerdict = "verdict.schema.json";


//- As misfitFoam writes it
nlohmann::json written(const finding& f)
{
    return nlohmann::json::parse(verdictJson(f, "a case"));
}


//- Recordings with a bump that neither mechanism nor fault explains
vec outside()
{
    const world w(20);
    vec added = vec::Zero(w.data.size());
    for (label i = 0; i < count(w.data.segments); ++i)
    {
        const segment& s = w.data.segments[i];
        s.of(added).array() +=
            (s.quantity == "pressure" ? 150 : 0.015)
           *(-((s.x.array() - 3.2 + 0.3*i)/0.25).square()).exp();
    }
    return added;
}


//- The first gauge reads that much too high [Pa]
vec shifted(const scalar by)
{
    const world w(20);
    vec added = vec::Zero(w.data.size());
    w.data.segments[0].of(added).setConstant(by);
    return added;
}


nlohmann::json named()
{
    worldSampler s(truth(0, 0.7), 200, vec());
    return written(diagnose(s));
}


//- The words of an enumeration, in the schema and in the program
template<class Words>
void expectWords(const nlohmann::json& inSchema, const Words& words)
{
    const nlohmann::json& all = inSchema["enum"];
    EXPECT_EQ(all.size(), size_t(words.size()));
    for (const std::string& name : words)
    {
        EXPECT_NE(std::find(all.begin(), all.end(), name), all.end()) << name;
    }
}


template<class Enumeration>
void expectSameWords(const nlohmann::json& inSchema, const Enumeration& names)
{
    expectWords(inSchema, wordList(names.names()));
}


//- The record is refused, and the reason names the place
void expectRefused(const nlohmann::json& record, const char* place)
{
    const std::string errors(schemaErrors(ofVerdict, record));
    EXPECT_NE(errors.find(place), std::string::npos) << place << ": " << errors;
}

} // End anonymous namespace


TEST(misfitSchema, eachKindOfVerdictIsOfIt)
{
    worldSampler agreeing(truth(-1, 0), 300, vec());
    worldSampler one(truth(0, 0.7), 200, vec());
    worldSampler twins(truth(0, 0.7), 200, vec());
    twins.makeTwins();
    worldSampler faulty(truth(-1, 0), 300, shifted(90));
    worldSampler inKilo(truth(-1, 0), 300, vec());
    inKilo.mislabel(1e-3);
    worldSampler strange(truth(-1, 0), 400, outside());
    const std::pair<worldSampler*, const char*> kinds[] =
    {
        {&agreeing, "none"}, {&one, "named"}, {&twins, "set"}, {&faulty, "sensor"},
        {&inKilo, "registration"}, {&strange, "unknown"}
    };
    for (const auto& kind : kinds)
    {
        const nlohmann::json record(written(diagnose(*kind.first)));
        EXPECT_EQ(record["verdict"], kind.second);
        const bool isSet = record["verdict"] == "set";
        EXPECT_EQ(record["alternatives"].empty(), !isSet);
        EXPECT_EQ(record["advice"].is_null(), !isSet);
        expectOfSchema(ofVerdict, record);
    }
}


TEST(misfitSchema, aFreeCorrectionAndItsLawsAreOfIt)
{
    settings set(worldSettings());
    set.candidates.resize(1);
    set.correction = elements();
    HashTable<scalar> push;
    push.insert("push2_2", -45);
    correctedWorld w(push, HashTable<scalar>(), 500);
    const nlohmann::json record(written(misfit::diagnose(w, set)));
    EXPECT_FALSE(record["freeCorrection"]["elements"].empty());
    const nlohmann::json& laws = record["freeCorrection"]["laws"];
    ASSERT_FALSE(laws.empty());
    const nlohmann::json& function = laws[0]["functions"][0];
    EXPECT_NE(function["coefficient"], 0);
    EXPECT_GT(function["deviation"], 0);
    expectOfSchema(ofVerdict, record);
}


TEST(misfitSchema, runsThatFailAreOfIt)
{
    worldSampler s(truth(0, 0.7), 200, vec());
    s.crashWith(1);
    s.failReplicate(3);
    settings set(worldSettings());
    set.replicates = 8;
    set.commonRandomNumbers = 2;
    const nlohmann::json record(written(diagnose(s, set)));
    EXPECT_FALSE(record["dropped"].empty());
    ASSERT_FALSE(record["failedRuns"].empty());
    EXPECT_EQ(record["failedRuns"][0]["experiment"], "A");
    EXPECT_EQ(record["failedRuns"][0]["resolution"], "base");
    expectOfSchema(ofVerdict, record);
}


TEST(misfitSchema, aWrongRecordIsRefused)
{
    const nlohmann::json right(named());
    ASSERT_EQ(schemaErrors(ofVerdict, right), "");

    nlohmann::json wrong(right);
    wrong["verdict"] = "certain";
    expectRefused(wrong, "verdict");

    wrong = right;
    wrong["schema"] = recordSchema - 1;
    expectRefused(wrong, "schema");

    wrong = right;
    wrong["confidence"] = 90;
    expectRefused(wrong, "confidence");

    wrong = right;
    wrong["names"] = nlohmann::json::array();
    expectRefused(wrong, "names");

    // As NaN is written
    wrong = right;
    wrong["gates"][0]["value"] = nullptr;
    expectRefused(wrong, "value");

    wrong = right;
    wrong["gates"][0]["value"] = "0.001";
    expectRefused(wrong, "value");

    // As of a set
    wrong = right;
    wrong["alternatives"] =
        {{{"mechanisms", {"porePressure"}}, {"fault", nullptr}, {"unknown", false}}};
    expectRefused(wrong, "conditional");

    wrong = right;
    wrong["advice"] = "Measure P3";
    expectRefused(wrong, "advice");

    wrong = right;
    wrong["strengths"][0].erase("deviation");
    expectRefused(wrong, "deviation");

    wrong = right;
    wrong["located"][0]["unit"] = "s";
    expectRefused(wrong, "unit");

    // A fault beside a name
    wrong = right;
    wrong["fault"] =
    {
        {"channel", "P1"}, {"experiment", ""}, {"kind", "gain"},
        {"partner", nullptr}, {"values", {0.2}}, {"deviations", {0.1}}
    };
    expectRefused(wrong, "conditional");
    wrong["verdict"] = "sensor";
    EXPECT_EQ(schemaErrors(ofVerdict, wrong), "");
    wrong["fault"]["kind"] = "swapped with P2";
    EXPECT_NE(schemaErrors(ofVerdict, wrong), "");
}


TEST(misfitSchema, itHasTheWordsThatTheProgramHas)
{
    const nlohmann::json s(schemaOf(ofVerdict));
    expectSameWords(s["properties"]["verdict"], verdictNames);
    expectSameWords(s["definitions"]["use"], purposeNames);
    expectSameWords(s["definitions"]["gate"]["properties"]["name"], gateNames);
    const nlohmann::json& grounds = s["definitions"]["grounds"]["properties"];
    EXPECT_EQ(label(grounds.size()), groundNames.size());
    for (const word& name : groundNames)
    {
        EXPECT_TRUE(grounds.contains(name)) << name;
    }
    const nlohmann::json& dropped = s["properties"]["dropped"]["items"]["properties"];
    expectSameWords(dropped["reason"], dropReasonNames);
    expectWords(s["definitions"]["faultKind"], statistics::faultNames());
    wordList kinds;
    for (const word& kind : adviceNames.names())
    {
        if (adviceNames[kind] != advice::kind::nothing)
        {
            kinds.append(kind);
        }
    }
    expectWords(s["definitions"]["advice"]["properties"]["kind"], kinds);
    wordList functions;
    for (const elementFamily family : {elementFamily::drag, elementFamily::push})
    {
        for (const lawFunction& function : functionsOf(family))
        {
            functions.append(function.name);
        }
    }
    expectWords(s["definitions"]["lawFunction"]["properties"]["name"], functions);
    EXPECT_EQ(s["properties"]["schema"]["const"], recordSchema);
}
