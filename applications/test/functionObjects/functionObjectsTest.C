// SPDX-License-Identifier: GPL-3.0-or-later
// The small parts of the function objects, on made-up grains.

#include "column.H"
#include "bedLayers.H"
#include "bedState.H"
#include "erosionPhases.H"
#include "sampleSeries.H"
#include "strips.H"
#include "testMesh.H"
#include "testNumber.H"

#include "mathematicalConstants.H"
#include "volFields.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar d = 0.01;

//- A cubic lattice of grains, 1 m x 0.3 m and nz layers
bedGrains lattice(const label nz)
{
    const label nx = 100;
    const label ny = 30;
    grainSnapshot grains(nx*ny*nz);

    label n = 0;
    for (label i = 0; i < nx; ++i)
    {
        for (label j = 0; j < ny; ++j)
        {
            for (label k = 0; k < nz; ++k)
            {
                grains.position[n++] =
                    d*vector(i + 0.5, j + 0.5, k + 0.5);
            }
        }
    }
    grains.d = d;

    return bedGrains(flumeFrame(), grains, identity(n));
}


const boundBox flume(point(0, 0, 0), point(1, 0.3, 0.5));

constexpr scalar latticePacking = constant::mathematical::pi/6;

} // End anonymous namespace


TEST(strips, aSphereIsSharedOutWithoutLoss)
{
    strips s(0, 1, 0.1);
    s.addSphere(0.52, 0.07, 3);
    s.addSphere(0.01, 0.05, 2);

    const scalar error = sum(s.values()) + s.outside() - 5;
    testNumber("volume lost", error);
    EXPECT_NEAR(error, 0, 1e-14);
    EXPECT_GT(s.outside(), 0);
}


TEST(strips, halfASphereLiesOnEachSideOfItsCentre)
{
    strips s(0, 1, 0.1);
    s.addSphere(0.5, 0.05, 1);
    EXPECT_NEAR(s.values()[4], 0.5, 1e-14);
    EXPECT_NEAR(s.values()[5], 0.5, 1e-14);
}


TEST(strips, theCapOfASphereHasItsVolume)
{
    const scalar r = 0.05;
    const scalar h = 0.02;
    const scalar pi = constant::mathematical::pi;

    strips s(0, 1, 0.1);
    s.addSphere(0.5 - r + h, r, 4*pi*pow3(r)/3);

    EXPECT_NEAR(s.values()[5], pi*sqr(h)*(3*r - h)/3, 1e-15);
    EXPECT_NEAR(sum(s.values()), 4*pi*pow3(r)/3, 1e-15);
}


TEST(strips, aQuantileIsLinearWithinAStrip)
{
    strips s(0, 1, 0.1);
    s.addRange(0, 1, 4);
    EXPECT_NEAR(s.quantile(0.99), 0.99, 1e-12);
    EXPECT_NEAR(s.quantile(0.123), 0.123, 1e-12);
}


TEST(strips, aSteepFrontIsFoundExactly)
{
    for (const scalar x : {0.41, 0.45, 0.499})
    {
        strips s(0, 1, 0.1);
        s.addRange(0, x, x);
        EXPECT_NEAR(s.farthest(0.005), x, 1e-12);
    }
}


TEST(strips, oneBouncingGrainIsNoFront)
{
    strips s(0, 1, 0.1);
    s.addRange(0, 0.4, 0.4);
    s.add(0.85, 0.005);
    EXPECT_NEAR(s.farthest(0.01), 0.4, 1e-12);
}


TEST(strips, theNthFarthestIsFound)
{
    strips s(0, 1, 0.01);
    for (label i = 0; i < 20; ++i)
    {
        s.add(0.505 + 0.01*i, 1);
    }
    s.add(0.995, 1);

    EXPECT_NEAR(s.beyond(10), 0.61, 0.011);
    EXPECT_EQ(s.beyond(30), 0);
}


TEST(strips, aMeanCountsPartsOfStrips)
{
    strips s(0, 1, 0.1);
    s.values()[3] = 1;
    EXPECT_NEAR(s.mean(0.35, 0.45), 0.5, 1e-12);
}


TEST(strips, wrongBoundsAreAnError)
{
    EXPECT_THROW(strips(0, 1, 0), Foam::error);
    EXPECT_THROW(strips(1, 1, 0.1), Foam::error);
}


TEST(sampleSeries, aSteadyFrontHasItsVelocity)
{
    sampleSeries s;
    for (label i = 0; i <= 10; ++i)
    {
        s.append(0.1*i, 3 + 2.5*0.1*i);
    }
    EXPECT_NEAR(s.lastSlope(0.35), 2.5, 1e-12);
    EXPECT_NEAR(s.slope(0, 1), 2.5, 1e-12);
}


