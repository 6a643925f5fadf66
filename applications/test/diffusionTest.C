// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing by diffusion: width, conservation, cost.

#include "diffusion.H"
#include "grainsInBox.H"
#include "saidDuring.H"
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

//- A bed of grains of 2 mm, 0.1 m high, beneath air: the largest change of its solid
//  fraction [-], and the solid that passes its surface [m], when two grains of 20 mm
//  come in 0.25 m above it, 9 % of the volume
Pair<scalar> changeOfBedAtRest(const std::string& more)
{
    testBox b;
    b.span = vector(0.04, 0.04, 0.4);
    b.cells = labelVector(8, 8, 80);
    testMesh test(b);
    const fvMesh& mesh = test.mesh();

    const label n = 20000;
    pointField places(n + 2, point(0.02, 0.02, 0.35));
    places[n].z() += 0.02;
    for (label i = 0; i < n; ++i)
    {
        places[i] = 0.002*vector(i % 20 + 0.5, i/20 % 20 + 0.5, i/400 + 0.5);
    }

    standingGrains phase(mesh);
    grainExchange exchange(mesh);
    dictionary dict(settings("sphereCaps", "diffusion"));
    dictionary& smoothing = dict.subDict("smoothing");
    smoothing.set("width", 3);
    smoothing.merge(dictionary(IStringStream(more)()));
    voidFraction pores(exchange, dict);

    place(phase, pointField(SubField<point>(places, n)), 0.001);
    exchange.locate(phase);
    pores.update();
    const scalarField before(pores.solidFraction());

    place(phase, places, 0.001);
    phase.radii[n] = phase.radii[n + 1] = 0.01;
    exchange.locate(phase);
    pores.update();
    const scalarField change(pores.solidFraction() - before);

    Pair<scalar> result(0, 0);
    forAll(change, cell)
    {
        const scalar z = mesh.C()[cell].z();
        if (z < 0.2)
        {
            result.first() = max(result.first(), mag(change[cell]));
            result.second() +=
                z > 0.1 ? change[cell]*mesh.V()[cell]/sqr(0.04) : 0;
        }
    }
    return result;
}

} // End anonymous namespace


TEST(diffusion, aPointBecomesABellCurveOfTheWidth)
{
    testBox b;
    b.cells = labelVector(33, 25, 21);
    testMesh test(b);

    // Two grains in the middle cell; their mean diameter is sum V d/sum V
    const point middle(0.5, 0.5, 0.5);
    standingGrains phase(test.mesh());
    place(phase, pointField(2, middle), 0.008);
    phase.radii[1] = 0.02;
    grainExchange exchange(test.mesh());
    exchange.locate(phase);
    const scalar d =
        (pow4(0.016) + pow4(0.04))/(pow3(0.016) + pow3(0.04));

    // Of exp(-r^2/width^2) it is width^2/2; that of the cell, seen from its
    // middle, is none
    const scalar exact = sqr(2*d)/2;

    voidFraction pores(exchange, settings("centroid", "diffusion"));
    pores.update();
    const vector moment
    (
        secondMoment(test.mesh(), pores.solidFraction(), middle)
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
                pores.mapping().smoothed(one, pores.mapping().ofVolume()),
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
    wide.setDiameter(0.3);
    EXPECT_LT(wide.nFluxes(), 180);

    // A wave between the walls decays by itself: eigenvalue of the second difference
    scalarField wave(mesh.nCells());
    forAll(wave, cell)
    {
        wave[cell] = Foam::cos(3*M_PI*mesh.C()[cell].x());
    }
    const scalar eigenvalue = sqr(2*40*Foam::sin(3*M_PI/80));
    const scalar decay = Foam::exp(-eigenvalue*sqr(0.9)/4);
    scalarField smoothed(wave);
    wide.smooth(smoothed);
    EXPECT_LT(max(mag(smoothed - decay*wave)), 1e-9);

    // A grain in one cell, and another: kept, not below zero, its own adjoint
    scalarField one(mesh.nCells(), Zero);
    scalarField other(mesh.nCells(), Zero);
    one[100] = 1;
    other[777] = 1;
    scalarField oneSmoothed(one);
    scalarField otherSmoothed(other);
    wide.smooth(oneSmoothed);
    wide.smooth(otherSmoothed);
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
    narrow.setDiameter(0.04);
    EXPECT_EQ(narrow.nFluxes(), 18);
}


TEST(diffusion, aBedAtRestStaysWhereCoarseGrainsComeInFarFromItAndADiameterIsGiven)
{
    Pair<scalar> change;
    const std::string said
    (
        saidDuring([&]{ change = changeOfBedAtRest(""); })
    );
    testNumber("change of the solid fraction", change.first());
    testNumber("solid that passes the surface [m]", change.second());
    EXPECT_GT(change.first(), 0.05);
    EXPECT_GT(change.second(), 5e-4);
    expectSays(said, "went from 0.002 to");
    expectSays(said, "diameter 0.002;");

    const std::string quiet
    (
        saidDuring([&]{ change = changeOfBedAtRest("diameter 0.002;"); })
    );
    EXPECT_EQ(change.first(), 0);
    expectSaysNo(quiet, "Warning");
}


TEST(diffusion, aDiameterOfNothingIsAnError)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());
    dictionary dict(settings("centroid", "diffusion"));
    dict.subDict("smoothing").add("diameter", 0);

    expectSays
    (
        refusal([&]{ voidFraction p(exchange, dict); }), "diameter is 0 m"
    );
}
