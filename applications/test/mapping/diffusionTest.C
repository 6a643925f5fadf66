// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing by diffusion: width, conservation, cost.

#include "diffusion.H"
#include "grainsInBox.H"
#include "terminalOutput.H"
#include "testNumber.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::grainsInBox;

namespace
{

//- Sum of V a (x - middle)^2 over that of V a, for x, y and z
vector secondMoment
(
    const fvMesh& mesh,
    const scalarField& a,
    const point& middle
)
{
    const scalarField weight(mesh.V().field()*a);
    const vectorField r(mesh.C().primitiveField() - middle);
    return sum(weight*cmptMultiply(r, r))/sum(weight);
}

//- Where water of this fraction is below, in cells of 1/20 m: full up to z = 1/2,
//  and a cell at the surface that is partly full
scalarField waterUpTo(const fvMesh& mesh, const scalar atSurface)
{
    scalarField water(mesh.nCells());
    forAll(water, cell)
    {
        const scalar z = 20*mesh.C()[cell].z();
        water[cell] = z < 10 ? 1 : z < 11 ? atSurface : 0;
    }
    return water;
}


//- Fine grains of 5 mm all about a box, and a boulder of 100 mm amid them: their solid
//  fraction with it, without it, and that of the boulder alone
List<scalarField> gravelWithBoulder()
{
    testBox b;
    b.cells = labelVector(16, 16, 16);
    testMesh test(b);
    const label n = 20000;
    const pointField gravel(0.05*vector::one + 0.9*randomPoints(n));

    List<scalarField> result;
    for (const label first : {0, 0, n})
    {
        standingGrains phase(test.mesh());
        pointField places(n + 1, point(0.5, 0.5, 0.5));
        SubField<point>(places, n) = gravel;
        const label last = result.size() == 1 ? n : n + 1;
        place(phase, pointField(SubField<point>(places, last - first, first)), 0.0025);
        if (last > n)
        {
            phase.radii[n - first] = 0.05;
        }

        grainExchange exchange(test.mesh());
        exchange.locate(phase);
        solidFractionField solids(exchange, settings("sphereCaps", "diffusion"));
        solids.update();
        result.append(solids.solidFraction());
    }
    return result;
}


void expectStopAtTheSurface()
{
    testBox b;
    b.span = vector(0.3, 0.3, 1);
    b.cells = labelVector(6, 6, 20);
    b.cut = 2;
    testMesh test(b);
    const fvMesh& mesh = test.mesh();
    smoothingModels::diffusion smoothing(mesh, dictionary(IStringStream("width 3;")()));
    smoothing.setDiameters(scalarList({0.02}));

    for (const scalar atSurface : {0.0, 0.3, 0.5, 0.8})
    {
        const scalarField water(waterUpTo(mesh, atSurface));
        smoothing.setWater(water);

        // What is in the water stays there, and all of it
        scalarField below(pos(water - 0.999));
        const scalar whole = gSum(mesh.V()*below);
        smoothing.smooth(below, 0);
        EXPECT_LT
        (
            gMax((below*neg(water - 0.001))()), atSurface > 0 ? 0.015 : 1e-15
        );
        EXPECT_NEAR(gSum(mesh.V()*below), whole, 1e-14);

        // A bed on both sides stays even
        scalarField bed(mesh.nCells(), 0.6);
        smoothing.smooth(bed, 0);
        EXPECT_LT(gMax(mag(bed - 0.6)()), 1e-14);

        // Its own adjoint
        scalarField one(mesh.C().primitiveField().component(vector::Z)());
        const scalarField other(sqr(mesh.C().primitiveField().component(vector::X)));
        scalarField smoothOther(other);
        const scalarField rough(one);
        smoothing.smooth(one, 0);
        smoothing.smooth(smoothOther, 0);
        EXPECT_NEAR
        (
            gSum(mesh.V()*one*other), gSum(mesh.V()*rough*smoothOther), 1e-15
        );
    }

    // One fluid: the whole mesh again
    smoothing.setWater(scalarField());
    scalarField below(pos(waterUpTo(mesh, 0) - 0.999));
    smoothing.smooth(below, 0);
    const scalarField air(neg(waterUpTo(mesh, 0) - 0.001));
    EXPECT_GT(gMax((below*air)()), 0.05);
}

} // End anonymous namespace


