// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: grains of LIGGGHTS on material points.

#include "OSspecific.H"
#include "foamCompatibility.H"
#include "grainSnapshot.H"
#include "testNumber.H"
#include "testPointsPhase.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

const string elastic
(
    "law linearElastic; density 1500; E 1e5; nu 0.2;"
);


//- What a test is about
struct beadsAndPoints
{
    //- Gravity [m/s2]
    vector g = Zero;

    //- LIGGGHTS commands that make beads of 40 mm
    std::string beads = "create_atoms 1 single 0.41 0.05 0.25 units box\n";

    //- Their velocity
    std::string U = "0 0 0";

    //- Settings of LIGGGHTS, materialPoints and contact, and others
    string LIGGGHTS = "";
    string points = "";
    string contact = "stiffness 1000;";
    string body = elastic + " region { box ((0.2 0 0.1) (0.6 1 0.225)); }";
    string more = "fluid none;";

    string demStep = "5e-5";

    testBox box = slice();
};


//- Beads and points in a slice
class beadsOnPoints
{
    const beadsAndPoints what_;

    testMesh mesh_;

    autoPtr<granularPhase> phase_;

    void write(const word& name, const std::string& text) const
    {
        std::ofstream file(mesh_.folder()/"constant"/name);
        file<< text;
    }

public:

    explicit beadsOnPoints(const beadsAndPoints& what)
    :
        what_(what),
        mesh_(what.box)
    {
        mkDir(mesh_.folder()/"constant");
        const std::string all = " all property/global ";
        write
        (
            "grains.initial",
            "units si\natom_style granular\nnewton off\n"
            "communicate single vel yes\n"
            "region box block 0 0.8 0 0.1 0 0.4 units box\n"
            "create_box 1 box\n" + what.beads
          + "set type 1 diameter 0.04 density 2500\n"
            "velocity all set " + what.U + " units box\n"
        );
        write
        (
            "grains.physics",
            "neighbor 0.004 bin\nneigh_modify delay 0\n"
            "fix E" + all + "youngsModulus peratomtype 1e7\n"
            "fix nu" + all + "poissonsRatio peratomtype 0.2\n"
            "fix e" + all + "coefficientRestitution peratomtypepair 1 0.5\n"
            "fix mu" + all + "coefficientFriction peratomtypepair 1 0.4\n"
            "pair_style gran model hertz tangential history\n"
            "pair_coeff * *\ntimestep " + what.demStep
          + "\nfix integrate all nve/sphere\n"
        );
        phase_ = again();
    }

    //- One more, which goes on from what is written
    autoPtr<granularPhase> again()
    {
        const string text
        (
            "granularPhase grainsOnPoints; " + what_.more
          + " grainsOnPoints { LIGGGHTS { " + what_.LIGGGHTS
          + " } materialPoints { cellSize 0.02; " + what_.points
          + " bodies { bed { " + what_.body + " } } } contact { "
          + what_.contact + " } }"
        );
        return granularPhase::New
        (
            mesh_.mesh(), dictionary(IStringStream(text)()), what_.g, 10
        );
    }

    granularPhase& phase()
    {
        return phase_();
    }

    testMesh& mesh()
    {
        return mesh_;
    }

    void advance(const label n)
    {
        for (label i = 0; i < n; ++i)
        {
            phase_->advance();
        }
    }

    //- Of beads and points of all ranks [kg m/s]. A bead has had half of the last
    //  step's force, a point all of it
    vector momentum() const
    {
        const auto now = phase_->snapshot();
        vector sum(Zero);

        forAll(now->mass, i)
        {
            sum += now->mass[i]*now->U[i];
            if (now->type[i] == 1)
            {
                sum += 0.5*phase_->timeStep()*now->contactForce[i];
            }
        }
        reduce(sum, sumOp<vector>());
        return sum;
    }

    //- Force in contacts, and the velocity, of the bead, on all ranks
    vector ofBead(const bool force) const
    {
        const auto now = phase_->snapshot();
        vector sum(Zero);
        forAll(now->mass, i)
        {
            sum +=
                now->type[i] > 1 ? vector(Zero)
              : force ? now->contactForce[i] : now->U[i];
        }
        reduce(sum, sumOp<vector>());
        return sum;
    }
};


std::string output(const beadsAndPoints& what)
{
    return refusal([&]() { beadsOnPoints all(what); });
}


