// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: material points where the answer is known.

#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const vector down(0, 0, -9.81);


//- Gravity on a slope of an angle [degrees], x downhill
vector onSlope(const scalar angle)
{
    const scalar a = angle*M_PI/180;
    return 9.81*vector(std::sin(a), 0, -std::cos(a));
}


//- Settings of one body in a box
string body(const string& law, const string& box, const string& rest = "")
{
    return rest + " bodies { body { " + law + " region { box " + box + "; } } }";
}


const string elastic("law linearElastic; density 1000; E 1e6; nu 0;");


//- Period of the first longitudinal vibration of a free bar over 2 L/c
scalar periodOfBar(const string& transfer)
{
    pointBox box;
    box.length = 2;
    box.height = 0.6;
    boxOfPoints bar
    (
        box, Zero, body(elastic, "((0.5 0 0.25) (1.5 1 0.35))", transfer)
    );

    // The mode's velocity at the points where they began
    scalarField mode(bar.points().size());
    forAll(mode, i)
    {
        mode[bar.points().id[i]] = std::cos(M_PI*(bar.points().x[i].x() - 0.5));
    }
    forAll(mode, i)
    {
        bar.points().U[i].x() = 0.01*mode[bar.points().id[i]];
    }

    // Between the first and the third change of its sign is a period
    const scalar exact = 2/bar.waveSpeed();
    const scalar dt = 0.2*bar.stableStep();
    DynamicList<scalar> zeros;
    scalar before = 1;

    for (scalar t = dt; zeros.size() < 3 && t < 3*exact; t += dt)
    {
        bar.step(dt);
        scalar amplitude = 0;
        forAll(mode, i)
        {
            amplitude += bar.points().U[i].x()*mode[bar.points().id[i]];
        }
        if (amplitude*before < 0)
        {
            zeros.append(t);
        }
        before = amplitude;
    }

    return zeros.size() < 3 ? 0 : (zeros[2] - zeros[0])/exact;
}


//- Largest speed [m/s]
scalar fastest(const materialPointMethod& points)
{
    scalar U = 0;
    for (const vector& u : points.points().U)
    {
        U = max(U, mag(u));
    }
    return U;
}


const string sand
(
    "law softeningDruckerPrager; density 1500; E 1e6; nu 0.2;"
    " frictionAngle 32;"
);


//- Mean speed down a slope [m/s], after a second, of an infinite layer 0.2 m
//  deep, over that of a block without friction
scalar speedOnSlope(const scalar angle, const string& law)
{
    pointBox box;
    box.repeats = true;
    box.length = 0.2;
    box.height = 0.4;
    box.h = 0.02;
    box.base = 10;
    boxOfPoints layer(box, onSlope(0), body(law, "((0 0 0) (1 1 0.2))"));

    // Settled, then tilted slowly, then left alone
    layer.run(0.3, 20);
    for (scalar a = 0; a < angle; a += 0.5)
    {
        layer.setGravity(onSlope(min(a, angle)));
        layer.run(0.01, 20);
    }
    layer.setGravity(onSlope(angle));
    layer.run(0.5);

    scalar U = 0;
    for (const vector& u : layer.points().U)
    {
        U += u.x()/layer.points().size();
    }
    return U/(9.81*std::sin(angle*M_PI/180)*0.5);
}

} // End anonymous namespace


TEST(materialPoints, anElasticBarVibratesWithItsPeriodWithin1Percent)
{
    const scalar APIC = periodOfBar("");
    const scalar FLIP = periodOfBar("transfer { model FLIP; share 0.98; }");
    testNumber("period over 2 L/c, APIC", APIC);
    testNumber("period over 2 L/c, FLIP", FLIP);

    EXPECT_NEAR(APIC, 1, 0.01);
    EXPECT_NEAR(FLIP, 1, 0.01);
}


TEST(materialPoints, aBlockSlidesDownASlopeAsCoulombSaysWithin1Percent)
{
    pointBox box;
    box.length = 1;
    box.height = 0.3;
    box.h = 0.02;
    box.base = 0.3;
    boxOfPoints block
    (
        box, onSlope(30), body(elastic, "((0.2 0 0) (0.4 1 0.1))")
    );

    const auto middle = [&]()
    {
        return average(vectorField(block.points().x)).x();
    };

    const scalar before = middle();
    const scalar t = 0.4;
    block.run(t);

    const scalar a = 30*M_PI/180;
    const scalar exact = 0.5*9.81*(std::sin(a) - 0.3*std::cos(a))*sqr(t);
    const scalar ratio = (middle() - before)/exact;
    testNumber("distance over the exact one", ratio);
    EXPECT_NEAR(ratio, 1, 0.01);
}


