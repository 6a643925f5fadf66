// SPDX-License-Identifier: GPL-3.0-or-later
// How a flow that has diverged is seen.

#include "divergence.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(divergence, aVelocityThatIsNoNumberIsFasterThanAny)
{
    const scalar none = std::nan("");
    const scalar infinite = std::numeric_limits<scalar>::infinity();

    EXPECT_EQ(fastestComponent(vector(1, -3, 2)), 3);
    EXPECT_EQ(fastestComponent(vector(0, none, 0)), VGREAT);
    EXPECT_EQ(fastestComponent(vector(none, none, 0)), VGREAT);
    EXPECT_EQ(fastestComponent(vector(0, 0, -infinite)), VGREAT);
}