//- A bead that flies into a block, aslant
beadsAndPoints shot(const string& contact = "stiffness 1000;")
{
    beadsAndPoints what;
    what.U = "0.5 0 -1";
    what.contact = contact;
    return what;
}


void expectMomentumIsKept(const string& contact)
{
    beadsOnPoints all(shot(contact));
    const vector before(all.momentum());
    scalar changed = 0;
    scalar largest = 0;

    for (label i = 0; i < 60; ++i)
    {
        all.advance(1);
        changed = max(changed, mag(all.momentum() - before));
        largest = max(largest, mag(all.ofBead(true)));
    }

    // It has bounced
    EXPECT_GT(largest, 1);
    EXPECT_GT(all.ofBead(false).z(), -0.5);
    testNumber("change of momentum over that before", changed/mag(before));
    EXPECT_LT(changed, 1e-12*mag(before));
}


//- Stops amid the contact, goes on, and is where one is that never stopped
void expectRestartIsExact()
{
    beadsAndPoints what(shot("stiffness 1000; friction 0.3;"));
    what.g = down;
    what.body = sand + " region { box ((0.2 0 0) (0.6 1 0.225)); }";
    beadsOnPoints all(what);
    all.advance(30);
    ASSERT_GT(mag(all.ofBead(true)), 0.1);

    fileName folder
    (
        all.mesh().time().timePath()/granularPhase::stateFolder
    );
    compatibility::broadcast(folder);
    mkDir(folder);
    ASSERT_TRUE(all.phase().writeState(folder));
    all.phase().checkOut();

    auto second = all.again();
    EXPECT_TRUE(second->restarted());
    EXPECT_EQ(furthest(all.phase(), *second), 0);

    for (label i = 0; i < 40; ++i)
    {
        all.advance(1);
        second->advance();
    }
    EXPECT_EQ(furthest(all.phase(), *second), 0);
}

} // End anonymous namespace


TEST(grainsOnPoints, bothAreListedWithNumbersAndTypesOfTheirOwn)
{
    beadsOnPoints all{beadsAndPoints()};
    const granularPhase& phase = all.phase();
    const auto now = phase.snapshot();

    ASSERT_EQ(phase.size(), 1 + 40*13);
    EXPECT_EQ(now->type[0], 1);
    EXPECT_EQ(now->type[1], 2);
    EXPECT_EQ(now->id[0], 1);
    EXPECT_GE(now->id[1], 1000000000);
    EXPECT_NEAR(now->d[0], 0.04, 1e-12);
    EXPECT_EQ(now->wallForce["zMin"].size(), phase.size());
}


TEST(grainsOnPoints, momentumOfBothIsKeptToRoundOff)
{
    expectMomentumIsKept("stiffness 1000;");
    expectMomentumIsKept("stiffness 1000; friction 0.5;");
}


TEST(grainsOnPoints, frictionSpinsABeadAndWithoutItNothingDoes)
{
    for (const bool rough : {false, true})
    {
        beadsOnPoints all
        (
            shot(rough ? "stiffness 1000; friction 0.5;" : "stiffness 1000;")
        );
        all.advance(60);
        const scalar spin = all.phase().angularVelocity()[0].y();

        if (rough)
        {
            EXPECT_GT(spin, 1);
        }
        else
        {
            EXPECT_EQ(spin, 0);
        }
    }
}


TEST(grainsOnPoints, aBedBearsTheWeightOfABeadWithin1Percent)
{
    beadsAndPoints what;
    what.g = down;
    what.LIGGGHTS = "localDamping 0.7;";
    what.body =
        elastic + " settling { time 100; damping 100; }"
        " region { box ((0 0 0) (0.8 1 0.225)); }";
    beadsOnPoints all(what);
    all.advance(2000);

    // The base bears both
    const scalar weight = 2500*M_PI/6*pow3(0.04)*9.81;
    const scalar both = sum(scalarField(all.phase().mass()))*9.81;
    const auto now = all.phase().snapshot();
    testNumber("force on the bead over its weight", all.ofBead(true).z()/weight);
    EXPECT_NEAR(all.ofBead(true).z(), weight, 0.01*weight);
    EXPECT_NEAR(sum(now->wallForce["zMin"]).z(), both, 0.01*weight);
}


TEST(grainsOnPoints, aRestartAmidAContactIsExactToTheLastBit)
{
    expectRestartIsExact();
}