TEST(materialPoints, aBlockOnARougherSlopeStays)
{
    pointBox box;
    box.height = 0.3;
    box.h = 0.02;
    box.base = 0.7;
    boxOfPoints block
    (
        box, onSlope(30), body(elastic, "((0.2 0 0) (0.4 1 0.1))")
    );
    block.run(0.3, 20);
    const point before(average(vectorField(block.points().x)));
    block.run(0.3);
    EXPECT_LT(mag(average(vectorField(block.points().x)) - before), 1e-4);
}


TEST(materialPoints, wallsTakeTheWeight)
{
    pointBox box;
    box.length = 0.4;
    box.height = 0.5;
    box.h = 0.02;
    boxOfPoints column(box, down, body(sand, "((0 0 0) (0.4 1 0.3))"));
    column.run(0.5, 20);
    column.walls().resetImpulse();
    column.run(0.1, 20);

    const scalar weight = 1500*0.4*0.3*0.1*9.81;
    EXPECT_NEAR(column.walls().impulse()[0].z()/0.1, -weight, 1e-3*weight);
    EXPECT_NEAR(column.walls().impulse()[1].x()/0.1, 0, 1e-3*weight);
}


TEST(materialPoints, stressAtRestIsThatOfTheWeightWithin1PercentSaveAtTheBase)
{
    pointBox box;
    box.length = 0.2;
    box.height = 1.4;
    box.h = 0.025;
    boxOfPoints column
    (
        box,
        down,
        body
        (
            "law softeningDruckerPrager; density 1500; E 1e7; nu 0.2;"
            " frictionAngle 32;",
            "((0 0 0) (1 1 1))"
        )
    );
    for (label i = 1; i <= 50; ++i)
    {
        column.setGravity(i/50.0*down);
        column.run(0.004, 40);
    }
    column.run(0.1, 40);

    // Mean of each layer of cells, over the stress at the base
    scalarField error(40, Zero);
    scalarField n(40, Zero);
    const pointSet& p = column.points();
    forAll(p.x, i)
    {
        const label layer = min(39, label(p.x[i].z()/0.025));
        const scalar exact = -1500*9.81*(1 - p.x[i].z());
        error[layer] += (p.stress[i].zz() - exact)/(1500*9.81);
        n[layer] += 1;
    }
    error /= n;
    testNumber
    (
        "stress in the layer at the base over that of its weight", 1 - error[0]
    );

    // Where points of one side alone reach the nodes at the base it is too high
    EXPECT_LT(mag(error[0]), 0.1);
    error[0] = 0;
    testNumber
    (
        "largest error of all other layers over the stress at the base",
        max(mag(error))
    );
    EXPECT_LT(max(mag(error)), 0.01);
}


TEST(materialPoints, APICKeepsMomentumAndAngularMomentumTo1em10)
{
    for (const bool solid : {false, true})
    {
        pointBox box;
        box.solid = solid;
        box.width = solid ? 1 : 0.1;
        boxOfPoints block
        (
            box,
            Zero,
            body
            (
                "law linearElastic; density 1000; E 1e6; nu 0.3;",
                solid
              ? "((0.35 0.35 0.4) (0.65 0.65 0.6))"
              : "((0.3 0 0.35) (0.7 1 0.6))"
            )
        );
        const vector spin(solid ? vector(3, 8, -5) : vector(0, 8, 0));
        forAll(block.points().x, i)
        {
            const vector r(block.points().x[i] - point(0.5, 0.5, 0.5));
            block.points().U[i] = (spin^r) + vector(0.2*r.z(), 0, 0.1);
            if (!solid)
            {
                block.points().U[i].y() = 0;
            }
        }

        const vector L(block.angularMomentum());
        const vector P(block.momentum());
        block.run(0.2);

        testNumber
        (
            "change of angular momentum over itself",
            mag(block.angularMomentum() - L)/mag(L)
        );
        EXPECT_LT(mag(block.angularMomentum() - L), 1e-10*mag(L));
        EXPECT_LT(mag(block.momentum() - P), 1e-10*mag(P));
        EXPECT_GT(block.points().size(), 100);
    }
}


TEST(materialPoints, aSlopeOfSlopeMatchingStandsBelowItsAngleAndFlowsAbove)
{
    const string slope(sand + " matching slope;");
    const scalar at30 = speedOnSlope(30, slope);
    const scalar at34 = speedOnSlope(34, slope);
    testNumber("speed at 30 degrees over that without friction", at30);
    testNumber("speed at 34 degrees over that without friction", at34);

    EXPECT_LT(at30, 1e-3);

    // sin 34 - tan 32 cos 34 of sin 34
    EXPECT_GT(at34, 0.5*(1 - std::tan(32*M_PI/180)/std::tan(34*M_PI/180)));
}


TEST(materialPoints, aSlopeOfPlaneStrainMatchingFailsAtTheSineOfItsAngle)
{
    // tan theta = sin 32: theta = 27.9 degrees
    const scalar at27 = speedOnSlope(27, sand);
    const scalar at30 = speedOnSlope(30, sand);
    testNumber("speed at 27 degrees over that without friction", at27);
    testNumber("speed at 30 degrees over that without friction", at30);

    EXPECT_LT(at27, 1e-3);
    EXPECT_GT(at30, 0.5*(1 - std::sin(32*M_PI/180)/std::tan(30*M_PI/180)));
}


