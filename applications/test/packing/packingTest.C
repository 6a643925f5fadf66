// SPDX-License-Identifier: GPL-3.0-or-later
// Packings: no overlaps, the requested masses, the same packing from the same seed.

#include "densePacking.H"
#include "grainContacts.H"
#include "grainsData.H"
#include "overlapRelaxation.H"
#include "packingCache.H"
#include "settledPacking.H"
#include "temporaryFolder.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace Foam;

namespace
{

const vector down(0, 0, -9.81);


FixedList<bool, 3> periodicIn(const bool x, const bool y, const bool z)
{
    FixedList<bool, 3> periodic(false);
    periodic[0] = x;
    periodic[1] = y;
    periodic[2] = z;
    return periodic;
}


autoPtr<packingModel> model(const std::string& entries, const vector& g = down)
{
    IStringStream is(entries + " density 2650;");
    return packingModel::New(dictionary(is), g);
}


//- Pairs within the gap, image by image, in the simplest way there is
label pairsByComparingAll
(
    const packingBox& box,
    const pointField& p,
    const scalarField& d,
    const scalar gap
)
{
    label n = 0;
    const vector span = box.span();

    for (label i = 0; i < p.size(); ++i)
    {
        for (label j = 0; j < p.size(); ++j)
        {
            for (label k = -8; k <= 8; ++k)
            {
                const bool self = i == j && k == 0;
                const vector r = p[j] + k*vector(0, span.y(), 0) - p[i];
                n += !self && mag(r) < 0.5*(d[i] + d[j]) + gap;
            }
        }
    }
    return n/2;
}


//- Largest overlap over diameter, 0 for none
void expectClear
(
    const packingModel& packing,
    const packedGrains& grains,
    const scalar bound = 0
)
{
    EXPECT_LE
    (
        largestOverlap(packing.box(), grains.position, grains.diameter),
        bound
    );
}

} // End anonymous namespace


TEST(packing, findsTheSamePairsAsComparingAllWithAll)
{
    Random random(3);
    pointField p(60);
    scalarField d(60);
    forAll(p, i)
    {
        p[i] = cmptMultiply(random.sample01<vector>(), vector(3, 1.2, 2));
        d[i] = 0.2 + 0.8*random.sample01<scalar>();
    }
    const packingBox box
    (
        boundBox(Zero, vector(3, 1.2, 2)),
        periodicIn(false, true, false)
    );

    const label expected = pairsByComparingAll(box, p, d, 0.3);
    ASSERT_GT(expected, 100);
    EXPECT_EQ(pairsWithin(box, p, d, 0.3).size(), expected);
}


TEST(packing, overlapIsOneLessDistanceOverMeanDiameterAndCountsWalls)
{
    const packingBox box
    (
        boundBox(Zero, vector(1, 1, 1)),
        periodicIn(true, false, false)
    );
    const scalarField d(2, 0.2);
    pointField acrossTheSide(2);
    acrossTheSide[0] = point(0.05, 0.5, 0.5);
    acrossTheSide[1] = point(0.9, 0.5, 0.5);
    EXPECT_NEAR(largestOverlap(box, acrossTheSide, d), 0.25, 1e-12);

    pointField inTheWall(2, point(0.5, 0.5, 0.5));
    inTheWall[1] = point(0.2, 0.08, 0.5);
    EXPECT_NEAR(largestOverlap(box, inTheWall, d), 0.1, 1e-12);
}


class packingFraction
:
    public ::testing::TestWithParam<double>
{};


TEST_P(packingFraction, isReachedWithoutOverlapInAPeriodicBox)
{
    const auto packing = model
    (
        "type dense; box (0 0 0) (0.3 0.3 0.3); periodic (x y z);"
        " diameter 0.03; solidFraction " + std::to_string(GetParam()) + ";"
    );
    const packedGrains grains(packing->make("/tmp"));

    expectClear(*packing, grains);
    const scalar oneGrain = M_PI/6*pow3(0.1);
    EXPECT_NEAR(grains.solidVolume()/0.027, GetParam(), 0.51*oneGrain);
}


TEST_P(packingFraction, isReachedBetweenWallsSevenAndAHalfDiametersApart)
{
    const auto packing = model
    (
        "type dense; box (0 0 0) (0.5 0.3 0.57); diameter 0.04;"
        " solidFraction " + std::to_string(GetParam()) + ";"
    );
    const packedGrains grains(packing->make("/tmp"));

    expectClear(*packing, grains, 1e-3);
    EXPECT_NEAR(grains.solidVolume()/0.0855, GetParam(), 4e-4);
}


INSTANTIATE_TEST_SUITE_P
(
    from40to62Percent,
    packingFraction,
    ::testing::Values(0.40, 0.50, 0.55, 0.62)
);


TEST(packing, holdsTheMassOfGrainsAndWaterToRoundOff)
{
    const auto packing = model
    (
        "type dense; foot (0 0) (0.5 0.3); base 0.06; diameter 0.04;"
        " mass 185; fluidDensity 1000; solidFraction 0.55;"
    );
    const packedGrains grains(packing->make("/tmp"));
    const dictionary reached(packing->properties(grains));

    expectClear(*packing, grains);
    EXPECT_EQ(grains.size(), 1592);
    EXPECT_NEAR(reached.get<scalar>("mass"), 185, 1e-9);
    EXPECT_NEAR(reached.get<scalar>("solidFraction"), 0.55, 5e-4);
    EXPECT_NEAR(reached.get<scalar>("height"), 0.6466, 5e-4);
    EXPECT_DOUBLE_EQ(packing->box().bounds().min().z(), 0.06);
}