TEST(sampleSeries, timesThatAreDoneAgainReplaceTheOldOnes)
{
    sampleSeries s;
    s.append(0, 1);
    s.append(1, 2);
    s.append(2, 3);
    s.append(1, 5);
    EXPECT_EQ(s.size(), 2);
    EXPECT_EQ(s.values().last(), 5);
}


TEST(sampleSeries, aTriangleIsAboveHalfItsPeakForHalfItsBase)
{
    const sampleSeries s({0, 1, 3}, {0, 10, 0});
    EXPECT_NEAR(s.durationAbove(5), 1.5, 1e-12);
    EXPECT_NEAR(s.lastAbove(5), 2, 1e-12);
    EXPECT_EQ(s.peak(), 1);
    EXPECT_NEAR(s.mean(0, 3), 5, 1e-12);
}


TEST(linearFit, scatterLowersTheShareOfVariance)
{
    const linearFit line(scalarList({0, 1, 2}), scalarList({0, 2, 4}));
    EXPECT_NEAR(line.slope, 2, 1e-14);
    EXPECT_NEAR(line.R2, 1, 1e-14);

    const linearFit cross
    (
        scalarList({0, 0, 1, 1}), scalarList({0, 1, 0, 1})
    );
    EXPECT_NEAR(cross.slope, 0, 1e-14);
    EXPECT_NEAR(cross.R2, 0, 1e-14);
}


TEST(flumeFrame, axesAreRightHanded)
{
    const flumeFrame frame;
    EXPECT_LT(mag(frame.across() - vector(0, 1, 0)), 1e-15);
    EXPECT_LT(mag(frame.local(point(1, 2, 3)) - vector(1, 2, 3)), 1e-15);
}


TEST(flumeFrame, aSlantedNormalIsAnError)
{
    dictionary dict;
    dict.add("normal", vector(1, 0, 1));
    EXPECT_THROW(flumeFrame frame(dict), Foam::IOerror);
}


TEST(bedErosion, thePackingOfALatticeIsItsOwn)
{
    for (const label layers : {4, 6, 9})
    {
        const bedGrains bed(lattice(layers));
        const scalar packing =
            corePacking(bed, flume, bed.alongFlume(flume, 0.01), 0.3);

        testNumber("solid fraction", packing);
        EXPECT_NEAR(packing, latticePacking, 0.003*latticePacking);
    }
}


TEST(bedErosion, twoLayersTakenAwayAreTwoDiametersDeep)
{
    const scalar packing = latticePacking*0.3*0.01;
    const strips before(lattice(6).alongFlume(flume, 0.01));
    const strips after(lattice(4).alongFlume(flume, 0.01));

    const scalarField depth((before.values() - after.values())/packing);
    EXPECT_NEAR(min(depth), 0.02, 1e-12);
    EXPECT_NEAR(max(depth), 0.02, 1e-12);
}


TEST(bedErosion, aScarAndItsDepositAreMeasured)
{
    strips depth(0, 2, 0.01);
    forAll(depth.values(), i)
    {
        const scalar x = depth.centre(i);
        depth.values()[i] = x < 1.5 ? 0.03 : x < 1.8 ? -0.02 : 0;
    }

    const erosionExtent scar(depth, 0.6, 0.001, 0.005);
    EXPECT_NEAR(scar.length, 0.9, 0.006);
    EXPECT_NEAR(scar.end, 1.5, 0.006);
    EXPECT_NEAR(scar.raisedEnd, 1.8, 0.011);
    EXPECT_EQ(erosionExtent(depth, 0.6, 0.001, 0.03).raisedEnd, 0.6);
    EXPECT_NEAR(scar.eroded, 0.9*0.03, 1e-12);
    EXPECT_NEAR(scar.deposited, 0.3*0.02, 1e-12);
}


TEST(bedErosion, phasesAreThoseOfAMadeUpErosion)
{
    // Nothing until 0.3 s, then 0.03 (1 - exp(-(t - 0.3)/0.4))
    sampleSeries depth;
    sampleSeries rate;

    for (label i = 0; i <= 400; ++i)
    {
        const scalar t = 0.01*i;
        const scalar decay = t < 0.3 ? 0 : Foam::exp(-(t - 0.3)/0.4);
        depth.append(t, t < 0.3 ? 0 : 0.03*(1 - decay));
        rate.append(t, 0.03/0.4*decay);
    }

    const erosionPhases phases(depth, rate, 1e-4, 0.05);
    EXPECT_NEAR(phases.netStart, 0.3, 0.021);
    EXPECT_NEAR(phases.peakRate, 0.075, 1e-12);
    EXPECT_NEAR(phases.peakTime, 0.3, 1e-12);
    EXPECT_NEAR(phases.netEnd, 0.3 - 0.4*Foam::log(0.05), 0.01);

    // While the bed is still carried away, that has no end
    const label half = 60;
    const auto early = [&](const sampleSeries& s)
    {
        return sampleSeries
        (
            scalarList(SubList<scalar>(s.times(), half)),
            scalarList(SubList<scalar>(s.values(), half))
        );
    };
    EXPECT_EQ
    (
        erosionPhases(early(depth), early(rate), 1e-4, 0.05).netEnd, GREAT
    );
}


