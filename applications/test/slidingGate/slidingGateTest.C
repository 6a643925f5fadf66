// SPDX-License-Identifier: GPL-3.0-or-later
// A gate: its faces, where it is in time, what it lets through.

#include "terminalOutput.H"
#include "slidingGate.H"
#include "testMesh.H"

#include "Function1.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "surfaceFields.H"
#include "volFields.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Cells of 0.25 x 0.25 x 0.125 m, cut along x where there are ranks
testBox box(const direction cut = 0)
{
    testBox b;
    b.cells = labelVector(4, 4, 8);
    b.cut = cut;
    return b;
}


//- Across x at 0.5 m, drawn upwards at 2 m/s
dictionary gateAt(const scalar x)
{
    dictionary dict;
    dict.add("point", vector(x, 0, 0));
    dict.add("normal", vector(1, 0, 0));
    dict.add("speed", scalar(2));
    return dict;
}


surfaceScalarField ones(const fvMesh& mesh)
{
    return surfaceScalarField
    (
        IOobject("ones", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    );
}


//- Area through which the field lets pass at x [m2], faces between ranks
//  counted half on either side
scalar openArea(const surfaceScalarField& share, const scalar x)
{
    const fvMesh& mesh = share.mesh();
    scalar area = 0;

    forAll(share, face)
    {
        if (mag(mesh.Cf()[face].x() - x) < 1e-6 && mag(mesh.Sf()[face].x()) > 0)
        {
            area += share[face]*mesh.magSf()[face];
        }
    }

    forAll(share.boundaryField(), patch)
    {
        if (share.boundaryField()[patch].coupled())
        {
            forAll(share.boundaryField()[patch], i)
            {
                if (mag(mesh.Cf().boundaryField()[patch][i].x() - x) < 1e-6)
                {
                    area +=
                        0.5*share.boundaryField()[patch][i]
                       *mesh.magSf().boundaryField()[patch][i];
                }
            }
        }
    }

    return returnReduce(area, sumOp<scalar>());
}


//- Open area at x when the gate has moved to time t
scalar openArea(slidingGate& gate, const fvMesh& mesh, scalar t, scalar x)
{
    gate.move(t);
    surfaceScalarField through(ones(mesh));
    gate.close(through);
    return openArea(through, x);
}

} // End anonymous namespace


TEST(slidingGate, AClosedGateLetsNothingThroughAndNothingElseIsTouched)
{
    testMesh m(box());
    slidingGate gate(m.mesh(), gateAt(0.5));

    EXPECT_TRUE(gate.exists());
    EXPECT_EQ(openArea(gate, m.mesh(), 0, 0.5), 0);
    EXPECT_DOUBLE_EQ(openArea(gate, m.mesh(), 0, 0.25), 1);
    EXPECT_DOUBLE_EQ(openArea(gate, m.mesh(), 0, 0.75), 1);
}


TEST(slidingGate, OpensInProportionToItsWayAlsoWithinAFace)
{
    testMesh m(box());
    slidingGate gate(m.mesh(), gateAt(0.5));

    for (const scalar t : {0.01, 0.0625, 0.1, 0.33, 0.5})
    {
        EXPECT_NEAR(openArea(gate, m.mesh(), t, 0.5), 2*t, 1e-12);
    }
    EXPECT_DOUBLE_EQ(openArea(gate, m.mesh(), 7, 0.5), 1);
}


TEST(ParallelSlidingGate, IsTheSameWhereTheRanksAreCutAtItAndAcrossIt)
{
    for (const direction cut : {0, 2})
    {
        testMesh m(box(cut));
        slidingGate gate(m.mesh(), gateAt(0.5));

        EXPECT_EQ(openArea(gate, m.mesh(), 0, 0.5), 0);
        EXPECT_NEAR(openArea(gate, m.mesh(), 0.3, 0.5), 0.6, 1e-12);
        EXPECT_NEAR(openArea(gate, m.mesh(), 0.3, 0.25), 1, 1e-12);
    }
}


TEST(slidingGate, BetweenFacesItStandsOnTheFacesBetweenItsSides)
{
    testMesh m(box());
    slidingGate gate(m.mesh(), gateAt(0.55));

    EXPECT_EQ(openArea(gate, m.mesh(), 0, 0.5), 0);
    EXPECT_DOUBLE_EQ(openArea(gate, m.mesh(), 0, 0.75), 1);
}


