// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosity of a liquid with a yield stress at a grain that moves through it.

#include "grainShear.H"
#include "interphaseForces.H"
#include "standingGrains.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar rho = 1000;
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
        mkDir(box.folder()/"constant");
        OFstream(box.folder()/"constant"/"transportProperties")()
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object transportProperties; }\n"
            << "phases (mud air); mud { transportModel " << model.c_str() << "; rho "
            << rho << "; nu 1; HerschelBulkleyCoeffs { n " << n << "; tau0 "
            << tau0/rho << "; k " << k/rho << "; nu0 " << atRest/rho << "; } }"
            << " air { nu 1.5e-5; rho " << airRho << "; }\n";
    }

    grainShear law(const string& entries = "")
    {
        return grainShear(box.mesh(), dictionary(IStringStream(entries)()));
    }
};


//- Error of the law in that mud
std::string refused(const scalar n, const string& model)
{
    mud liquid(n, model);
    return refusal([&]() { liquid.law(); });
}

//- A sphere in a box of fluid
struct sphereInMud
:
    mud
{
    static constexpr scalar interval = 1e-3;

    static constexpr scalar mass = 0.01;

    standingGrains phase;

    grainExchange exchange;

    autoPtr<solidFractionField> solids;

    autoPtr<interphaseForces> forces;

    explicit sphereInMud(const bool mobile)
    :
        phase(box.mesh()),
        exchange(box.mesh())
    {
        phase.grains = grainSnapshot(1);
        phase.grains.id = identity(1);
        phase.grains.position = point(0.4, 0.4, 0.4);
        phase.grains.mass = mass;
        phase.radii = scalarField(1, 0.5*d);
        if (!mobile)
        {
            phase.held.insert(0);
        }
        exchange.locate(phase);
        const auto entries = [](const string& text)
        {
            return dictionary(IStringStream(text)());
        };
        solids.reset
        (
            new solidFractionField
            (
                exchange, entries("model centroid; smoothing { model none; }")
            )
        );
        solids->update();
        forces.reset
        (
            new interphaseForces
            (
                exchange,
                *solids,
                entries("drag { model SchillerNaumann; } grainShear { }"),
                vector(Zero),
                1
            )
        );
    }

    //- In fluid of that density and viscosity, which moves along x with U
    scalar force(const scalar U, const scalar density, const scalar mu)
    {
        const label n = box.mesh().nCells();
        const vectorField none(n, Zero);
        const scalarField one(n, 1);
        const vectorField moving(n, vector(U, 0, 0));
        forces->prepare
        (
            fluidFields{density*one, mu*one, one, moving, none, none, none}, interval
        );
        forces->finish(fluidMeans{moving, none, none, none, density*one, Zero});
        return forces->force()[0].x();
    }
};


//- Drag of Schiller & Naumann [N]
scalar drag(const scalar U, const scalar density, const scalar mu)
{
    return 3*M_PI*mu*d*U*(1 + 0.15*std::pow(density*U*d/mu, 0.687));
}

} // End anonymous namespace


TEST(grainShear, sphereMovesFromTheForceOfBerisOn)
{
    mud liquid;
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
    EXPECT_GT(mu, 1e9);
}


TEST(grainShear, followsTheConsistencyWhereSlipIsFast)
{
    const scalar rate = 1e12;

    EXPECT_NEAR(mud().law().mu(atRest, rho, d, rate*d), k, 1e-6*k);

    const scalar thinned = k*std::pow(rate, 0.4 - 1);
    EXPECT_NEAR
    (
        mud(0.4).law().mu(atRest, rho, d, rate*d), thinned, 1e-3*thinned
    );
}


TEST(grainShear, isThatOfTheFlowWhereThatShearsMore)
{
    mud liquid;
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
    mud liquid;
    const scalar whole = liquid.law().mu(50, rho, d, 5*d);

    EXPECT_NEAR
    (
        liquid.law("strength 0.3;").mu(50, rho, d, 5*d), 50 + 0.3*(whole - 50), 1e-12
    );

    // Off, it reads nothing
    mud newtonian(1, "Newtonian");
    EXPECT_FALSE(newtonian.law("strength 0;").isOn());
}


TEST(grainShear, refusesOtherLiquids)
{
    const std::string newtonian(refused(1, "Newtonian"));
    expectHolds(newtonian, "mud is Newtonian");
    expectHolds(newtonian, "take grainShear out");
    expectHolds(refused(1.5, "HerschelBulkley"), "n is 1.5");
}


TEST(grainShear, aFrozenGrainHasTheDragOfItsSlip)
{
    sphereInMud sphere(false);
    const grainShear law(sphere.law());

    for (scalar U = 1e-6; U < 1; U *= 1.07)
    {
        const scalar exact = drag(U, rho, law.mu(atRest, rho, d, U));
        EXPECT_NEAR(sphere.force(U, rho, atRest), exact, 1e-9*exact) << U;
    }
}


TEST(grainShear, mudStopsAGrainWithinAnIntervalWhereItHoldsIt)
{
    sphereInMud sphere(true);
    const scalar held = 3.5*M_PI*sqr(d)*tau0*sphere.interval/sphere.mass;

    // All of the slip, as the yield stress takes more momentum in an interval
    const scalar slow = 0.5*held;
    EXPECT_NEAR
    (
        sphere.force(slow, rho, atRest)*sphere.interval, sphere.mass*slow,
        1e-3*sphere.mass*slow
    );

    // The yield stress and what viscosity adds to it; the Reynolds number is that before
    const scalar fast = 2*held;
    const scalar force = sphere.force(fast, rho, atRest);
    const scalar left = fast - force*sphere.interval/sphere.mass;
    EXPECT_GT(left, 0);

    const scalar mu = sphere.law().mu(atRest, rho, d, left);
    EXPECT_NEAR(force, drag(left, rho, mu), 2e-3*force);
}


TEST(grainShear, aGrainInAirHasTheDragOfAir)
{
    sphereInMud sphere(false);
    const scalar exact = drag(0.2, airRho, airMu);
    EXPECT_NEAR(sphere.force(0.2, airRho, airMu), exact, 1e-9*exact);
}
