// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of entrainment: rates and depths.

#include "erosionByLaws.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"
#include "terminalOutput.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

#include <vector>

using namespace Foam;

namespace
{

const std::string discs("radius 1.75e-3; density 2650;");

dictionary entries(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

dictionary bed(const std::string& more = "")
{
    return entries
    (
        "slope 15; frictionAngle 43; bulkDensity 2080; scouring { " + discs
      + " } " + more
    );
}

} // End anonymous namespace


TEST(progressiveScouring, hasTheRatesOfAnIndependentEvaluationOfEqs1To3)
{
    // Evaluated outside this code for T = 2 R tau, a deviation of 0.1 rad and
    // 2650 kg/m3. The paper does not print them
    const progressiveScouring law(entries(discs), 15, 9.81);
    const std::vector<std::pair<scalar, scalar>> rates
    {
        {150, 0.08}, {200, 0.11}, {250, 0.125}, {300, 0.14}, {350, 0.155},
        {400, 0.17}, {500, 0.19}, {600, 0.21}
    };

    for (const auto& r : rates)
    {
        EXPECT_NEAR(law.rate(r.first), r.second, 0.005) << r.first << " Pa";
    }
}


TEST(progressiveScouring, hasTheRangeThatThePaperPrintsFrom260To590Pa)
{
    // 0.13 to 0.21 m/s at P1. Its text gives no shear there: Coulomb's is that of a
    // flow 14 to 32 mm deep
    const progressiveScouring law(entries(discs), 15, 9.81);

    EXPECT_NEAR(law.rate(260), 0.13, 0.005);
    EXPECT_NEAR(law.rate(590), 0.21, 0.005);
}


TEST(progressiveScouring, timesAreThoseOfSmallStepsThroughEq1)
{
    const progressiveScouring law(entries(discs), 15, 9.81);
    constexpr scalar R = 1.75e-3;
    constexpr scalar tau = 300;
    const scalar m = constant::mathematical::pi*sqr(R)*2650;
    const scalar inertia = 1.5*m*sqr(R);
    const scalar slope = degToRad(15.0);

    for (const scalar degrees : {20.0, 33.0, 60.0})
    {
        const scalar alpha0 = degToRad(degrees);
        scalar alpha = alpha0;
        scalar speed = 0;
        scalar t = 0;

        while (alpha < constant::mathematical::piByTwo - slope)
        {
            constexpr scalar dt = 1e-7;
            speed +=
                dt*R
               *(2*R*tau*std::sin(alpha) - m*9.81*std::cos(alpha + slope))
               /inertia;
            alpha += dt*speed;
            t += dt;
        }
        EXPECT_NEAR(law.timeToRoll(alpha0, tau)/t, 1, 1e-3) << degrees;
    }
}


TEST(progressiveScouring, aShearThatLiftsNoGrainErodesNothing)
{
    const progressiveScouring law(entries(discs), 15, 9.81);

    EXPECT_EQ(law.rate(0), 0);
    EXPECT_EQ(law.rate(-100), 0);

    // 2 R tau sin(alpha0) below m g cos(alpha0 + slope)
    EXPECT_EQ(law.timeToRoll(degToRad(10.0), 100), GREAT);
    EXPECT_EQ(law.rate(degToRad(80.0), 100), 0);
}


TEST(shearingLaws, staticAndDynamicErosionAreTheirEquations)
{
    const shearingLaws laws(bed(), 15, 9.81);
    const scalar tan43 = std::tan(degToRad(43.0));

    EXPECT_NEAR(laws.Coulomb(500), 500*tan43, 1e-9);
    EXPECT_NEAR(laws.Voellmy(500, 2), 500*tan43 + 2080*9.81*4/100, 1e-9);
    EXPECT_NEAR
    (
        laws.staticDepth(1000, 500),
        (1000 - 500*tan43)
       /(2080*9.81*(std::cos(degToRad(15.0))*tan43 - std::sin(degToRad(15.0)))),
        1e-12
    );
    EXPECT_NEAR
    (
        laws.dynamicRate(1000, 500, 2), (1000 - 500*tan43)/(2080*2), 1e-12
    );
    EXPECT_LT(laws.dynamicRate(100, 500, 2), 0);
    EXPECT_THROW(shearingLaws(bed(), 45, 9.81), Foam::IOerror);
}


TEST(shearingLaws, anAngleThatIsNoneOrMayBeInRadiansIsNamed)
{
    const auto laws = [](const std::string& angles)
    {
        shearingLaws(entries("bulkDensity 2080;" + angles), 0.26, 9.81);
    };
    const auto output = [&](const std::string& angles)
    {
        return outputDuring([&]() { laws(angles); });
    };

    expectHolds(output("frictionAngle 0.75;"), "frictionAngle is 0.75 degrees");
    expectHolds(output("frictionAngle 0.75;"), "write 42.97");
    expectHolds
    (
        output("frictionAngle 43; residualFrictionAngle 0.4;"),
        "residualFrictionAngle is 0.4 degrees"
    );
    EXPECT_EQ(output("frictionAngle 43; residualFrictionAngle 0;"), "");

    for (const char* angle : {"430", "90", "-5"})
    {
        const std::string wrong("frictionAngle " + std::string(angle));
        expectHolds
        (
            refusal([&]() { laws(wrong + ";"); }), "must lie from 0 up"
        );
    }
}


TEST(erosionByLaws, depthsGrowAndStopAtTheFloor)
{
    sectionSeries s;
    s.t.setSize(11);
    s.depth.setSize(11);
    s.sigma = scalarList(11, scalar(300));
    s.v = scalarList(11, scalar(1));
    s.tau = scalarList(11, scalar(400));
    forAll(s.t, i)
    {
        s.t[i] = 0.1*i;
        s.depth[i] = 0.1*i*0.17;
    }

    const auto free = erosionByLaws(bed()).of(s);
    const auto floor = erosionByLaws(bed("erodibleDepth 0.1;")).of(s);

    ASSERT_EQ(free.size(), 3);
    EXPECT_EQ(free[0].shear, "measured");
    EXPECT_EQ(free[1].shear, "Coulomb");
    EXPECT_EQ(free[2].shear, "Voellmy");

    const scalar rate = progressiveScouring(entries(discs), 15, 9.81).rate(400);
    EXPECT_NEAR(free[0].byScouring.last(), rate, 1e-12);
    EXPECT_NEAR(floor[0].byScouring.last(), 0.1, 1e-12);
    EXPECT_EQ(free[0].byScouring.first(), 0);

    // Ten depths of the static law, whatever the length of a step
    const shearingLaws laws(bed(), 15, 9.81);
    EXPECT_NEAR
    (
        free[0].byStatic.last(), 10*laws.staticDepth(400, 300), 1e-12
    );
    EXPECT_NEAR
    (
        free[0].byDynamic.last(), laws.dynamicRate(400, 300, 1), 1e-12
    );

    // Coulomb's shear is the resistance: it erodes by scouring alone
    EXPECT_EQ(free[1].byStatic.last(), 0);
    EXPECT_GT(free[1].byScouring.last(), 0);
    EXPECT_GT(free[2].byDynamic.last(), 0);
}


TEST(erosionByLaws, errorsAreMeansOfSquares)
{
    sectionSeries s;
    s.t = scalarList({0.0, 1.0});
    s.sigma = scalarList(2, scalar(300));
    s.v = scalarList(2, scalar(1));
    s.tau = scalarList(2, Zero);
    s.depth = scalarList({0.0, 0.2});

    const auto all = erosionByLaws(bed()).of(s);
    EXPECT_NEAR(all[0].scouringError, 0.02, 1e-14);
    EXPECT_NEAR(all[0].staticError, 0.02, 1e-14);
    EXPECT_EQ(all[0].shearError, 0);
    EXPECT_NEAR
    (
        all[1].shearError, sqr(300*std::tan(degToRad(43.0))), 1e-6
    );

    s.depth.clear();
    EXPECT_EQ(erosionByLaws(bed()).of(s)[0].scouringError, -1);
}


TEST(erosionByLaws, stressesThatPullInTheMeanAreAnErrorWithItsRemedy)
{
    sectionSeries s;
    s.t = scalarList({0.0, 1.0});
    s.sigma = scalarList({-300.0, 0.01});
    s.v = scalarList(2, scalar(1));

    const std::string output(refusal([&]() { erosionByLaws(bed()).of(s); }));
    expectHolds(output, "pulls in the mean from 0 to 1 s");
    expectHolds(output, "write factor -1 at normalStress");

    // Nothing there yet is no mistake
    s.sigma = scalarList(2, Zero);
    EXPECT_EQ(erosionByLaws(bed()).of(s)[0].byScouring.last(), 0);
    s.sigma[0] = 300;
    EXPECT_EQ(erosionByLaws(bed()).of(s).size(), 2);
}


TEST(erosionByLaws, aVelocityAgainstTheFlowIsAnErrorWithItsRemedy)
{
    sectionSeries s;
    s.t = scalarList({0.0, 1.0});
    s.sigma = scalarList(2, scalar(300));
    s.v = scalarList({-2.0, -0.5});

    const std::string output(refusal([&]() { erosionByLaws(bed()).of(s); }));
    expectHolds(output, "never positive from 0 to 1 s");
    expectHolds(output, "write factor -1 at velocity");

    // What flows back for a while is no mistake, nor what stands still
    s.v = scalarList({-2.0, 0.5});
    EXPECT_EQ(erosionByLaws(bed()).of(s).size(), 2);
    s.v = scalarList(2, -1e-12);
    EXPECT_EQ(erosionByLaws(bed()).of(s).size(), 2);
}
