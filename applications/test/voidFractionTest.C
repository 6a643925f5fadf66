// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction from grains: conservation, adjointness, over-full cells.

#include "diffusion.H"
#include "otherMeshes.H"
#include "saidDuring.H"
#include "scatteredGrains.H"
#include "testNumber.H"
#include "voidFraction.H"

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
scalar lostVolume(const fvMesh& mesh, const voidFraction& p, const label n)
{
    return
        mag(gSum(p.solidFraction()*mesh.V().field()) - volumeOf(n))/volumeOf(n);
}


//- |sum V spread(a) u - sum a gather(u)| over the sum of magnitudes
scalar adjointError
(
    const fvMesh& mesh,
    const grainExchange& exchange,
    const voidFraction& p
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

    const scalarField cells(mesh.V().field()*p.mapping().spread(a)*u);
    const scalarField grains(a*p.mapping().gather(u));

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
        voidFraction p(exchange, settings(model, smoothing));
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

        voidFraction p(exchange, settings(model, "diffusion"));
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

    voidFraction p(exchange, settings("satellitePoints", "none"));
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


//- Volume of a grain at p in the cell around each of the places, over the
//  grain's own, with sphereCaps and without smoothing
scalarList capShares
(
    const testBox& b,
    const point& p,
    const List<point>& places
)
{
    testMesh test(b);
    standingGrains phase(test.mesh());
    place(phase, pointField(1, p), radius);
    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    voidFraction pores(exchange, settings("sphereCaps", "none"));
    pores.update();
    EXPECT_EQ(pores.spreadVolume(), 0);

    scalarList shares;
    for (const point& at : places)
    {
        const label cell = test.mesh().findCell(at);
        shares.append
        (
            pores.solidFraction()[cell]*test.mesh().V()[cell]/volumeOf(1)
        );
    }
    return shares;
}


//- Share of a sphere in its cap beyond a plane at the distance h of its centre
scalar capShare(const scalar h)
{
    const scalar height = radius - h;
    return
        constant::mathematical::pi*sqr(height)*(3*radius - height)/3
       /volumeOf(1);
}


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

} // End anonymous namespace


TEST(voidFraction, keepsVolumeAndIsItsOwnAdjoint)
{
    for (const word model : {"centroid", "satellitePoints", "sphereCaps"})
    {
        expectConserved(box(), model, false);
        expectConserved(periodicBox(), model, false);
    }
}


TEST(voidFraction, keepsVolumeInASkewedAndGradedMesh)
{
    testBox b(box());
    b.patches.fill("wall");

    for (const word model : {"centroid", "satellitePoints", "sphereCaps"})
    {
        expectConserved(b, model, true);
    }
}


TEST(voidFraction, spreadsWhatDoesNotFitAndLosesNothing)
{
    expectSpread();
}


TEST(voidFraction, shiftsWithTheGrains)
{
    expectShifted("satellitePoints");
    expectShifted("sphereCaps");
}


TEST(sphereCaps, aGrainBesideAFaceHasItsCapBeyond)
{
    // Middle of a cell, and of those around
    const point c(0.4375, 0.4375, 0.4375);
    const scalar w = 0.125;
    const vector x(w, 0, 0);

    for (const scalar s : {0.05, 0.3, 0.5, 0.9})
    {
        for (direction k = 0; k < 3; ++k)
        {
            for (const scalar side : {-1, 1})
            {
                vector n(Zero);
                n[k] = side;
                const scalarList shares
                (
                    capShares
                    (
                        box(), c + (w/2 - s*radius)*n, {c, c + w*n, c - w*n}
                    )
                );
                EXPECT_NEAR(shares[1], capShare(s*radius), 1e-12);
                EXPECT_NEAR(shares[0], 1 - capShare(s*radius), 1e-12);
                EXPECT_EQ(shares[2], 0);
            }
        }
    }

    // It reaches no plane, or only a wall
    EXPECT_NEAR(capShares(box(), c, {c})[0], 1, 1e-12);
    const point corner(w/2, w/2, c.z());
    const scalarList atWall
    (
        capShares(box(), point(0.01, w/2, c.z()), {corner, corner + x})
    );
    EXPECT_NEAR(atWall[0], 1, 1e-12);
    EXPECT_EQ(atWall[1], 0);
}


