// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: walls of material points that are not on lines of the grid.

#include "testWalls.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Where the walls put a point that is at a place and came from another [m]
vector2D putBack
(
    const pointGrid& grid,
    const pointWalls& walls,
    const vector2D& at,
    const vector2D& from
)
{
    // Its cell is that of where it came from
    const point was(from.x(), 0.05, from.y());
    FixedList<label, 3> cell(0);
    for (label k = 0; k < 2; ++k)
    {
        cell[k] = pointGrid::cell(grid.coordinate(was, k));
    }

    point p(at.x(), 0.05, at.y());
    walls.putBack(p, grid.node(cell));
    return vector2D(p.x(), p.z());
}


//- How far a place is in front of the nearer of two faces that meet in a fold and
//  have these directions from it [m]; negative behind one
scalar beforeBoth
(
    const vector2D& place,
    const vector2D& fold,
    const vector2D& left,
    const vector2D& right
)
{
    const vector2D way(place - fold);
    return min
    (
        left.y()*way.x() - left.x()*way.y(),
        right.x()*way.y() - right.y()*way.x()
    );
}


//- Largest distance of a point from where the walls put it back, of points at
//  a distance [m], negative behind them, on the line from a to b
scalar moved
(
    const pointGrid& grid,
    const pointWalls& walls,
    const vector2D& a,
    const vector2D& b,
    const scalar distance
)
{
    const vector2D along((b - a)/mag(b - a));
    const vector2D normal(-along.y(), along.x());
    scalar most = 0;

    for (scalar s = 0.001; s < mag(b - a); s += 0.0013)
    {
        const vector2D at(a + s*along + distance*normal);

        // From half a cell away, too
        for (const scalar from : {0.0, 0.024})
        {
            const vector2D now(putBack(grid, walls, at, at + from*normal));
            most = max(most, mag(now - at));
            if (distance < 0)
            {
                // In front of the wall again, by no more than a rounding
                EXPECT_GE((now - a) & normal, 0) << at.x() << ' ' << at.y();
                EXPECT_LT((now - a) & normal, 1e-6);
            }
        }
    }

    return most;
}

} // End anonymous namespace


TEST(pointWalls, aPointBehindAnInclinedWallIsPutBack)
{
    for (const scalar angle : {3.0, 10.0, 33.0, 45.0, 71.0})
    {
        const pointGrid grid(slice());
        pointWalls walls(grid);
        const label wall = walls.add("slope", 0);
        const scalar a = angle*M_PI/180;
        const vector2D low(0.1, 0.12);
        const vector2D high(low + 0.8*vector2D(std::cos(a), std::sin(a)));
        addFace(walls, wall, low, high);
        walls.findNodes();

        EXPECT_GT(moved(grid, walls, low, high, -0.01), 0.0099);
        EXPECT_EQ(moved(grid, walls, low, high, 0.001), 0);
    }
}


TEST(pointWalls, aPointBehindAHollowWallIsPutBack)
{
    // An arc of six faces, hollow to the points above it
    const pointGrid grid(slice());
    pointWalls walls(grid);
    const label wall = walls.add("arc", 0);
    List<vector2D> corner(7);
    forAll(corner, i)
    {
        const scalar a = (i - 3)*12*M_PI/180;
        corner[i] = vector2D(0.5, 0.7) + 0.5*vector2D(std::sin(a), -std::cos(a));
    }
    for (label i = 0; i < 6; ++i)
    {
        addFace(walls, wall, corner[i], corner[i + 1]);
    }
    walls.findNodes();

    for (label i = 0; i < 6; ++i)
    {
        EXPECT_EQ(moved(grid, walls, corner[i], corner[i + 1], 0.006), 0);

        // What is behind one face and its neighbour goes in front of both
        const vector2D middle(0.5*(corner[i] + corner[i + 1]));
        const vector2D along(0.3*(corner[i + 1] - corner[i]));
        EXPECT_GT
        (
            moved(grid, walls, middle - along, middle + along, -0.004), 0.0039
        );
    }
}


TEST(pointWalls, aPointInAFoldOfAHollowWallIsPutBackBeforeBothFaces)
{
    for (const scalar turn : {6.0, 12.0, 20.0, 45.0})
    {
        for (const scalar shift : {0.0, 0.011, 0.023, 0.037})
        {
            const pointGrid grid(slice());
            pointWalls walls(grid);
            const label wall = walls.add("arc", 0);
            List<vector2D> corner(7);
            forAll(corner, i)
            {
                const scalar a = (i - 3)*turn*M_PI/180;
                corner[i] =
                    vector2D(0.5 + shift, 0.5 - shift)
                  + 0.4*vector2D(std::sin(a), -std::cos(a));
            }
            for (label i = 0; i < 6; ++i)
            {
                addFace(walls, wall, corner[i], corner[i + 1]);
            }
            walls.findNodes();

            // Of what is a little behind one of the two, or both
            for (label i = 1; i < 6; ++i)
            {
                const vector2D& fold = corner[i];
                const vector2D left((corner[i - 1] - fold)/mag(corner[i - 1] - fold));
                const vector2D right((corner[i + 1] - fold)/mag(corner[i + 1] - fold));
                const vector2D out(fold - vector2D(0.5 + shift, 0.5 - shift));

                for (scalar s = -0.02; s < 0.02; s += 0.0007)
                {
                    const vector2D at
                    (
                        fold + mag(s)*(s < 0 ? left : right)
                      + 0.002*out/mag(out)
                    );
                    const vector2D now(putBack(grid, walls, at, at));
                    EXPECT_GE(beforeBoth(now, fold, left, right), 0)
                        << turn << " degrees, shift " << shift << ", fold " << i
                        << ", " << s << " m from it";
                }
            }
        }
    }
}


