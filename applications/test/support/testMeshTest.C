// SPDX-License-Identifier: GPL-3.0-or-later
// The test mesh itself: what other tests take for granted.

#include "testMesh.H"
#include "testNumber.H"
#include "OSspecific.H"
#include "fvc.H"
#include "volFields.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

testBox oblong()
{
    testBox box;
    box.origin = point(-1, 0, 2);
    box.span = vector(6, 2, 1);
    box.cells = labelVector(8, 3, 2);
    return box;
}


//- A field that is periodic along x: sin(2 pi x/6)
tmp<volScalarField> wave(const fvMesh& mesh)
{
    auto tfield = tmp<volScalarField>::New
    (
        IOobject("wave", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero)
    );
    auto& field = tfield.ref();

    forAll(field, i)
    {
        field[i] = std::sin(constant::mathematical::pi/3*mesh.C()[i].x());
    }
    field.correctBoundaryConditions();
    return tfield;
}


void expectWholeBox(const fvMesh& mesh)
{
    EXPECT_EQ(returnReduce(mesh.nCells(), sumOp<label>()), 48);

    const scalar volume = gSum(mesh.V());
    testNumber("relative error of the volume", mag(volume - 12)/12);
    EXPECT_NEAR(volume, 12, 1e-12);

    const boundBox& bounds = mesh.bounds();
    EXPECT_LT(mag(bounds.min() - point(-1, 0, 2)), 1e-14);
    EXPECT_LT(mag(bounds.max() - point(5, 2, 3)), 1e-14);
}


//- Gradients of the wave, which need both sides of every coupled face, against
//  the central difference that a uniform periodic mesh has
void expectPeriodicGradient(const fvMesh& mesh)
{
    const volVectorField gradient(fvc::grad(wave(mesh)));
    const scalar h = 0.75;
    const scalar k = constant::mathematical::pi/3;

    forAll(gradient, i)
    {
        const scalar expected = std::cos(k*mesh.C()[i].x())*std::sin(k*h)/h;
        EXPECT_NEAR(gradient[i].x(), expected, 1e-12);
    }
}

} // End anonymous namespace


TEST(testMesh, holdsTheBoxThatWasRequested)
{
    testMesh test(oblong());
    expectWholeBox(test.mesh());
    EXPECT_LT(mag(test.mesh().C()[9] - point(0.125, 1, 2.25)), 1e-14);
}


TEST(testMesh, isAcceptedByOpenFOAMsOwnCheck)
{
    testMesh test(oblong());
    EXPECT_FALSE(test.mesh().checkMesh(false));
}


TEST(testMesh, givesEachSideItsTypeAndArea)
{
    testBox box(oblong());
    box.patches = {"patch", "wall", "empty", "empty", "wall", "symmetryPlane"};
    testMesh test(box);
    const polyBoundaryMesh& patches = test.mesh().boundaryMesh();

    ASSERT_EQ(patches.size(), 6);
    EXPECT_EQ(patches[0].name(), "xMin");
    EXPECT_EQ(patches[5].name(), "zMax");
    const vector outward[6] =
    {
        {-2, 0, 0}, {2, 0, 0}, {0, -6, 0}, {0, 6, 0}, {0, 0, -12}, {0, 0, 12}
    };
    for (label i = 0; i < 6; ++i)
    {
        EXPECT_EQ(patches[i].type(), box.patches[i]);
        EXPECT_LT(mag(sum(patches[i].faceAreas()) - outward[i]), 1e-12);
    }
    EXPECT_EQ(test.mesh().nGeometricD(), 2);
}


TEST(testMesh, cyclicSidesAreCoupled)
{
    testBox box(oblong());
    box.patches = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    testMesh test(box);
    expectPeriodicGradient(test.mesh());
}


TEST(testMesh, removesItsFolder)
{
    fileName folder;
    {
        testMesh test;
        folder = test.folder();
        EXPECT_TRUE(isDir(folder));
    }
    EXPECT_FALSE(isDir(folder));
}


TEST(ParallelTestMesh, slabsMakeUpTheBox)
{
    testMesh test(oblong());
    expectWholeBox(test.mesh());
    EXPECT_FALSE(test.mesh().checkMesh(false));
}


TEST(ParallelTestMesh, cyclicSidesAreCoupledAcrossRanks)
{
    testBox box(oblong());
    box.patches = {"cyclic", "cyclic", "wall", "wall", "wall", "wall"};
    testMesh test(box);
    EXPECT_FALSE(test.mesh().checkMesh(false));
    expectPeriodicGradient(test.mesh());
}
