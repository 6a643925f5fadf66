// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: the constitutive laws of material points, on single points.

#include "StringStream.H"
#include "constitutiveLaw.H"
#include "terminalOutput.H"
#include "scalarField.H"
#include "softeningDruckerPrager.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

dictionary settings(const string& text)
{
    return dictionary(IStringStream(text)());
}


const string soft
(
    "law softeningDruckerPrager; density 1920; E 45e6; nu 0.2; cohesion 100;"
    " frictionAngle 42; residualFrictionAngle 22.5;"
    " softeningStrains (0.033 0.1);"
);


//- A point of density rho that deforms with a gradient of velocity
struct singlePoint
{
    pointSet points;
    scalarField dilation = scalarField(1, 0);

    singlePoint(const scalar rho, const tensor& gradient)
    {
        points.resize(1);
        points.volume[0] = 1e-3;
        points.mass[0] = 1e-3*rho;
        points.gradient[0] = gradient;
    }

    scalar rootJ2() const
    {
        return std::sqrt(0.5*magSqr(dev(points.stress[0])));
    }

    scalar pressure() const
    {
        return -tr(points.stress[0])/3;
    }
};


//- tan phi of the settings above, as Fig. 5 of the study draws it
scalar drawnFriction(const scalar strain)
{
    const scalar peak = std::tan(42*M_PI/180);
    const scalar residual = std::tan(22.5*M_PI/180);
    const scalar along = min(max((strain - 0.033)/(0.1 - 0.033), 0.0), 1.0);
    return peak + along*(residual - peak);
}

const tensor shear(0, 0, 1, 0, 0, 0, 0, 0, 0);
const tensor stretch(1, 0, 0, 0, 0, 0, 0, 0, -1);

} // End anonymous namespace


TEST(pointLaws, simpleShearFollowsTheSofteningToRoundOff)
{
    const softeningDruckerPrager law(settings(soft));
    singlePoint one(1.001*1920, shear);
    const scalar p = law.bulkModulus()*std::log(1.001);

    for (label n = 1; n <= 2500; ++n)
    {
        law.update(one.points, 0, one.dilation, 1e-4);
        const scalar strain = 1e-4*n/std::sqrt(3.0);
        const scalar tangent = drawnFriction(strain);
        const scalar limit = (p*tangent + 100)/std::sqrt(1 + sqr(tangent));

        ASSERT_NEAR(one.points.strain[0], strain, 1e-13);
        ASSERT_NEAR(one.pressure(), p, 1e-10*p);
        ASSERT_LE(one.rootJ2(), limit*(1 + 1e-12));

        // Elastic up to a strain of some 1e-3
        if (n > 100)
        {
            ASSERT_NEAR(one.rootJ2(), limit, 1e-12*limit);
        }
    }
    EXPECT_EQ(law.friction(one.points.strain[0]), law.friction(1));
}


TEST(pointLaws, belowTheLimitItIsElastic)
{
    const softeningDruckerPrager law(settings(soft));
    singlePoint one(1.001*1920, shear);
    law.update(one.points, 0, one.dilation, 1e-6);
    EXPECT_NEAR(one.points.stress[0].xz(), law.shearModulus()*1e-6, 1e-9);
}


TEST(pointLaws, netStrainComesBackWherePathStrainGrows)
{
    const string names[] = {"path", "net"};
    const scalar expected[] = {0.2*2/std::sqrt(3.0), 0};

    for (const int k : {0, 1})
    {
        const softeningDruckerPrager law
        (
            settings(soft + "measure " + names[k] + ";")
        );
        singlePoint one(1.001*1920, stretch);

        for (const scalar sign : {1.0, -1.0})
        {
            one.points.gradient[0] = sign*stretch;
            for (label n = 0; n < 100; ++n)
            {
                law.update(one.points, 0, one.dilation, 1e-3);
            }
            if (sign > 0)
            {
                // std::sqrt(4 e_z^2)/std::sqrt(3)
                EXPECT_NEAR(one.points.strain[0], 0.1*2/std::sqrt(3.0), 1e-13);
            }
        }
        EXPECT_NEAR(one.points.strain[0], expected[k], 1e-13) << names[k];
    }
}