TEST(ParallelGrainsOnPoints, momentumIsKeptAndARestartIsExact)
{
    expectMomentumIsKept("stiffness 1000; friction 0.5;");
    expectRestartIsExact();
}


TEST(ParallelGrainsOnPoints, aBeadThatChangesRankMovesAsOneThatStaysOnIt)
{
    // The same, a whole number of cells apart; ranks meet at x = 0.4 m
    const auto shotAt = [](const string& x, const string& from, const string& to)
    {
        beadsAndPoints what(shot("stiffness 1000; friction 0.3;"));
        what.beads = "create_atoms 1 single " + x + " 0.05 0.25 units box\n";
        what.body =
            elastic + " region { box ((" + from + " 0 0.1) (" + to
          + " 1 0.225)); }";
        return what;
    };
    beadsOnPoints across(shotAt("0.39", "0.3", "0.5"));
    beadsOnPoints within(shotAt("0.19", "0.1", "0.3"));
    across.advance(60);
    within.advance(60);

    const vector U(across.ofBead(false));
    const scalar apart = mag(U - within.ofBead(false));
    testNumber("difference of the velocities of the bead [m/s]", apart);
    EXPECT_GT(U.z(), -0.5);
    EXPECT_LT(apart, 1e-11);
}


TEST(grainsOnPoints, whatIsNotSupportedIsNamed)
{
    beadsAndPoints what;
    EXPECT_EQ(output(what), "nothing");

    what.more = "";
    EXPECT_NE(output(what).find("fluid none;"), std::string::npos);

    what.more = "fluid none; coarseGraining 2;";
    EXPECT_NE(output(what).find("coarseGraining"), std::string::npos);

    what = beadsAndPoints();
    what.points = "timeStep 1e-4;";
    EXPECT_NE(output(what).find("timeStep is not read"), std::string::npos);

    what = beadsAndPoints();
    what.box.patches =
        {{"cyclic", "cyclic", "empty", "empty", "wall", "patch"}};
    EXPECT_NE(output(what).find("repeats itself along x"), std::string::npos);
}


TEST(grainsOnPoints, stepsOfThePointsAreNoLongerThanContactAllows)
{
    // 1.9 and 3.4 DEM steps at the most; a point has 15 g
    for (const auto& [most, steps] : {std::pair(1.9, 10), std::pair(3.4, 4)})
    {
        beadsAndPoints what;
        what.contact =
            "stiffness " + std::to_string(0.015*sqr(0.5/(most*5e-5))) + ";";
        EXPECT_NE
        (
            outputDuring([&]() { beadsOnPoints all(what); }).find
            (
                std::to_string(steps) + " steps of the points in 10 DEM steps"
            ),
            std::string::npos
        );
    }
}


TEST(grainsOnPoints, aWrongContactIsNamed)
{
    beadsAndPoints what;
    what.contact = "stiffness -1;";
    EXPECT_NE(output(what).find("stiffness"), std::string::npos);

    what.contact = "stiffness 1000; friction -1;";
    EXPECT_NE(output(what).find("friction"), std::string::npos);

    what.contact = "stiffness 1000; restitution 1;";
    EXPECT_NE(output(what).find("restitution"), std::string::npos);

    what.contact = "stifness 1000;";
    EXPECT_NE
    (
        output(what).find("Valid keywords: stiffness"), std::string::npos
    );

    what.contact = "stiffness 1e9;";
    EXPECT_NE(output(what).find("steps of at most"), std::string::npos);
}


TEST(grainsOnPoints, aBeadAmongPointsIsNamed)
{
    beadsAndPoints what;
    what.beads = "create_atoms 1 single 0.4 0.05 0.2 units box\n";
    const std::string error
    (
        refusal([&]()
        {
            beadsOnPoints all(what);
            all.advance(1);
        })
    );
    EXPECT_NE(error.find("deeper in a grain"), std::string::npos) << error;
}


TEST(grainsOnPoints, bodiesMayDifferInTheirGrainsWithoutAFluid)
{
    beadsAndPoints what;
    what.body =
        elastic + " grainDiameter 0.001; region { box ((0.2 0 0.1) (0.4 1 0.2)); } }"
        " clay { " + elastic
      + " grainDiameter 0.002; region { box ((0.4 0 0.1) (0.6 1 0.2)); }";
    EXPECT_EQ(output(what), "nothing");
}
