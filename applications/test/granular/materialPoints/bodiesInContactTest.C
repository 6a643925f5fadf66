// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: bodies of material points in frictional contact.

#include "terminalOutput.H"
#include "testNumber.H"
#include "testPoints.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const string stiff("law linearElastic; density 1000; E 1e6; nu 0.3;");


//- Settings of two bodies in contact; a and b hold law, region and velocity
string two(const string& a, const string& b, const string& contact)
{
    return
        "contact { " + contact + " } bodies { a { " + a + " } b { " + b + " } }";
}


string region(const string& box)
{
    return " region { box " + box + "; } ";
}


//- Mean of what the points of a body have, and its mass
struct bodyMean
{
    vector x = Zero;
    vector U = Zero;
    scalar mass = 0;

    bodyMean(const materialPointMethod& method, const label body)
    {
        const pointSet& p = method.points();
        forAll(p.x, i)
        {
            if (p.body[i] == body)
            {
                x += p.mass[i]*p.x[i];
                U += p.mass[i]*p.U[i];
                mass += p.mass[i];
            }
        }
        x /= mass;
        U /= mass;
    }
};


//- A block on a bed of the other body on a slope of 30 degrees
struct blockOnBed
{
    boxOfPoints points;

    static pointBox size()
    {
        pointBox box;
        box.length = 1;
        box.height = 0.3;
        box.h = 0.02;
        box.base = 10;
        return box;
    }

    explicit blockOnBed(const string& contact, const scalar angle)
    :
        points
        (
            size(),
            onSlope(angle),
            two
            (
                "law linearElastic; density 4000; E 1e8; nu 0;"
              + region("((0 0 0) (1 1 0.1))"),
                elastic + region("((0.2 0 0.1) (0.4 1 0.2))"),
                contact
            )
        )
    {}
};

} // End anonymous namespace


TEST(bodiesInContact, blocksThatCollideKeepMomentumAndPart)
{
    for (const string transfer : {"", "transfer { model FLIP; } "})
    {
        pointBox box;
        box.h = 0.02;
        boxOfPoints blocks
        (
            box,
            Zero,
            transfer
          + two
            (
                stiff + " U (1 0 0.1);" + region("((0.2 0 0.4) (0.4 1 0.6))"),
                stiff + " U (-0.6 0 0);" + region("((0.5 0 0.5) (0.7 1 0.8))"),
                "friction 0.3;"
            )
        );
        const vector P(blocks.momentum());
        const vector L(blocks.angularMomentum());
        blocks.run(0.15);

        const bodyMean a(blocks, 0);
        const bodyMean b(blocks, 1);
        const scalar size = mag(a.mass*a.U) + mag(b.mass*b.U);

        testNumber("speed of approach after over before", (a.U - b.U).x()/1.6);
        testNumber("change of momentum", mag(blocks.momentum() - P)/size);

        EXPECT_LT(mag(blocks.momentum() - P), 1e-12*size);
        EXPECT_LT((a.U - b.U).x(), -0.1);
        if (transfer.empty())
        {
            EXPECT_LT(mag(blocks.angularMomentum() - L), 1e-12*mag(L));
        }
    }
}


TEST(bodiesInContact, blocksSideBySideThatPartDoNotHoldEachOther)
{
    pointBox box;
    box.h = 0.02;
    boxOfPoints blocks
    (
        box,
        Zero,
        two
        (
            stiff + " U (-0.3 0 0);" + region("((0.2 0 0.4) (0.4 1 0.6))"),
            stiff + " U (0.5 0 0);" + region("((0.4 0 0.4) (0.6 1 0.6))"),
            "friction 0.9;"
        )
    );
    blocks.run(0.2);

    EXPECT_LT(mag(bodyMean(blocks, 0).U - vector(-0.3, 0, 0)), 1e-13);
    EXPECT_LT(mag(bodyMean(blocks, 1).U - vector(0.5, 0, 0)), 1e-13);

    scalar stress = 0;
    for (const symmTensor& s : blocks.points().stress)
    {
        stress = max(stress, mag(s));
    }
    EXPECT_LT(stress, 1e-6);
}


