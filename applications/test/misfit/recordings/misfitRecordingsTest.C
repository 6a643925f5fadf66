// SPDX-License-Identifier: GPL-3.0-or-later
// All recordings together: what is fitted, what is held out, and what is refused.

#include "recordedFiles.H"
#include "recordings.H"
#include "report.H"
#include "terminalOutput.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;
using namespace Foam::recorded;

namespace
{

//- A dictionary, and two files that it may name
struct twoFiles
:
    files
{
    const dictionary dict;

    explicit twoFiles
    (
        const std::string& entries,
        const std::string& a = "t_s,p_Pa\n0,1\n1,2\n2,4\n",
        const std::string& b = "t_s,p_Pa\n0,1\n1,3\n2,4\n"
    )
    :
        dict(IStringStream(entries)())
    {
        write("a.csv", a);
        write("b.csv", b);
    }

    recordings read() const
    {
        return recordings(dict, folder());
    }
};


//- The error for a whole dictionary, with good files a.csv and b.csv
std::string refusalOfAll(const std::string& entries, const label unknowns = 0)
{
    const twoFiles f(entries);
    return refusal([&]() { f.read().checkEnough(f.dict, unknowns); });
}


//- The channels S1 of the file a.csv and S2 of another one, with these entries beside
std::string channels
(
    const std::string& ofFirst = "",
    const std::string& ofSecond = "file \"b.csv\";"
)
{
    return
        "channels { S1 {" + pressure + "file \"a.csv\"; " + ofFirst + "} S2 {"
      + pressure + ofSecond + "} } ";
}


const std::string twoChannels(channels());

} // End anonymous namespace


TEST(misfitRecordings, theReportHasTheirFilesWhateverColumnsAndValuesAreCalled)
{
    const twoFiles f
    (
        "channels { S1 {" + pressure + "file \"a.csv\"; column \"0:p\"; unit Pa; } a:b {"
      + pressure + "value 3; unit Pa; } }",
        "t_s,0:p\n0,1\n1,2\n2,4\n"
    );
    const stringList row(originOf("a case", f.read(), {}).experiments.first());
    EXPECT_EQ(row[1], "S1, a:b");
    EXPECT_EQ(row[4], "a.csv");
}


TEST(misfitRecordings, heldOutChannelsAreNotFitted)
{
    const twoFiles f(twoChannels + "heldOut { validation (S2); }");
    const recordings all(f.read());
    EXPECT_EQ(all.select("A", purpose::calibration), labelList({0}));
    EXPECT_EQ(all.select("A", purpose::validation), labelList({1}));
    all.checkEnough(f.dict, 3);
}


TEST(misfitRecordings, allChannelsOfAHeldOutExperimentAreHeldOut)
{
    const twoFiles f
    (
        "experiments { A {} B { use test; } } "
      + channels("", "file \"b.csv\"; experiment B;")
    );
    const recordings all(f.read());
    EXPECT_EQ(all.select("B", purpose::test), labelList({1}));
    EXPECT_TRUE(all.select("B", purpose::calibration).empty());
}


TEST(misfitRecordings, whatIsSealedIsNotUsedWhereItsExperimentGates)
{
    const twoFiles f
    (
        "experiments { A {} B { use validation; } } heldOut { test (S2); } "
      + channels("", "file \"b.csv\"; experiment B;")
    );
    const recordings all(f.read());
    EXPECT_EQ(all.select("B", purpose::test), labelList({1}));
    EXPECT_TRUE(all.select("B", purpose::validation).empty());
}


TEST(misfitRecordings, heldOutDataListedTwiceIsRefused)
{
    const std::string twice("heldOut lists S2 twice");
    expectHolds(refusalOfAll(twoChannels + "heldOut { validation (S2 S2); }"), twice);
    expectHolds
    (
        refusalOfAll(twoChannels + "heldOut { validation (S2); test (S2); }"), twice
    );
    expectHolds
    (
        refusalOfAll
        (
            channels("", "file \"a.csv\";") + "heldOut { validation (S2); }"
        ),
        "are the same numbers"
    );
}