TEST(slidingGate, ReportsHowFarBesideItsPlaneItStands)
{
    testMesh m(box());
    const auto output = [&](const scalar x)
    {
        return outputDuring([&]{ slidingGate gate(m.mesh(), gateAt(x)); });
    };
    expectHolds(output(0.55), "up to 0.05 m beside its plane");
    expectLacks(output(0.5), "beside its plane");
}


TEST(slidingGate, CanBeDrawnDownOrAside)
{
    testMesh m(box());
    dictionary dict(gateAt(0.5));
    dict.add("direction", vector(0, 0, -3));
    slidingGate down(m.mesh(), dict);
    down.move(0.125);

    // The uppermost quarter is open
    forAll(m.mesh().owner(), face)
    {
        const point& c = m.mesh().Cf()[face];
        if (mag(c.x() - 0.5) < 1e-6 && mag(m.mesh().Sf()[face].x()) > 0)
        {
            EXPECT_NEAR(down.open()[face], c.z() > 0.75 ? 1 : 0, 1e-12);
        }
    }

    dict.set("direction", vector(0, 1, 0));
    slidingGate aside(m.mesh(), dict);
    EXPECT_NEAR(openArea(aside, m.mesh(), 0.2, 0.5), 0.4, 1e-12);
}


TEST(slidingGate, StrengthStretchesTheTimeOfOpening)
{
    testMesh m(box());
    dictionary dict(gateAt(0.5));
    dict.add("start", 1);
    dict.add("strength", 0.5);
    slidingGate gate(m.mesh(), dict);

    EXPECT_EQ(gate.travel(0.9), 0);
    EXPECT_NEAR(gate.travel(1.1), 0.4, 1e-12);
}


TEST(slidingGate, SpeedCanBeATable)
{
    testMesh m(box());
    dictionary dict(gateAt(0.5));
    IStringStream text("speed table ((0 0) (0.1 2) (9 2));");
    dict.remove("speed");
    dict.read(text);
    slidingGate gate(m.mesh(), dict);

    EXPECT_NEAR(gate.travel(0.05), 0.025, 1e-12);
    EXPECT_NEAR(gate.travel(0.2), 0.3, 1e-12);
}


TEST(slidingGate, StrengthZeroAndNoFileAreNoGate)
{
    testMesh m(box());
    dictionary dict(gateAt(0.5));
    dict.add("strength", 0);
    slidingGate weak(m.mesh(), dict);
    slidingGate none(m.mesh());

    EXPECT_FALSE(weak.exists());
    EXPECT_FALSE(none.exists());
    EXPECT_DOUBLE_EQ(openArea(weak, m.mesh(), 0, 0.5), 1);
    EXPECT_DOUBLE_EQ(openArea(none, m.mesh(), 0, 0.5), 1);
}


TEST(slidingGate, AFileThatCannotBeReadIsAnErrorNotARunWithoutGate)
{
    testMesh m(box());
    const Time& time = m.mesh().time();
    mkDir(time.path()/time.constant());
    {
        OFstream os(time.path()/time.constant()/"slidingGate");
        os  << "speed 1;" << nl;
    }

    EXPECT_ANY_THROW(slidingGate gate(m.mesh()));
}


TEST(slidingGate, BadSettingsAreErrorsThatStateWhatToDo)
{
    testMesh m(box());
    const auto messageOf = [&](const dictionary& dict)
    {
        return refusal([&]{ slidingGate gate(m.mesh(), dict); });
    };

    dictionary misspelt(gateAt(0.5));
    misspelt.add("sped", 1);
    EXPECT_NE(messageOf(misspelt).find("sped"), std::string::npos);
    EXPECT_NE(messageOf(misspelt).find("strength"), std::string::npos);

    dictionary negative(gateAt(0.5));
    negative.add("strength", -1);
    EXPECT_NE(messageOf(negative).find("above 0"), std::string::npos);

    dictionary nowhere(gateAt(0.5));
    nowhere.set("normal", vector::zero);
    EXPECT_NE(messageOf(nowhere).find("normal"), std::string::npos);

    // Its faces would have no extent along the way that it is drawn
    dictionary trapdoor(gateAt(0.5));
    trapdoor.set("point", vector(0.5, 0.5, 0.5));
    trapdoor.set("normal", vector(0, 0, 2));
    EXPECT_NE(messageOf(trapdoor).find("lies in its plane"), std::string::npos);
    trapdoor.set("direction", vector(1, 0, 0));
    EXPECT_EQ(messageOf(trapdoor), "nothing");

    EXPECT_NE(messageOf(gateAt(5)).find("inside"), std::string::npos);
}
