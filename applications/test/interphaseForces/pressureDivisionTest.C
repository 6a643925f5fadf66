// SPDX-License-Identifier: GPL-3.0-or-later
// The pressure force at faces, divided between fluid and grains.

#include "otherMeshes.H"
#include "pressureDivision.H"
#include "testMesh.H"

#include "fvc.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A box of cells that grow along x and y by up to five, and shrink along z
struct gradedMesh
:
    public testMesh
{
    gradedMesh()
    {
        pointField points(mesh().points());
        for (point& p : points)
        {
            p.x() *= 0.3 + 0.7*p.x();
            p.y() *= 0.4 + 0.6*p.y();
            p.z() *= 1.6 - 0.6*p.z();
        }
        mesh().movePoints(points);
    }
};


//- A force at faces and a share in cells that change from place to place
struct divided
{
    const fvMesh& mesh;
    const pressureDivision division;
    surfaceScalarField net;
    volScalarField share;

    explicit divided(const fvMesh& m)
    :
        mesh(m),
        division(m),
        net("net", m.Sf() & vector(1, -2, 3)),
        share
        (
            IOobject("share", "0", m),
            m,
            dimensionedScalar("share", dimless, 1),
            "zeroGradient"
        )
    {
        net *= (1 + (m.Cf() & m.Cf())/dimensionedScalar("one", dimArea, 1));
        share.primitiveFieldRef() =
            1/(1.5 + mag(m.C().primitiveField()));
        share.correctBoundaryConditions();
    }
};


//- Both sides get the whole, and grains what the fluid feels
void expectDivided(const fvMesh& mesh)
{
    const divided force(mesh);
    const vectorField fluid
    (
        fvc::reconstruct(force.division.atFaces(force.share)*force.net)()
       .primitiveField()
    );
    const vectorField perCell(force.division.atCells(force.net));
    const vectorField grains((1 - force.share.primitiveField())*perCell);
    const scalarField& V = mesh.V();
    const vector whole(gSum(V*perCell));

    EXPECT_LT(mag(gSum(V*(fluid + grains)) - whole), 1e-13*mag(whole));

    const vectorField alone(fvc::reconstruct(force.net)().primitiveField());
    EXPECT_LT(gMax(mag(perCell - alone)()), 1e-12*gMax(mag(alone)()));
}

} // End anonymous namespace


TEST(pressureDivision, givesFluidAndGrainsTheWholeOnAGradedMesh)
{
    gradedMesh box;
    expectDivided(box.mesh());
}


TEST(pressureDivision, givesFluidAndGrainsTheWholeOnARefinedMesh)
{
    testMesh box;
    refineBeyond(box.mesh(), 0.5);
    expectDivided(box.mesh());
}


TEST(ParallelPressureDivision, givesFluidAndGrainsTheWholeAcrossRanks)
{
    gradedMesh box;
    expectDivided(box.mesh());
}
