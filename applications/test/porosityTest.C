// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction from grains: conservation, adjointness, over-full cells.

#include "porosity.H"
#include "scatteredGrains.H"
#include "testNumber.H"

#include "volFields.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const scalar radius = 0.06;


//- Cells of 1/8 m; x and y with walls, z periodic
testBox box()
{
    testBox b;
    b.cells = labelVector(8, 8, 8);
    b.patches = {"wall", "wall", "wall", "wall", "cyclic", "cyclic"};
    return b;
}


testBox periodicBox()
{
    testBox b(box());
    b.patches.fill("cyclic");
    return b;
}


dictionary settings(const word& model, const word& smoothing)
{
    dictionary smooth;
    smooth.add("model", smoothing);
    smooth.add("width", 2);

    dictionary dict;
    dict.add("model", model);
    dict.add("smoothing", smooth);
    return dict;
}


scalar volumeOf(const label n)
{
    return n*4*constant::mathematical::pi/3*pow3(radius);
}


//- Relative difference of the grains' volume and that in the cells
scalar lostVolume(const fvMesh& mesh, const porosity& p, const label n)
{
    return
        mag(gSum(p.solidFraction()*mesh.V().field()) - volumeOf(n))/volumeOf(n);
}


//- |sum V spread(a) u - sum a gather(u)| over the sum of magnitudes
scalar adjointError
(
    const fvMesh& mesh,
    const grainExchange& exchange,
    const porosity& p
)
{
    scalarField a(exchange.grains().size());
    forAll(a, i)
    {
        a[i] = std::sin(1 + 7.0*exchange.grains()[i].id);
    }

    scalarField u(mesh.nCells());
    forAll(u, cell)
    {
        u[cell] = std::cos(mesh.C()[cell] & vector(13, 29, 17));
    }

    const scalarField cells(mesh.V().field()*p.spread(a)*u);
    const scalarField grains(a*p.gather(u));

    return mag(gSum(cells) - gSum(grains))/(gSum(mag(cells)) + VSMALL);
}


//- Both, with grains that reach into walls and over periodic sides
void expectConserved(const testBox& b, const word& model, const bool skewed)
{
    testMesh test(b);
    if (skewed)
    {
        skew(test.mesh());
    }

    pointField places(randomPoints(300));
    if (skewed)
    {
        for (point& p : places)
        {
            p.x() += 0.4*p.z();
        }
    }

    standingGrains phase(test.mesh());
    place(phase, places, radius);
    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    for (const word smoothing : {"none", "diffusion"})
    {
        porosity p(exchange, settings(model, smoothing));
        p.update();

        const scalar lost = lostVolume(test.mesh(), p, places.size());
        const scalar error = adjointError(test.mesh(), exchange, p);

        testNumber
        (
            (model + ", " + smoothing + ": relative loss of volume").c_str(),
            lost
        );
        testNumber
        (
            (model + ", " + smoothing + ": relative error of the adjoint")
           .c_str(),
            error
        );
        EXPECT_LT(lost, 1e-13);
        EXPECT_LT(error, 1e-12);
    }
}


//- Solid fraction of all cells on every rank, x fastest
scalarField global(const fvMesh& mesh, const scalarField& cells)
{
    scalarField all(512, Zero);

    forAll(cells, cell)
    {
        const point at(8*mesh.C()[cell]);
        all[label(at.x()) + 8*label(at.y()) + 64*label(at.z())] = cells[cell];
    }

    reduce(all, sumOp<scalarField>());
    return all;
}


//- Grains in a cluster that is shifted by whole cells along x: so is the solid
//  fraction, whatever ranks the cluster lies on
void expectShifted(const word& model)
{
    testMesh test(periodicBox());
    const pointField cluster
    (
        randomPoints(40, point(0.05, 0.1, 0.9), point(0.3, 0.4, 1.1))
    );
    scalarField first;
    scalar most = 0;

    for (label shift = 0; shift < 8; ++shift)
    {
        standingGrains phase(test.mesh());
        place(phase, pointField(cluster + vector(shift/8.0, 0, 0)), radius);
        grainExchange exchange(test.mesh());
        exchange.locate(phase);

        porosity p(exchange, settings(model, "diffusion"));
        p.update();
        const scalarField all(global(test.mesh(), p.solidFraction()));

        if (shift == 0)
        {
            first = all;
        }

        forAll(all, i)
        {
            const label from = i - i % 8 + (i % 8 + 8 - shift) % 8;
            most = max(most, mag(all[i] - first[from]));
        }
    }

    testNumber((model + ": largest difference").c_str(), most);
    EXPECT_GT(max(first), 0.01);
    EXPECT_LT(most, 1e-13);
}


//- Sixty grains in one place: what does not fit is spread, none is lost
void expectSpread()
{
    testMesh test(box());
    standingGrains phase(test.mesh());
    place
    (
        phase,
        randomPoints(60, point(0.4, 0.02, 0.4), point(0.6, 0.1, 0.6)),
        radius
    );
    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    porosity p(exchange, settings("divided", "none"));
    p.update();

    const scalar lost = lostVolume(test.mesh(), p, 60);
    const scalar most = gMax(p.solidFraction());

    testNumber("spread volume over grain volume", p.spreadVolume()/volumeOf(60));
    testNumber("relative loss of volume", lost);
    testNumber("largest solid fraction", most);

    EXPECT_GT(p.spreadVolume(), 0.1*volumeOf(60));
    EXPECT_LT(lost, 1e-13);
    EXPECT_LT(most, 0.7 + 1e-8);
    EXPECT_GE(gMin(p.solidFraction()), 0);
}

} // End anonymous namespace


TEST(porosity, keepsVolumeAndIsItsOwnAdjoint)
{
    for (const word model : {"centre", "divided", "caps"})
    {
        expectConserved(box(), model, false);
        expectConserved(periodicBox(), model, false);
    }
}


TEST(porosity, keepsVolumeInASkewedAndGradedMesh)
{
    testBox b(box());
    b.patches.fill("wall");

    for (const word model : {"centre", "divided", "caps"})
    {
        expectConserved(b, model, true);
    }
}


TEST(porosity, spreadsWhatDoesNotFitAndLosesNothing)
{
    expectSpread();
}


TEST(porosity, shiftsWithTheGrains)
{
    expectShifted("divided");
    expectShifted("caps");
}


TEST(porosity, refusesAnUnknownModelWithTheChoices)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());

    try
    {
        porosity p(exchange, settings("halved", "none"));
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("divided"), std::string::npos);
    }
}


TEST(ParallelPorosity, keepsVolumeAndIsItsOwnAdjoint)
{
    for (const word model : {"centre", "divided", "caps"})
    {
        expectConserved(box(), model, false);
        expectConserved(periodicBox(), model, false);
    }
}


TEST(ParallelPorosity, spreadsWhatDoesNotFitAndLosesNothing)
{
    expectSpread();
}


TEST(ParallelPorosity, isTheSameWhereverTheRanksMeet)
{
    expectShifted("divided");
    expectShifted("caps");
}
