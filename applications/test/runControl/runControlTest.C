// SPDX-License-Identifier: GPL-3.0-or-later
// When a run writes and stops, and how long its fluid steps are.

#include "exchangeTime.H"
#include "fluidTimeStep.H"
#include "outputControl.H"
#include "testMesh.H"
#include "timeFolders.H"

#include "IFstream.H"
#include "OFstream.H"

#include <gtest/gtest.h>

#include <csignal>

using namespace Foam;

namespace
{

//- A second Time of a test mesh, with entries of controlDict that differ
autoPtr<exchangeTime> timeOf(const testMesh& box, const dictionary& changes)
{
    const fileName control(box.folder()/"system"/Time::controlDictName);
    dictionary entries{IFstream(control)()};
    entries.merge(changes);
    OFstream file(control);
    file<< "FoamFile { version 2.0; format ascii; class dictionary;"
        " object controlDict; }\n";
    entries.write(file, false);
    file.flush();

    return autoPtr<exchangeTime>
    (
        new exchangeTime
        (
            Time::controlDictName,
            box.folder().path(),
            fileName(box.folder().name())
        )
    );
}


dictionary controlEntry(const word& key, const scalar value)
{
    dictionary result;
    result.add(key, value);

    return result;
}


//- A run to its end: what happened, a letter each: s a step, p prepared,
//  w written
std::string course
(
    exchangeTime& time,
    const std::function<bool()>& atOneTime,
    const bool writeEnd,
    const label signalAt = -1
)
{
    std::string happened;
    const stageTimes times;
    outputControl output
    (
        time,
        times,
        {
            atOneTime,
            [&]() { happened += 'p'; },
            [&]()
            {
                happened += 'w';
                return time.writeNow();
            },
            writeEnd
        }
    );
    timeFolders::markStart(time);

    while (output.run())
    {
        ++time;
        happened += 's';
        if (time.timeIndex() == signalAt)
        {
            std::raise(SIGUSR1);
        }
        output.endStep();
    }
    output.end();

    return happened;
}

} // End anonymous namespace


TEST(exchangeTime, goesOnWithTheNumberThatWasWrittenNotWithThatOfTheFolder)
{
    testMesh box;
    const scalar written = 0.1 + 3e-16;
    const fileName folder(box.folder()/"0.1"/"uniform");
    mkDir(folder);
    {
        OFstream file(folder/"time");
        file.precision(18);
        file<< "FoamFile { version 2.0; format ascii; class dictionary;"
            " object time; }\nvalue " << written << ";\nname \"0.1\";\nindex 7;\n";
    }

    autoPtr<exchangeTime> time(timeOf(box, controlEntry("startTime", 0.1)));
    EXPECT_EQ(time->value(), 0.1);
    time->restoreValue();
    EXPECT_NE(time->value(), 0.1);
    EXPECT_EQ(time->value(), written);
    EXPECT_EQ(time->timeIndex(), 7);
    EXPECT_EQ(time->timeName(), "0.1");
}


TEST(exchangeTime, putsWritingOffToTheEndOfAnInterval)
{
    testMesh box;
    autoPtr<exchangeTime> owner(timeOf(box, controlEntry("writeInterval", 3)));
    exchangeTime& time = *owner;
    const auto written = [&](const bool together)
    {
        ++time;
        time.writeWhere(together);
        return time.writeTime();
    };

    EXPECT_FALSE(written(true));
    EXPECT_FALSE(written(true));
    EXPECT_FALSE(written(false));
    EXPECT_FALSE(written(false));
    EXPECT_TRUE(written(true));
    EXPECT_TRUE(written(true));
    EXPECT_FALSE(written(true));
}


TEST(fluidTimeStep, shrinksImmediatelyAndGrowsByAFifthAtMost)
{
    fluidTimeStep step(1e-3);

    step.adjust(0.5, 1e-3, 1);
    EXPECT_DOUBLE_EQ(step.allowed(), 5e-4);

    step.adjust(1.5, 5e-4, 1);
    EXPECT_DOUBLE_EQ(step.allowed(), 1.15*5e-4);

    step.adjust(100, 1.15*5e-4, 1);
    EXPECT_DOUBLE_EQ(step.allowed(), 1.2*1.15*5e-4);

    step.adjust(100, step.allowed(), 6e-4);
    EXPECT_DOUBLE_EQ(step.allowed(), 6e-4);
}


TEST(fluidTimeStep, growsFromWhatWasAllowedNotFromAStepThatWasCutToFit)
{
    fluidTimeStep step(1e-3);
    step.adjust(10, 0.6e-3, 1);

    EXPECT_DOUBLE_EQ(step.allowed(), 1.2e-3);
}


TEST(outputControl, writesTimesThatAreDueAfterTheirFunctionObjects)
{
    testMesh box;
    autoPtr<exchangeTime> time(timeOf(box, controlEntry("writeInterval", 2)));
    time->setEndTime(5*time->deltaTValue());
    const auto always = []() { return true; };

    EXPECT_EQ(course(*time, always, false), "sspwsspws");
}


TEST(outputControl, writesTheEndWhereverItIsIfTheRunWantsThat)
{
    testMesh box;
    autoPtr<exchangeTime> time(timeOf(box, controlEntry("writeInterval", 2)));
    time->setEndTime(3*time->deltaTValue());
    const auto always = []() { return true; };

    EXPECT_EQ(course(*time, always, true), "sspwspw");
    EXPECT_TRUE(timeFolders::marked(*time));
}


TEST(outputControl, finishesTheIntervalBeforeItEnds)
{
    testMesh box;
    autoPtr<exchangeTime> time(timeOf(box, controlEntry("writeInterval", 1000)));
    time->setEndTime(4*time->deltaTValue());
    const auto everyThird = [&]() { return time->timeIndex() % 3 == 0; };

    EXPECT_EQ(course(*time, everyThird, true), "sssssspw");
}


TEST(outputControl, aSignalEndsTheRunWithATimeThatIsWhole)
{
    testMesh box;
    autoPtr<exchangeTime> time(timeOf(box, controlEntry("writeInterval", 1000)));
    time->setEndTime(9*time->deltaTValue());
    const auto everyThird = [&]() { return time->timeIndex() % 3 == 0; };

    EXPECT_EQ(course(*time, everyThird, false, 4), "sssssspw");
    EXPECT_TRUE(timeFolders::marked(*time));
    EXPECT_TRUE(isFile(time->timePath()/"uniform/stopRequested"));
}


TEST(outputControl, aSignalInTheLastStepWritesTheEnd)
{
    testMesh box;
    autoPtr<exchangeTime> time(timeOf(box, controlEntry("writeInterval", 1000)));
    time->setEndTime(3*time->deltaTValue());
    const auto always = []() { return true; };

    EXPECT_EQ(course(*time, always, false, 3), "ssspw");
    EXPECT_TRUE(timeFolders::marked(*time));
}
