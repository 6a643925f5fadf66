// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres that come in while the run goes on.

#include "clumpsInBox.H"
#include "terminalOutput.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace clumpsInBox;

namespace
{

const scalar massOfOne = density*shape().volume();


//- The scripts of a case in which no clump is there and an insertion of the physics
//  script brings them
void placeNone(const boxOfWater& w, const std::string& insertion)
{
    w.write
    (
        "constant/grains/initial",
        "units si\natom_style granular\natom_modify map array\nnewton off\n"
        "communicate single vel yes\nregion box block 0 1 0 1 0 1 units box\n"
        "create_box 1 box\nfix clumps all multisphere\n"
    );
    std::ostringstream cut;
    cut << "method simple; simpleCoeffs { n (" << Pstream::nProcs() << " 1 1); }\n";
    w.write("system/decomposeParDict", cut.str());
    w.writePhysics(stoneTemplate() + insertion);
}


//- One in each 75th step from the first on, six in all, where ranks meet
const std::string sixInTurn
(
    "region place block 0.3 0.7 0.3 0.7 0.3 0.7 units box\n"
    "fix insertion all insert/rate/region seed 32452867 distributiontemplate stones"
    " nparticles 6 particlerate 666.66666668 insert_every 75 overlapcheck yes"
    " vel constant 0 0 0 orientation random region place\n"
);


//- Those that have come within so many intervals of 50 steps
label nCome(const label intervals)
{
    return min((50*intervals - 1)/75 + 1, 6);
}


//- Volume and shares of each are whole, numbers are unlike
void expectWhole(const granularPhase& phase, const label n)
{
    EXPECT_EQ(phase.nTotal(), 3*n);
    EXPECT_EQ(phase.nBodies(), n);
    Map<scalar> shares;
    Map<scalar> masses;
    Map<label> ids;

    forAll(phase.clump(), i)
    {
        EXPECT_GT(phase.clump()[i], 0);
        shares(phase.clump()[i], 0) += phase.share()[i];
        masses(phase.clump()[i], 0) += phase.mass()[i];
        ids(phase.id()[i], 0) += 1;
        EXPECT_NEAR(phase.clumpRadius()[i], shape().equivalentRadius(), 1e-14);
    }
    Pstream::mapCombineGather(shares, plusEqOp<scalar>());
    Pstream::mapCombineGather(masses, plusEqOp<scalar>());
    Pstream::mapCombineGather(ids, plusEqOp<label>());

    if (Pstream::master())
    {
        EXPECT_EQ(shares.size(), n);
        EXPECT_EQ(ids.size(), 3*n);
        for (const label clump : shares.toc())
        {
            EXPECT_NEAR(shares[clump], 1, 1e-14);
            EXPECT_NEAR(masses[clump], massOfOne, 1e-13*massOfOne);
        }
    }
}


//- Their number and times, with a restart after some intervals; 0: none
void expectTurnsAreKept(const label restartAt)
{
    boxOfWater w("fluid none;");
    placeNone(w, sixInTurn);
    autoPtr<demCoupling> alone(new demCoupling(w.box().mesh(), vector(Zero)));
    expectWhole(phaseOf(w), 0);
    label before = 0;

    for (label k = 1; k < 13; ++k)
    {
        alone->moveGrains();
        alone->locateGrains();
        EXPECT_EQ(before + phaseOf(w).nEntered(), nCome(k)) << k;
        EXPECT_EQ(phaseOf(w).nLeft(), 0);
        expectWhole(phaseOf(w), nCome(k));

        if (k == restartAt)
        {
            EXPECT_TRUE(alone->write());
            before = nCome(k);
            alone.clear();
            alone.reset(new demCoupling(w.box().mesh(), vector(Zero)));
            EXPECT_TRUE(alone->restarted());
            expectWhole(phaseOf(w), before);
        }
    }
}


//- One that comes in on the plane where ranks meet is carried by the water at once
void expectBuoyancy()
{
    boxOfWater w("interphaseForces { drag { model none; } }");
    placeNone
    (
        w,
        "region place block 0.4999 0.5001 0.4 0.6 0.4 0.6 units box\n"
        "fix insertion all insert/pack seed 32452867 distributiontemplate stones"
        " insert_every once overlapcheck no vel constant 0 0 0 orientation constant"
        " 1 0 0 0 particles_in_region 1 region place\n"
    );
    demCoupling coupling(w.box().mesh(), hydrostatics(g));
    coupling.start(w.water());
    coupling.moveGrains([&]{ return w.water(); });
    const granularPhase& phase = phaseOf(w);
    EXPECT_EQ(phase.nEntered(), 1);
    expectWhole(phase, 1);
    const label here = phase.size() > 0;
    testNumber("ranks that have spheres", returnReduce(here, sumOp<label>()));

    // It comes in during the first of the 50 steps
    const wholeClumps all(phase);
    const scalar speed = -(1 - 1000/density)*mag(g)*interval;
    EXPECT_NEAR(all.velocity.z(), speed, 0.03*mag(speed));
    EXPECT_LT(mag(all.spin), 1e-9*mag(speed)/shape().equivalentRadius());
    EXPECT_LT(mag(all.force + 1000*shape().volume()*g), 1e-9*mag(all.force));

    // And goes on so
    exchangeOnce(coupling, w);
    const wholeClumps later(phase);
    EXPECT_NEAR(later.velocity.z() - all.velocity.z(), speed, 1e-9*mag(speed));
}

//- A horizontal face at z = 0.8 m, as LIGGGHTS reads it
std::string faceAbove()
{
    std::ostringstream os;
    os  << "solid face\n";
    for (const char* third : {"0.7 0.4", "0.3 0.6"})
    {
        os  << "facet normal 0 0 1\nouter loop\n"
            << "vertex 0.3 0.4 0.8\nvertex " << third << " 0.8\nvertex 0.7 0.6 0.8\n"
            << "endloop\nendfacet\n";
    }
    os  << "endsolid face\n";
    return os.str();
}


//- A stream of three through a face across the plane where ranks meet: they fly at its
//  speed up to the face, and fall behind it
void expectStreamIsWhole(const label restartAt)
{
    boxOfWater w("fluid none;");
    w.write("face.stl", faceAbove());
    placeNone
    (
        w,
        "fix face all mesh/surface/planar file face.stl type 1\n"
        "fix insertion all insert/stream seed 32452867 distributiontemplate stones"
        " nparticles 3 particlerate 83.333334 insert_every 600 overlapcheck yes"
        " orientation random vel constant 0 0 -5 insertion_face face\n"
    );
    autoPtr<demCoupling> alone(new demCoupling(w.box().mesh(), g));
    label before = 0;

    for (label k = 1; k < 35; ++k)
    {
        alone->moveGrains();
        alone->locateGrains();
        const granularPhase& phase = phaseOf(w);
        const label n = before + phase.nEntered();
        EXPECT_EQ(n, min((50*k - 1)/600 + 1, 3)) << k;
        expectWhole(phase, n);
        forAll(phase.velocity(), i)
        {
            const scalar speed = -phase.velocity()[i].z();
            EXPECT_GE(speed, 5 - 1e-9);
            EXPECT_LT(speed, 5 + mag(g)*k*interval + 1e-9);
        }
        if (k == restartAt)
        {
            EXPECT_TRUE(alone->write());
            before = n;
            alone.clear();
            alone.reset(new demCoupling(w.box().mesh(), g));
        }
    }
    testNumber("mean speed at the end", -wholeClumps(phaseOf(w)).velocity.z());
    EXPECT_LT(wholeClumps(phaseOf(w)).velocity.z(), -5.02);
}

} // End anonymous namespace


