// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: mu(I) with dilation, on single points and slopes.

#include "dilatantMuI.H"
#include "terminalOutput.H"
#include "scalarField.H"
#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

dictionary settings(const string& text)
{
    return dictionary(IStringStream(text)());
}


//- phi_m 0.56; density is that of a solid fraction of 0.56
const string grains
(
    "law dilatantMuI; density 1484; solidDensity 2650; grainDiameter 0.01;"
    " E 1e6; nu 0.2; staticFriction 0.382; limitFriction 0.643; b 0.31;"
    " maxSolidFraction 0.56; a 1.23; dilation 4.7;"
);


//- A point that shears at a rate of 10 1/s
struct shearedPoint
{
    pointSet points;
    scalarField dilation = scalarField(1, 0);
    const scalar rate = 10;

    explicit shearedPoint(const scalar phi, const scalar p = 0)
    {
        points.resize(1);
        points.mass[0] = 1;
        points.gradient[0] = tensor(0, 0, rate, 0, 0, 0, 0, 0, 0);
        points.stress[0] = -p*symmTensor::I;
        setFraction(phi);
    }

    void setFraction(const scalar phi)
    {
        points.volume[0] = points.mass[0]/(2650*phi);
    }

    scalar pressure() const
    {
        return -tr(points.stress[0])/3;
    }

    scalar rootJ2() const
    {
        return std::sqrt(0.5*magSqr(dev(points.stress[0])));
    }
};

} // End anonymous namespace


TEST(dilatantMuI, shearAtConstantVolumeFindsTheFrictionAndPressureOfItsRate)
{
    for (const string liquid : {"", "viscosity 1;"})
    {
        const scalar eta = liquid.empty() ? 0 : 1;
        const dilatantMuI law(settings(grains + liquid));
        shearedPoint one(0.5);

        for (label n = 0; n < 2000; ++n)
        {
            law.update(one.points, 0, one.dilation, 1e-4);
        }

        // phi = phi_m/(1 + a I_m), solved for p and I_m
        const scalar I = (0.56/0.5 - 1)/1.23;
        const scalar p = (sqr(10*0.01)*2650 + 2*eta*10)/sqr(I);
        const scalar mu =
            0.382 + (0.643 - 0.382)/(1 + 0.31/I)
          + 2.5*0.5*eta*10/p/(1.23*I);

        // The stress turns by its elastic strain, which counts squared
        const scalar turned = sqr(mu*p/law.shearModulus());
        EXPECT_NEAR(one.pressure(), p, turned*p);
        EXPECT_NEAR(one.rootJ2(), mu*p, turned*mu*p);
    }
}


//- Grains so small that phi_eq = phi_m at any rate
const string tinyGrains
(
    "law dilatantMuI; density 1600; solidDensity 2650; E 1e8; nu 0.2;"
    " grainDiameter 1e-9; staticFriction 0.382; limitFriction 0.643;"
    " b 0.31; maxSolidFraction 0.56; a 1.23; dilation 4.7;"
);


//- Solid fraction after a shear of 2 at a pressure of 1 kPa, from this one on
scalar shearedAtConstantPressure(const dilatantMuI& law, const scalar start)
{
    // As much as follows by itself where the pressure is held: p is read, and
    // the volume gives way until it is 1 kPa
    const scalar dt = 1e-5;
    shearedPoint one(start, 1000);
    scalar phi = start;
    for (label n = 0; n < 20000; ++n)
    {
        const scalar excess = one.pressure() - 1000;
        one.dilation[0] = excess/law.bulkModulus()/dt;
        phi /= 1 + dt*one.dilation[0];
        one.setFraction(phi);
        law.update(one.points, 0, one.dilation, dt);
    }
    return phi;
}


//- The same: d phi/d gamma = -phi K (phi - phi_m), with K_4 or K_c
scalar exactFraction(const scalar K, const scalar start)
{
    return 0.56/(1 - (1 - 0.56/start)*std::exp(-K*0.56*2));
}


