// SPDX-License-Identifier: GPL-3.0-or-later
// All recordings together: what is fitted, what is held out, and what is refused.

#include "recordedFiles.H"
#include "recordings.H"
#include "saidDuring.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;
using namespace Foam::recorded;

namespace
{

//- What is said of a whole dictionary, with good files a.csv and b.csv
std::string refusalOfAll(const std::string& entries, const label unknowns = 0)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    f.write("b.csv", "t_s,p_Pa\n0,1\n1,3\n2,4\n");
    IStringStream is(entries);
    const dictionary dict(is);
    return refusal
    (
        [&]() { recordings(dict, f.folder()).checkEnough(dict, unknowns); }
    );
}


const std::string twoChannels =
    "channels { S1 {" + pressure + "file \"a.csv\"; }"
    " S2 {" + pressure + "file \"b.csv\"; } }";

} // End anonymous namespace


TEST(misfitRecordings, heldOutChannelsAreNotFitted)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    f.write("b.csv", "t_s,p_Pa\n0,1\n1,3\n2,4\n");
    IStringStream is(twoChannels + "heldOut { validation (S2); }");
    const dictionary dict(is);
    const recordings all(dict, f.folder());
    EXPECT_EQ(all.select("A", purpose::calibration), labelList({0}));
    EXPECT_EQ(all.select("A", purpose::validation), labelList({1}));
    all.checkEnough(dict, 3);
}


TEST(misfitRecordings, allChannelsOfAHeldOutExperimentAreHeldOut)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    f.write("b.csv", "t_s,p_Pa\n0,1\n1,3\n2,4\n");
    IStringStream is
    (
        "experiments { A {} B { use test; } } channels { S1 {" + pressure
      + "file \"a.csv\"; } S2 {" + pressure
      + "file \"b.csv\"; experiment B; } }"
    );
    const recordings all(dictionary(is), f.folder());
    EXPECT_EQ(all.select("B", purpose::test), labelList({1}));
    EXPECT_TRUE(all.select("B", purpose::calibration).empty());
}


TEST(misfitRecordings, whatIsSealedIsNotUsedWhereItsExperimentGates)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    f.write("b.csv", "t_s,p_Pa\n0,1\n1,3\n2,4\n");
    IStringStream is
    (
        "experiments { A {} B { use validation; } } channels { S1 {" + pressure
      + "file \"a.csv\"; } S2 {" + pressure
      + "file \"b.csv\"; experiment B; } } heldOut { test (S2); }"
    );
    const recordings all(dictionary(is), f.folder());
    EXPECT_EQ(all.select("B", purpose::test), labelList({1}));
    EXPECT_TRUE(all.select("B", purpose::validation).empty());
}


TEST(misfitRecordings, heldOutDataListedTwiceIsRefused)
{
    const std::string twice("heldOut lists S2 twice");
    expectSays(refusalOfAll(twoChannels + "heldOut { validation (S2 S2); }"), twice);
    expectSays
    (
        refusalOfAll(twoChannels + "heldOut { validation (S2); test (S2); }"), twice
    );
    expectSays
    (
        refusalOfAll
        (
            "channels { S1 {" + pressure + "file \"a.csv\"; } S2 {" + pressure
          + "file \"a.csv\"; } } heldOut { validation (S2); }"
        ),
        "are the same numbers"
    );
}


TEST(misfitRecordings, aPartOfHeldOutDataIsRefusedTwoPartsOfAFileAreNot)
{
    const auto parts = [](const std::string& first, const std::string& second)
    {
        return
            "channels { S1 {" + pressure + "file \"a.csv\"; interval (" + first
          + "); } S2 {" + pressure + "file \"a.csv\"; interval (" + second
          + "); } } heldOut { validation (S2); }";
    };
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n3,5\n4,6\n5,6\n");
    IStringStream apart(parts("0 2.5", "2.5 5"));
    EXPECT_NO_THROW(recordings(dictionary(apart), f.folder()));
    IStringStream overlapping(parts("0 3.5", "1.5 5"));
    try
    {
        recordings(dictionary(overlapping), f.folder());
        FAIL();
    }
    catch (const Foam::error& e)
    {
        expectSays(e.message(), "have some of the same numbers");
    }
}


TEST(misfitRecordings, whatIsHeldOutMustBeRecorded)
{
    expectSays
    (
        refusalOfAll
        (
            "channels { S1 {" + pressure + "file \"a.csv\"; } S2 {" + pressure
          + "} } heldOut { validation (S2); }"
        ),
        "has no recording"
    );
    expectSays
    (
        refusalOfAll
        (
            twoChannels + "experiments { A { } B { use validation; } }"
        ),
        "experiment B has no recorded channel"
    );
}


TEST(misfitRecordings, aCopyOfHeldOutDataIsRefused)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    f.write("b.csv", "# a copy\nt_s,p_kPa\n0,0.001\n1,0.002\n2,0.004\n");
    IStringStream is(twoChannels + "heldOut { validation (S2); }");
    EXPECT_THROW(recordings(dictionary(is), f.folder()), Foam::error);
}


TEST(misfitRecordings, twoSensorsThatStayDryAreNotTakenForACopy)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,0\n1,0\n2,0\n");
    f.write("b.csv", "t_s,p_Pa\n0,0\n1,0\n2,0\n");
    IStringStream is(twoChannels + "heldOut { validation (S2); }");
    EXPECT_NO_THROW(recordings(dictionary(is), f.folder()));
}


TEST(misfitRecordings, theSameDataFittedTwiceAreToldOf)
{
    files f;
    f.write("a.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    f.write("b.csv", "t_s,p_Pa\n0,1\n1,2\n2,4\n");
    IStringStream is(twoChannels);
    const dictionary dict(is);
    const std::string said
    (
        saidDuring([&]() { EXPECT_NO_THROW(recordings(dict, f.folder())); })
    );
    expectSays(said, "The channels S1 and S2 are the same numbers");
    expectSays(said, "count twice");
}


TEST(misfitRecordings, anUnknownNameIsRefused)
{
    expectSays
    (
        refusalOfAll(twoChannels + "heldOut { validation (S3); }"),
        "which is no channel"
    );
    expectSays
    (
        refusalOfAll(twoChannels + "experiments { B { } }"),
        "Experiments: B"
    );
}


TEST(misfitRecordings, aFormerNameOfAUseIsRefusedWithThePresentOne)
{
    expectSays
    (
        refusalOfAll(twoChannels + "heldOut { gate (S2); }"),
        "is called validation now"
    );
    expectSays
    (
        refusalOfAll(twoChannels + "heldOut { score (S2); }"),
        "is called test now"
    );
    expectSays
    (
        refusalOfAll(twoChannels + "experiments { A { use fit; } }"),
        "is called calibration now"
    );
}


TEST(misfitRecordings, fewerSamplesThanUnknownsAreRefused)
{
    expectSays(refusalOfAll(twoChannels, 7), "6 samples for 7 unknowns");
    EXPECT_EQ(refusalOfAll(twoChannels, 6), "nothing");
}


TEST(misfitRecordings, nothingLeftToFitIsRefused)
{
    expectSays
    (
        refusalOfAll(twoChannels + "heldOut { validation (S1); test (S2); }"),
        "No recorded channel is left to calibrate with"
    );
}
