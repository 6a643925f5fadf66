// SPDX-License-Identifier: GPL-3.0-or-later
// Packings of clumps: no overlaps, the requested solid fraction, seeds, and errors.

#include "clumpRelaxation.H"
#include "packingCache.H"
#include "packingModel.H"
#include "sphereUnion.H"
#include "temporaryFolder.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

using namespace Foam;
using constant::mathematical::pi;

namespace
{

autoPtr<packingModel> model(const std::string& entries)
{
    IStringStream is(entries + " density 2650; diameter 0.03;");
    return packingModel::New(dictionary(is), vector(0, 0, -9.81));
}


//- A shape by its entries, of the volume of a sphere of 30 mm
clumpShape shapeOf(const std::string& entries)
{
    IStringStream is("clump " + entries);
    return clumpShape(dictionary(is), 0.03);
}


//- The message of the error that making such a packing ends with
std::string complaint(const std::string& entries)
{
    try
    {
        model(entries)->make("/tmp");
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "";
}


void expectComplaint(const std::string& entries, const char* words)
{
    const std::string text(complaint(entries));
    EXPECT_NE(text.find(words), std::string::npos) << text;
}


//- Least gap over mean diameter of spheres of two clumps, or of two images of one,
//  in the simplest way there is
scalar leastGap(const packingModel& packing, const packedGrains& clumps)
{
    const pointField p(packing.sphereCentres(clumps));
    const scalarField d(packing.sphereDiameters(clumps));
    const labelList body(packing.sphereGrains(clumps));
    scalar least = VGREAT;

    forAll(p, i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (body[i] != body[j])
            {
                const scalar apart = mag(packing.box().nearest(p[i] - p[j]));
                least = min(least, 2*apart/(d[i] + d[j]) - 1);
            }
        }
    }
    return least;
}


//- Largest depth of a sphere in a wall [m]
scalar inTheWalls(const packingModel& packing, const packedGrains& clumps)
{
    const pointField p(packing.sphereCentres(clumps));
    const scalarField d(packing.sphereDiameters(clumps));
    const boundBox box(packing.box().bounds());
    scalar deepest = -VGREAT;

    forAll(p, i)
    {
        for (direction k = 0; k < 3; ++k)
        {
            if (!packing.box().periodic(k))
            {
                const scalar low = box.min()[k] - p[i][k] + 0.5*d[i];
                const scalar high = p[i][k] + 0.5*d[i] - box.max()[k];
                deepest = max(deepest, max(low, high));
            }
        }
    }
    return deepest;
}


const std::string box = "type dense; box (0 0 0) (0.3 0.2 0.25); ";

} // End anonymous namespace


class clumpPacking
:
    public ::testing::TestWithParam<const char*>
{};


TEST_P(clumpPacking, itsShapeHasTheVolumeOfTheSphereAndItsCentreAtTheOrigin)
{
    const clumpShape shape(shapeOf(GetParam()));
    const sphereUnion all(shape.centres(), shape.radii());
    const scalar V = pi/6*pow3(0.03);

    EXPECT_NEAR(all.volume(), V, 1e-12*V);
    EXPECT_LT(mag(all.centre()), 1e-14);
    EXPECT_NEAR(shape.sphericity(), all.sphericity(), 1e-12);
    EXPECT_NEAR(sqr(shape.gyration()), tr(all.inertia())/(3*V), 1e-12*sqr(0.03));
}


TEST_P(clumpPacking, reachesTheSolidFractionWithoutOverlap)
{
    for (const std::string periodic : {"", "x y", "x y z"})
    {
        const auto packing = model
        (
            box + "solidFraction 0.5; periodic (" + periodic + "); clump "
          + GetParam()
        );
        const packedGrains clumps(packing->make("/tmp"));
        const scalar one = pi/6*pow3(0.03)/0.015;

        EXPECT_NEAR(clumps.solidVolume()/0.015, 0.5, 0.51*one);
        EXPECT_EQ(clumps.orientation.size(), clumps.size());
        EXPECT_GE(leastGap(*packing, clumps), 0) << periodic;
        if (periodic != "x y z")
        {
            EXPECT_LE(inTheWalls(*packing, clumps), 0) << periodic;
        }
        const dictionary reached(packing->properties(clumps));
        EXPECT_EQ(reached.get<scalar>("largestOverlap"), 0);
        EXPECT_LE(reached.get<scalar>("highestGrain"), periodic == "x y z" ? 0.27 : 0.25);
    }
}


INSTANTIATE_TEST_SUITE_P
(
    ofEachShape,
    clumpPacking,
    ::testing::Values
    (
        "cube8;", "tetra4;", "rod3;",
        "cobble; spheres (((1 0 0) 2) ((-1 1 0) 1.5) ((0 -1 2) 1));"
    )
);


TEST(clumpPacking, largestOverlapIsThatOfTheSpheres)
{
    const auto packing = model(box + "solidFraction 0.01; clump rod3;");
    const clumpShape& shape = *packing->clump();
    packedGrains two;
    two.position = pointField({point(0.1, 0.1, 0.1), point(0.1, 0.1, 0.1)});
    two.position[1].z() += 1.5*shape.radii()[0];
    two.orientation = List<quaternion>(2, quaternion(1));
    two.diameter = scalarField(2, 0.03);
    two.setMaterial(2650, 1);
    const dictionary reached(packing->properties(two));

    // Side by side, a quarter of the diameter of the spheres in each other
    EXPECT_NEAR(reached.get<scalar>("largestOverlap"), 0.25, 1e-12);
    const scalar top = two.position[1].z() + shape.radii()[0];
    EXPECT_NEAR(reached.get<scalar>("highestGrain"), top, 1e-14);
}


