// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure gradient of fluids at rest, where a mesh repeats itself along gravity.

#include "hydrostatics.H"
#include "testMesh.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const vector onSlope(2.5, 0, -9.5);

//- A box that repeats itself along x and y
testBox chute()
{
    testBox box;
    box.patches = {"cyclic", "cyclic", "cyclic", "cyclic", "wall", "patch"};

    return box;
}


//- Water in the lower half, air above
scalarField waterAndAir(const fvMesh& mesh)
{
    scalarField rho(mesh.nCells(), 1.2);

    forAll(rho, cell)
    {
        rho[cell] = mesh.cellCentres()[cell].z() < 0.5 ? 1000 : 1.2;
    }

    return rho;
}

} // End anonymous namespace


TEST(hydrostatics, gravityAlongCyclicPatchesDrivesTwoFluids)
{
    testMesh box(chute());
    const scalarField rho(waterAndAir(box.mesh()));
    const hydrostatics rest(box.mesh(), onSlope, rho, 1.2);

    EXPECT_TRUE(rest.drives());
    EXPECT_LT(mag(rest.along() - vector(2.5, 0, 0)), 1e-14);
    EXPECT_LT(mag(rest.normal() - vector(0, 0, -9.5)), 1e-14);

    // Pressure gradient and driving force together are the weight of the fluid
    const scalarField full(rho.size(), 1);
    const vectorField both
    (
        rest.gradient(rho) + rest.drivingForce(full, rho)
    );
    EXPECT_LT(gMax(mag(both - rho*onSlope)()), 1e-10);
}


TEST(hydrostatics, alongTheChuteThePressureRisesAsInTheLighterFluid)
{
    testMesh box(chute());
    const hydrostatics rest(box.mesh(), onSlope, waterAndAir(box.mesh()), 1.2);

    EXPECT_NEAR(rest.gradient(1000).x(), 1.2*2.5, 1e-12);
    EXPECT_NEAR(rest.gradient(1.2).x(), 1.2*2.5, 1e-12);

    // Air at rest stays there
    const scalarField air(1, 1.2);
    EXPECT_LT(mag(rest.drivingForce(scalarField(1, 1), air)[0]), 1e-12);
}


TEST(hydrostatics, allDirectionsThatRepeatCount)
{
    testMesh box(chute());
    const hydrostatics rest
    (
        box.mesh(), vector(2, -1, -9), waterAndAir(box.mesh()), 1.2
    );

    EXPECT_LT(mag(rest.along() - vector(2, -1, 0)), 1e-14);
}


TEST(hydrostatics, gravityAcrossCyclicPatchesIsLeftAsItIs)
{
    testMesh box(chute());
    const vector down(0, 0, -9.81);
    const hydrostatics rest(box.mesh(), down, waterAndAir(box.mesh()), 1.2);

    EXPECT_FALSE(rest.drives());
    EXPECT_EQ(rest.normal(), down);
    EXPECT_EQ(rest.gradient(1000), 1000*down);
}


TEST(hydrostatics, withoutCyclicPatchesGravityIsLeftAsItIs)
{
    testMesh box;
    const hydrostatics rest(box.mesh(), onSlope, waterAndAir(box.mesh()), 1.2);

    EXPECT_FALSE(rest.drives());
    EXPECT_EQ(rest.normal(), onSlope);
}


TEST(hydrostatics, oneFluidAloneIsBalancedAndASecondIsReported)
{
    testMesh box(chute());
    const scalarField water(box.mesh().nCells(), 1000);
    const hydrostatics rest(box.mesh(), onSlope, water, 1.2);

    EXPECT_FALSE(rest.drives());
    EXPECT_EQ(rest.normal(), onSlope);
    rest.check(water);

    EXPECT_THROW(rest.check(waterAndAir(box.mesh())), Foam::error);
}


TEST(hydrostatics, sidesThatMissEachOtherByRoundingAreNoSlope)
{
    testMesh box(chute());
    pointField points(box.mesh().points());
    for (point& p : points)
    {
        p.z() += p.x() > 0.9 ? 5e-6 : 0;
    }
    box.mesh().movePoints(points);

    const vector down(0, 0, -9.81);
    const hydrostatics rest(box.mesh(), down, waterAndAir(box.mesh()), 1.2);

    EXPECT_FALSE(rest.drives());
    EXPECT_EQ(rest.normal(), down);
}


TEST(hydrostatics, patchesWhoseFacesOnlyOverlapRepeatNoChute)
{
    testBox overlapping(chute());
    overlapping.patches[0] = overlapping.patches[1] = "cyclicAMI";
    testMesh box(overlapping);
    const scalarField rho(waterAndAir(box.mesh()));

    const vector down(0, 0, -9.81);
    EXPECT_EQ(hydrostatics(box.mesh(), down, rho, 1.2).normal(), down);
    EXPECT_THROW(hydrostatics(box.mesh(), vector(9, 0, -4), rho, 1.2), Foam::error);
}
