// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: material points where the answer is known.

#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

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


TEST(materialPoints, aBlockSlidesDownASlopeAsCoulombStatesWithin1Percent)
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
        const std::string output(e.message());
        EXPECT_NE(output.find("Point "), std::string::npos) << output;
        EXPECT_NE(output.find("of body body is beyond"), std::string::npos);
    }
}


TEST(materialPoints, densityAveragingSpreadsTheVolumeOfAPointOverItsCellAndKeepsTheSum)
{
    for (const bool on : {false, true})
    {
        pointBox box;
        boxOfPoints block
        (
            box,
            Zero,
            body
            (
                elastic,
                "((0.3 0 0.3) (0.7 1 0.7))",
                on ? "densityAveraging on;" : ""
            )
        );
        pointSet& p = block.points();
        const scalar one = p.volume[0];

        // One in the middle of the block, larger by a fifth: it has three
        // others in its cell
        label middle = 0;
        forAll(p.x, i)
        {
            const point centre(0.513, 0.5, 0.513);
            if (mag(p.x[i] - centre) < mag(p.x[middle] - centre))
            {
                middle = i;
            }
        }
        p.volume[middle] *= 1.2;
        const label id = p.id[middle];
        block.step(1e-5);

        scalar all = 0;
        forAll(p.x, i)
        {
            all += p.volume[i];
            if (p.id[i] == id)
            {
                EXPECT_NEAR(p.volume[i], (on ? 1.05 : 1.2)*one, 1e-9*one);
            }
        }
        EXPECT_NEAR(all, (p.size() + 0.2)*one, 1e-9*one);
    }
}