TEST(bedErosion, aBedAtRestHasNoPhases)
{
    const sampleSeries rest({0, 1, 2}, {0, 1e-5, 0});
    const erosionPhases phases(rest, rest, 1e-3, 0.05);
    EXPECT_EQ(phases.netStart, GREAT);
    EXPECT_EQ(phases.netEnd, GREAT);
}


TEST(bedErosion, layersArePartedBySpeed)
{
    bedGrains bed(lattice(6));
    forAll(bed.U, i)
    {
        const scalar z = bed.centre[i].z();
        bed.U[i].x() = z > 0.05 ? 1 : z > 0.03 ? 0.1 : 0.001;
    }

    const bedLayers layers(bed, 0.2, 0.4, 0.5, 0.02);
    EXPECT_EQ(layers.bouncing.n, 600);
    EXPECT_EQ(layers.creeping.n, 1200);
    EXPECT_EQ(layers.stationary.n, 1800);
    EXPECT_NEAR(layers.bouncing.U, 1, 1e-12);
    EXPECT_NEAR(layers.UMoving, (1 + 2*0.1)/3, 1e-12);
}


TEST(column, lengthIsThatOfTheLineInTheMesh)
{
    testMesh box;
    const column upright
    (
        box.mesh(), point(0.4, 0.4, 0), vector(0, 0, 2)
    );
    EXPECT_NEAR(upright.length(), 1, 1e-12);

    const column slanted
    (
        box.mesh(), point(0.4, 0.4, 0), vector(0.3, 0, 1)
    );
    EXPECT_NEAR(slanted.length(), Foam::sqrt(1.09), 1e-12);
}


TEST(column, waterUpToALevelHasThatDepth)
{
    testMesh box;
    volScalarField alpha
    (
        IOobject("alpha", "0", box.mesh()),
        box.mesh(),
        dimensionedScalar(dimless, Zero)
    );
    forAll(alpha, i)
    {
        const scalar z = box.mesh().C()[i].z();
        alpha[i] = z < 0.25 ? 1 : z < 0.5 ? 0.4 : 0;
    }

    const column upright
    (
        box.mesh(), point(0.4, 0.4, 0), vector(0, 0, 1)
    );
    EXPECT_NEAR(upright.integral(alpha), 0.35, 1e-12);
}


TEST(patchDisc, aDiscOnTheBaseHasItsArea)
{
    testMesh box;
    const label base = box.mesh().boundaryMesh().findPatchID("zMin");
    const patchDisc disc
    (
        box.mesh().boundary()[base], point(0.45, 0.55, 0.01), 0.3
    );

    const scalar exact = constant::mathematical::pi*sqr(0.3);
    testNumber("relative error of the area", disc.area()/exact - 1);
    EXPECT_NEAR(disc.area(), exact, 0.01*exact);
    EXPECT_NEAR(disc.distance(), 0.01, 1e-12);
    EXPECT_NEAR(disc.normal().z(), -1, 1e-12);
}


TEST(ParallelBedErosion, theBedIsTheSameHoweverItIsShared)
{
    const bedGrains whole(lattice(6));
    grainSnapshot mine(whole.size());
    DynamicList<label> local;

    forAll(whole.d, i)
    {
        mine.position[i] = whole.centre[i];
        mine.d[i] = whole.d[i];

        if (i % Pstream::nProcs() == Pstream::myProcNo())
        {
            local.append(i);
        }
    }

    const bedGrains bed(flumeFrame(), mine, local);
    const strips along(bed.alongFlume(flume, 0.01));
    const planGrid grid(flume, 0.02);
    const scalar solid = latticePacking*0.3*0.06;

    EXPECT_NEAR(sum(along.values()), solid, 1e-12);
    EXPECT_NEAR(sum(bed.overPlan(grid)), solid, 1e-12);
    EXPECT_NEAR(min(bed.highest(grid, GREAT)), 0.055, 1e-15);
    EXPECT_NEAR(bed.farthest(), 0.995, 1e-12);
    EXPECT_NEAR
    (
        corePacking(bed, flume, along, 0.3), latticePacking, 2e-3
    );
}