TEST(sphereCaps, anEnlargedGrainHasTheCapOfALargerSphere)
{
    const point c(0.4375, 0.4375, 0.4375);
    const point next(c + vector(0.125, 0, 0));
    const point at(c + vector(0.125/2 - 0.3*radius, 0, 0));

    testMesh test(box());
    standingGrains grains(test.mesh());
    place(grains, pointField(1, at), radius/2);
    grainExchange exchange(test.mesh());
    exchange.locate(grains);

    dictionary dict(settings("sphereCaps", "none"));
    dict.add("enlargement", 2);
    voidFraction p(exchange, dict);
    p.update();

    const label cell = test.mesh().findCell(next);
    const scalar solid = p.solidFraction()[cell]*test.mesh().V()[cell];
    EXPECT_NEAR(solid/p.mapping().volumes()[0], capShare(0.3*radius), 1e-12);
    EXPECT_NEAR(lostVolume(test.mesh(), p, 1), 1 - 1.0/8, 1e-12);
}


TEST(sphereCaps, aGrainOnACornerIsInEightEqualParts)
{
    const point corner(0.5, 0.5, 0.5);
    pointField around;
    for (label i = 0; i < 8; ++i)
    {
        const vector to(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        around.append(corner + 0.0625*to);
    }

    for (const scalar share : capShares(box(), corner, around))
    {
        EXPECT_NEAR(share, 0.125, 1e-12);
    }

    // Beside it, the parts beyond each plane are its cap
    const vector h(0.01, 0.02, 0.03);
    const scalarList shares(capShares(box(), corner - h, around));
    for (direction k = 0; k < 3; ++k)
    {
        scalar beyond = 0;
        forAll(shares, i)
        {
            beyond += (i & (1 << k)) ? shares[i] : 0;
        }
        EXPECT_NEAR(beyond, capShare(h[k]), 1e-12);
    }

    // And those beyond all three the corner, against points at random
    Random random(11);
    const label n = 400000;
    label beyond = 0;
    for (label i = 0; i < n; ++i)
    {
        vector p;
        for (direction k = 0; k < 3; ++k)
        {
            p[k] = h[k] + (radius - h[k])*random.sample01<scalar>();
        }
        beyond += magSqr(p) < sqr(radius);
    }
    const vector side(vector::uniform(radius) - h);
    EXPECT_NEAR
    (
        shares[7], beyond*side.x()*side.y()*side.z()/(n*volumeOf(1)), 2e-4
    );
}


//- Largest change of the volume of a grain in a cell, over its own, while it
//  goes in steps of 0.02 mm through a face between cells of 125 mm and of half
//  as much, off any symmetry
scalar largestChange(const word& model, const word& smoothing)
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    scalarField before;
    scalar most = 0;

    for (label step = -200; step < 200; ++step)
    {
        standingGrains phase(test.mesh());
        place(phase, pointField(1, point(0.5 + 2e-5*step, 0.41, 0.43)), radius);
        grainExchange exchange(test.mesh());
        exchange.locate(phase);
        voidFraction pores(exchange, settings(model, smoothing));
        pores.update();
        const scalarField now(pores.solidFraction()*test.mesh().V()/volumeOf(1));

        if (before.size())
        {
            most = max(most, max(mag(now - before)));
        }
        before = now;
    }

    testNumber((model + ", " + smoothing + ": largest change").c_str(), most);
    return most;
}


TEST(sphereCaps, aGrainMovesItsVolumeInProportionAtRefinedCells)
{
    // The largest section of the grain passes a face: 3/4 of step over radius
    const scalar inProportion = 0.75*2e-5/radius;

    EXPECT_LT(largestChange("sphereCaps", "none"), 1.001*inProportion);
    EXPECT_LT(largestChange("sphereCaps", "diffusion"), inProportion);
}


TEST(sphereCaps, aGrainOnARefinedFaceIsHalfInTheLargeCell)
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    standingGrains phase(test.mesh());
    const point p(0.5, 0.4375, 0.4375);
    place(phase, pointField(1, p), radius);
    grainExchange exchange(test.mesh());
    exchange.locate(phase);
    voidFraction pores(exchange, settings("sphereCaps", "none"));
    pores.update();

    const scalarField shares(pores.solidFraction()*test.mesh().V()/volumeOf(1));
    EXPECT_NEAR(shares[test.mesh().findCell(p - vector(0.01, 0, 0))], 0.5, 1e-10);
    for (label i = 0; i < 4; ++i)
    {
        const vector to(0.01, i & 1 ? 0.01 : -0.01, i & 2 ? 0.01 : -0.01);
        EXPECT_NEAR(shares[test.mesh().findCell(p + to)], 0.125, 1e-10);
    }
}


