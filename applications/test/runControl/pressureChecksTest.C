// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings and errors where the pressure at the start would be far from rest.

#include "otherMeshes.H"
#include "pressureChecks.H"
#include "terminalOutput.H"

#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const vector downwards(0, 0, -9.81);

//- Down a slope of 20 degrees along x
const vector downhill
(
    9.81*Foam::sin(degToRad(20)), 0, -9.81*Foam::cos(degToRad(20))
);


//- Gravity times the place, at cells and faces
volScalarField potential(const fvMesh& mesh, const vector& g)
{
    volScalarField gh
    (
        IOobject("gh", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(sqr(dimVelocity), Zero)
    );
    gh.primitiveFieldRef() = g & mesh.C().primitiveField();
    for (fvPatchScalarField& patch : gh.boundaryFieldRef())
    {
        patch == (g & patch.patch().Cf());
    }
    return gh;
}


//- A field of one value whose patches are of these types
volScalarField uniform
(
    const fvMesh& mesh,
    const word& name,
    const scalar value,
    const wordList& types
)
{
    return volScalarField
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(name, dimless, value),
        types
    );
}


//- A flume 4 m long whose far end holds the pressure, or another type of condition
class flume
{
    testMesh box_;

    static testBox shape()
    {
        testBox box;
        box.span = vector(4, 1, 1);
        box.patches[1] = "patch";
        return box;
    }

public:

    flume()
    :
        box_(shape())
    {}

    //- The warnings with gravity g where the lighter fluid has a density of rhoLeast
    std::string warnings
    (
        const vector& g,
        const word& typeAtEnd = "fixedValue",
        const scalar rhoLeast = 1.2
    )
    {
        const fvMesh& mesh = box_.mesh();
        wordList types(6, "zeroGradient");
        volScalarField rho(uniform(mesh, "rho", 1000, types));
        rho[0] = rhoLeast;
        types[1] = typeAtEnd;
        const volScalarField p_rgh(uniform(mesh, "p_rgh", 0, types));
        return outputDuring([&]()
        {
            checkOpenEnds(p_rgh, potential(mesh, g), rho, hydrostatics(g), 1000, 1.2);
        });
    }
};


//- The error where the upper side of a chute that repeats itself along x and gravity has
//  that type of condition
std::string refusalInChute(const word& type, const vector& g)
{
    testBox shape;
    shape.patches = {"cyclic", "cyclic", "cyclic", "cyclic", "wall", "patch"};
    testMesh box(shape);
    scalarField rho(box.mesh().nCells(), 1000);
    rho[0] = 1.2;
    const volScalarField p_rgh
    (
        uniform
        (
            box.mesh(), "p_rgh", 0,
            {"cyclic", "cyclic", "cyclic", "cyclic", "zeroGradient", type}
        )
    );
    const hydrostatics rest(box.mesh(), g, rho, 1.2);
    return refusal([&]() { checkPressurePatches(p_rgh, rest); });
}


//- The warnings in a box whose base is at a height [m]
std::string warningsAt(const scalar height, const vector& g)
{
    testBox shape;
    shape.origin = point(0, 0, height);
    testMesh box(shape);
    return outputDuring([&]() { checkHeight(potential(box.mesh(), g), g, 0); });
}


//- The warnings where cells beyond x hold air and water, and those before it only air, in
//  a box that is refined beyond x = 1/2
std::string warningsAtSurface(const scalar x, const vector& g)
{
    testMesh box;
    refineBeyond(box.mesh(), 0.5);
    const fvMesh& mesh = box.mesh();
    volScalarField alpha(uniform(mesh, "alpha", 0, wordList(6, "zeroGradient")));
    forAll(alpha, cell)
    {
        alpha[cell] = mesh.C()[cell].x() > x ? 0.5 : 0;
    }
    return outputDuring([&]() { checkSurfaceAtRefinement(alpha, g); });
}

} // End anonymous namespace


TEST(pressureChecks, anOpenEndThatIsAWeirIsWarnedOfWithWhatToWrite)
{
    const std::string words(flume().warnings(downhill));
    const scalar slope = downhill.x()/9.81;
    const scalar upright = -downhill.z()/9.81;
    expectHolds(words, "Patch xMax of p_rgh is of type fixedValue");
    expectHolds(words, "a head of " + Foam::name(4*slope - 0.125*upright) + " m");
    expectHolds
    (
        words,
        "prghTotalPressure; p0 uniform " + Foam::name(1.2*9.81*(4*slope - 0.5*upright))
    );
}


TEST(pressureChecks, otherEndsAndOneFluidAloneAreNotWarnedOf)
{
    flume f;
    EXPECT_EQ(f.warnings(downwards), "");
    EXPECT_EQ(f.warnings(-downhill), "");
    EXPECT_EQ(f.warnings(downhill, "zeroGradient"), "");
    EXPECT_EQ(f.warnings(downhill, "fixedValue", 1000), "");
}


TEST(pressureChecks, aConditionThatTakesAllOfGravityIsRefusedInAChute)
{
    const std::string words(refusalInChute("prghPressure", downhill));
    expectHolds(words, "Patch zMax of p_rgh is of type prghPressure");
    expectHolds(words, "Use fixedValue or totalPressure there");
    EXPECT_EQ(refusalInChute("fixedValue", downhill), "nothing");
    EXPECT_EQ(refusalInChute("prghPressure", downwards), "nothing");
}


TEST(pressureChecks, aMeshFarFromWhereHeightIsZeroIsWarnedOfWithItsHeight)
{
    const std::string words(warningsAt(999.125, downwards));
    expectHolds(words, "up to 1000 m from where height counts as zero");
    expectHolds(words, "1 m high");
    expectHolds(words, "value 999.625;");
    EXPECT_EQ(warningsAt(10, downwards), "");

    // Between axes gh.H takes no height
    EXPECT_EQ(warningsAt(1000, vector(6.9, 0, -6.9)), "");
}


TEST(pressureChecks, aSurfaceAtRefinedCellsIsWarnedOfWithItsFaces)
{
    // The four by four large cells beside the refined ones have four faces each there
    expectHolds(warningsAtSurface(0, downwards), "at 64 faces");
    expectHolds(warningsAtSurface(0.5, downwards), "at 64 faces");
    EXPECT_EQ(warningsAtSurface(0.6, downwards), "");
    EXPECT_EQ(warningsAtSurface(0, vector(Zero)), "");
}