TEST(pointLaws, looseMaterialIsFreeOfStressUntilItIsDenseAgain)
{
    const softeningDruckerPrager law(settings(soft));
    singlePoint one(1.001*1920, shear);
    law.update(one.points, 0, one.dilation, 1e-3);
    EXPECT_GT(one.rootJ2(), 0);

    one.points.volume[0] *= 1.01;
    law.update(one.points, 0, one.dilation, 1e-3);
    EXPECT_EQ(mag(one.points.stress[0]), 0);

    one.points.volume[0] /= 1.01;
    law.update(one.points, 0, one.dilation, 1e-3);
    EXPECT_NEAR
    (
        one.pressure(), law.bulkModulus()*std::log(1.001), 1e-9*law.bulkModulus()
    );
}


TEST(pointLaws, slopeMatchingIsTheTangent)
{
    const softeningDruckerPrager law
    (
        settings(soft + "matching slope;")
    );
    EXPECT_NEAR
    (
        law.strength(1000, 0), 1000*std::tan(42*M_PI/180) + 100, 1e-9
    );
}


TEST(pointLaws, stressTurnsWithTheMaterial)
{
    // A quarter turn brings xx to zz
    const auto law = constitutiveLaw::New
    (
        settings("law linearElastic; density 1000; E 1e6; nu 0.3;")
    );
    singlePoint one(1000, tensor(0, 0, 1, 0, 0, 0, -1, 0, 0));
    one.points.stress[0] = symmTensor(100, 0, 0, 0, 0, 0);

    const label n = 20000;
    for (label i = 0; i < n; ++i)
    {
        law->update(one.points, 0, one.dilation, 0.5*M_PI/n);
    }
    EXPECT_NEAR(one.points.stress[0].zz(), 100, 0.05);
    EXPECT_NEAR(one.points.stress[0].xx(), 0, 0.05);
}


TEST(pointLaws, anAngleThatMayBeInRadiansIsNamed)
{
    const auto output = [](const string& angles)
    {
        return outputDuring
        (
            [&]()
            {
                constitutiveLaw::New
                (
                    settings
                    (
                        "law softeningDruckerPrager; density 1; E 1; nu 0;"
                      + angles
                    )
                );
            }
        );
    };

    expectHolds(output("frictionAngle 0.56;"), "frictionAngle is 0.56 degrees");
    expectHolds(output("frictionAngle 0.56;"), "write 32.08");
    expectHolds
    (
        output("frictionAngle 32; residualFrictionAngle 0.4;"),
        "residualFrictionAngle is 0.4 degrees"
    );
    expectLacks
    (
        output("frictionAngle 1.6; residualFrictionAngle 0;"), "Warning"
    );
    expectLacks
    (
        output("frictionAngle 0.56;"), "residualFrictionAngle"
    );
}


TEST(pointLaws, whatIsWrongIsNamed)
{
    const char* const wrong[][2]
    {
        {"law noSuch; density 1; E 1; nu 0;", "softeningDruckerPrager"},
        {"law linearElastic; density 0; E 1; nu 0;", "density is 0"},
        {"law linearElastic; density 1; E 1; nu 0.5;", "Poisson"},
        {"law linearElastic; density 1; E 1; nu 0; cohesin 1;", "cohesin"},
        {"law linearElastic; densty 1; E 1; nu 0;", "Valid keywords: law density"},
        {
            "law softeningDruckerPrager; density 1; E 1; nu 0;"
            " frictionAngl 30;",
            "Valid keywords: law density E nu solidDensity grainDiameter"
            " poreDiameter frictionAngle"
        },
        {
            "law dilatantMuI; density 1; E 1; nu 0; staticFrction 0.3;",
            "Valid keywords: law density"
        },
        {
            "law softeningDruckerPrager; density 1; E 1; nu 0;"
            " frictionAngle 95;",
            "frictionAngle is 95"
        },
        {
            "law softeningDruckerPrager; density 1; E 1; nu 0;"
            " frictionAngle 30; softeningStrains (0.2 0.1);",
            "softeningStrains are 0.2 and 0.1"
        }
    };

    for (const auto& w : wrong)
    {
        try
        {
            constitutiveLaw::New(settings(w[0]));
            ADD_FAILURE() << "no error for " << w[0];
        }
        catch (const Foam::error& e)
        {
            EXPECT_NE(std::string(e.message()).find(w[1]), std::string::npos)
                << e.message();
        }
    }
}
