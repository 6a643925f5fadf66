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


//- What is said of a whole dictionary, with good files a.csv and b.csv
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
    expectSays(refusalOfAll(twoChannels + "heldOut { validation (S2 S2); }"), twice);
    expectSays
    (
        refusalOfAll(twoChannels + "heldOut { validation (S2); test (S2); }"), twice
    );
    expectSays
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
    expectSays
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
    expectSays(parts("0 3.5", "1.5 5"), "have some of the same numbers");
}


TEST(misfitRecordings, whatIsHeldOutMustBeRecorded)
{
    expectSays
    (
        refusalOfAll
        (
            channels("", "") + "heldOut { validation (S2); }"
        ),
        "has no recording"
    );
    expectSays
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


TEST(misfitRecordings, theSameDataFittedTwiceAreToldOf)
{
    const std::string same("t_s,p_Pa\n0,1\n1,2\n2,4\n");
    const twoFiles f(twoChannels, same, same);
    const std::string said(saidDuring([&]() { EXPECT_NO_THROW(f.read()); }));
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
    const auto said = [](const std::string& use)
    {
        return refusalOfAll(twoChannels + use);
    };
    expectSays(said("heldOut { gate (S2); }"), "is called validation now");
    expectSays(said("heldOut { score (S2); }"), "is called test now");
    expectSays(said("experiments { A { use fit; } }"), "is called calibration now");
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
