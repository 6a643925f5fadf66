// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of an exchange, with LIGGGHTS, and its place in time.

#include "boxOfWater.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;


TEST(demCoupling, hasNoGrainsWithoutTheirDictionary)
{
    testMesh box;
    const demCoupling coupling(box.mesh(), hydrostatics(g));

    EXPECT_FALSE(coupling.hasGrains());
    EXPECT_FALSE(coupling.due());
}


TEST(demCoupling, leavesEquationsAsTheyAreWithoutGrains)
{
    testMesh box;
    const fvMesh& mesh = box.mesh();
    demCoupling coupling(mesh, hydrostatics(g));
    const slidingGate gate(mesh);
    const auto field = [&](const word& name, const scalar value)
    {
        return volScalarField
        (
            IOobject(name, mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(name, dimless, value)
        );
    };
    volScalarField voidFraction(field("voidFraction", 0.7));
    voidFraction.oldTime();
    const surfaceScalarField phi
    (
        IOobject("phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimVelocity*dimArea, 1)
    );

    coupling.advanceVoidFraction(voidFraction, phi, 0.1);
    EXPECT_EQ(min(voidFraction).value(), 0.7);
    EXPECT_EQ(max(voidFraction).value(), 0.7);
    EXPECT_EQ
    (
        max(mag(coupling.voidFractionRate(voidFraction, gate, 0.1)().field())), 0
    );
    EXPECT_EQ
    (
        max(mag(coupling.fluidPressureShare(voidFraction)().primitiveField() - 0.7)), 0
    );
    EXPECT_EQ(max(mag(coupling.dragCoefficient()())), 0);
    EXPECT_EQ(max(mag(coupling.explicitForce()())), 0);
    EXPECT_EQ(coupling.dragCoefficient()().size(), mesh.nCells());
    EXPECT_EQ(coupling.viscousForceStrength(), 0);
    EXPECT_EQ(coupling.relaxationTime(), 0);
    EXPECT_NO_THROW(coupling.checkTimes(mesh.time(), false));
}


TEST(demCoupling, takesAWholeNumberOfFluidStepsInAnInterval)
{
    boxOfWater w;
    const demCoupling coupling(w.box().mesh(), hydrostatics(g));

    EXPECT_TRUE(coupling.due());
    EXPECT_NEAR(coupling.clock().stepInInterval(1), interval, 1e-12*interval);
    EXPECT_NEAR(coupling.clock().stepInInterval(interval), interval, 1e-12*interval);
    EXPECT_NEAR
    (
        coupling.clock().stepInInterval(0.3*interval), interval/4, 1e-12*interval
    );
}


TEST(demCoupling, goesEvenlyToTheVoidFractionThatTheGrainsLeave)
{
    boxOfWater w;
    const fvMesh& mesh = w.box().mesh();
    demCoupling coupling(mesh, hydrostatics(g));
    const fluidFields water(w.water());
    volScalarField voidFraction
    (
        IOobject("voidFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    );
    const scalarField before(1 - coupling.solidFraction());
    coupling.start(water);

    coupling.moveGrains();
    coupling.locateGrains();
    coupling.findVoidFraction();
    coupling.prepareForces(water);

    EXPECT_FALSE(coupling.due());
    const scalarField after(1 - coupling.solidFraction());
    EXPECT_GT(max(mag(after - before)), 1e-12);

    const slidingGate gate(mesh);

    // Times the interval, whatever the fluid's step
    const auto change = [&](const scalar dt)
    {
        return scalarField
        (
            interval*coupling.voidFractionRate(voidFraction, gate, dt)().field()
        );
    };
    voidFraction.primitiveFieldRef() = before;
    EXPECT_LT(max(mag(change(interval) - (after - before))), 1e-15);
    EXPECT_LT(max(mag(change(interval/2) - (after - before)/2)), 1e-15);
    voidFraction.primitiveFieldRef() = after;
    EXPECT_LT(max(mag(change(interval))), 1e-15);
}


TEST(demCoupling, takesARelaxationTimeToReachTheVoidFractionOfTheGrains)
{
    boxOfWater w("exchange { interval 50; relaxationTime 0.01; }");
    const fvMesh& mesh = w.box().mesh();
    demCoupling coupling(mesh, hydrostatics(g));
    coupling.start(w.water());
    coupling.moveGrains();
    coupling.locateGrains();
    coupling.findVoidFraction();

    volScalarField voidFraction
    (
        IOobject("voidFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    );
    const slidingGate gate(mesh);
    const scalarField missing(-coupling.solidFraction());
    const tmp<volScalarField::Internal> rate
    (
        coupling.voidFractionRate(voidFraction, gate, interval)
    );
    EXPECT_LT(max(mag(0.01*rate().field() - missing)), 1e-15);
}


TEST(demCoupling, refusesARelaxationTimeBelowTheInterval)
{
    boxOfWater w("exchange { interval 50; relaxationTime 1e-4; }");
    const std::string words
    (
        refusal([&]() { demCoupling(w.box().mesh(), hydrostatics(g)); })
    );
    EXPECT_NE(words.find("below the exchange interval"), std::string::npos) << words;
}


TEST(demCoupling, givesGrainsTheOppositeOfWhatTheFluidGets)
{
    boxOfWater w;
    const fvMesh& mesh = w.box().mesh();
    demCoupling coupling(mesh, hydrostatics(g));
    const fluidFields water(w.water());
    coupling.start(water);

    coupling.moveGrains();
    coupling.locateGrains();
    coupling.findVoidFraction();
    coupling.prepareForces(water);

    const surfaceScalarField none
    (
        IOobject("none", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure/dimLength*dimArea, Zero)
    );
    coupling.addFluidStep
    (
        water.U, water.rho, none, water.U, vectorField(), interval
    );
    EXPECT_TRUE(coupling.due());
    coupling.setGrainForces(water.U);

    EXPECT_LT(coupling.forces().residual(), 1e-12);
    EXPECT_EQ(coupling.forces().force().size(), 4);
}