TEST(dilatantMuI, shearAtConstantPressureDilatesAsTheClosedForm)
{
    const scalar exact = exactFraction(4.7, 0.62);
    const scalar phi =
        shearedAtConstantPressure(dilatantMuI(settings(tinyGrains)), 0.62);

    EXPECT_NEAR(phi, exact, 0.01*(0.62 - exact));
    EXPECT_LT(phi, 0.565);
}


TEST(dilatantMuI, aLooseSkeletonContractsAsTheClosedForm)
{
    const string loose = "looseSolidFraction 0.5; contraction 3;";
    const scalar exact = exactFraction(3, 0.52);
    const scalar phi = shearedAtConstantPressure
    (
        dilatantMuI(settings(tinyGrains + loose)), 0.52
    );

    EXPECT_NEAR(phi, exact, 0.01*(exact - 0.52));
    EXPECT_GT(phi, 0.55);
}


TEST(dilatantMuI, aLooseSkeletonBearsStressUntilItIsSheared)
{
    // At constant volume, as a liquid in the pores holds it: with B = K_c (phi_m - phi)
    // the pressure falls by K B for each plastic strain, and with it the elastic one
    dilatantMuI law
    (
        settings(tinyGrains + "looseSolidFraction 0.5; contraction 3;")
    );
    const scalar K = law.bulkModulus();
    const scalar G = law.shearModulus();
    const scalar B = 3*(0.56 - 0.53);
    const scalar start = 1e5;

    shearedPoint one(0.53, start);
    const tensor shear = one.points.gradient[0];
    one.points.gradient[0] = Zero;
    law.update(one.points, 0, one.dilation, 1e-4);
    EXPECT_EQ(one.pressure(), start);

    // Half of the pressure is gone
    const scalar yields = 0.382*start/G;
    const scalar strain = yields + 0.5*start/(K*B)*(1 - 0.382*K*B/G);
    const label steps = 1000;
    one.points.gradient[0] = shear;
    for (label n = 0; n < steps; ++n)
    {
        law.update(one.points, 0, one.dilation, strain/one.rate/steps);
    }
    EXPECT_NEAR(one.pressure(), 0.5*start, 0.005*start);
    EXPECT_NEAR(one.rootJ2(), 0.382*0.5*start, 0.382*0.005*start);

    // Then all of it: the skeleton has collapsed
    for (label n = 0; n < 2*steps; ++n)
    {
        law.update(one.points, 0, one.dilation, strain/one.rate/steps);
    }
    EXPECT_LT(one.pressure(), 1e-6*start);

    // While it settles it keeps its density, and its stress
    law.setSettling(true);
    shearedPoint settling(0.53, start);
    for (label n = 0; n < steps; ++n)
    {
        law.update(settling.points, 0, settling.dilation, strain/one.rate/steps);
    }
    EXPECT_NEAR(settling.pressure(), start, 1e-6*start);
}


TEST(dilatantMuI, theReturnIsConsistent)
{
    for
    (
        const string more :
        {
            "strength printed;", "strength withDilation;",
            "looseSolidFraction 0.55; contraction 5;"
        }
    )
    {
        const dilatantMuI law(settings(grains + "viscosity 0.5; " + more));
        const scalar loosest = law.looseDensity()/2650;
        const scalar K = law.bulkModulus();
        const scalar G = law.shearModulus();
        const scalar dt = 1e-4;

        for (const scalar phi : {0.58, 0.561, 0.555, 0.5})
        {
            shearedPoint one(phi, 2000);

            for (label n = 0; n < 200; ++n)
            {
                const scalar p = one.pressure();
                symmTensor s(dev(one.points.stress[0]));
                const tensor& L = one.points.gradient[0];
                s += dt*(turning(L, s) + 2*G*dev(symm(L)));
                const scalar trial = std::sqrt(0.5*magSqr(s));

                law.update(one.points, 0, one.dilation, dt);
                const scalar rate = (trial - one.rootJ2())/(G*dt);
                const scalar now = one.pressure();
                const scalar limit = law.yieldLimit(rate, now, phi);

                ASSERT_GE(rate, -1e-9);
                ASSERT_LE(one.rootJ2(), limit*(1 + 1e-6) + 1e-6);
                if (rate < 1e-6)
                {
                    continue;
                }

                // On the surface of shear; and either dilated, or compacted to
                // the pressure at which it is in equilibrium
                ASSERT_NEAR(one.rootJ2(), limit, 1e-6*limit + 1e-6);
                const scalar opened =
                    p + K*dt*rate*law.dilatancy(rate, now, phi);
                if (phi < loosest && now < opened*(1 - 1e-6))
                {
                    ASSERT_NEAR(now, law.largestPressure(rate, phi), 1e-5*now);
                }
                else
                {
                    ASSERT_NEAR(now, opened, 1e-6*opened);
                }
            }
        }
    }
}


