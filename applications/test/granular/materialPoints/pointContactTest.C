// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: the contact of bodies of material points at a node.

#include "StringStream.H"
#include "pointContact.H"
#include "terminalOutput.H"
#include "vector.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A node at which two bodies have masses of 2 and 3 kg, after contact with the
//  normal z: velocity of each, mass first
struct touchedNode
{
    std::vector<nodeLanes> velocity;

    //- first is the volume of the first body and its moment
    touchedNode
    (
        const scalar friction,
        const vector& U,
        const lanes& first = lanes(0.4, 0.1, 0, -0.12)
    )
    :
        velocity
        ({
            nodeLanes(1, lanes(2, U.x(), U.y(), U.z())),
            nodeLanes(1, lanes(3, 0, 0, 0))
        })
    {
        dictionary dict;
        dict.add("friction", friction);
        const pointContact contact(dict, wordList({"a", "b"}));

        // By default the edge of the first, below the second: free where it ends
        const std::vector<nodeLanes> inward
        ({
            nodeLanes(1, first),
            nodeLanes(1, lanes(0.5, 0, 0, 0.2))
        });
        contact.apply(velocity, inward, 1, labelList({0}));
    }

    vector U(const label body) const
    {
        const lanes& node = velocity[body][0];
        return vector(node[1], node[2], node[3]);
    }
};

} // End anonymous namespace


TEST(pointContact, theImpulseIsThatOfCoulombAndEqualAndOpposite)
{
    // Approach 1 m/s, sliding 5 m/s, friction 0.5; reduced mass 1.2 kg
    const touchedNode node(0.5, vector(3, 4, 1));
    const vector impulse(1.2*vector(0.5*0.6, 0.5*0.8, 1));

    EXPECT_LT(mag(3*node.U(1) - impulse), 1e-15);
    EXPECT_LT(mag(2*(node.U(0) - vector(3, 4, 1)) + impulse), 2e-15);
}


TEST(pointContact, frictionBrakesAtMostToRest)
{
    const touchedNode node(20, vector(3, 4, 1));
    EXPECT_LT(mag(node.U(0) - node.U(1)), 1e-15);
    EXPECT_LT(mag(node.U(0) - 0.4*vector(3, 4, 1)), 1e-15);
}


TEST(pointContact, bodiesThatPartAreLeftAlone)
{
    const touchedNode node(20, vector(3, 4, -1));
    EXPECT_EQ(node.U(0), vector(3, 4, -1));
    EXPECT_EQ(node.U(1), vector::zero);
}


TEST(pointContact, aClumpMakesNoNormal)
{
    // Its moment is 1.4 times that of a half-space, and not along z
    const touchedNode node(0, vector(0, 0, 1), lanes(0.4, 0.2, 0, -0.2));
    EXPECT_LT(mag(node.U(0) - vector(0, 0, 0.4)), 1e-15);
    EXPECT_LT(mag(node.U(1) - vector(0, 0, 0.4)), 1e-15);
}


TEST(pointContact, aPairThatIsNoneIsNamed)
{
    const wordList bodies({"debris", "bed"});
    const auto output = [&](const string& settings) -> std::string
    {
        return refusal([&]()
        {
            pointContact(dictionary(IStringStream(settings)()), bodies);
        });
    };

    EXPECT_EQ(output("frictions { debris { bed 0.2; } }"), "nothing");
    EXPECT_NE(output("frictions { debris { bad 0; } }").find("bad"), -1ul);
    EXPECT_NE(output("frictions { bad { bed 0; } }").find("bad"), -1ul);
    EXPECT_NE(output("frictions { bed { bed 0; } }").find("one body"), -1ul);
    EXPECT_NE(output("friction -1;").find("below zero"), -1ul);
    EXPECT_NE
    (
        output("frictions { bed { debris 0; } debris { bed 0; } }").find("twice"),
        -1ul
    );
}
