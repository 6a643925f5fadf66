// SPDX-License-Identifier: GPL-3.0-or-later
// Keywords of system/misfitDict that have another name now.

#include "terminalOutput.H"
#include "settings.H"

#include "IStringStream.H"

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- The error for a dictionary with these entries
std::string refusalOf(const std::string& entries)
{
    return refusal([&]{ readSettings(dictionary(IStringStream(entries)())); });
}


//- True if the error names the present keyword in place of the old one
bool isNamed(const std::string& entries, const std::string& present)
{
    return
        refusalOf(entries).find("is called " + present + " now")
     != std::string::npos;
}

} // End anonymous namespace


TEST(misfitSettings, aFormerKeywordIsAnErrorThatNamesThePresentOne)
{
    EXPECT_TRUE(isNamed("trigger 0.01;", "clockUncertainty"));
    EXPECT_TRUE(isNamed("packing ();", "replicateChanges"));
    EXPECT_TRUE(isNamed("packings 20;", "replicates"));
    EXPECT_TRUE(isNamed("common 3;", "commonRandomNumbers"));
    EXPECT_TRUE(isNamed("bank 100;", "trainingEnsemble"));
    EXPECT_TRUE
    (
        isNamed("decision { formulaTolerance 0.2; }", "modelDiscrepancy")
    );
}


TEST(misfitSettings, thePresentKeywordsAreRead)
{
    const settings s
    (
        readSettings
        (
            dictionary
            (
                IStringStream
                (
                    "clockUncertainty 0.01; replicateChanges (); replicates 12;"
                    " commonRandomNumbers 2; trainingEnsemble 100; chaotic yes;"
                    " decision { modelDiscrepancy 0.3; }"
                )()
            )
        )
    );
    EXPECT_EQ(s.clockUncertainty, 0.01);
    EXPECT_EQ(s.replicates, 12);
    EXPECT_EQ(s.commonRandomNumbers, 2);
    EXPECT_EQ(s.trainingEnsemble, 100);
    EXPECT_TRUE(s.chaotic);
    EXPECT_EQ(s.modelDiscrepancy, 0.3);
}


TEST(misfitSettings, aParameterIsKnownAsWellAsItWasMeasured)
{
    const auto read = [](const std::string& measured)
    {
        return readSettings
        (
            dictionary
            (
                IStringStream
                (
                    "parameters { slope { mean 1; deviation 0.5; bounds (0 3); "
                  + measured
                  + " changes ({ file g; entry along; }); } }"
                )()
            )
        ).parameters[0];
    };
    const parameter p(read("measured (1.2 0.1);"));
    EXPECT_EQ(p.mean, 1);
    EXPECT_EQ(p.deviation, 0.5);
    EXPECT_EQ(p.measured, 1.2);
    EXPECT_EQ(p.measuredDeviation, 0.1);
    EXPECT_EQ(read("").measured, 1);
    EXPECT_EQ(read("").measuredDeviation, 0.5);
    EXPECT_TRUE(p.isMeasured);
    EXPECT_FALSE(read("").isMeasured);
    for (const char* wrong : {"(-0.1 0.1)", "(2.1 0.1)", "(1 0)", "(1 0.6)"})
    {
        expectHolds
        (
            refusal([&]{ read("measured " + std::string(wrong) + ";"); }),
            "within the bounds (0 3) and two deviations"
        );
    }
}


TEST(misfitSettings, chaosNeedsReplicatesToBeKnown)
{
    expectHolds(refusalOf("chaotic yes; replicates 12;"), "give replicateChanges");
    expectHolds
    (
        refusalOf("chaotic yes; replicateChanges (); replicates 2;"),
        "3 replicates or more"
    );
    EXPECT_EQ(refusalOf("chaotic yes; replicateChanges (); replicates 3;"), "nothing");
}


TEST(misfitSettings, anotherMeshHasReplicatesOnlyWhereRunsDifferByChance)
{
    const std::string three("replicateChanges (); replicates 3; resolutionReplicates ");
    EXPECT_EQ(refusalOf("chaotic yes; " + three + "3;"), "nothing");
    expectHolds(refusalOf("chaotic yes; " + three + "4;"), "number of replicates, 3");
    expectHolds(refusalOf(three + "2;"), "without 'chaotic yes' give 1");
    expectHolds(refusalOf("resolutionReplicates 0;"), "give 1");
}


TEST(misfitSettings, replicatesThatDoNothingOrHaveNoSpreadAreWarnedOf)
{
    const auto output = [](const std::string& entries)
    {
        return outputDuring
        (
            [&]() { readSettings(dictionary(IStringStream(entries)())); }
        );
    };
    const std::string one(output("replicateChanges (); replicates 1;"));
    expectHolds(one, "replicates is 1");
    expectHolds(one, "20 are advised");
    const std::string idle(output("replicates 4;"));
    expectHolds(idle, "replicates is 4");
    expectHolds(idle, "give replicateChanges");

    for (const char* right : {"", "replicates 1;", "replicateChanges (); replicates 20;"})
    {
        expectLacks(output(right), "replicates is");
    }
}
