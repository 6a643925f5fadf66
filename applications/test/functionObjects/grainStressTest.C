// SPDX-License-Identifier: GPL-3.0-or-later
// Mean stress: what of a grain lies in a region.

#include "grainStress.H"
#include "periodicity.H"
#include "terminalOutput.H"
#include "sphereParts.H"
#include "standingGrains.H"
#include "testMesh.H"
#include "testNumber.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

//- Share of a sphere of radius r at p in one of radius R at the origin, from n
//  points along each side of the cube around it
scalar counted(const point& p, const scalar r, const scalar R, const label n)
{
    label all = 0;
    label inside = 0;

    for (label i = 0; i < n*n*n; ++i)
    {
        const vector to
        (
            (2.0*(i % n) + 1)/n - 1,
            (2.0*((i/n) % n) + 1)/n - 1,
            (2.0*(i/(n*n)) + 1)/n - 1
        );

        if (magSqr(to) <= 1)
        {
            ++all;
            inside += magSqr(p + r*to) <= sqr(R);
        }
    }

    return scalar(inside)/all;
}

} // End anonymous namespace


TEST(sphereParts, theShareInASphereIsThatOfCountedPoints)
{
    scalar most = 0;

    for (const scalar R : {0.3, 1.0, 4.0})
    {
        for (const scalar s : {0.1, 0.8, 1.5, 3.5, 4.5})
        {
            const point p(s*vector(2, -1, 2)/3);
            const scalar share = sphereParts::inSphere(p, 1, Zero, R);
            most = max(most, mag(share - counted(p, 1, R, 120)));
        }
    }

    testNumber("largest difference", most);
    EXPECT_LT(most, 1e-3);
}


TEST(sphereParts, boxesSideBySideHaveAllOfASphere)
{
    const point p(0.2, -0.1, 0.05);
    scalar all = 0;

    for (label i = 0; i < 8; ++i)
    {
        const point low(i & 1 ? 0 : -2, i & 2 ? 0 : -2, i & 4 ? 0 : -2);
        all += sphereParts::inBox(p, 0.5, boundBox(low, low + vector::one*2));
    }

    EXPECT_NEAR(all, 1, 1e-14);
}


TEST(periodicity, aPointHasNineImagesWhereTwoDirectionsRepeat)
{
    testBox box;
    box.patches = {"cyclic", "cyclic", "wall", "wall", "empty", "empty"};
    box.cells = labelVector(4, 4, 1);
    testMesh mesh(box);

    const List<vector> shifts(periodicity(mesh.mesh()).shifts());

    EXPECT_EQ(shifts.size(), 9);
    EXPECT_EQ(shifts[0], vector::zero);
    EXPECT_EQ(sum(shifts), vector::zero);
    for (const vector& shift : shifts)
    {
        EXPECT_EQ(shift.y(), 0);
    }
}


TEST(grainStress, aGrainOnABorderThatRepeatsCountsOnce)
{
    testBox box;
    box.patches = {"cyclic", "cyclic", "cyclic", "cyclic", "wall", "wall"};
    testMesh mesh(box);
    standingGrains grains(mesh.mesh());
    grains.grains = grainSnapshot(1);
    grains.grains.position[0] = point(0.98, 0.01, 0.5);
    grains.grains.d[0] = 0.1;
    grains.grains.mass[0] = 1;
    grains.grains.stressMoment[0] = symmTensor(1, 2, 3, 4, 5, 6);

    functionObjects::grainStress stress
    (
        "stress",
        mesh.time(),
        dictionary
        (
            IStringStream
            (
                "boxes (((0 0 0) (1 1 1))); spheres (((0 0 0.5) 0.2));"
                " rhoWater 1000; log no;"
            )()
        )
    );
    stress.write();

    std::ifstream is
    (
        mesh.folder()/"postProcessing"/"stress"/"0"/"grainStress.dat"
    );
    std::string line;
    while (std::getline(is, line) && line[0] == '#')
    {}

    std::istringstream numbers(line);
    scalar time, inSphere, inBox, skipped;
    numbers >> time >> inSphere;
    for (label i = 0; i < 9; ++i)
    {
        numbers >> skipped;
    }
    numbers >> inBox;

    EXPECT_NEAR(inSphere, 1, 1e-10);
    EXPECT_NEAR(inBox, 1, 1e-10);
}


TEST(grainStress, aRegionMayBeWiderThanASliceThatRepeatsAsFarAsItsImagesReach)
{
    testBox box;
    box.patches = {"cyclic", "cyclic", "cyclic", "cyclic", "wall", "wall"};
    testMesh mesh(box);
    standingGrains grains(mesh.mesh());
    const auto output = [&](const std::string& boxes)
    {
        const dictionary dict(IStringStream("boxes (" + boxes + "); log no;")());
        return refusal
        (
            [&]() { functionObjects::grainStress("stress", mesh.time(), dict); }
        );
    };

    EXPECT_EQ(output("((-0.2 0 0) (1.2 1 1))"), "nothing");
    EXPECT_EQ(output("((1.1 0 0) (1.2 1 1))"), "nothing");
    expectHolds(output("((-2 0 0) (2 1 1))"), "is longer than the mesh");
    expectHolds(output("((0 0 -0.2) (1 1 1.2))"), "is longer than the mesh");
}