TEST(pointWalls, aPointInASharpFoldIsPutBackBeforeBothFaces)
{
    for (const scalar between : {30.0, 60.0, 80.0, 90.0, 120.0})
    {
        const scalar half = between/2*M_PI/180;
        const vector2D fold(0.513, 0.207);
        const vector2D left(-std::sin(half), std::cos(half));
        const vector2D right(std::sin(half), std::cos(half));
        const pointGrid grid(slice());
        pointWalls walls(grid);
        const label wall = walls.add("fold", 0);
        addFace(walls, wall, fold + 0.6*left, fold);
        addFace(walls, wall, fold, fold + 0.6*right);
        walls.findNodes();

        for (scalar s = -0.01; s < 0.01; s += 0.0007)
        {
            const vector2D at(fold + vector2D(s, -0.001));
            const vector2D now(putBack(grid, walls, at, at));
            EXPECT_GE(beforeBoth(now, fold, left, right), -1e-7)
                << between << " degrees, " << s << " m beside it";
            EXPECT_LT(mag(now - fold), 0.05);
        }
    }
}


TEST(pointWalls, aPointBesideAnEdgeThatStandsOutIsLeftAlone)
{
    // A step down at x = 0.53, off the lines of the grid
    const pointGrid grid(slice());
    pointWalls walls(grid);
    const label wall = walls.add("step", 0);
    const vector2D edge(0.53, 0.41);
    addFace(walls, wall, vector2D(0, 0.41), edge);
    addFace(walls, wall, edge, vector2D(0.53, 0));
    walls.findNodes();

    EXPECT_EQ(moved(grid, walls, edge, vector2D(0.53, 0), 0.002), 0);
    EXPECT_EQ(moved(grid, walls, vector2D(0, 0.41), edge, 0.002), 0);
    EXPECT_GT
    (
        moved(grid, walls, vector2D(0.2, 0.41), vector2D(0.45, 0.41), -0.01),
        0.0099
    );
}


TEST(pointWalls, aPointBesideAWallThatBulgesIsLeftAlone)
{
    // Arcs of six faces that bulge to the points above them
    for (const scalar turn : {6.0, 12.0, 20.0})
    {
        const pointGrid grid(slice());
        pointWalls walls(grid);
        const label wall = walls.add("arc", 0);
        List<vector2D> corner(7);
        forAll(corner, i)
        {
            const scalar a = (i - 3)*turn*M_PI/180;
            corner[i] =
                vector2D(0.5, 0.1) + 0.4*vector2D(std::sin(a), std::cos(a));
        }
        for (label i = 0; i < 6; ++i)
        {
            addFace(walls, wall, corner[i], corner[i + 1]);
        }
        walls.findNodes();

        for (label i = 0; i < 6; ++i)
        {
            const vector2D& a = corner[i];
            const vector2D& b = corner[i + 1];
            for (const scalar distance : {0.001, 0.003})
            {
                EXPECT_EQ(moved(grid, walls, a, b, distance), 0)
                    << turn << " degrees, face " << i;
            }
            EXPECT_GT
            (
                moved(grid, walls, 0.7*a + 0.3*b, 0.3*a + 0.7*b, -0.001),
                0.00099
            );
        }
    }
}


TEST(pointWalls, whatIsBehindAWallHasNotLeftThroughTheOutletBesideIt)
{
    // A leaning outlet that ends at a base, both through the same cells
    const vector2D corner(0.513, 0.207);
    const vector2D up(std::sin(0.3), std::cos(0.3));
    const pointGrid grid(slice());
    pointWalls walls(grid);
    const label wall = walls.add("base", 0);
    const label outlet = walls.addOutlet("outlet");
    addFace(walls, wall, corner, corner + vector2D(0.4, 0));
    addFace(walls, outlet, corner + 0.4*up, corner);
    walls.findNodes();

    const auto isBehindOutlet = [&](const vector2D& at)
    {
        const point p(at.x(), 0.05, at.y());
        FixedList<label, 3> cell(0);
        for (label k = 0; k < 2; ++k)
        {
            cell[k] = pointGrid::cell(grid.coordinate(p, k));
        }
        return walls.isBehindOutlet(p, grid.node(cell));
    };

    for (const scalar s : {0.01, 0.02, 0.04})
    {
        EXPECT_FALSE(isBehindOutlet(corner + vector2D(s, -0.005))) << s;
        EXPECT_FALSE(isBehindOutlet(corner + s*up + vector2D(0.005, 0))) << s;
        EXPECT_TRUE(isBehindOutlet(corner + s*up - vector2D(0.005, 0))) << s;
    }
}
