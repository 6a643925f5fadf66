// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of an exchange, with LIGGGHTS, and its place in time.

#include "boxOfWater.H"

#include <gtest/gtest.h>

using namespace Foam;


TEST(demCoupling, hasNoGrainsWithoutTheirDictionary)
{
    testMesh box;
    const demCoupling grains(box.mesh(), hydrostatics(g));

    EXPECT_FALSE(grains.hasGrains());
    EXPECT_FALSE(grains.due());
}


TEST(demCoupling, takesAWholeNumberOfFluidStepsInAnInterval)
{
    boxOfWater w;
    const demCoupling grains(w.box().mesh(), hydrostatics(g));

    EXPECT_TRUE(grains.due());
    EXPECT_NEAR(grains.stepInInterval(1), interval, 1e-12*interval);
    EXPECT_NEAR(grains.stepInInterval(interval), interval, 1e-12*interval);
    EXPECT_NEAR(grains.stepInInterval(0.3*interval), interval/4, 1e-12*interval);
}


TEST(demCoupling, goesEvenlyToTheVoidFractionThatTheGrainsLeave)
{
    boxOfWater w;
    const fvMesh& mesh = w.box().mesh();
    demCoupling grains(mesh, hydrostatics(g));
    const fluidFields water(w.water());
    volScalarField voidFraction
    (
        IOobject("voidFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    );
    const scalarField before(1 - grains.solidFraction());
    grains.start(water);

    grains.moveGrains();
    grains.locateGrains();
    grains.findVoidFraction();
    grains.prepareForces(water);

    EXPECT_FALSE(grains.due());
    const scalarField after(1 - grains.solidFraction());
    EXPECT_GT(max(mag(after - before)), 1e-12);

    // Times the interval, whatever the fluid's step
    const auto change = [&](const scalar dt)
    {
        return scalarField
        (
            interval*grains.voidFractionRate(voidFraction, dt)().field()
        );
    };
    voidFraction.primitiveFieldRef() = before;
    EXPECT_LT(max(mag(change(interval) - (after - before))), 1e-15);
    EXPECT_LT(max(mag(change(interval/2) - (after - before)/2)), 1e-15);
    voidFraction.primitiveFieldRef() = after;
    EXPECT_LT(max(mag(change(interval))), 1e-15);
}


TEST(demCoupling, givesGrainsTheOppositeOfWhatTheFluidGets)
{
    boxOfWater w;
    const fvMesh& mesh = w.box().mesh();
    demCoupling grains(mesh, hydrostatics(g));
    const fluidFields water(w.water());
    grains.start(water);

    grains.moveGrains();
    grains.locateGrains();
    grains.findVoidFraction();
    grains.prepareForces(water);

    const surfaceScalarField none
    (
        IOobject("none", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure/dimLength*dimArea, Zero)
    );
    grains.addFluidStep
    (
        water.U, water.rho, none, water.U, vectorField(), interval
    );
    EXPECT_TRUE(grains.due());
    grains.setParticleForces(water.U);

    EXPECT_LT(grains.forces().residual(), 1e-12);
    EXPECT_EQ(grains.forces().force().size(), 4);
}
