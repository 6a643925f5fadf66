// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: the grid of material points.

#include "pointGrid.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(pointGrid, hasACellForEveryPlaceAtTheSeamOfABoxThatIsNearlyWholeCells)
{
    // 30.000003 cells, and 29.999997
    for (const scalar h : {0.003333333, 0.003333333667})
    {
        const pointGrid grid
        (
            boundBox(point(0.1, 0, 0), point(0.2, 0.01, 0.08)),
            h,
            Vector<bool>(true, false, true),
            Vector<bool>(true, false, false)
        );
        const label k = grid.axes()[0] == vector::X ? 0 : 1;

        for (const scalar away : {0.0, 1e-17, 1e-12, 1e-9, 5e-9, 9e-9, 1e-7})
        {
            for (const scalar x : {0.2 - away, 0.2 + away, 0.1 - away, 0.1 + away})
            {
                point p(x, 0, 0.04);
                grid.wrap(p);
                const label cell = pointGrid::cell(grid.coordinate(p, k));

                EXPECT_TRUE(grid.holds(p)) << h << ' ' << away;
                EXPECT_GE(cell, 0) << h << ' ' << away;
                EXPECT_LT(cell, 30) << h << ' ' << away;
            }
        }
    }
}
