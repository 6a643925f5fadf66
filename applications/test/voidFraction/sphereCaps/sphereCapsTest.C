// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a grain in cells by the caps of a sphere, also in refined cells.

#include "grainsInBox.H"
#include "otherMeshes.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::grainsInBox;

namespace
{

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

    solidFractionField solids(exchange, settings("sphereCaps", "none"));
    solids.update();
    EXPECT_EQ(solids.excess().movedVolume(), 0);

    scalarList shares;
    for (const point& at : places)
    {
        const label cell = test.mesh().findCell(at);
        shares.append
        (
            solids.solidFraction()[cell]*test.mesh().V()[cell]/volumeOf(1)
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
        solidFractionField solids(exchange, settings(model, smoothing));
        solids.update();
        const scalarField now(solids.solidFraction()*test.mesh().V()/volumeOf(1));

        if (before.size())
        {
            most = max(most, max(mag(now - before)));
        }
        before = now;
    }

    testNumber((model + ", " + smoothing + ": largest change").c_str(), most);
    return most;
}

} // End anonymous namespace


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
    solidFractionField p(exchange, dict);
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
    solidFractionField solids(exchange, settings("sphereCaps", "none"));
    solids.update();

    const scalarField shares(solids.solidFraction()*test.mesh().V()/volumeOf(1));
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
            solidFractionField solids(exchange, dict);
            solids.update();

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
                solids.solidFraction()*test.mesh().V()/volume
            );
            most = max(most, gMax(mag(shares - expected)()));
            EXPECT_NEAR(gSum(shares), 1, 1e-12);
        }

        testNumber("largest difference of a share", most);
        EXPECT_LT(most, 4*0.5/std::sqrt(scalar(20000)));
    }
}
