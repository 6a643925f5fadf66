// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres that leave through an outflow: whole, and counted once.

#include "clumpTable.H"
#include "clumpsInBox.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace clumpsInBox;

namespace
{

const scalar massOfOne = density*shape().volume();

//- An exchange in each DEM step, which shows what it leaves behind
const std::string eachStep("fluid none; exchange { interval 1; } ");

const std::string open
(
    eachStep + "LIGGGHTS { walls { patches (zMin); } outflow (xMax); }"
);


//- Speeds what starts near a side of 1 m up so that it leaves within 80 steps [m/s2]
const vector pull(4e4, 0, 0);


//- A clump at the side x = 1 m, where y = 0.5 m is in its middle, and one that stays,
//  or leaves as well
void placeAtSide
(
    boxOfWater& w,
    const bool allLeave = false,
    const std::string& boxEnd = "1"
)
{
    if (Pstream::master())
    {
        DynamicList<placedClump> clumps;
        clumps.append
        (
            {"stone", point(0.97, 0.505, 0.5), quaternion(vector(0, 0, 1), 0.1)}
        );
        writeClumpTable(w.box().folder()/"clumps", clumps);
    }
    settings s;
    s.x = "0 " + boxEnd;
    s.region =
        allLeave ? "0.94 0.96 0.05 0.2 0.3 0.7" : "0.3 0.6 0.05 0.2 0.3 0.7";
    s.initial = "fix leaving all insert/clumps file clumps\n";
    place(w, s);

    // The clump at the side is on two ranks
    std::ostringstream cut;
    cut << "method simple; simpleCoeffs { n (1 " << Pstream::nProcs() << " 1); }\n";
    w.write("system/decomposeParDict", cut.str());
}


//- Spheres, bodies and mass belong to whole clumps
void expectWhole(const granularPhase& phase, const label n, const label step)
{
    EXPECT_EQ(phase.nTotal(), 3*n) << step;
    EXPECT_EQ(phase.nBodies(), n) << step;
    EXPECT_NEAR
    (
        returnReduce(sum(phase.mass()), sumOp<scalar>()),
        n*massOfOne,
        1e-12*massOfOne
    )   << step;
    EXPECT_EQ(phase.clump().size(), phase.size());
    EXPECT_EQ(phase.share().size(), phase.size());
}


//- Farthest place along x [m], and number of ranks that have a sphere beyond x = 0.9 m
Tuple2<scalar, label> atSide(const granularPhase& phase)
{
    scalar farthest = 0;
    for (const point& p : phase.position())
    {
        farthest = max(farthest, p.x());
    }
    const label here = farthest > 0.9;
    return Tuple2<scalar, label>
    (
        returnReduce(farthest, maxOp<scalar>()), returnReduce(here, sumOp<label>())
    );
}


void expectLeavesWhole
(
    const std::string& contacts,
    const std::string& boxEnd = "1"
)
{
    boxOfWater w(open + " LIGGGHTS { contacts " + contacts + "; }");
    placeAtSide(w, false, boxEnd);
    demCoupling alone(w.box().mesh(), pull);
    const granularPhase& phase = phaseOf(w);
    expectWhole(phase, 2, -1);
    EXPECT_EQ(atSide(phase).second(), min(Pstream::nProcs(), 2));
    scalar farthest = 0;

    for (label step = 0; step < 100; ++step)
    {
        alone.moveGrains();
        alone.locateGrains();
        expectWhole(phase, 2 - phase.nLeft(), step);
        farthest = max(farthest, atSide(phase).first());
    }
    EXPECT_EQ(phase.nLeft(), 1);
    EXPECT_EQ(phase.nEntered(), 0);
    const scalar end = std::stod(boxEnd);
    EXPECT_GT(farthest, end - 0.002);
    // Half the skin, and a step
    EXPECT_LT(farthest, end + 0.003);
}


//- Written and read again now and then
void expectLeavesWholeWithRestarts(const bool allLeave)
{
    boxOfWater w(open);
    placeAtSide(w, allLeave);
    autoPtr<demCoupling> alone(new demCoupling(w.box().mesh(), pull));
    label left = 0;

    for (label step = 0; step < 80; ++step)
    {
        alone->moveGrains();
        alone->locateGrains();
        if (step % 20 == 19)
        {
            EXPECT_TRUE(alone->write());
            left += phaseOf(w).nLeft();
            expectWhole(phaseOf(w), 2 - left, step);
            alone.clear();
            alone.reset(new demCoupling(w.box().mesh(), pull));
            EXPECT_TRUE(alone->restarted());
            expectWhole(phaseOf(w), 2 - left, step);
            EXPECT_TRUE(phaseOf(w).hasClumps());
        }
    }
    EXPECT_EQ(left, allLeave ? 2 : 1);
}


//- The error of a clump that leaves elsewhere than through the outflow
std::string leavesElsewhere()
{
    return refusal([&]
    {
        boxOfWater w
        (
            eachStep + "LIGGGHTS { walls { patches (zMin); } outflow (xMin); }"
        );
        placeAtSide(w);
        demCoupling alone(w.box().mesh(), pull);
        for (label step = 0; step < 80; ++step)
        {
            alone.moveGrains();
        }
    });
}

} // End anonymous namespace


TEST(clumpOutflow, theyLeaveWhole)
{
    expectLeavesWhole("vectorised");
    expectLeavesWhole("stock");
    expectLeavesWhole("vectorised", "1.02");
}


TEST(ParallelClumpOutflow, theyLeaveWholeFromSeveralRanks)
{
    expectLeavesWhole("vectorised");
}


TEST(clumpOutflow, theyLeaveWholeWithRestarts)
{
    expectLeavesWholeWithRestarts(false);
    expectLeavesWholeWithRestarts(true);
}


TEST(ParallelClumpOutflow, theyLeaveWholeWithRestarts)
{
    expectLeavesWholeWithRestarts(false);
    expectLeavesWholeWithRestarts(true);
}


TEST(clumpOutflow, oneThatLeavesElsewhereIsNamed)
{
    const std::string output(leavesElsewhere());
    expectHolds(output, "It is a sphere of clump 2, which counts once");
    expectHolds(output, "1 of 2 grains left so");
}