TEST(clumpEntry, comesInItsTurnsWhole)
{
    expectTurnsAreKept(0);
}


TEST(ParallelClumpEntry, comesInItsTurnsWhole)
{
    expectTurnsAreKept(0);
}


TEST(clumpEntry, keepsItsTurnsOverARestart)
{
    expectTurnsAreKept(2);
    expectTurnsAreKept(3);
}


TEST(ParallelClumpEntry, keepsItsTurnsOverARestart)
{
    expectTurnsAreKept(3);
}


TEST(clumpEntry, hasBuoyancyAtOnce)
{
    expectBuoyancy();
}


TEST(ParallelClumpEntry, hasBuoyancyAtOnce)
{
    expectBuoyancy();
}


TEST(clumpEntry, aFixThatWouldMoveItsSpheresIsRefusedBefore)
{
    expectHolds
    (
        refusal([&]
        {
            boxOfWater w("fluid none;");
            placeNone(w, sixInTurn + "fix integrate all nve/sphere\n");
            demCoupling alone(w.box().mesh(), vector(Zero));
        }),
        "fix integrate (nve/sphere)"
    );
}


// Others of the initial script are there at the start
TEST(clumpEntry, whatTheInitialScriptStartsLaterWaits)
{
    boxOfWater w("fluid none;");
    settings s;
    s.initial =
        "fix late all insert/pack seed 49979687 distributiontemplate stones start 60"
        " insert_every once overlapcheck yes orientation constant 1 0 0 0"
        " particles_in_region 2 region place\n";
    place(w, s);
    demCoupling alone(w.box().mesh(), vector(Zero));
    const granularPhase& phase = phaseOf(w);
    expectWhole(phase, 1);
    alone.moveGrains();
    expectWhole(phase, 1);
    alone.moveGrains();
    expectWhole(phase, 2);
    EXPECT_EQ(phase.nEntered(), 1);
}


TEST(clumpEntry, comesInAsAStream)
{
    expectStreamIsWhole(0);
    expectStreamIsWhole(3);
}


TEST(ParallelClumpEntry, comesInAsAStream)
{
    expectStreamIsWhole(3);
}
