// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: material points go on from what they have written.

#include "OFstream.H"
#include "OSspecific.H"
#include "foamCompatibility.H"
#include "materialPointsPhase.H"
#include "testPointsPhase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A second body on the first, in contact with it; the end of the settings of
//  one closes its dictionary
const string secondBody
(
    "contact { friction 0.3; } bodies { block { " + sand
  + " walls { frictions { zMin 0.1; } } region { box ((0 0 0.2) (0.1 1 0.3)); }"
    " } }"
);


//- Stop after some intervals, go on from the state, and be where one is that
//  never stopped
void expectRestartIsExact(const string& rest = "")
{
    const string here("box ((0 0 0) (0.2 1 0.2));");
    testMesh box(slice());
    auto whole = points(box.mesh(), here, rest);
    const label n = whole->nTotal();
    for (label i = 0; i < 7; ++i)
    {
        whole->advance();
    }

    fileName folder(box.time().timePath()/granularPhase::stateFolder);
    compatibility::broadcast(folder);
    mkDir(folder);
    ASSERT_TRUE(whole->writeState(folder));
    whole->checkOut();

    auto second = points(box.mesh(), here, rest);
    EXPECT_TRUE(second->restarted());
    EXPECT_EQ(furthest(*whole, *second), 0);

    for (label i = 0; i < 20; ++i)
    {
        whole->advance();
        second->advance();
    }
    EXPECT_EQ(furthest(*whole, *second), 0);
    EXPECT_EQ(whole->nTotal(), n);
}

//- Beside a fluid points move before the time of the mesh does, alone behind it
enum class TimeOfMesh
{
    behind,
    ahead
};


//- Stop when the time to settle is over. The strain of settling would have taken
//  all friction
void expectRestartAsSettlingEnds(const TimeOfMesh ofMesh)
{
    const string here
    (
        "box ((0 0 0) (0.2 1 0.2)); } residualFrictionAngle 10;"
        " softeningStrains (0 1e-5); settling { time 0.007; damping 20;"
    );
    const string rest("timeStep 1e-4;");
    testMesh box(slice());
    const auto goOn = [&](granularPhase& phase, const label n)
    {
        for (label i = 0; i < n; ++i)
        {
            const label now = box.time().timeIndex() + 1;
            const auto toNow = [&]() { box.time().setTime(1e-3*now, now); };

            if (ofMesh == TimeOfMesh::ahead)
            {
                toNow();
            }
            phase.advance();
            if (ofMesh == TimeOfMesh::behind)
            {
                toNow();
            }
        }
    };

    auto whole = points(box.mesh(), here, rest);
    goOn(*whole, 7);

    const fileName folder(box.time().timePath()/granularPhase::stateFolder);
    mkDir(folder);
    ASSERT_TRUE(whole->writeState(folder));
    whole->checkOut();

    auto second = points(box.mesh(), here, rest);
    ASSERT_TRUE(second->restarted());
    goOn(*whole, 20);
    box.time().setTime(7e-3, 7);
    goOn(*second, 20);
    EXPECT_EQ(furthest(*whole, *second), 0);
}

} // End anonymous namespace


TEST(materialPointsPhase, aRestartIsExactToTheLastBit)
{
    expectRestartIsExact();
}


TEST(materialPointsPhase, aRestartOfBodiesInContactIsExactToTheLastBit)
{
    expectRestartIsExact(secondBody);
}


TEST(materialPointsPhase, aRestartAsSettlingEndsIsExactToTheLastBit)
{
    expectRestartAsSettlingEnds(TimeOfMesh::behind);
    expectRestartAsSettlingEnds(TimeOfMesh::ahead);
}


TEST(materialPointsPhase, aRestartAsTheFastestLeavesIsExactToTheLastBit)
{
    testMesh box(slice("patch"));
    const fileName folder(box.time().timePath()/granularPhase::stateFolder);
    const auto goOn = [&]()
    {
        const string text
        (
            "granularPhase materialPoints; materialPoints { cellSize 0.02;"
            " timeStep 1e-4; outflow (xMax); bodies { sand { " + sand
          + " U (4 0 0); region { box ((0.6 0 0) (0.8 1 0.2)); } } } }"
        );
        return granularPhase::New
        (
            box.mesh(), dictionary(IStringStream(text)()), down, 10
        );
    };
    const auto step = [](const granularPhase& phase)
    {
        return refCast<const materialPointsPhase>(phase).method().stableStep();
    };
    auto whole = goOn();
    label restarts = 0;

    while (whole->nLeft() < 300)
    {
        const label before = whole->nLeft();
        whole->advance();

        if (whole->nLeft() > before)
        {
            mkDir(folder);
            ASSERT_TRUE(whole->writeState(folder));
            auto second = goOn();
            ASSERT_TRUE(second->restarted());
            EXPECT_EQ(step(*second), step(*whole));
            whole->advance();
            second->advance();
            EXPECT_EQ(furthest(*whole, *second), 0);
            ++restarts;
        }
    }
    EXPECT_GT(restarts, 5);
}