TEST(bodiesInContact, aBlockSlidesOnAnotherBodyAsCoulombStatesWithin1Percent)
{
    blockOnBed slope("friction 0.3;", 30);
    const scalar before = bodyMean(slope.points, 1).x.x();
    const scalar bed = bodyMean(slope.points, 0).x.x();
    const scalar t = 0.4;
    slope.points.run(t);

    const scalar a = 30*M_PI/180;
    const scalar exact = 0.5*9.81*(std::sin(a) - 0.3*std::cos(a))*sqr(t);
    const scalar ratio = (bodyMean(slope.points, 1).x.x() - before)/exact;
    testNumber("distance over the exact one", ratio);

    EXPECT_NEAR(ratio, 1, 0.01);
    EXPECT_LT(mag(bodyMean(slope.points, 0).x.x() - bed), 1e-4);
}


TEST(bodiesInContact, aBlockOnARougherBedStays)
{
    blockOnBed slope("friction 0.1; frictions { b { a 0.7; } }", 30);
    slope.points.run(0.3, 20);
    const vector before(bodyMean(slope.points, 1).x);
    slope.points.run(0.3);
    EXPECT_LT(mag(bodyMean(slope.points, 1).x - before), 1e-4);
}


TEST(bodiesInContact, aBlockLiesOnABedAndThatBearsItsWeight)
{
    blockOnBed flat("friction 0.5;", 0);
    const scalar before = bodyMean(flat.points, 1).x.z();
    flat.points.run(0.3, 20);
    flat.points.walls().resetImpulse();
    flat.points.run(0.1, 20);

    const bodyMean block(flat.points, 1);
    const scalar weight = 9.81*(bodyMean(flat.points, 0).mass + block.mass);
    testNumber
    (
        "load of the base over the weight of both",
        -flat.points.walls().impulse()[0].z()/0.1/weight
    );
    testNumber("the block has sunk by [cells]", (before - block.x.z())/0.02);

    EXPECT_NEAR
    (
        flat.points.walls().impulse()[0].z()/0.1, -weight, 1e-3*weight
    );
    EXPECT_LT(mag(block.U), 1e-4);
    EXPECT_LT(mag(block.x.z() - before), 0.1*0.02);
}


TEST(bodiesInContact, withoutContactBodiesShareOneVelocity)
{
    pointBox box;
    box.h = 0.02;
    boxOfPoints blocks
    (
        box,
        Zero,
        "bodies { a { " + stiff + region("((0.2 0 0.4) (0.4 1 0.6))")
      + "} b { " + stiff + " U (1 0 0);" + region("((0.4 0 0.4) (0.6 1 0.6))")
      + "} }"
    );
    blocks.run(0.2);
    EXPECT_NEAR
    (
        bodyMean(blocks, 1).x.x() - bodyMean(blocks, 0).x.x(), 0.2, 0.02
    );
}


TEST(bodiesInContact, bodiesFarApartAreToTheLastBitWhatEachIsAlone)
{
    pointBox box;
    box.h = 0.02;
    box.length = 2;
    const string left(sand + region("((0 0 0) (0.3 1 0.4))"));
    const string right(stiff + region("((1.5 0 0) (1.7 1 0.2))"));

    boxOfPoints both(box, down, two(left, right, "friction 0.3;"));
    boxOfPoints alone(box, down, "bodies { a { " + left + " } }");
    const scalar dt = both.stableStep()/2;

    for (label i = 0; i < 200; ++i)
    {
        both.step(dt);
        alone.step(dt);
    }

    label same = 0;
    const pointSet& p = both.points();
    forAll(p.x, i)
    {
        forAll(alone.points().x, j)
        {
            same += p.body[i] == 0 && p.id[i] == alone.points().id[j]
             && p.x[i] == alone.points().x[j]
             && p.stress[i] == alone.points().stress[j];
        }
    }
    EXPECT_EQ(same, alone.points().size());
}


TEST(bodiesInContact, regionsThatOverlapAreNamed)
{
    const auto output = [](const string& high) -> std::string
    {
        const string low(stiff + region("((0.1 0 0) (0.3 1 0.2))"));
        return refusal([&]()
        {
            boxOfPoints
            (
                pointBox(), down, two(low, stiff + region(high), "friction 0;")
            );
        });
    };

    EXPECT_EQ(output("((0.1 0 0.2) (0.3 1 0.4))"), "nothing");

    // The place is that of the first point of both
    const std::string overlap(output("((0.2 0 0.1) (0.4 1 0.4))"));
    EXPECT_NE(overlap.find("bodies a and b overlap"), std::string::npos)
        << overlap;
    EXPECT_NE(overlap.find("(0.2125 0.05 0.1125)"), std::string::npos)
        << overlap;
}
