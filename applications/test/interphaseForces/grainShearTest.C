// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosity of a liquid with a yield stress at a grain that moves through it.

#include "grainShear.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include "IStringStream.H"
#include "OFstream.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar rho = 1100;
constexpr scalar airRho = 1.2;
constexpr scalar airMu = 1.2*1.5e-5;

//- Yield stress [Pa], consistency [Pa s^n] and viscosity at rest [Pa s]
constexpr scalar tau0 = 4;
constexpr scalar k = 0.3;
constexpr scalar atRest = 1e4;

constexpr scalar d = 0.02;

//- A mesh whose liquid has that yield stress
struct mud
{
    testMesh box;

    explicit mud(const scalar n = 1, const string& model = "HerschelBulkley")
    {
        OFstream(box.folder()/"constant"/"transportProperties")()
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object transportProperties; }\n"
            << "phases (mud air); mud { transportModel " << model.c_str() << "; rho "
            << rho << "; nu 1; HerschelBulkleyCoeffs { n " << n << "; tau0 "
            << tau0/rho << "; k " << k/rho << "; nu0 " << atRest/rho << "; } }"
            << " air { nu 1.5e-5; rho " << airRho << "; }\n";
    }

    grainShear law(const string& entries = "") const
    {
        return grainShear(box.mesh(), dictionary(IStringStream(entries)()));
    }
};


//- Error of the law in that mud
std::string refused(const scalar n, const string& model)
{
    const mud liquid(n, model);
    return refusal([&]() { liquid.law(); });
}

} // End anonymous namespace


TEST(grainShear, sphereMovesFromTheForceOfBerisOn)
{
    const mud liquid;
    const scalar force = 3.5*M_PI*sqr(d)*tau0;

    // Creeping, in liquid that rests
    for (const scalar slip : {1e-10, 1e-7})
    {
        const scalar mu = liquid.law().mu(atRest, rho, d, slip);
        EXPECT_NEAR(3*M_PI*mu*d*slip, force, 1e-5*force);
    }

    // At rest it is finite, and large enough to hold a grain
    const scalar mu = liquid.law().mu(atRest, rho, d, 0);
    EXPECT_TRUE(std::isfinite(mu));
    EXPECT_GT(mu, 1e10);
}


TEST(grainShear, followsTheConsistencyWhereSlipIsFast)
{
    const scalar rate = 1e9;

    EXPECT_NEAR(mud().law().mu(atRest, rho, d, rate*d), k, 1e-6*k);

    const scalar thinned = k*std::pow(rate, 0.4 - 1);
    EXPECT_NEAR
    (
        mud(0.4).law().mu(atRest, rho, d, rate*d), thinned, 1e-3*thinned
    );
}


TEST(grainShear, isThatOfTheFlowWhereThatShearsMore)
{
    const mud liquid;
    const scalar ofFlow = 2;

    EXPECT_EQ(liquid.law().mu(ofFlow, rho, d, 1e-3*d), ofFlow);
    EXPECT_NEAR
    (
        liquid.law().mu(ofFlow, rho, d, 100*d), k + 3.5/3*tau0/100, 1e-12
    );
}


TEST(grainShear, leavesOtherFluidAlone)
{
    const grainShear law(mud().law());

    EXPECT_NEAR(law.mu(airMu, airRho, d, 0.1), airMu, 1e-12*airMu);

    const scalar half = 0.5*(k + 3.5/3*tau0/5 + airMu);
    EXPECT_NEAR
    (
        law.mu(0.5*(atRest + airMu), 0.5*(rho + airRho), d, 5*d), half, 1e-9*half
    );
}


TEST(grainShear, isScaledByItsStrength)
{
    const mud liquid;
    const scalar whole = liquid.law().mu(50, rho, d, 5*d);

    EXPECT_NEAR
    (
        liquid.law("strength 0.3;").mu(50, rho, d, 5*d), 50 + 0.3*(whole - 50), 1e-12
    );

    // Off, it reads nothing
    const mud newtonian(1, "Newtonian");
    EXPECT_FALSE(newtonian.law("strength 0;").isOn());
}


TEST(grainShear, refusesOtherLiquids)
{
    const std::string newtonian(refused(1, "Newtonian"));
    expectHolds(newtonian, "mud is Newtonian");
    expectHolds(newtonian, "take grainShear out");
    expectHolds(refused(1.5, "HerschelBulkley"), "n is 1.5");
}