TEST(packing, givesEachSizeItsShareOfTheMass)
{
    const auto packing = model
    (
        "type dense; box (0 0 0) (0.3 0.3 0.3); solidFraction 0.58;"
        " diameters ((0.02 0.3) (0.03 0.7)); periodic (x);"
    );
    const packedGrains grains(packing->make("/tmp"));
    expectClear(*packing, grains);

    scalar small = 0;
    for (const scalar d : grains.diameter)
    {
        small += d < 0.025 ? pow3(d) : 0;
    }
    EXPECT_NEAR(small/sum(pow3(grains.diameter)), 0.3, 1e-3);
}


TEST(packing, fillsAPeriodicSliceOneAndAHalfDiametersWide)
{
    const auto packing = model
    (
        "type dense; box (0 0 0) (0.5 0.06 0.6); periodic (y);"
        " diameter 0.04; solidFraction 0.55;"
    );
    expectClear(*packing, packing->make("/tmp"));
}


TEST(packing, isTheSameForTheSameSeedAndAnotherForAnotherSeed)
{
    const std::string entries =
        "type dense; box (0 0 0) (0.2 0.2 0.2); diameter 0.02;"
        " solidFraction 0.5; seed ";
    const pointField a(model(entries + "7;")->make("/tmp").position);
    const pointField b(model(entries + "7;")->make("/tmp").position);
    const pointField c(model(entries + "8;")->make("/tmp").position);

    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
}


TEST(packing, dataFileGivesBackEveryBit)
{
    const auto packing = model
    (
        "type dense; box (0 0 0) (0.2 0.2 0.2); diameter 0.03;"
        " solidFraction 0.4; material 2;"
    );
    const packedGrains grains(packing->make("/tmp"));

    const temporaryFolder folder;
    const fileName file(fileName(folder)/"grains.data");
    writeGrainsData(file, grains, packing->box().bounds(), "Test");
    packedGrains again;
    ASSERT_TRUE(readGrainsData(file, again));

    EXPECT_EQ(again.position, grains.position);
    EXPECT_EQ(again.diameter, grains.diameter);
    EXPECT_EQ(again.density, grains.density);
    EXPECT_EQ(again.material, grains.material);

    // Room for a material that no grain has
    for (const label materials : {1, 3})
    {
        writeGrainsData
        (
            file, grains, packing->box().bounds(), "Test", materials
        );
        std::ifstream is(file);
        const std::string all{std::istreambuf_iterator<char>(is), {}};
        const char* types = materials == 1 ? "\n2 atom types" : "\n3 atom types";
        EXPECT_NE(all.find(types), std::string::npos);
    }
}


TEST(packing, aDataFileCutShortIsNotTaken)
{
    const temporaryFolder folder;
    const fileName file(fileName(folder)/"grains.data");
    {
        std::ofstream os(file);
        os << "Test\n\n2 atoms\n1 atom types\n\nAtoms\n\n1 1 0.1 2650 0 0 0\n";
    }
    packedGrains grains;
    EXPECT_FALSE(readGrainsData(file, grains));
    EXPECT_FALSE(readGrainsData(file + ".absent", grains));
}


TEST(packing, isKeptAndFoundByWhatItDependsOn)
{
    const temporaryFolder folder;
    setEnv("INTERDEMFOAM_CACHE", fileName(folder), true);

    const std::string entries =
        "type dense; box (0 0 0) (0.2 0.2 0.2); diameter 0.03; solidFraction ";
    const auto packing = model(entries + "0.40;");
    const packedGrains made(packingCache::obtain(*packing));
    EXPECT_TRUE(isFile(packingCache::folder(*packing)/"grains.data"));

    const packedGrains kept(packingCache::obtain(*model(entries + "0.4;")));
    EXPECT_EQ(kept.position, made.position);
    EXPECT_NE
    (
        packingCache::folder(*packing),
        packingCache::folder(*model(entries + "0.41;"))
    );
    unsetenv("INTERDEMFOAM_CACHE");
}


TEST(packing, settledBedIsLevelAndAtRestOnTheSlope)
{
    const vector g = 9.81*vector(0.342, 0, -0.9397);
    const auto packing = model
    (
        "type settled; box (0 0 0) (0.6 0.1 0.05); periodic (y);"
        " diameter 0.01; tileLength 0.15; contact { youngsModulus 5e6;"
        " poissonsRatio 0.3; restitution 0.4; friction 0.7;"
        " rollingFriction 0.1; }",
        g
    );
    const temporaryFolder folder;
    const packedGrains grains(packing->make(folder));
    const dictionary reached(packing->properties(grains));

    EXPECT_LE(reached.get<scalar>("highestGrain"), 0.05);
    EXPECT_GT(reached.get<scalar>("highestGrain"), 0.049);
    EXPECT_GT(reached.get<scalar>("innerSolidFraction"), 0.54);
    EXPECT_LT(reached.get<scalar>("innerSolidFraction"), 0.62);

    // The weight of the bed presses soft grains into each other
    EXPECT_GT(reached.get<scalar>("largestOverlap"), 0);
    EXPECT_LT(reached.get<scalar>("largestOverlap"), 0.03);
}