TEST(diffusion, aPointBecomesABellCurveOfTheWidth)
{
    testBox b;
    b.cells = labelVector(33, 25, 21);
    testMesh test(b);

    // Two grains of a size class in the middle cell; their mean diameter is
    // sum V d/sum V
    const point middle(0.5, 0.5, 0.5);
    standingGrains phase(test.mesh());
    place(phase, pointField(2, middle), 0.016);
    phase.radii[1] = 0.02;
    grainExchange exchange(test.mesh());
    exchange.locate(phase);
    const scalar d =
        (pow4(0.032) + pow4(0.04))/(pow3(0.032) + pow3(0.04));

    // Of exp(-r^2/width^2) it is width^2/2; that of the cell, seen from its
    // middle, is none
    const scalar exact = sqr(2*d)/2;

    solidFractionField solids(exchange, settings("centroid", "diffusion"));
    solids.update();
    const vector moment
    (
        secondMoment(test.mesh(), solids.solidFraction(), middle)
    );
    for (direction k = 0; k < 3; ++k)
    {
        testNumber("relative error", moment[k]/exact - 1);
        EXPECT_NEAR(moment[k]/exact, 1, 1e-9);
    }

    // What grains see of the fluid is smoothed alike
    scalarField one(test.mesh().nCells(), Zero);
    one[test.mesh().findCell(middle)] = 1;
    EXPECT_LT
    (
        mag
        (
            secondMoment
            (
                test.mesh(),
                solids.mapping().smoothed(one, solids.mapping().ofVolume(), 0),
                middle
            )
          - vector::uniform(exact)
        ),
        1e-9*exact
    );
}


TEST(diffusion, wideSmoothingTakesFewFluxesAndIsThatOfTheClosedForm)
{
    testBox b;
    b.cells = labelVector(40, 6, 6);
    testMesh test(b);
    const fvMesh& mesh = test.mesh();
    IStringStream text("width 3;");
    smoothingModels::diffusion wide(mesh, dictionary(text));

    // Sides of 1/40 and 1/6: for a bell of 0.9 the steps would be 1,355
    wide.setDiameters(scalarList({0.3}));
    EXPECT_LT(wide.nFluxes(0), 180);

    // A wave between the walls decays by itself: eigenvalue of the second difference
    scalarField wave(mesh.nCells());
    forAll(wave, cell)
    {
        wave[cell] = Foam::cos(3*M_PI*mesh.C()[cell].x());
    }
    const scalar eigenvalue = sqr(2*40*Foam::sin(3*M_PI/80));
    const scalar decay = Foam::exp(-eigenvalue*sqr(0.9)/4);
    scalarField smoothed(wave);
    wide.smooth(smoothed, 0);
    EXPECT_LT(max(mag(smoothed - decay*wave)), 1e-9);

    // A grain in one cell, and another: kept, not below zero, its own adjoint
    scalarField one(mesh.nCells(), Zero);
    scalarField other(mesh.nCells(), Zero);
    one[100] = 1;
    other[777] = 1;
    scalarField oneSmoothed(one);
    scalarField otherSmoothed(other);
    wide.smooth(oneSmoothed, 0);
    wide.smooth(otherSmoothed, 0);
    EXPECT_NEAR(sum(oneSmoothed), 1, 1e-12);
    EXPECT_GT(min(oneSmoothed), -1e-10);
    EXPECT_NEAR(oneSmoothed[777], otherSmoothed[100], 1e-15);
}


TEST(diffusion, narrowSmoothingKeepsItsSteps)
{
    testBox b;
    b.cells = labelVector(20, 20, 20);
    testMesh test(b);
    IStringStream text("width 3;");
    smoothingModels::diffusion narrow(test.mesh(), dictionary(text));

    // (3 d)^2/4 over dx^2/12, of equal cells
    narrow.setDiameters(scalarList({0.04}));
    EXPECT_EQ(narrow.nFluxes(0), 18);
}


TEST(diffusion, aBoulderLeavesTheGravelAroundItAsDenseAsItIs)
{
    const List<scalarField> solid(gravelWithBoulder());
    const scalarField& both = solid[0];
    const scalarField& gravel = solid[1];
    const scalarField& boulder = solid[2];

    // With one width for all the gravel would be smeared over 190 mm
    EXPECT_GT(max(boulder), 1e-3);
    EXPECT_LT(gMax(mag(both - gravel - boulder)()), 1e-14);
}


TEST(diffusion, warnsWhereTheWidthOfLikeGrainsChanges)
{
    testMesh test(box());
    const auto output = [&](const string& more)
    {
        return outputDuring
        (
            [&]
            {
                smoothingModels::diffusion smoothing
                (
                    test.mesh(), dictionary(IStringStream(more)())
                );
                smoothing.setDiameters(scalarList({0.002, 0.02}));
                smoothing.setDiameters(scalarList({0.0025, 0.02}));
            }
        );
    };

    expectHolds(output("width 3;"), "went from 0.002 to 0.0025");
    expectHolds(output("width 3;"), "diameter 0.002;");
    expectLacks(output("width 3; diameter 0.002;"), "Warning");
}


TEST(diffusion, stopsAtTheSurfaceOfTheWater)
{
    expectStopAtTheSurface();
}


TEST(ParallelDiffusion, stopsAtTheSurfaceOfTheWater)
{
    expectStopAtTheSurface();
}


TEST(diffusion, aDiameterOfNothingIsAnError)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());
    dictionary dict(settings("centroid", "diffusion"));
    dict.subDict("smoothing").add("diameter", 0);

    expectHolds
    (
        refusal([&]{ solidFractionField p(exchange, dict); }), "diameter is 0 m"
    );
}
