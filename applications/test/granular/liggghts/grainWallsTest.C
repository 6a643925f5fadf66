// SPDX-License-Identifier: GPL-3.0-or-later
// Walls of the grains made from wall patches: planes where a patch is in a side of the
// mesh's box, room for all of it.

#include "liggghtsInstance.H"
#include "liggghtsWalls.H"
#include "testMesh.H"
#include "wallTriangles.H"

#include "ListOps.H"
#include "unitConversion.H"

#include <gtest/gtest.h>
#include <liggghts/domain.h>
#include <liggghts/lammps.h>

#include <fstream>

using namespace Foam;

namespace
{

using wallTriangles::corners;


//- A box, corners of which can be moved, and LIGGGHTS with walls made from it
class walledBox
{
    testMesh box_;

    const fileName script_;

    autoPtr<liggghtsInstance> liggghts_;

    autoPtr<liggghtsWalls> walls_;

public:

    explicit walledBox(const testBox& box = testBox())
    :
        box_(box),
        script_(box_.folder()/"physics")
    {
        std::ofstream(script_)
            << "pair_style gran model hertz tangential history\n";
    }

    fvMesh& mesh()
    {
        return box_.mesh();
    }

    //- Move all corners; way gives by how much one at p does
    template<class Way>
    void move(const Way& way)
    {
        pointField points(mesh().points());
        for (point& p : points)
        {
            p += way(p);
        }
        mesh().movePoints(points);
    }

    liggghtsWalls& walls()
    {
        if (!walls_)
        {
            walls_.reset(new liggghtsWalls(mesh(), dictionary(), script_));
        }
        return *walls_;
    }

    labelList sides(const word& patch)
    {
        return walls().sides(mesh().boundaryMesh()[patch]);
    }

