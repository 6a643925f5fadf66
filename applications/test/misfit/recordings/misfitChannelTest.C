// SPDX-License-Identifier: GPL-3.0-or-later
// A recording: read with units and reduced to samples.

#include "recordedChannel.H"
#include "units.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::misfit;
using namespace Foam::recorded;


TEST(misfitUnits, theUnitIsReadFromTheNameOfTheColumn)
{
    EXPECT_EQ(unitInName("p_Pa"), "Pa");
    EXPECT_EQ(unitInName("p_excess_kPa"), "kPa");
    EXPECT_EQ(unitInName("v_m_per_s"), "m_per_s");
    EXPECT_EQ(unitInName("level [mm]"), "mm");
    EXPECT_EQ(unitInName("h_over_d"), "");
    EXPECT_EQ(unitInName("Pa"), "");
}


TEST(misfitUnits, eachQuantityHasItsSIUnit)
{
    EXPECT_EQ(siUnit("pressure"), "Pa");
    EXPECT_EQ(siUnit("velocity"), "m/s");
    EXPECT_EQ(siUnit("mass"), "kg");
    EXPECT_EQ(siUnit("dimensionless"), "");
    EXPECT_EQ(siUnit("no such quantity"), "");
}


TEST(misfitChannel, aFileInOtherUnitsIsReadInSI)
{
    const channel c(channelOf("# sensor S1\nt_ms,p [kPa]\n0,1\n500,2\n\n1000,4\n"));
    ASSERT_EQ(c.recorded.x.size(), 3);
    EXPECT_DOUBLE_EQ(c.recorded.x[1], 0.5);
    EXPECT_DOUBLE_EQ(c.recorded.y[2], 4000);
}


TEST(misfitChannel, aFileWithoutUnitsIsReadWithThoseGivenBeside)
{
    const channel c
    (
        channelOf
        (
            "T,Z\n0,1\n1,2\n2,4\n",
            "file \"S1.csv\"; xUnit s; xScale 0.1; unit Pa; scale 3; offset 1;"
        )
    );
    EXPECT_DOUBLE_EQ(c.recorded.x[2], 0.2);
    EXPECT_DOUBLE_EQ(c.recorded.y[2], 13);
}


TEST(misfitChannel, everyUnitCanBeGivenBesideAlsoOneThatIsNoWord)
{
    const auto second = [](const std::string& quantity, const std::string& unit)
    {
        const std::string entries
        (
            "file \"S1.csv\"; quantity " + quantity + "; unit " + unit + ";"
        );
        return channelOf("t_s,x\n0,1\n1,2\n2,4\n", entries).recorded.y[1];
    };
    EXPECT_DOUBLE_EQ(second("velocity", "m/s"), 2);
    EXPECT_DOUBLE_EQ(second("velocity", "cm/s"), 0.02);
    EXPECT_DOUBLE_EQ(second("velocity", "\"cm/s\""), 0.02);
    EXPECT_DOUBLE_EQ(second("velocity", "m_per_s"), 2);
    EXPECT_DOUBLE_EQ(second("flowRate", "l/s"), 0.002);
    EXPECT_DOUBLE_EQ(second("flowRate", "m3/s"), 2);
    EXPECT_DOUBLE_EQ(second("rate", "1/s"), 2);
    EXPECT_DOUBLE_EQ(second("dimensionless", "1"), 2);
    EXPECT_DOUBLE_EQ(second("dimensionless", "-"), 2);
    EXPECT_DOUBLE_EQ(second("dimensionless", "%"), 0.02);
    EXPECT_DOUBLE_EQ(channelOf("", "value 3; quantity rate; unit 1/s;").recorded.y[0], 3);
}


TEST(misfitChannel, theMarkThatExcelBeginsAFileWithIsNoPartOfTheFirstName)
{
    const channel c
    (
        channelOf
        (
            "\xEF\xBB\xBFp_Pa,t_s\r\n5,0\r\n6,1\r\n7,2\r\n",
            "file \"S1.csv\"; column p; xColumn t;"
        )
    );
    EXPECT_EQ(c.recorded.y[0], 5);
}


TEST(misfitChannel, aGapInTheColumnOfAnotherSensorIsNoFault)
{
    const std::string text("t_s,p_Pa,q_Pa\n0,1,5\n1,NaN,6\n2,,7\n3,4,8\n");
    EXPECT_EQ(channelOf(text, "file \"S1.csv\"; column q;").recorded.y.size(), 4);
    const std::string output(refusalOf(text, "file \"S1.csv\"; column p;"));
    expectHolds(output, "Line 3 of");
    expectHolds(output, "holds \"NaN\"");
    expectHolds(output, "first of 2 such lines");
}