TEST(misfitRecordings, aRepeatThatIsHeldOutElsewhereIsRefused)
{
    expectHolds
    (
        refusalOfAll
        (
            channels("repeats (\"b.csv\");", "file \"b.csv\";")
          + "heldOut { validation (S2); }"
        ),
        "are the same numbers"
    );
}


TEST(misfitRecordings, aPartOfHeldOutDataIsRefusedTwoPartsOfAFileAreNot)
{
    const auto parts = [](const std::string& first, const std::string& second)
    {
        const twoFiles f
        (
            channels
            (
                "interval (" + first + ");",
                "file \"a.csv\"; interval (" + second + ");"
            )
          + "heldOut { validation (S2); }",
            "t_s,p_Pa\n0,1\n1,2\n2,4\n3,5\n4,6\n5,6\n"
        );
        return refusal([&]() { f.read(); });
    };
    EXPECT_EQ(parts("0 2.5", "2.5 5"), "nothing");
    expectHolds(parts("0 3.5", "1.5 5"), "have some of the same numbers");
}


TEST(misfitRecordings, whatIsHeldOutMustBeRecorded)
{
    expectHolds
    (
        refusalOfAll
        (
            channels("", "") + "heldOut { validation (S2); }"
        ),
        "has no recording"
    );
    expectHolds
    (
        refusalOfAll(twoChannels + "experiments { A { } B { use validation; } }"),
        "experiment B has no recorded channel"
    );
}


TEST(misfitRecordings, aCopyOfHeldOutDataIsRefused)
{
    const twoFiles f
    (
        twoChannels + "heldOut { validation (S2); }",
        "t_s,p_Pa\n0,1\n1,2\n2,4\n",
        "# a copy\nt_s,p_kPa\n0,0.001\n1,0.002\n2,0.004\n"
    );
    EXPECT_THROW(f.read(), Foam::error);
}


TEST(misfitRecordings, twoSensorsThatStayDryAreNotTakenForACopy)
{
    const std::string dry("t_s,p_Pa\n0,0\n1,0\n2,0\n");
    const twoFiles f(twoChannels + "heldOut { validation (S2); }", dry, dry);
    EXPECT_NO_THROW(f.read());
}


TEST(misfitRecordings, theSameDataFittedTwiceAreReported)
{
    const std::string same("t_s,p_Pa\n0,1\n1,2\n2,4\n");
    const twoFiles f(twoChannels, same, same);
    const std::string output(outputDuring([&]() { EXPECT_NO_THROW(f.read()); }));
    expectHolds(output, "The channels S1 and S2 are the same numbers");
    expectHolds(output, "count twice");
}


TEST(misfitRecordings, anUnknownNameIsRefused)
{
    expectHolds
    (
        refusalOfAll(twoChannels + "heldOut { validation (S3); }"),
        "which is no channel"
    );
    expectHolds
    (
        refusalOfAll(twoChannels + "experiments { B { } }"),
        "Experiments: B"
    );
}


TEST(misfitRecordings, aFormerNameOfAUseIsRefusedWithThePresentOne)
{
    const auto output = [](const std::string& use)
    {
        return refusalOfAll(twoChannels + use);
    };
    expectHolds(output("heldOut { gate (S2); }"), "is called validation now");
    expectHolds(output("heldOut { score (S2); }"), "is called test now");
    expectHolds(output("experiments { A { use fit; } }"), "is called calibration now");
}


TEST(misfitRecordings, fewerSamplesThanUnknownsAreRefused)
{
    expectHolds(refusalOfAll(twoChannels, 7), "6 samples for 7 unknowns");
    EXPECT_EQ(refusalOfAll(twoChannels, 6), "nothing");
}


TEST(misfitRecordings, nothingLeftToFitIsRefused)
{
    expectHolds
    (
        refusalOfAll(twoChannels + "heldOut { validation (S1); test (S2); }"),
        "No recorded channel is left to calibrate with"
    );
}