    //- LIGGGHTS with a box of those ends; it goes as far as the first step
    LAMMPS_NS::LAMMPS& start(const boundBox& ends)
    {
        liggghts_.reset(new liggghtsInstance(box_.folder()/"log.liggghts"));

        std::ostringstream region;
        region.precision(17);
        region << "region tank block";
        for (direction k = 0; k < 3; ++k)
        {
            region << ' ' << ends.min()[k] << ' ' << ends.max()[k];
        }

        for
        (
            const std::string& line : std::initializer_list<std::string>
            {
                "units si", "atom_style granular", "atom_modify map array",
                "newton off", "communicate single vel yes", "boundary f f f",
                region.str() + " units box", "create_box 1 tank",
                "neighbor 0.05 bin",
                "fix y all property/global youngsModulus peratomtype 5e6",
                "fix p all property/global poissonsRatio peratomtype 0.3",
                "fix r all property/global coefficientRestitution"
                " peratomtypepair 1 0.4",
                "fix f all property/global coefficientFriction"
                " peratomtypepair 1 0.7",
                "create_atoms 1 single 0.5 0.5 0.5 units box",
                "set group all diameter 0.1 density 2650",
                "pair_style gran model hertz tangential history",
                "pair_coeff * *", "timestep 1e-5", "fix move all nve/sphere"
            }
        )
        {
            liggghts_->command(line);
        }

        walls().enlargeBox(*liggghts_);
        walls().add(*liggghts_);
        liggghts_->setup();
        liggghts_->run(1);

        return **liggghts_;
    }
};


//- Of the triangles of the faces of a patch [rad]
scalar smallestAngleOf(const polyPatch& patch)
{
    scalar smallest = GREAT;
    for (const wallTriangles::corners& face : wallTriangles::faces(patch))
    {
        scalar angle;
        wallTriangles::best(face, angle);
        smallest = min(smallest, angle);
    }
    return smallest;
}


//- The message of the error that comes of making triangles of the patch; empty for
//  none
std::string complaint(const polyPatch& patch)
{
    try
    {
        scalar angle;
        wallTriangles::of(patch.name(), wallTriangles::faces(patch), angle);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return std::string();
}

} // End anonymous namespace


TEST(GrainWalls, faceTooThinForLIGGGHTSNamesPatchAndPlace)
{
    // Sides of 0.25 and 0.125 m wide cells, one layer of which has 0.2 mm
    testBox shape;
    shape.cells = labelVector(4, 4, 1);
    shape.span = vector(1, 1, 2e-4);

    walledBox box(shape);
    const polyBoundaryMesh& patches = box.mesh().boundaryMesh();

    // Half a face is 0.2 mm by 0.25 m
    EXPECT_NEAR(smallestAngleOf(patches["xMax"]), 2e-4/0.25, 1e-9);
    EXPECT_GT(smallestAngleOf(patches["zMax"]), wallTriangles::smallestTaken);
    EXPECT_EQ(complaint(patches["zMax"]), "");

    const std::string output(complaint(patches["xMax"]));
    EXPECT_NE(output.find("wall xMax, at (1 "), std::string::npos) << output;
    EXPECT_NE(output.find("LIGGGHTS/walls/patches"), std::string::npos) << output;
}


TEST(GrainWalls, sidesMovedBySnappingStayPlanes)
{
    walledBox box;
    const auto noise = [](const point& p)
    {
        return 1e-4*vector(std::sin(70*p.y()), std::sin(90*p.z()), std::sin(80*p.x()));
    };
    box.move(noise);

    for (label side = 0; side < 6; ++side)
    {
        EXPECT_EQ
        (
            box.sides(box.mesh().boundaryMesh()[side].name()),
            labelList(1, side)
        );
    }
}


TEST(GrainWalls, sideThatBulgesIsASurface)
{
    walledBox box;
    box.move([](const point& p)
    {
        return vector(p.x() > 0.99 && mag(p.y() - 0.5) < 0.1 ? 0.01 : 0, 0, 0);
    });

    EXPECT_TRUE(box.sides("xMax").empty());
    EXPECT_EQ(box.sides("xMin"), labelList(1, label(0)));

    // Wider than the others by the bulge, and still in its side
    EXPECT_EQ(box.sides("zMin"), labelList(1, label(4)));
}


TEST(GrainWalls, planesCloseNoOpening)
{
    // The wall zMin rises to the middle and stays there; beyond, zMax is open and
    // so no wall is in the way
    testBox shape;
    shape.patches[5] = "patch";
    walledBox box(shape);
    EXPECT_EQ(box.sides("zMin"), labelList(1, label(4)));

    // An opening that looks down, above the floor
    shape.patches[1] = "patch";
    walledBox sloped(shape);
    sloped.move([](const point& p)
    {
        return vector(p.x() > 0.9 ? -0.4*(1 - p.z()) : 0, 0, 0);
    });
    EXPECT_TRUE(sloped.sides("zMin").empty());
    EXPECT_EQ(sloped.sides("xMin"), labelList(1, label(0)));
}


TEST(GrainWalls, boxOfLIGGGHTSHoldsAllSurfaces)
{
    walledBox box;
    box.move([](const point& p)
    {
        return vector(p.x() > 0.99 ? 0.02 + 0.01*std::sin(9*p.y()) : 0, 0, 0);
    });

    // LIGGGHTS would stop at triangles outside of the box that the script gives
    const LAMMPS_NS::Domain& domain =
        *box.start(boundBox(point(0, 0, 0), point(1, 1, 1))).domain;

    EXPECT_TRUE(box.walls().surfaces().found("xMax"));
    EXPECT_GE(domain.boxhi[0], box.mesh().bounds().max().x());
    EXPECT_EQ(domain.boxlo[0], 0);
    EXPECT_EQ(domain.boxhi[1], 1);
}


TEST(GrainWalls, LIGGGHTSTakesAllThatPassesTheCheckOfAngles)
{
    // Faces 700 times as long as wide; left to itself LIGGGHTS stops at 224 times
    testBox shape;
    shape.cells = labelVector(4, 4, 4);
    shape.span = vector(4, 4, 4./700);
    walledBox box(shape);
    box.move([](const point& p)
    {
        return vector(p.x() > 2.5 && p.y() > 2.5 ? 0.1 : 0, 0, 0);
    });

    ASSERT_TRUE(box.sides("xMax").empty());
    box.start(boundBox(point(0, 0, 0), point(4, 4, 4)));
    EXPECT_TRUE(box.walls().surfaces().found("xMax"));
}


TEST(ParallelGrainWalls, areThoseOfOneRank)
{
    walledBox box;
    box.move([](const point& p)
    {
        return vector(0, 0, p.z() > 0.99 && mag(p.y() - 0.5) < 0.1 ? 0.02 : 0);
    });

    // The last rank has no face of xMin, the middle ones only of the sides
    EXPECT_EQ(box.sides("xMin"), labelList(1, label(0)));
    EXPECT_EQ(box.sides("yMin"), labelList(1, label(2)));
    EXPECT_TRUE(box.sides("zMax").empty());

    const List<corners> faces
    (
        wallTriangles::faces(box.mesh().boundaryMesh()["zMax"])
    );
    EXPECT_EQ(faces.size(), Pstream::master() ? 16 : 0);
}
