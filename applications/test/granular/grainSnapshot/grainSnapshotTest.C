// SPDX-License-Identifier: GPL-3.0-or-later
// The cloud of grains in the time folders.

#include "grainSnapshot.H"
#include "testMesh.H"
#include "testNumber.H"

#include "OSspecific.H"
#include "volFields.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A grain in the middle of each cell but the first of this rank
grainSnapshot oneInEachCell(const fvMesh& mesh, labelList& cells)
{
    grainSnapshot grains(mesh.nCells() - 1);
    cells.setSize(grains.size());

    forAll(cells, i)
    {
        cells[i] = i + 1;
        grains.id[i] = 1000*Pstream::myProcNo() + i;
        grains.type[i] = 1 + i % 2;
        grains.clump[i] = i % 3;
        grains.position[i] = mesh.C()[i + 1] + vector(0.01, 0.02, -0.03);
        grains.U[i] = vector(i, 2*i, 3);
        grains.omega[i] = vector(0, i, 1);
        grains.d[i] = 0.001*i;
        grains.mass[i] = 0.1 + i;
        grains.force[i] = vector(i, 0, 0);
        grains.contactForce[i] = vector(0, i, 0);
        grains.stressMoment[i] = symmTensor(i, 1, 2, 3, 4, 5);
    }

    grains.share = 0.3*scalarField(grains.size(), 1);
    grains.clumpDiameter = scalarField(grains.size(), 0.07);
    grains.orientation = 0.01*grains.U;
    grains.axes = vectorField(grains.size(), vector(0.1, 0.2, 0.3));

    const vectorField wall(grains.size(), vector(0, 0, 7));
    grains.wallForce.insert("zMin", wall);
    return grains;
}


void expectEqual(const grainSnapshot& a, const grainSnapshot& b)
{
    ASSERT_EQ(a.size(), b.size());
    const auto expectSame = [&](const char* name, const auto member)
    {
        EXPECT_EQ(a.*member, b.*member) << name;
    };
    grainSnapshot::forEachField(expectSame);
    grainSnapshot::forEachClumpField(expectSame);
    EXPECT_EQ(a.wallForce.sortedToc(), b.wallForce.sortedToc());

    for (const word& wall : a.wallForce.sortedToc())
    {
        EXPECT_EQ(a.wallForce[wall], b.wallForce[wall]);
    }

    scalar moved = 0;
    forAll(a.position, i)
    {
        moved = max(moved, mag(a.position[i] - b.position[i]));
    }
    testNumber("largest change of a position [m]", moved);
    EXPECT_LT(moved, 1e-12);
}

} // End anonymous namespace


TEST(grainSnapshot, whatIsWrittenIsReadAgain)
{
    testMesh box;
    labelList cells;
    const grainSnapshot grains(oneInEachCell(box.mesh(), cells));

    ASSERT_TRUE(grains.write(box.mesh(), cells));
    expectEqual(grains, *grainSnapshot::read(box.mesh()));
}


TEST(grainSnapshot, aTimeWithoutCloudHasNoGrains)
{
    testMesh box;
    EXPECT_EQ(grainSnapshot::New(box.mesh())->size(), 0);
}


TEST(grainSnapshot, aGrainOutsideTheMeshIsAnErrorWithItsId)
{
    testMesh box;
    labelList cells;
    const grainSnapshot grains(oneInEachCell(box.mesh(), cells));
    cells[5] = -1;

    try
    {
        grains.write(box.mesh(), cells);
        FAIL() << "no error";
    }
    catch (const Foam::error& err)
    {
        EXPECT_NE(err.message().find("Grain 5 "), std::string::npos)
            << err.message();
    }
}


TEST(grainSnapshot, anIncompleteCloudIsAnError)
{
    testMesh box;
    labelList cells;
    const grainSnapshot grains(oneInEachCell(box.mesh(), cells));
    ASSERT_TRUE(grains.write(box.mesh(), cells));

    const fileName folder(box.mesh().time().timePath()/"lagrangian"/"grains");
    ASSERT_TRUE(rm(folder/"mass"));
    EXPECT_THROW(grainSnapshot::read(box.mesh()), Foam::error);
}


TEST(grainSnapshot, aFolderThatCannotBeWrittenIsNoticed)
{
    testMesh box;
    labelList cells;
    const grainSnapshot grains(oneInEachCell(box.mesh(), cells));

    // A folder stands where the file should be
    const fileName folder(box.mesh().time().timePath()/"lagrangian"/"grains");
    mkDir(folder/"mass");
    EXPECT_FALSE(grains.write(box.mesh(), cells));
}


TEST(ParallelGrainSnapshot, eachRankReadsItsOwnGrains)
{
    testMesh box;
    labelList cells;
    grainSnapshot grains(oneInEachCell(box.mesh(), cells));

    // The last rank touches no wall and does not know it
    if (Pstream::myProcNo() == Pstream::nProcs() - 1)
    {
        grains.wallForce.clear();
    }
    ASSERT_TRUE(grains.write(box.mesh(), cells));

    auto again = grainSnapshot::read(box.mesh());
    ASSERT_TRUE(again->wallForce.found("zMin"));
    EXPECT_EQ(again->wallForce["zMin"].size(), again->size());

    grains.wallForce.clear();
    again->wallForce.clear();
    expectEqual(grains, *again);
}


TEST(ParallelGrainSnapshot, aRankMayHaveNoGrains)
{
    testMesh box;
    labelList cells;
    grainSnapshot grains(oneInEachCell(box.mesh(), cells));

    if (!Pstream::master())
    {
        grains = grainSnapshot(0);
        cells.clear();
    }

    ASSERT_TRUE(grains.write(box.mesh(), cells));
    EXPECT_EQ(grainSnapshot::read(box.mesh())->size(), grains.size());
}