TEST(materialPoints, aDryColumnRunsOutAsSandDoes)
{
    pointBox box;
    box.length = 0.8;
    box.height = 0.36;
    box.h = 0.01;
    box.base = 0.6;
    boxOfPoints column
    (
        box, down, body(sand, "((0 0 0) (0.15 1 0.3))")
    );
    column.run(1);

    // Where the heap is half a cell deep: volume of a strip over its width
    scalarField depth(80, Zero);
    const pointSet& p = column.points();
    forAll(p.x, i)
    {
        depth[label(p.x[i].x()/0.01)] += p.mass[i]/1500/(0.01*0.1);
    }
    label front = 79;
    while (depth[front] < 0.005)
    {
        --front;
    }
    const scalar runOut = (0.01*(front + 1) - 0.15)/0.15;
    testNumber("run-out over width", runOut);
    testNumber("height over width", depth[0]/0.15);
    testNumber("speed left [m/s]", fastest(column));
    EXPECT_GT(runOut, 2.4);
    EXPECT_LT(runOut, 3.6);
}


TEST(materialPoints, aPointBeyondTheGridIsNamed)
{
    pointBox box;
    boxOfPoints block
    (
        box,
        vector(0, 0, 50),
        body(elastic, "((0.3 0 0.5) (0.5 1 0.7))")
    );
    try
    {
        block.run(1);
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        const std::string said(e.message());
        EXPECT_NE(said.find("Point "), std::string::npos) << said;
        EXPECT_NE(said.find("of body body is beyond"), std::string::npos);
    }
}


namespace
{

//- A small column that collapses in a box
autoPtr<boxOfPoints> smallCollapse
(
    const bool cut,
    const bool repeats,
    const bool solid,
    const string& transfer
)
{
    pointBox box;
    box.length = 0.8;
    box.height = 0.4;
    box.h = 0.04;
    box.base = 0.5;
    box.cut = cut;
    box.repeats = repeats;
    box.solid = solid;
    box.width = solid ? 0.16 : 0.1;

    autoPtr<boxOfPoints> column
    (
        new boxOfPoints
        (
            box,
            vector(2, 0, -9.81),
            body(sand, "((0.1 0 0) (0.36 1 0.3))", transfer)
        )
    );
    column->run(solid ? 0.15 : 0.4);
    return column;
}


//- What many ranks compute is what each computes alone, to a rounding that
//  has grown for some hundred steps
void expectAsAlone
(
    const bool repeats,
    const bool solid,
    const string& transfer = ""
)
{
    auto together = smallCollapse(true, repeats, solid, transfer);
    auto alone = smallCollapse(false, repeats, solid, transfer);
    const pointSet& p = together->points();
    const pointSet& all = alone->points();

    EXPECT_EQ(returnReduce(p.size(), sumOp<label>()), all.size());

    labelList where(all.size());
    forAll(all.id, i)
    {
        where[all.id[i]] = i;
    }

    scalar apart = 0;
    scalar stress = 0;
    label crossed = 0;
    const bool above = together->grid().first() > 0;

    forAll(p.id, i)
    {
        const label j = where[p.id[i]];
        apart = max(apart, mag(p.x[i] - all.x[j]));
        stress = max(stress, mag(p.stress[i] - all.stress[j]));

        // The column began below that
        crossed += above && p.x[i].x() > 0.36;
    }
    testNumber
    (
        "largest distance from the same point on one rank [m]",
        returnReduce(apart, maxOp<scalar>())
    );
    EXPECT_LT(apart, 1e-11);
    EXPECT_LT(stress, 1e-4);
    EXPECT_GT(returnReduce(crossed, sumOp<label>()), 0);

    // The impulse of each wall is counted once
    for (label wall = 0; wall < together->walls().names().size(); ++wall)
    {
        vector impulse(together->walls().impulse()[wall]);
        reduce(impulse, sumOp<vector>());
        EXPECT_NEAR
        (
            mag(impulse - alone->walls().impulse()[wall]), 0, 1e-6
        );
    }
}

} // End anonymous namespace


TEST(ParallelMaterialPoints, aCollapseIsTheSameOnAnyNumberOfRanks)
{
    expectAsAlone(false, false);
}


TEST(ParallelMaterialPoints, aCollapseInABoxThatRepeatsIsTheSame)
{
    expectAsAlone(true, false);
}


TEST(ParallelMaterialPoints, aCollapseByFLIPIsTheSame)
{
    expectAsAlone(false, false, "transfer { model FLIP; }");
}


TEST(ParallelMaterialPoints, aCollapseInThreeDimensionsIsTheSame)
{
    expectAsAlone(false, true);
}
