// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres near a sphere, and skins: no pair is missed, and memory is bounded.

#include "grainSkins.H"
#include "hierarchicalGrid.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace Foam;

namespace
{

//- Spheres in a box, with radii from 1 to the ratio, as many in each octave
struct spheres
{
    std::vector<double> x, radius;

    spheres(const int n, const double ratio, const double box, const double origin)
    {
        std::mt19937 numbers(20);
        std::uniform_real_distribution<double> part(0, 1);

        for (int i = 0; i < n; ++i)
        {
            for (int d = 0; d < 3; ++d)
            {
                x.push_back(origin + box*part(numbers));
            }
            radius.push_back(std::pow(ratio, part(numbers)));
        }
    }

    int size() const
    {
        return int(radius.size());
    }

    double gap(const int i, const int j) const
    {
        double squared = 0;
        for (int d = 0; d < 3; ++d)
        {
            squared += std::pow(x[3*i + d] - x[3*j + d], 2);
        }
        return std::sqrt(squared) - radius[i] - radius[j];
    }
};


//- Pairs that a grid does not find, and those it finds though they are far apart
void expectAllPairs(const spheres& s, const double box)
{
    hierarchicalGrid grid;
    grid.set(s.x.data(), s.radius.data(), s.size());
    int nPairs = 0;

    for (int i = 0; i < s.size(); ++i)
    {
        const auto near = grid.overlapsAbove(i);
        std::vector<int> sorted(near.first, near.first + near.size);
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
        nPairs += near.size;

        for (int j = 0; j < s.size(); ++j)
        {
            const bool isFound = std::binary_search(sorted.begin(), sorted.end(), j);
            const double gap = s.gap(i, j);

            if (j <= i || gap > 1e-6*box)
            {
                EXPECT_FALSE(isFound) << i << ' ' << j << " gap " << gap;
            }
            else if (gap <= 0)
            {
                EXPECT_TRUE(isFound) << i << ' ' << j << " gap " << gap;
            }
        }
    }

    EXPECT_GT(nPairs, s.size()/2);
}

} // End anonymous namespace


TEST(hierarchicalGrid, findsEachPairOnce)
{
    for (const double ratio : {1., 2., 20.})
    {
        for (const double origin : {0., -1000.})
        {
            const double box = 15*ratio;
            expectAllPairs(spheres(3000, ratio, box, origin), box);
        }
    }
}


// Single precision has 1e-4 of a radius there
TEST(hierarchicalGrid, findsPairsThatHardlyTouch)
{
    std::mt19937 numbers(3);
    std::uniform_real_distribution<double> part(0, 1);
    spheres s(0, 1, 1, 0);
    const int nPairs = 2000;

    for (int k = 0; k < nPairs; ++k)
    {
        const double x = 1000*part(numbers), y = 1000*part(numbers);
        const double r = 0.5 + 0.5*part(numbers);
        const double angle = 6.28*part(numbers), apart = (r + 1)*(1 - 1e-12);
        s.x.insert(s.x.end(), {x, y, 10.0*k});
        s.x.insert
        (
            s.x.end(),
            {x + apart*std::cos(angle), y + apart*std::sin(angle), 10.0*k}
        );
        s.radius.insert(s.radius.end(), {r, 1});
    }

    hierarchicalGrid grid;
    grid.set(s.x.data(), s.radius.data(), s.size());
    int nFound = 0;
    for (int k = 0; k < nPairs; ++k)
    {
        nFound += grid.overlapsAbove(2*k).size;
    }
    EXPECT_EQ(nFound, nPairs);
}


TEST(hierarchicalGrid, hasNoPairsWithoutSpheres)
{
    hierarchicalGrid grid;
    grid.set(nullptr, nullptr, 0);

    const double x[] = {1, 2, 3};
    const double radius[] = {0.5};
    grid.set(x, radius, 1);
    EXPECT_EQ(grid.overlapsAbove(0).size, 0);
}


// A thousand beads of metres in a box of 1000 km
TEST(hierarchicalGrid, isBoundedByTheSpheresNotByTheirBox)
{
    spheres few(1000, 4, 1e6, 0);
    hierarchicalGrid grid;
    grid.set(few.x.data(), few.radius.data(), few.size());
    EXPECT_LT(grid.bytes(), 200*few.size());
}


TEST(grainSkins, areWideWhereSomethingFastIsNear)
{
    // A row of grains at rest, 2 m apart, and one that moves at 4 m/s along it
    const int n = 20, fast = 10;
    std::vector<double> x(3*n, 0), v(3*n, 0), radius(n, 0.5), skins;
    for (int i = 0; i < n; ++i)
    {
        x[3*i] = 2*i;
    }
    v[3*fast] = 4;

    const double time = 0.5, least = 0.01, most = 1.5;
    grainSkins().find(x.data(), v.data(), radius.data(), n, time, least, most, skins);

    EXPECT_EQ(skins[fast], most);
    EXPECT_EQ(skins[fast + 1], most);
    EXPECT_EQ(skins[fast - 1], most);
    EXPECT_EQ(skins[0], least);
    EXPECT_EQ(skins[n - 1], least);
}