TEST(dilatantMuI, thinMaterialThatIsShearedFastComesBackToTheSurface)
{
    // So thin that K_c (phi_m - phi) would take more strength than the shear gives
    const dilatantMuI law
    (
        settings(grains + "looseSolidFraction 0.5; contraction 7;")
    );
    shearedPoint one(0.2, 5000);
    one.points.gradient[0] = tensor(0, 0, 1e4, 0, 0, 0, 0, 0, 0);
    const scalar dt = 1e-5;

    for (label n = 0; n < 20; ++n)
    {
        symmTensor s(dev(one.points.stress[0]));
        const tensor& L = one.points.gradient[0];
        s += dt*(turning(L, s) + 2*law.shearModulus()*dev(symm(L)));
        const scalar trial = std::sqrt(0.5*magSqr(s));

        law.update(one.points, 0, one.dilation, dt);
        const scalar rate = (trial - one.rootJ2())/(law.shearModulus()*dt);
        const scalar limit = law.yieldLimit(rate, one.pressure(), 0.2);
        ASSERT_LE(one.rootJ2(), limit*(1 + 1e-6) + 1e-6) << n;
    }
}


TEST(dilatantMuI, tensionOpensItAndLooseMaterialAtRestIsFreeOfStress)
{
    const dilatantMuI law(settings(grains));

    shearedPoint pulled(0.57, 10);
    pulled.points.gradient[0] = tensor::I;
    pulled.dilation[0] = 3;
    law.update(pulled.points, 0, pulled.dilation, 1e-2);
    EXPECT_EQ(mag(pulled.points.stress[0]), 0);

    shearedPoint loose(0.5, 10);
    loose.points.gradient[0] = Zero;
    law.update(loose.points, 0, loose.dilation, 1e-4);
    EXPECT_EQ(mag(loose.points.stress[0]), 0);
}


TEST(dilatantMuI, aSlopeStandsBelowItsStaticFrictionAndFlowsAbove)
{
    // atan 0.382 is 20.9 degrees
    pointBox box;
    box.length = 0.1;
    box.height = 0.3;
    box.h = 0.025;
    const scalar below = speedOnSlope(19.5, grains, box);
    const scalar above = speedOnSlope(23, grains, box);
    testNumber("speed at 19.5 degrees over that without friction", below);
    testNumber("speed at 23 degrees over that without friction", above);

    EXPECT_LT(below, 1e-3);
    EXPECT_GT(above, 0.01);
}


TEST(dilatantMuI, whatIsWrongIsNamed)
{
    const auto output = [](const string& more)
    {
        return refusal([&]() { constitutiveLaw::New(settings(grains + more)); });
    };

    EXPECT_EQ(output(""), "nothing");
    EXPECT_NE
    (
        output("limitFriction 0.3;").find("below staticFriction"),
        std::string::npos
    );
    EXPECT_NE
    (
        output("maxSolidFraction 1;").find("maxSolidFraction is 1"),
        std::string::npos
    );
    EXPECT_NE(output("contraction 2;").find("set both"), std::string::npos);
    EXPECT_NE
    (
        output("looseSolidFraction 0.6;").find("looseSolidFraction is 0.6"),
        std::string::npos
    );
    EXPECT_NE
    (
        output("looseSolidFraction 0.4; contraction 9;").find("below 7.2"),
        std::string::npos
    );
    EXPECT_NE(output("strength both;").find("withDilation"), std::string::npos);
    EXPECT_NE(output("frictionAngle 3;").find("frictionAngle"), std::string::npos);
}