TEST(materialPointsPhase, aGateHoldsTheSameSideAfterARestart)
{
    // Most of the flow is beyond the gate as it stops
    testMesh box(slice());
    const Time& time = box.time();
    mkDir(time.path()/time.constant());
    const auto putGate = [&](const char* place)
    {
        OFstream os(time.path()/time.constant()/"slidingGate");
        os  << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object slidingGate; }" << nl << "point " << place << "; normal (1 0 0);"
            << " speed table ((0 40) (0.01 40) (0.011 0) (1 0));" << nl;
    };
    putGate("(0.1 0 0)");
    const string here("box ((0 0 0) (0.1 1 0.3));");
    auto whole = points(box.mesh(), here);
    const scalar interval = whole->exchangeInterval();
    label n = 0;
    const auto goOn = [&]()
    {
        whole->advance();
        ++n;
        box.time().setTime(n*interval, n);
    };
    const auto side = [](const granularPhase& phase)
    {
        return refCast<const materialPointsPhase>(phase).method().gateSide();
    };
    ASSERT_EQ(side(*whole), -1);

    while (n*interval < 0.5)
    {
        goOn();
    }
    scalar mean = 0;
    for (const point& p : whole->position())
    {
        mean += p.x()/whole->size();
    }
    ASSERT_GT(mean, 0.1);

    const fileName folder(time.timePath()/granularPhase::stateFolder);
    mkDir(folder);
    ASSERT_TRUE(whole->writeState(folder));
    whole->checkOut();
    auto second = points(box.mesh(), here);
    ASSERT_TRUE(second->restarted());
    EXPECT_EQ(side(*second), -1);

    for (label i = 0; i < 50; ++i)
    {
        whole->advance();
        second->advance();
    }
    EXPECT_EQ(furthest(*whole, *second), 0);

    // Another gate, with most of the points on its other side
    second->checkOut();
    putGate("(0.05 0 0)");
    auto third = points(box.mesh(), here);
    ASSERT_TRUE(third->restarted());
    EXPECT_EQ(side(*third), 1);
}


TEST(materialPointsPhase, aRestartOfPointsThatShiftIsExactToTheLastBit)
{
    // Pushed together in flight, they overfill the grid
    testMesh box(slice());
    const string here("box ((0.2 0 0) (0.5 1 0.3)); } U (0 0 -4); settling {");
    const string on("shifting on;");
    auto whole = points(box.mesh(), here, on);
    auto without = points(box.mesh(), here);
    for (label i = 0; i < 33; ++i)
    {
        whole->advance();
        without->advance();
    }
    ASSERT_GT(furthest(*whole, *without), 0);

    const fileName folder(box.time().timePath()/granularPhase::stateFolder);
    mkDir(folder);
    ASSERT_TRUE(whole->writeState(folder));
    whole->checkOut();
    without->checkOut();
    auto second = points(box.mesh(), here, on);
    ASSERT_TRUE(second->restarted());

    for (label i = 0; i < 20; ++i)
    {
        whole->advance();
        second->advance();
    }
    EXPECT_EQ(furthest(*whole, *second), 0);
}


TEST(materialPointsPhase, aStateOfAHigherMeshIsRefused)
{
    testMesh box(slice());
    const string here("box ((0 0 0) (0.2 1 0.4));");
    auto high = points(box.mesh(), here);
    high->advance();

    testBox cut(slice());
    cut.span.z() = 0.2;
    testMesh low(cut);
    const fileName folder(low.time().timePath()/granularPhase::stateFolder);
    mkDir(folder);
    ASSERT_TRUE(high->writeState(folder));

    EXPECT_NE
    (
        refusal([&]() { points(low.mesh(), here); }).find("not in the mesh"),
        std::string::npos
    );
}


TEST(materialPointsPhase, aStateOfAnotherDensityIsRefused)
{
    testMesh box(slice());
    const string here("box ((0 0 0) (0.2 1 0.2));");
    auto sandy = points(box.mesh(), here);
    const fileName folder(box.time().timePath()/granularPhase::stateFolder);
    mkDir(folder);
    ASSERT_TRUE(sandy->writeState(folder));
    sandy->checkOut();

    // The body's dictionary goes on after its region
    const std::string output
    (
        refusal([&]() { points(box.mesh(), here + " } density 1800; region {"); })
    );
    EXPECT_NE(output.find("sand 1500"), std::string::npos) << output;
    EXPECT_NE(output.find("sand 1800"), std::string::npos) << output;
}


TEST(ParallelMaterialPointsPhase, aRestartIsExactToTheLastBit)
{
    expectRestartIsExact();
    expectRestartIsExact(secondBody);
}


TEST(ParallelMaterialPointsPhase, aStateBeyondTheBuffersOfMPIIsWritten)
{
    // On 2 ranks 30 MB each; a buffered message holds 20 MB
    testMesh box(slice());
    const string all("box ((0 0 0) (1 1 1));");
    auto first = points(box.mesh(), all, "pointsPerCell 16;");
    EXPECT_EQ(first->nTotal(), 40*20*16*16);

    fileName folder(box.time().timePath()/granularPhase::stateFolder);
    compatibility::broadcast(folder);
    mkDir(folder);
    ASSERT_TRUE(first->writeState(folder));
    first->checkOut();

    auto second = points(box.mesh(), all, "pointsPerCell 16;");
    EXPECT_TRUE(second->restarted());
    EXPECT_EQ(furthest(*first, *second), 0);
}
