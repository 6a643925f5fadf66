// SPDX-License-Identifier: GPL-3.0-or-later
// Which time folders are complete, and which files are cut off.

#include "testMesh.H"
#include "timeFolders.H"
#include "truncatedFiles.H"

#include "OSspecific.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

const std::string begin("/*--------*- C++ -*----------*\\\nFoamFile { }\n");
const std::string end("\n// **************** //\n");

} // End anonymous namespace


TEST(truncatedFiles, findsAFileOfOpenFOAMWithoutItsEnd)
{
    const temporaryFolder scratch;
    const fileName folder(scratch);
    mkDir(folder/"lagrangian");
    std::ofstream(folder/"U") << begin << "1 2 3" << end;
    std::ofstream(folder/"lagrangian"/"d") << begin << "4 5 6" << end;
    std::ofstream(folder/"notes") << "of the user";
    EXPECT_EQ(truncatedFile(folder, ""), "");

    std::ofstream(folder/"lagrangian"/"d") << begin << "4 5";
    EXPECT_EQ(truncatedFile(folder, ""), folder/"lagrangian"/"d");
    EXPECT_EQ(truncatedFile(folder, folder/"lagrangian"/"d"), "");

    std::ofstream(folder/"lagrangian"/"d").close();
    EXPECT_EQ(truncatedFile(folder, ""), folder/"lagrangian"/"d");
}


TEST(timeFolders, marksATimeThatIsWholeAndStopsAtOneThatIsNot)
{
    testMesh box;
    const Time& time = box.time();
    const fileName folder(box.folder()/time.timeName());
    mkDir(folder);
    std::ofstream(folder/"U") << begin << "1 2 3" << end;

    EXPECT_FALSE(timeFolders::marked(time));
    timeFolders::markWritten(time, true);
    EXPECT_TRUE(timeFolders::marked(time));
    timeFolders::unmark(time);
    EXPECT_FALSE(timeFolders::marked(time));

    EXPECT_THROW(timeFolders::markWritten(time, false), Foam::error);
    EXPECT_FALSE(timeFolders::marked(time));

    std::ofstream(folder/"U") << begin << "1 2";
    EXPECT_THROW(timeFolders::markWritten(time, true), Foam::error);
    EXPECT_FALSE(timeFolders::marked(time));
}