TEST(sphereCaps, aCellThinnerThanTheGrainHasCapsOnBothSides)
{
    testBox thin(box());
    thin.cells = labelVector(12, 8, 8);
    const scalar w = 1.0/12;
    const point c(5.5*w, 0.4375, 0.4375);
    const vector x(w, 0, 0);
    ASSERT_GT(2*radius, w);

    for (const scalar off : {0.0, 0.01, -0.015})
    {
        const scalarList shares
        (
            capShares(thin, c + vector(off, 0, 0), {c - x, c, c + x})
        );
        const scalar below = capShare(w/2 + off);
        const scalar above = capShare(w/2 - off);
        EXPECT_NEAR(shares[0], below, 1e-12);
        EXPECT_NEAR(shares[1], 1 - below - above, 1e-12);
        EXPECT_NEAR(shares[2], above, 1e-12);
    }
}


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
            secondMoment(test.mesh(), pores.mapping().smoothed(one), middle)
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


TEST(voidFraction, refusesAnUnknownModelWithTheChoices)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());

    try
    {
        voidFraction p(exchange, settings("halved", "none"));
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("satellitePoints"), std::string::npos);
    }
}


TEST(voidFraction, anEnlargementIsForCapsAloneAndNotBelowOne)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());

    const auto said = [&](const word& model, const scalar enlargement)
    {
        dictionary dict(settings(model, "none"));
        dict.add("enlargement", enlargement);
        return refusal([&]{ voidFraction p(exchange, dict); });
    };

    EXPECT_EQ(said("sphereCaps", 1.9), "nothing");
    EXPECT_NE(said("sphereCaps", 0.9).find("is 0.9"), std::string::npos);
    EXPECT_NE(said("centroid", 1.9).find("enlargement"), std::string::npos);
}


TEST(voidFraction, formerNamesOfModelsAreErrorsThatSayThePresentOnes)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());
    const HashTable<word> present
    ({
        {"caps", "sphereCaps"},
        {"divided", "satellitePoints"},
        {"centre", "centroid"}
    });

    forAllConstIters(present, model)
    {
        EXPECT_NE
        (
            refusal
            (
                [&]{ voidFraction p(exchange, settings(model.key(), "none")); }
            ).find("Write " + model.val()),
            std::string::npos
        );
    }
}


TEST(ParallelVoidFraction, keepsVolumeAndIsItsOwnAdjoint)
{
    for (const word model : {"centroid", "satellitePoints", "sphereCaps"})
    {
        expectConserved(box(), model, false);
        expectConserved(periodicBox(), model, false);
    }
}


TEST(ParallelVoidFraction, spreadsWhatDoesNotFitAndLosesNothing)
{
    expectSpread();
}


TEST(ParallelVoidFraction, isTheSameWhereverTheRanksMeet)
{
    expectShifted("satellitePoints");
    expectShifted("sphereCaps");
}


//- On a refined mesh each cell holds the points of a grain that lie in it,
//  whatever ranks the grain reaches over. One grain at a time: what of several does
//  not fit into a cell is spread
TEST(ParallelVoidFraction, capsAreTheVolumesOfRandomPointsAtRefinedCells)
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    const pointField centres
    (
        randomPoints(6, point(0.4, 0.3, 0.3), point(0.6, 0.7, 0.7))
    );
    dictionary dict(settings("sphereCaps", "none"));
    dict.add("minimum", 1e-6);

    for (const scalar r : {0.05, 0.15})
    {
        const scalar volume = 4*constant::mathematical::pi/3*pow3(r);
        scalar most = 0;

        for (const point& centre : centres)
        {
            standingGrains phase(test.mesh());
            place(phase, pointField(1, centre), r);
            grainExchange exchange(test.mesh());
            exchange.locate(phase);
            voidFraction pores(exchange, dict);
            pores.update();

            scalarField expected(test.mesh().nCells(), Zero);
            const label n = 20000;
            Random random(5);

            for (label i = 0; i < n; ++i)
            {
                point p;
                do
                {
                    for (direction k = 0; k < 3; ++k)
                    {
                        p[k] = 2*random.sample01<scalar>() - 1;
                    }
                } while (magSqr(p) > 1);

                const label cell = exchange.cellOf(centre + r*p);
                if (cell >= 0)
                {
                    expected[cell] += 1.0/n;
                }
            }

            const scalarField shares
            (
                pores.solidFraction()*test.mesh().V()/volume
            );
            most = max(most, gMax(mag(shares - expected)()));
            EXPECT_NEAR(gSum(shares), 1, 1e-12);
        }

        testNumber("largest difference of a share", most);
        EXPECT_LT(most, 4*0.5/std::sqrt(scalar(20000)));
    }
}