TEST(misfitChannel, aColumnIsFoundByItsNameWithOrWithoutUnit)
{
    const std::string text("t_s,pa_Pa,p_Pa\n0,1,5\n1,2,6\n2,4,7\n");
    EXPECT_EQ(channelOf(text, "file \"S1.csv\"; column p;").recorded.y[0], 5);
    EXPECT_EQ(channelOf(text, "file \"S1.csv\"; column p_Pa;").recorded.y[0], 5);
    EXPECT_EQ(channelOf(text).recorded.y[0], 1);
}


TEST(misfitChannel, aWholeNameGoesBeforeOneWithoutItsUnit)
{
    const channel c
    (
        channelOf
        (
            "t_s,p_Pa,p\n0,1,5\n1,2,6\n2,4,7\n",
            "file \"S1.csv\"; column p; unit Pa;"
        )
    );
    EXPECT_EQ(c.recorded.y[0], 5);
}


TEST(misfitChannel, aColumnIsFoundByItsNumberFromOne)
{
    const std::string text("p_Pa,t_s,q_Pa\n5,0,1\n6,1,2\n7,2,4\n");
    const channel c(channelOf(text, "file \"S1.csv\"; xColumn 2; column 1;"));
    EXPECT_EQ(c.recorded.x[2], 2);
    EXPECT_EQ(c.recorded.y[2], 7);
    for (const std::string number : {"0", "4"})
    {
        expectHolds
        (
            refusalOf(text, "file \"S1.csv\"; column " + number + ';'),
            "no column \"" + number + "\", counted from 1"
        );
    }
}


TEST(misfitChannel, samplesAreMeansOfTheReadingsInThem)
{
    std::string text("t_s,p_Pa\n");
    for (int i = 0; i <= 1000; ++i)
    {
        text += std::to_string(0.001*i) + ',' + std::to_string(2*i) + '\n';
    }
    const channel c(channelOf(text, "file \"S1.csv\";", 10));
    ASSERT_EQ(c.samples.size, 10);
    EXPECT_NEAR(c.samples.span, 0.1, 1e-12);
    EXPECT_NEAR(c.samples.x[3], 0.35, 1e-12);
    EXPECT_NEAR(c.samples.readings[3], 100, 1);
    EXPECT_NEAR(c.sampled(c.recorded)[3], 2*350, 2);

    // A simulation with long steps is sampled in the same way
    const series simulated{{0, 0.5, 1}, {0, 1000, 2000}};
    EXPECT_NEAR(c.sampled(simulated)[3], c.sampled(c.recorded)[3], 1e-9);
}


TEST(misfitChannel, ofRepeatedExperimentsTheMeanIsRecordedAtTheTimesOfTheFirst)
{
    files f;
    f.write("S1.csv", "t_s,p_Pa\n0,0\n1,6\n2,12\n3,18\n");
    f.write("again.csv", "t_s,p_Pa\n0,3\n1.5,3\n2,3\n3,3\n4,3\n");
    f.write("dry.csv", "t_s,p_Pa\n0,3\n1.5,3\n2,3\n3,3\n4,3\n");
    f.write("coarse.csv", "t_s,p_Pa\n0,3\n1,4\n3,3\n");
    f.write("short.csv", "t_s,p_Pa\n0,3\n1,3\n1.5,3\n2,3\n");
    const auto read = [&](const std::string& entries)
    {
        IStringStream is(pressure + "repeats (" + entries);
        return channel("S1", dictionary(is), purpose::calibration, f.folder(), 40);
    };
    const std::string file("file \"S1.csv\";");
    const channel c(read("\"again.csv\" \"dry.csv\"); " + file));
    EXPECT_EQ(c.samples.repeats, 3);
    EXPECT_EQ(c.samples.readings[1], 3);
    ASSERT_EQ(c.recorded.y.size(), 4);
    EXPECT_NEAR(c.recorded.y[0], 2, 1e-12);
    EXPECT_NEAR(c.recorded.y[3], 8, 1e-12);
    EXPECT_NEAR(c.sampled(series({0, 3}, {5, 5}))[1], 5, 1e-12);
    ASSERT_EQ(c.files.size(), 3);
    const auto refused = [&](const std::string& entries)
    {
        return refusal([&]() { read(entries); });
    };
    expectHolds(refused("\"S1.csv\"); " + file), "done again, not a copy");
    expectHolds(refused("\"short.csv\"); " + file), "that all repeats cover");
    expectHolds(refused("\"coarse.csv\"); " + file), "the coarsest one as file");
    expectHolds(refused("\"none.csv\"); " + file), "there is no file");
    expectHolds(refused("\"again.csv\");"), "repeats of no recording");
    expectHolds(refused("\"again.csv\"); value 3; unit Pa;"), "no file and no repeats");
}


