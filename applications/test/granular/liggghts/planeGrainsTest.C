// SPDX-License-Identifier: GPL-3.0-or-later
// Plane grains: one layer that stays one, local damping, grains that slide without
// rolling, linear contacts.

#include "fixLocalDamping.H"
#include "fixStyles.H"
#include "liggghtsInstance.H"
#include "temporaryFolder.H"
#include "vector.H"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/lammps.h>

using namespace Foam;

namespace
{

//- Grains of 4 mm in one layer at y = 0 over a floor, linear contacts, friction 0.3;
//  gravity as on a slope
struct planeGrains
{
    temporaryFolder folder;

    liggghtsInstance liggghts;

    planeGrains
    (
        const std::string& grains,
        const double slope,
        const std::string& integration,
        const std::string& more = ""
    )
    :
        liggghts(fileName(folder)/"log.liggghts")
    {
        addFixStyle<fixLocalDamping>(&*liggghts);

        std::ostringstream gravity;
        gravity.precision(17);
        gravity
            << "fix g all gravity 9.81 vector " << std::sin(slope) << " 0 "
            << -std::cos(slope) << '\n';

        commands
        (
            "units si\n"
            "atom_style granular\n"
            "atom_modify map array\n"
            "boundary f p f\n"
            "newton off\n"
            "communicate single vel yes\n"
            "region box block 0 2 -0.005 0.005 0 0.2 units box\n"
            "create_box 1 box\n" + grains +
            "set group all diameter 0.004\n"
            "set group all density 2650\n"
            "neighbor 0.001 bin\n"
            "fix a all property/global kn peratomtypepair 1 1e4\n"
            "fix b all property/global kt peratomtypepair 1 1e4\n"
            "fix c all property/global gamman peratomtypepair 1 3000\n"
            "fix d all property/global gammat peratomtypepair 1 3000\n"
            "fix e all property/global coefficientFriction peratomtypepair 1 0.3\n"
            "pair_style gran model hooke/stiffness tangential history\n"
            "pair_coeff * *\n"
            "timestep 1e-5\n" + gravity.str() +
            "fix floor all wall/gran model hooke/stiffness tangential history"
            " primitive type 1 zplane 0\n"
            "fix move all " + integration + "\n" + more
        );
        liggghts.setup();
    }

    void commands(const std::string& lines)
    {
        std::istringstream is(lines);
        for (std::string line; std::getline(is, line);)
        {
            liggghts.command(line);
        }
    }

    vector velocity(const int i = 0) const
    {
        const double* v = liggghts->atom->v[i];
        return vector(v[0], v[1], v[2]);
    }

    vector spin(const int i = 0) const
    {
        const double* w = liggghts->atom->omega[i];
        return vector(w[0], w[1], w[2]);
    }

    //- Acceleration downslope over n steps of 1e-5 s, after n/2 to settle
    double acceleration(const label n)
    {
        liggghts.run(n/2);
        const double before = velocity().x();
        liggghts.run(n);
        return (velocity().x() - before)/(n*1e-5);
    }
};

const std::string onFloor("create_atoms 1 single 0.1 0 0.002 units box\n");

const std::string damping("fix damp all interDEMFoam/localDamping 0.7\n");

const double slope = std::acos(-1.0)/6;

} // End anonymous namespace


TEST(localDamping, aGrainFallsWithTheShareOfGravityThatIsLeft)
{
    planeGrains free("create_atoms 1 single 0.1 0 0.15 units box\n", 0, "nve/sphere");
    planeGrains damped
    (
        "create_atoms 1 single 0.1 0 0.15 units box\n", 0, "nve/sphere", damping
    );
    free.liggghts.run(5000);
    damped.liggghts.run(5000);

    EXPECT_NEAR(free.velocity().z()/(-9.81*0.05), 1, 1e-6);
    EXPECT_NEAR(damped.velocity().z()/(-0.3*9.81*0.05), 1, 1e-3);
}


TEST(localDamping, forceAgainstTheMotionIsIncreased)
{
    planeGrains damped
    (
        "create_atoms 1 single 0.1 0 0.1 units box\n",
        0,
        "nve/sphere",
        damping + "velocity all set 0 0 0.4 units box\n"
    );
    damped.liggghts.run(1000);

    // Thrown upwards it is braked by 1.7 g
    EXPECT_NEAR(damped.velocity().z(), 0.4 - 1.7*9.81*0.01, 1e-3);
}


TEST(localDamping, aSlideWithoutRollingKeepsTheShareOfWhatDrivesIt)
{
    planeGrains damped(onFloor, slope, "nve", damping);

    EXPECT_NEAR
    (
        damped.acceleration(2000)
       /(0.3*9.81*(std::sin(slope) - 0.3*std::cos(slope))),
        1,
        0.01
    );
}


TEST(planeGrains, aGrainThatDoesNotRollSlidesAsABlock)
{
    planeGrains block(onFloor, slope, "nve");

    EXPECT_NEAR
    (
        block.acceleration(2000)/(9.81*(std::sin(slope) - 0.3*std::cos(slope))),
        1,
        0.01
    );
    EXPECT_EQ(block.spin(), vector::zero);
}


TEST(planeGrains, aGrainThatRollsIsASphere)
{
    planeGrains sphere(onFloor, slope, "nve/sphere");

    EXPECT_NEAR(sphere.acceleration(2000)/(9.81*std::sin(slope)*5/7), 1, 0.01);
    EXPECT_NEAR(sphere.spin().y()*0.002/sphere.velocity().x(), 1, 0.01);
}


TEST(planeGrains, nothingLeavesThePlane)
{
    std::string grains;
    for (int i = 0; i < 60; ++i)
    {
        std::ostringstream os;
        os  << "create_atoms 1 single " << 0.01 + 0.0045*(i % 10) + 0.001*(i/10 % 2)
            << " 0 " << 0.003 + 0.0042*(i/10) << " units box\n";
        grains += os.str();
    }

    planeGrains pile(grains, slope, "nve/sphere");
    pile.liggghts.run(3000);

    double spin = 0;
    for (int i = 0; i < pile.liggghts->atom->nlocal; ++i)
    {
        EXPECT_EQ(pile.liggghts->atom->x[i][1], 0);
        EXPECT_EQ(pile.velocity(i).y(), 0);
        EXPECT_EQ(pile.spin(i).x(), 0);
        EXPECT_EQ(pile.spin(i).z(), 0);
        spin = std::max(spin, std::abs(pile.spin(i).y()));
    }
    EXPECT_GT(spin, 1);
}
