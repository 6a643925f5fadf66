// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates of misfitFoam that are contacts of LIGGGHTS: what a strength of 0 and
// of 1 does to grains.

#include "caseChange.H"
#include "granularPhase.H"
#include "testMesh.H"
#include "testNumber.H"

#include "IStringStream.H"
#include "OSspecific.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

constexpr scalar diameter = 0.02;


//- The script that makes grains in a box of 1 m, 0.2 m high
std::string initially(const std::string& grains)
{
    return
        "units si\natom_style granular\nnewton off\n"
        "communicate single vel yes\n"
        "region box block 0 1 0 1 0 0.2 units box\ncreate_box 1 box\n"
      + grains
      + "set type 1 diameter 0.02 density 2500\n";
}


//- The script of their contacts, with more behind the model's name, and more lines
std::string contacts(const std::string& model, const std::string& lines)
{
    const std::string all = " all property/global ";
    return
        "neighbor 0.002 bin\nneigh_modify delay 0\n" + lines
      + "fix E" + all + "youngsModulus peratomtype 1e7\n"
        "fix nu" + all + "poissonsRatio peratomtype 0.3\n"
        "fix e" + all + "coefficientRestitution peratomtypepair 1 0.4\n"
        "fix mu" + all + "coefficientFriction peratomtypepair 1 0.7\n"
        "pair_style gran model hertz tangential history " + model + "\n"
        "pair_coeff * *\ntimestep 2e-5\nfix integrate all nve/sphere\n";
}


//- As candidates.md has it in a case
std::string withRolling()
{
    return contacts
    (
        "rolling_friction epsd2",
        "variable rolling equal 0\n"
        "fix rolling all property/global coefficientRollingFriction"
        " peratomtypepair 1 ${rolling}\n"
    );
}


//- As candidates.md has it in a case
std::string withCohesion()
{
    return contacts
    (
        "cohesion sjkr",
        "variable cohesion equal 0\n"
        "fix cohesion all property/global cohesionEnergyDensity"
        " peratomtypepair 1 ${cohesion}\n"
    );
}


//- Grains of LIGGGHTS in a box whose floor is z = 0
class boxOfGrains
{
    testMesh box_;

    autoPtr<granularPhase> grains_;

    static testBox shape()
    {
        testBox box;
        box.span = vector(1, 1, 0.2);
        return box;
    }

    void write(const word& name, const std::string& text) const
    {
        std::ofstream file(box_.folder()/"constant"/name);
        file<< text;
    }


public:

    //- A change is made in the script of the contacts: a dictionary's entries
    //  and the strength
    boxOfGrains
    (
        const std::string& initial,
        const std::string& physics,
        const vector& g,
        const std::string& change = "",
        const scalar strength = 0
    )
    :
        box_(shape())
    {
        mkDir(box_.folder()/"constant");
        write("grains.initial", initial);
        write("grains.physics", physics);

        if (!change.empty())
        {
            const std::string text = "file \"constant/grains.physics\"; " + change;
            misfit::caseChange(dictionary(IStringStream(text)()))
                .apply(box_.folder(), strength);
        }

        grains_ = granularPhase::New
        (
            box_.mesh(),
            dictionary
            (
                IStringStream
                (
                    "granularPhase LIGGGHTS; LIGGGHTS { walls"
                    " { patches (\".*\"); type 1; } }"
                )()
            ),
            g,
            50
        );
    }

    const granularPhase& grains() const
    {
        return *grains_;
    }

    //- Go on for so long [s]
    void advance(const scalar duration)
    {
        const label n = round(duration/grains_->exchangeInterval());
        for (label i = 0; i < n; ++i)
        {
            grains_->advance();
        }
    }

    //- Two grains along x, with a force [N] outwards on each that rises to its
    //  full value in that share of the time [s]
    void pullApart
    (
        const scalar force,
        const scalar duration,
        const scalar rise
    )
    {
        const label n = round(duration/grains_->exchangeInterval());
        for (label i = 0; i < n; ++i)
        {
            const scalar now = force*min(1, (i + 1)/(rise*n + 1));
            const UList<vector>& at = grains_->position();
            const scalar sign = at[0].x() < at[1].x() ? 1 : -1;
            const vectorField forces({{-sign*now, 0, 0}, {sign*now, 0, 0}});
            grains_->setFluidForce(forces, vectorField(2, Zero));
            grains_->advance();
        }
    }
};


//- A ball that rolls at 0.5 m/s along x, from x = 0.1 m, as deep in the floor as
//  its weight presses it
const std::string rollingBall = initially
(
    "create_atoms 1 single 0.1 0.5 0.009973 units box\n"
    "velocity all set 0.5 0 0 units box\n"
    "set atom 1 omegay 50\n"
);

const vector weight(0, 0, -9.81);

//- How a strength of rolling resistance changes a case (candidates.md)
const std::string rollingChange = "variable rolling; scale 0.3;";


//- Two grains whose centres are 0.0199 m apart
const std::string touching = initially
(
    "create_atoms 1 single 0.5 0.5 0.1 units box\n"
    "create_atoms 1 single 0.5199 0.5 0.1 units box\n"
);

//- How a strength of cohesion changes a case (candidates.md)
const std::string cohesionChange = "variable cohesion; scale 1e5;";

//- What drives the first grain towards the second [N]
scalar pull(const boxOfGrains& two)
{
    const UList<vector>& force = two.grains().totalForce();
    return two.grains().id()[0] == 1 ? force[0].x() : force[1].x();
}

