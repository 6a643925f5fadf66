// SPDX-License-Identifier: GPL-3.0-or-later
// The record and the report of a diagnosis: whole, readable by programs, and
// with all that a reader needs in one file.

#include "report.H"
#include "misfitWorld.H"
#include "temporaryFolder.H"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

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
    f.verdict = "named";
    f.names = {"porePressure"};
    f.told = "Left out: \"pore\" <pressure>";
    f.confidence = 0.9;
    f.detection = {0.001, 0.001, 0.001, 100, {{0, 5, 9, 12}}};
    f.raw = f.detection;
    f.located = {"P1, 1 to 2 s"};
    f.strengths.append({"porePressure", 0.7, 0.1, false});
    f.gates.append({"detection", "chance", "0.001", "below 0.05", true, true});
    f.data = w.data;
    f.before = base;
    f.after = w.data.y;
    f.sigma = vec::Constant(base.size(), 20);
    f.sources =
    {
        {"sensors", vec::Constant(base.size(), 12)},
        {"mesh", vec::Constant(base.size(), 16)}
    };
    f.held.append
    ({
        "held-out channels", purpose::gate, w.data, base, w.data.y, f.sigma,
        9, 1
    });
    weighed best;
    best.what.mechanisms = {0};
    best.score = 0;
    f.explanations.append(best);
    f.library = {"porePressure"};
    return f;
}

} // End anonymous namespace


TEST(misfitReport, theRecordIsReadableByPrograms)
{
    const auto j = nlohmann::json::parse(verdictJson(found(), "case"));
    EXPECT_EQ(j["verdict"], "named");
    EXPECT_EQ(j["names"][0], "porePressure");
    EXPECT_EQ(j["words"], "Left out: \"pore\" <pressure>");
    EXPECT_EQ(j["located"][0]["channel"], "P1");
    EXPECT_EQ(j["gates"][0]["result"], "passed");
    EXPECT_EQ(j["heldOut"][0]["meanSquareAfter"], 1);
    EXPECT_NEAR(j["uncertainty"]["P1"]["whole"], 20, 1e-9);
    EXPECT_NEAR(j["uncertainty"]["P1"]["mesh"], 16, 1e-9);
}


TEST(misfitReport, oneFileHoldsWordsAndPictures)
{
    const temporaryFolder scratch;
    const fileName folder(scratch);
    writeReport(found(), folder, "a case");

    std::ifstream is(folder/"report.html");
    const std::string html
    (
        (std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>()
    );
    EXPECT_NE(html.find("&lt;pressure&gt;"), std::string::npos);
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
