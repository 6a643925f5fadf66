// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: the contact of one grain with one material point.

#include "StringStream.H"
#include "grainPointContact.H"
#include "pointGrid.H"
#include "pointSet.H"
#include "terminalOutput.H"
#include "testNumber.H"
#include "vectorField.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A point of 0.02 kg at rest and a grain above it that overlaps it by 0.1 mm
//  and slides; points are 10 mm apart
struct grainAndPoint
{
    static constexpr scalar step = 1e-4;

    pointGrid grid;
    pointSet points;
    vectorField x, U, spin, force, torque;
    scalarField radius, mass;

    grainAndPoint
    (
        const scalar ofGrain,
        const scalar kg,
        const bool space = false
    )
    :
        grid
        (
            boundBox(point(0, 0, 0), point(0.4, 0.1, 0.4)),
            0.02,
            Vector<bool>(true, space, true)
        ),
        U(1, vector(1, 0, 0)),
        spin(1, Zero),
        force(1, Zero),
        torque(1, Zero),
        radius(1, ofGrain),
        mass(1, kg)
    {
        points.resize(1);
        points.id[0] = 7;
        points.x[0] = point(0.2, 0.05, 0.2);
        points.mass[0] = 0.02;
    }

    //- Impulses of a step of the points
    void touch(const string& settings)
    {
        grainPointContact contact
        (
            dictionary(IStringStream(settings)()), 0.01, grid.nDims()
        );
        const scalar apart =
            radius[0] + dictionary(IStringStream(settings)())
                .getOrDefault<scalar>("radius", 0.005);
        x = vectorField(1, points.x[0] + vector(0, 0, apart - 1e-4));
        contact.sort(grid, points);
        contact.act
        (
            grainsInStep{x, U, spin, radius, mass, force, torque},
            grid,
            points,
            points.force,
            step
        );
        U += step*force/mass[0];
        spin += step*torque/(0.4*mass[0]*sqr(radius[0]));
        points.U[0] += step*points.force[0]/points.mass[0];
    }

    //- Along the surface of contact [m/s]
    scalar sliding() const
    {
        return (U[0] + (spin[0]^vector(0, 0, -radius[0])) - points.U[0]).x();
    }
};


//- The error for a grain that touches the point
std::string messageOf
(
    const scalar radius,
    const scalar mass,
    const bool space = false,
    const string& settings = "stiffness 1000;"
)
{
    return refusal
    (
        [&]() { grainAndPoint(radius, mass, space).touch(settings); }
    );
}

} // End anonymous namespace


TEST(grainPointContact, theForceIsThatOfTheOverlapEqualAndOpposite)
{
    grainAndPoint both(0.02, 0.1);
    both.touch("stiffness 1000;");

    EXPECT_NEAR(both.force[0].z(), 0.1, 1e-12);
    EXPECT_EQ(mag(both.force[0] + both.points.force[0]), 0);
    EXPECT_EQ(both.sliding(), 1);
}


TEST(grainPointContact, frictionStopsASphereThatSpinsInAStepAndNoMore)
{
    for (const scalar mass : {0.02, 0.1, 100.0})
    {
        grainAndPoint both(0.02, mass);
        both.touch("stiffness 1000; friction 1e6;");

        testNumber("sliding left [m/s]", both.sliding());
        EXPECT_NEAR(both.sliding(), 0, 1e-12) << mass << " kg";
        EXPECT_GT(both.points.U[0].x(), 0.1);
    }
}


TEST(grainPointContact, nothingActsAcrossASlice)
{
    grainAndPoint alone(0.02, 0.1), across(0.02, 0.1);
    across.U[0].y() = 3;
    for (grainAndPoint* both : {&alone, &across})
    {
        both->touch("stiffness 1000; friction 0.5;");
    }

    EXPECT_EQ(across.force[0], alone.force[0]);
    EXPECT_EQ(across.force[0].y(), 0);
    EXPECT_LT(across.force[0].x(), -0.04);
}


TEST(grainPointContact, aGrainLighterThanAPointIsRefused)
{
    EXPECT_EQ(messageOf(0.02, 0.02), "nothing");

    const std::string error(messageOf(0.02, 0.0199));
    EXPECT_NE(error.find("lighter than a point"), std::string::npos) << error;
    EXPECT_NE(error.find("the point 7 of 0.02 kg"), std::string::npos) << error;
    EXPECT_NE(error.find("cellSize"), std::string::npos) << error;
}


TEST(grainPointContact, aGrainThatSlipsBetweenPointsIsRefused)
{
    // Amid four points of a square: (sqrt(2) - 1) of 5 mm
    EXPECT_EQ(messageOf(0.00208, 0.1, true), "nothing");
    EXPECT_NE
    (
        messageOf(0.00206, 0.1, true).find("slip between points"),
        std::string::npos
    );

    // Points of a plane touch, unless their radius is less
    EXPECT_EQ(messageOf(0.001, 0.1), "nothing");
    const string thin("stiffness 1000; radius 3e-3;");
    EXPECT_EQ(messageOf(0.0021, 0.1, false, thin), "nothing");
    EXPECT_NE
    (
        messageOf(0.0019, 0.1, false, thin).find("slip between points"),
        std::string::npos
    );
}
