// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of wall faces that LIGGGHTS takes.

#include "testMesh.H"
#include "wallTriangles.H"

#include "ListOps.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

#include <set>

using namespace Foam;

namespace
{

using wallTriangles::corners;


//- Area of a triangle of the polygon along z; negative if turned against it
scalar area(const corners& at, const triFace& t)
{
    return 0.5*
    (
        (at[t[1]] - at[t[0]]) ^ (at[t[2]] - at[t[0]])
    ).z();
}


//- Smallest angle of the triangulation [degrees], which must fill the polygon of
//  that area without overlap
scalar smallestAngle(const corners& at, const scalar whole)
{
    scalar angle;
    const List<triFace> triangles(wallTriangles::best(at, angle));
    scalar filled = 0;

    EXPECT_EQ(triangles.size(), at.size() - 2);
    for (const triFace& t : triangles)
    {
        EXPECT_GT(area(at, t), 0) << t[0] << ' ' << t[1] << ' ' << t[2];
        filled += area(at, t);
    }
    EXPECT_NEAR(filled, whole, 1e-12);

    return radToDeg(angle);
}


//- How many triangles have both corners
label withEdge(const List<triFace>& triangles, const label a, const label b)
{
    label n = 0;
    for (const triFace& t : triangles)
    {
        n += t.which(a) >= 0 && t.which(b) >= 0;
    }
    return n;
}

} // End anonymous namespace


TEST(WallTriangles, splitASquareAsAFanFromItsFirstCorner)
{
    const corners square
    {
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)
    };
    scalar angle;
    const List<triFace> triangles(wallTriangles::best(square, angle));

    ASSERT_EQ(triangles.size(), 2);
    EXPECT_EQ(triangles[0], triFace(0, 1, 2));
    EXPECT_EQ(triangles[1], triFace(0, 2, 3));
    EXPECT_NEAR(radToDeg(angle), 45, 1e-9);
}


TEST(WallTriangles, hangingNodesMakeNoTriangleWithoutArea)
{
    // A fan from the first corner has one without area for each node on the two
    // sides that meet there
    const corners all
    {
        point(0, 0, 0), point(0.5, 0, 0), point(1, 0, 0), point(1, 0.5, 0),
        point(1, 1, 0), point(0.5, 1, 0), point(0, 1, 0), point(0, 0.5, 0)
    };
    EXPECT_GT(smallestAngle(all, 1), 26);

    for (label node = 1; node < 8; node += 2)
    {
        corners one;
        forAll(all, i)
        {
            if (i % 2 == 0 || i == node)
            {
                one.append(all[i]);
            }
        }

        // Wherever the face begins
        for (label first = 0; first < one.size(); ++first)
        {
            EXPECT_GT(smallestAngle(one, 1), 26) << node << ' ' << first;
            inplaceRotateList(one, 1);
        }
    }
}


TEST(WallTriangles, meetTheNextFaceAtItsHangingNode)
{
    const corners face
    {
        point(0, 0, 0), point(0.5, 0, 0), point(1, 0, 0), point(1, 1, 0),
        point(0, 1, 0)
    };
    scalar angle;
    const List<triFace> triangles(wallTriangles::best(face, angle));

    EXPECT_EQ(withEdge(triangles, 0, 1), 1);
    EXPECT_EQ(withEdge(triangles, 1, 2), 1);
    EXPECT_EQ(withEdge(triangles, 0, 2), 0);
}


TEST(WallTriangles, fillConcaveFacesWithoutOverlap)
{
    // An L, begun at each of its corners, and a deep notch
    corners L
    {
        point(0, 0, 0), point(2, 0, 0), point(2, 1, 0), point(1, 1, 0),
        point(1, 2, 0), point(0, 2, 0)
    };
    for (label first = 0; first < L.size(); ++first)
    {
        EXPECT_GT(smallestAngle(L, 3), 20) << first;
        inplaceRotateList(L, 1);
    }

    const corners notch
    {
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0.5, 0.1, 0),
        point(0, 1, 0)
    };
    EXPECT_GT(smallestAngle(notch, 0.55), 5);
}


TEST(WallTriangles, twoSidesOfAThinPlateAreOneWall)
{
    const corners square
    {
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)
    };
    const corners behind{square[2], square[1], square[0], square[3]};
    const corners beside
    {
        point(1, 0, 0), point(2, 0, 0), point(2, 1, 0), point(1, 1, 0)
    };
    std::set<corners, wallTriangles::before> others;

    List<corners> faces{square, beside, behind};
    EXPECT_EQ(wallTriangles::dropTwins(faces, others), 1);
    ASSERT_EQ(faces.size(), 2);
    EXPECT_EQ(faces[1], beside);

    // In another patch, too
    List<corners> slave{behind};
    EXPECT_EQ(wallTriangles::dropTwins(slave, others), 1);
    EXPECT_TRUE(slave.empty());
}


TEST(WallTriangles, platesThatMeetTooManyToOneNamePatchAndPlace)
{
    const corners square
    {
        point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)
    };
    const List<vector> ways{vector(0, 0, 1), vector(0, 0, -1), vector(5, 7, 0)};

    for (label nWays = 1; nWays <= 3; ++nWays)
    {
        // On each side of a square one to three others
        List<corners> faces{square};
        for (label i = 0; i < 4; ++i)
        {
            for (label way = 0; way < nWays; ++way)
            {
                const point& a = square[i];
                const point& b = square[(i + 1) % 4];
                faces.append(corners{a, b, b + ways[way], a + ways[way]});
            }
        }

        std::string output;
        try
        {
            scalar angle;
            wallTriangles::of("cross", faces, angle);
        }
        catch (const Foam::error& e)
        {
            output = e.message();
        }

        // Two others on two sides and the other half of the square are five
        EXPECT_EQ(output.empty(), nWays < 3) << nWays << output;
        EXPECT_EQ(output.find("wall cross") != std::string::npos, nWays == 3);
    }
}