TEST(misfitChannel, fewReadingsAreTakenAsTheyAre)
{
    const channel c(channelOf("t_s,p_Pa\n0,1\n1,2\n5,4\n"));
    ASSERT_EQ(c.samples.size, 3);
    EXPECT_EQ(c.samples.span, 0);
    EXPECT_EQ(c.samples.x[2], 5);
}


TEST(misfitChannel, onlyTheIntervalCounts)
{
    const std::string text("t_s,p_Pa\n0,1\n1,2\n2,4\n3,5\n4,6\n");
    const channel c(channelOf(text, "file \"S1.csv\"; interval (1 3);"));
    EXPECT_EQ(c.samples.size, 3);
    EXPECT_EQ(c.sampled(c.recorded)[0], 2);
}


TEST(misfitChannel, aNumberAloneIsOneSampleInSI)
{
    const channel c(channelOf("", "value 3; unit kPa; recorder logger;"));
    EXPECT_TRUE(c.isRecorded());
    EXPECT_FALSE(c.overTime());
    EXPECT_EQ(c.at, 0);
    EXPECT_EQ(c.samples.recorder, "logger");
    ASSERT_EQ(c.samples.size, 1);
    EXPECT_NEAR(c.sampled(c.recorded)[0], 3000, 1e-9);

    series simulated;
    simulated.x = {0.0};
    simulated.y = {7.0};
    EXPECT_NEAR(c.sampled(simulated)[0], 7, 1e-12);
}


TEST(misfitChannel, theQuietTimeBeforeTheArrivalShowsTheNoise)
{
    // Noise that forgets by half from reading to reading, then a step
    std::string text("t_s,p_Pa\n");
    double noise = 0;
    unsigned state = 1;
    for (int i = 0; i < 4000; ++i)
    {
        double kick = -6;
        for (int k = 0; k < 12; ++k)
        {
            state = 1664525u*state + 1013904223u;
            kick += state/4294967296.0;
        }
        noise = 0.5*noise + std::sqrt(0.75)*5*kick;
        text += std::to_string(0.001*i) + ','
            + std::to_string(noise + (i < 2000 ? 0 : 2000)) + '\n';
    }
    const channel c(channelOf(text));
    EXPECT_NEAR(c.samples.uncertainty, 5, 0.5);
    EXPECT_NEAR(c.samples.memory, 0.001/std::log(2.0), 0.0003);
    EXPECT_EQ(channelOf(text, "file \"S1.csv\"; memory 0.3;").samples.memory, 0.3);
}


TEST(misfitChannel, aSensorThatShowsNoChangeIsReported)
{
    // The uncertainty is 2
    const auto output = [](const std::string& numbers)
    {
        return outputDuring([&]() { channelOf("t_s,p_Pa\n" + numbers); });
    };
    const std::string words
    (
        "Channel S1 does not change by more than its uncertainty"
    );
    expectHolds(output("0,7\n1,7\n2,7\n"), words);
    expectHolds(output("0,7\n1,8\n2,7.5\n"), words);
    EXPECT_EQ(output("0,7\n1,10\n2,9\n"), "");

    EXPECT_EQ(outputDuring([]() { channelOf("", "value 3; unit Pa;"); }), "");
}


TEST(misfitChannel, listsAreReportedInPlainWords)
{
    const std::string good("t_s,p_Pa\n0,1\n1,2\n2,3\n");
    expectHolds(refusalOf("t,p_Pa\n0,1\n1,2\n2,3\n"), "Units of time: h min ms s");
    expectHolds(refusalOf("t_s,p_mm\n0,1\n1,2\n2,3\n"), "Valid units: MPa Pa bar");
    expectHolds(refusalOf("t_s,p_Pa\n0,1\n1\n2,3\n"), "columns: \"t_s\" \"p_Pa\"");
    expectHolds
    (
        refusalOf(good, "file \"S1.csv\"; column q;"),
        "Its columns: \"t_s\" \"p_Pa\""
    );
    expectHolds
    (
        refusalOf("t_s\n0\n1\n"), "no column \"2\", counted from 1. Its columns: \"t_s\""
    );
}
