// SPDX-License-Identifier: GPL-3.0-or-later
// Where a function is zero: its root, and where it has none between the bounds.

#include "rootBetween.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;


TEST(rootBetween, findsTheRootOfASmoothFunction)
{
    label calls = 0;
    const auto cube = [&calls](const scalar x)
    {
        ++calls;
        return x*x*x - 2;
    };
    EXPECT_NEAR(rootBetween(cube, 0, 10), std::cbrt(2.0), 1e-11);

    // Bisection to 40 bits takes more
    EXPECT_LT(calls, 30);
}


TEST(rootBetween, findsTheRootOfOneThatIsSteepOrJumps)
{
    // As a law with a yield stress: nearly flat, then steep
    const auto steep = [](const scalar x) { return std::pow(x, 15.0) - 1e-20; };
    EXPECT_NEAR(rootBetween(steep, 0, 1), std::pow(1e-20, 1/15.0), 1e-10);

    const auto jump = [](const scalar x) { return x < 0.3 ? -1.0 : 1.0; };
    EXPECT_NEAR(rootBetween(jump, 0, 1), 0.3, 1e-11);
}


TEST(rootBetween, isABoundWhereTheFunctionIsZeroThere)
{
    const auto line = [](const scalar x) { return x - 1; };
    EXPECT_EQ(rootBetween(line, 1, 3), 1);
    EXPECT_EQ(rootBetween(line, -3, 1), 1);
}


TEST(rootBetween, isTheBoundThatIsNearerWhereTheSignStays)
{
    const auto line = [](const scalar x) { return x - 1; };
    EXPECT_EQ(rootBetween(line, 2, 3), 2);
    EXPECT_EQ(rootBetween(line, -3, 0), 0);
}