TEST(clumpPacking, pairsAreSeenOverSidesThatRepeatHoweverFarASphereIsBeyond)
{
    FixedList<bool, 3> periodic(false);
    periodic[0] = true;
    const packingBox one(boundBox(Zero, vector::one), periodic);
    const pointField p({point(1.6, 0.5, 0.5), point(-0.3, 0.5, 0.5)});
    const scalarField d(2, 0.2);
    const auto pairs = pairsOfBodies(one, p, d, labelList({0, 1}), 0);

    ASSERT_EQ(pairs.size(), 1);
    const label i = pairs[0].first, j = pairs[0].second;
    EXPECT_NEAR(mag(p[j] + pairs[0].shift - p[i]), 0.1, 1e-12);

    // Of one body: not where it is, but its image
    EXPECT_EQ(pairsOfBodies(one, p, d, labelList({0, 0}), 0).size(), 1);
    const pointField near({point(0.5, 0.5, 0.5), point(0.6, 0.5, 0.5)});
    EXPECT_EQ(pairsOfBodies(one, near, d, labelList({0, 0}), 0).size(), 0);
}


TEST(clumpPacking, orientationsAreOfAllDirections)
{
    const auto packing = model
    (
        "type dense; box (0 0 0) (0.4 0.4 0.4); periodic (x y z);"
        " solidFraction 0.4; clump rod3;"
    );
    const packedGrains clumps(packing->make("/tmp"));
    symmTensor mean(Zero);
    for (const quaternion& q : clumps.orientation)
    {
        EXPECT_NEAR(mag(q), 1, 1e-12);
        mean += sqr(q.R() & vector(1, 0, 0))/clumps.size();
    }
    ASSERT_GT(clumps.size(), 1500);
    EXPECT_LT(mag(mean - symmTensor::I/3), 0.05);
}


TEST(clumpPacking, isTheSameForTheSameSeedAndAnotherForAnotherSeed)
{
    const std::string entries = box + "solidFraction 0.4; clump tetra4; seed ";
    const packedGrains a(model(entries + "7;")->make("/tmp"));
    const packedGrains b(model(entries + "7;")->make("/tmp"));
    const packedGrains c(model(entries + "8;")->make("/tmp"));

    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.orientation, b.orientation);
    EXPECT_NE(a.position, c.position);
    EXPECT_NE(a.orientation, c.orientation);
}


TEST(clumpPacking, isKeptWithItsOrientations)
{
    const temporaryFolder folder;
    setEnv("INTERDEMFOAM_CACHE", fileName(folder), true);
    const auto packing = model(box + "solidFraction 0.3; clump cube8;");
    const packedGrains made(packingCache::obtain(*packing));
    const packedGrains kept(packingCache::obtain(*packing));
    unsetenv("INTERDEMFOAM_CACHE");

    EXPECT_EQ(kept.position, made.position);
    EXPECT_EQ(kept.orientation, made.orientation);
}


TEST(clumpPacking, namesTheLargestSolidFraction)
{
    const std::string narrow = "type dense; box (0 0 0) (0.05 0.05 0.2);";
    expectComplaint(narrow + "solidFraction 0.62; clump cube8;", "largest one reached");
}


TEST(clumpPacking, anErrorNamesTheWrongEntry)
{
    const std::string half = box + "solidFraction 0.5; ";

    expectComplaint(half + "clump cube9;", "cube8, tetra4, rod3 and cobble");
    expectComplaint(half + "clump cobble;", "clump cobble; spheres (((");
    expectComplaint(half + "clump cube8; spheres (((0 0 0) 1));", "of no other");
    expectComplaint(half + "clump cobble; spheres (((0 0 0) 1));", "two spheres");
    expectComplaint
    (
        half + "clump cobble; spheres (((0 0 0) 1) ((1 0 0) 0));", "above zero"
    );
    expectComplaint(half + "spheres (((0 0 0) 1));", "spheres without clump");
    expectComplaint
    (
        "type dense; box (0 0 0) (0.3 0.3 0.04); solidFraction 0.5; clump rod3;",
        "too small"
    );
    expectComplaint
    (
        "type settled; box (0 0 0) (0.6 0.1 0.05); clump rod3; contact"
        " { youngsModulus 5e6; poissonsRatio 0.3; restitution 0.4; friction 0.7;"
        " rollingFriction 0.1; }",
        "Write type dense"
    );
}


TEST(clumpPacking, hasOneSize)
{
    IStringStream is
    (
        box + "density 1; solidFraction 0.5; clump rod3; diameters ((0.03 1));"
    );
    const dictionary dict(is);
    try
    {
        packingModel::New(dict, vector(Zero));
        FAIL();
    }
    catch (const Foam::error& e)
    {
        const std::string text(e.message());
        EXPECT_NE(text.find("one size only"), std::string::npos) << text;
    }
}