//- Between their centres [m]
scalar distance(const boxOfGrains& two)
{
    const UList<vector>& at = two.grains().position();
    return mag(at[0] - at[1]);
}


//- The most that two grains bear [N] with an energy density k [J/m3]: the largest
//  value of k pi R delta - b delta^1.5, Hertz's law, over the overlap delta
scalar greatestPull(const scalar k)
{
    const scalar R = 0.5*diameter;
    const scalar b = 4.0/3.0*1e7/(2*(1 - sqr(0.3)))*Foam::sqrt(0.5*R);
    return 4*pow3(k*constant::mathematical::pi*R)/(27*sqr(b));
}

} // End anonymous namespace


TEST(rollingResistance, withoutStrengthABallRollsAsWithoutTheModel)
{
    boxOfGrains without(rollingBall, contacts("", ""), weight);
    boxOfGrains zero(rollingBall, withRolling(), weight, rollingChange, 0);
    without.advance(0.4);
    zero.advance(0.4);

    EXPECT_EQ(zero.grains().position()[0], without.grains().position()[0]);
    EXPECT_EQ(zero.grains().velocity()[0], without.grains().velocity()[0]);
    testNumber("velocity [m/s]", zero.grains().velocity()[0].x());
    EXPECT_NEAR(zero.grains().velocity()[0].x(), 0.5, 0.001);
}


TEST(rollingResistance, aBallSlowsByFiveSeventhsOfCoefficientTimesGravity)
{
    boxOfGrains half(rollingBall, withRolling(), weight, rollingChange, 0.5);
    boxOfGrains one(rollingBall, withRolling(), weight, rollingChange, 1);
    half.advance(0.1);
    one.advance(0.1);

    // A solid sphere that rolls and is braked by the couple mu N r
    const scalar slowed = 5.0/7.0*0.3*9.81*0.1;
    testNumber("velocity [m/s]", one.grains().velocity()[0].x());
    EXPECT_NEAR(half.grains().velocity()[0].x(), 0.5 - 0.5*slowed, 0.01*slowed);
    EXPECT_NEAR(one.grains().velocity()[0].x(), 0.5 - slowed, 0.01*slowed);
}


TEST(rollingResistance, aBallStaysWhereItsSpeedIsSpent)
{
    boxOfGrains one(rollingBall, withRolling(), weight, rollingChange, 1);
    one.advance(0.6);

    const scalar slowing = 5.0/7.0*0.3*9.81;
    const scalar path = one.grains().position()[0].x() - 0.1;
    testNumber("path [m]", path);
    EXPECT_NEAR(path, sqr(0.5)/(2*slowing), 0.01*sqr(0.5)/(2*slowing));
    EXPECT_LT(mag(one.grains().velocity()[0]), 0.005);
}


TEST(rollingResistance, betweenTwoGrainsTheCoupleIsCoefficientForceAndHalfTheRadius)
{
    // They turn against each other like gears, pressed together with 1 N
    const std::string gears = initially
    (
        "create_atoms 1 single 0.5 0.5 0.1 units box\n"
        "create_atoms 1 single 0.519845 0.5 0.1 units box\n"
        "set atom 1 omegaz 200\nset atom 2 omegaz -200\n"
    );
    boxOfGrains two(gears, withRolling(), Zero, rollingChange, 1);
    two.pullApart(-1, 0.02, 0);

    const scalar R = 0.5*diameter;
    const scalar inertia = 0.4*two.grains().mass()[0]*sqr(R);
    const scalar slowed = 0.3*1*0.5*R/inertia*0.02;
    for (const vector& omega : two.grains().angularVelocity())
    {
        testNumber("spin [rad/s]", mag(omega.z()));
        EXPECT_NEAR(mag(omega.z()), 200 - slowed, 0.02*slowed);
    }
}


TEST(cohesion, withoutStrengthGrainsActAsWithoutTheModel)
{
    boxOfGrains without(touching, contacts("", ""), Zero);
    boxOfGrains zero(touching, withCohesion(), Zero, cohesionChange, 0);
    EXPECT_LT(pull(without), 0);
    EXPECT_EQ(pull(zero), pull(without));

    without.advance(0.05);
    zero.advance(0.05);
    EXPECT_EQ(zero.grains().position()[0], without.grains().position()[0]);
}


TEST(cohesion, pullsByItsEnergyDensityTimesTheAreaOfTheContact)
{
    const scalar without =
        pull(boxOfGrains(touching, withCohesion(), Zero, cohesionChange, 0));
    const scalar half =
        pull(boxOfGrains(touching, withCohesion(), Zero, cohesionChange, 0.5));
    const scalar one =
        pull(boxOfGrains(touching, withCohesion(), Zero, cohesionChange, 1));

    // The circle in which two spheres cut each other
    const scalar area =
        constant::mathematical::pi*(sqr(0.5*diameter) - sqr(0.5*0.0199));
    testNumber("pull [N]", one - without);
    EXPECT_NEAR(one - without, 1e5*area, 1e-6*1e5*area);
    EXPECT_NEAR(half - without, 0.5*1e5*area, 1e-6*1e5*area);
}


TEST(cohesion, holdsUntilItsClosedFormAndNoFurther)
{
    boxOfGrains two(touching, withCohesion(), Zero, cohesionChange, 1);
    two.advance(0.2);
    two.pullApart(0.9*greatestPull(1e5), 0.4, 0.5);
    EXPECT_LT(distance(two), diameter);
    two.pullApart(1.1*greatestPull(1e5), 0.4, 0.5);
    EXPECT_GT(distance(two), diameter);
}
