// SPDX-License-Identifier: GPL-3.0-or-later
// The record and the report of a diagnosis: whole, readable by programs, and
// with all that a reader needs in one file.

#include "report.H"
#include "misfitWorld.H"
#include "temporaryFolder.H"

#include "StringStream.H"

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
    writeReport(found(), folder, today());

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

    // A candidate that is called as a word of the sentence is not meant by it
    f.told = "Nothing passes the gate porePressure.";
    f.names = {"porePressures"};
    f.explanations[0].what.mechanisms.clear();
    EXPECT_FALSE(says(box(f), "water that cannot leave"));
    f.verdict = "set";
    f.names = {"gate", word("porePressure and walls", false)};
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
            "Confidence 90 % that this is at least part of what is missing, among"
            " the explanations that were weighed."
        )
    );
    f.names.append("gate");
    f.verdict = "set";
    EXPECT_TRUE(says(box(f), "90 % that one of these is at least part"));
    f.verdict = "sensor";
    f.names = {"P1"};
    EXPECT_TRUE(says(box(f), "90 % that the fault is at P1"));
    f.names.clear();
    f.verdict = "unknown";
    EXPECT_TRUE(says(box(f), "90 % that no candidate and no fault of one sensor"));
    f.verdict = "none";
    EXPECT_TRUE(says(box(f), "90 % that nothing missing and no fault is needed"));
}


TEST(misfitReport, theTopSaysWhatWasNotWeighed)
{
    finding f(found());
    EXPECT_FALSE(says(box(f), "Not weighed"));

    f.dropped =
    {
        {"lift", "the solver failed with it: floating point exception"},
        {"gate", "the recording differs the other way in what it changes"}
    };
    EXPECT_TRUE
    (
        says
        (
            box(f),
            "Not weighed: lift (the solver failed with it), gate (the recording"
            " differs the other way in what it changes)."
        )
    );
}


TEST(misfitReport, aGateThatCouldNotBeAskedIsToldFromOneWithNothingToAsk)
{
    finding f(found());
    f.gates =
    {
        {"adequacy", "", "", "", false, true},
        {"stability", "", "", "", false, true}
    };
    const std::string known(reportHtml(f, today(), {}));
    EXPECT_TRUE(says(known, "nothing to ask"));
    EXPECT_FALSE(says(known, "not asked"));

    f.explanations[0].what.unknown = true;
    const std::string partly(reportHtml(f, today(), {}));
    EXPECT_TRUE(says(partly, "not asked: the answer has something unknown"));
    EXPECT_TRUE(says(partly, "nothing to ask"));

    f.explanations[0].what.mechanisms.clear();
    const std::string unknown(reportHtml(f, today(), {}));
    EXPECT_TRUE(says(unknown, "not asked: nothing that is known is judged"));
    EXPECT_FALSE(says(unknown, "nothing to ask"));
}


TEST(misfitReport, noNumberIsTooLargeToRead)
{
    finding f(found());
    f.held[0].squareBefore = 2;
    f.held[0].squareAfter = 1e17;
    weighed far(f.explanations[0]);
    far.what.mechanisms.clear();
    far.score = 1.3e297;
    f.explanations.append(far);
    f.correction.asked = true;
    f.correction.held = f.held;
    const std::string page(reportHtml(f, today(), {}));
    EXPECT_FALSE(says(page, "e+"));
    EXPECT_TRUE(says(page, "more than 100000"));
    EXPECT_TRUE(says(page, "less than -1000 %"));

    // Of a channel that shows nothing the range is nought
    stacked data(f.data);
    data.segments[0].of(data.y).setZero();
    const vec misfit = vec::Constant(data.size(), 700);
    const window w{0, 5, 9, 12};
    EXPECT_TRUE
    (
        says(told(w, data, misfit), "the simulation is more than 1000 % of the range")
    );
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
