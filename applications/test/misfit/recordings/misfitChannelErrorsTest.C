// SPDX-License-Identifier: GPL-3.0-or-later
// A recording that has something wrong with it is refused with a clear message.

#include "recordedChannel.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;
using namespace Foam::recorded;


TEST(misfitChannel, aNumberAloneWithoutItsUnitOrBesideAFileIsRefused)
{
    const std::string good("t_s,p_Pa\n0,1\n1,2\n2,4\n");
    expectHolds(refusalOf(good, "value 3;"), "needs its unit");
    expectHolds(refusalOf(good, "value 3; unit Pa; file \"S1.csv\";"), "no file");
    expectHolds(refusalOf(good, "value 3; unit mm;"), "no unit of pressure");
}


TEST(misfitChannel, aMissingUnitIsRefused)
{
    expectHolds(refusalOf("t_s,p\n0,1\n1,2\n2,3\n"), "has no known unit");
    expectHolds(refusalOf("t,p_Pa\n0,1\n1,2\n2,3\n"), "Units of time");
}


TEST(misfitChannel, aWrongUnitIsRefused)
{
    expectHolds(refusalOf("t_s,p_mm\n0,1\n1,2\n2,3\n"), "no unit of pressure");
    expectHolds(refusalOf("t_s,p_mm\n0,1\n1,2\n2,3\n"), "kPa");
    expectHolds
    (
        refusalOf("t_s,p_Pa\n0,1\n1,2\n2,3\n", "file \"S1.csv\"; unit kPa;"),
        "Remove one of them"
    );
}


TEST(misfitChannel, whatIsNoFiniteNumberIsRefusedWithItsLine)
{
    for (const char* bad : {"nan", "inf", "1e999", "1.2.3", "", "12 Pa"})
    {
        const std::string output
        (
            refusalOf(std::string("t_s,p_Pa\n0,1\n1,") + bad + "\n2,3\n")
        );
        expectHolds(output, "Line 3 of");
        expectHolds(output, "no finite number");
    }
    expectHolds(refusalOf("t_s,p_Pa\n0,1\n1\n2,3\n"), "has 1 cells for 2 columns");
}


TEST(misfitChannel, whatStandsForNotRecordedIsRefusedWithItsLine)
{
    const std::string text("t_s,p_Pa\n0,1\n1,-9999\n2,-9999\n3,5\n4,-77\n");
    for (const char* other : {"", "scale 2;"})
    {
        const std::string output
        (
            refusalOf(text, std::string("file \"S1.csv\";") + other)
        );
        expectHolds(output, "Line 3 of");
        expectHolds(output, "holds -9999 in the column \"p_Pa\"");
        expectHolds(output, "are 2 such lines");
        expectHolds(output, "missing ();");
    }
    expectHolds(refusalOf(text, "file \"S1.csv\"; missing (-77);"), "Line 6 of");
    EXPECT_EQ(refusalOf(text, "file \"S1.csv\"; missing ();"), "nothing");
}


TEST(misfitChannel, commasInNumbersAndOtherCodingsAreReported)
{
    const std::string points("Write points, not commas");
    expectHolds(refusalOf("t_s,p_Pa\n0,0,1,0\n1,0,2,0\n"), points);
    expectHolds
    (
        refusalOf("Logger 3\nt_s,p_Pa\n0,1\n1,2\n2,4\n"),
        "begin each line above the names with #"
    );
    EXPECT_EQ(refusalOf("t_s,p_Pa\n0,1\n1\n").find(points), std::string::npos);
    const std::string wide("\xFF\xFEt\0_\0s\0,\0p\0\n\0", 15);
    expectHolds(refusalOf(wide), "not in UTF-16");
}


TEST(misfitChannel, timesThatCountFromElsewhereAreReportedInFull)
{
    const std::string output
    (
        refusalOf
        (
            "t_s,p_Pa\n1764162816.25,1\n1764162816.5,2\n1764162817,4\n",
            "file \"S1.csv\"; interval (0 1);"
        )
    );
    expectHolds(output, "covers 1764162816.25 to 1764162817.");
    expectHolds(output, "xOffset");
}


TEST(misfitChannel, aFileNameWithABlankIsReportedAsSuch)
{
    const std::string output(refusalOf("", "file \"run 1/S1.csv\";"));
    expectHolds(output, "run 1/S1.csv");
    expectHolds(output, "Rename it");
}


TEST(misfitChannel, aFileWithoutNamesOrNumbersIsRefused)
{
    expectHolds(refusalOf("0,1\n1,2\n"), "no line of column names");
    expectHolds(refusalOf("t_s,p_Pa\n"), "holds no numbers");
    const std::string none(refusalOf("", "file \"none.csv\";"));
    expectHolds(none, "channel S1");
    expectHolds(none, "there is no file");
    expectHolds(none, "none.csv");
    expectHolds(none, "Correct file");
    expectHolds
    (
        refusalOf("t_s,p_Pa\n0,1\n", "file \"S1.csv\"; column q;"),
        "has no column \"q\""
    );
}


TEST(misfitChannel, aVariableInTheNameMustBeSetOrHaveADefault)
{
    const std::string text("t_s,p_Pa\n0,1\n1,2\n2,5\n3,6\n");
    expectHolds(refusalOf(text, "file \"$NOT_SET/S1.csv\";"), "export NOT_SET=");
    expectHolds(refusalOf(text, "file \"${HOME}${NOT_SET}/S1.csv\";"), "export NOT_SET=");

    files f;
    f.write("S1.csv", text);
    const std::string folder("${NOT_SET:-" + f.folder() + "}");
    EXPECT_EQ(channelOf("", "file \"" + folder + "/S1.csv\";").samples.size, 4);
}


TEST(misfitChannel, unsortedTimesAreRefused)
{
    expectHolds(refusalOf("t_s,p_Pa\n0,1\n2,2\n1,3\n"), "Line 4 of");
    expectHolds(refusalOf("t_s,p_Pa\n0,1\n2,2\n1,3\n"), "Sort the file");
}


TEST(misfitChannel, duplicateTimesAreRefusedOrAveraged)
{
    const std::string text("t_s,p_Pa\n0,1\n1,2\n1,4\n2,5\n3,6\n");
    expectHolds(refusalOf(text), "duplicates average;");

    const channel c(channelOf(text, "file \"S1.csv\"; duplicates average;"));
    ASSERT_EQ(c.samples.size, 4);
    EXPECT_EQ(c.sampled(c.recorded)[1], 3);
}


TEST(misfitChannel, anUnknownKeyOrQuantityIsRefused)
{
    expectHolds(refusalOf("", "filee \"S1.csv\";"), "filee");
    IStringStream is
    (
        "quantity stress; uncertainty 1; simulated { type probe; }"
    );
    const dictionary dict(is);
    expectHolds
    (
        refusal([&]() { channel("S1", dict, purpose::calibration, "", 40); }),
        "Valid quantities"
    );
}
