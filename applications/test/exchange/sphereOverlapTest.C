// SPDX-License-Identifier: GPL-3.0-or-later
// Volume of a sphere in cells of any shape, against points thrown at random.

#include "sphereOverlap.H"
#include "otherMeshes.H"
#include "scatteredGrains.H"
#include "testNumber.H"

#include "tetPointRef.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Cells of 1/6 m
testBox box()
{
    testBox b;
    b.cells = labelVector(6, 6, 6);
    return b;
}


scalar volumeOf(const scalar radius)
{
    return 4*constant::mathematical::pi/3*pow3(radius);
}


//- Points spread evenly over a sphere
pointField pointsIn(const label n, const point& centre, const scalar radius)
{
    Random random(7);
    pointField result(n);

    for (point& p : result)
    {
        do
        {
            for (direction k = 0; k < 3; ++k)
            {
                p[k] = 2*random.sample01<scalar>() - 1;
            }
        } while (magSqr(p) > 1);

        p = centre + radius*p;
    }
    return result;
}


//- True for a point in one of the tetrahedra that centre, faces' centres and
//  edges of the cell make
bool inTetrahedra(const polyMesh& mesh, const label cell, const point& p)
{
    const point& middle = mesh.cellCentres()[cell];

    for (const label f : mesh.cells()[cell])
    {
        const face& corners = mesh.faces()[f];

        forAll(corners, i)
        {
            point a(mesh.points()[corners[i]]);
            point b(mesh.points()[corners.nextLabel(i)]);
            if (mesh.faceOwner()[f] != cell)
            {
                std::swap(a, b);
            }
            if (tetPointRef(middle, a, b, mesh.faceCentres()[f]).inside(p))
            {
                return true;
            }
        }
    }
    return false;
}


//- Share of the points in each cell
scalarField sharesOfPoints(const polyMesh& mesh, const pointField& points)
{
    const boundBox around(points, false);
    scalarField result(mesh.nCells(), Zero);

    forAll(result, cell)
    {
        const boundBox bounds
        (
            mesh.cells()[cell].points(mesh.faces(), mesh.points()),
            false
        );

        if (!bounds.overlaps(around))
        {
            continue;
        }
        for (const point& p : points)
        {
            if (bounds.contains(p) && inTetrahedra(mesh, cell, p))
            {
                result[cell] += 1.0/points.size();
            }
        }
    }
    return result;
}


//- Share of a sphere in each cell, by the faces
scalarField sharesOfSphere
(
    const sphereOverlap& overlap,
    const label cell,
    const point& centre,
    const scalar radius
)
{
    DynamicList<sphereOverlap::piece> pieces;
    DynamicList<sphereOverlap::exit> exits;
    pieces.append(sphereOverlap::piece{cell, centre, volumeOf(radius)});
    overlap.flood(radius, 0, pieces, exits);

    scalarField result(overlap.walker().mesh().nCells(), Zero);
    for (const auto& p : pieces)
    {
        result[p.cell] += p.volume/volumeOf(radius);
    }
    return result;
}


label cellByTetrahedra(const polyMesh& mesh, const point& p)
{
    label cell = 0;
    while (cell < mesh.nCells() && !inTetrahedra(mesh, cell, p))
    {
        ++cell;
    }
    return cell;
}


//- Spheres of many sizes against points, none of them reaching a wall
void expectVolumesOfPoints(const char* what, const polyMesh& mesh)
{
    const meshWalker walker(mesh);
    const sphereOverlap overlap(walker);
    const label nPoints = 40000;
    scalar worst = 0;
    scalar lost = 0;
    scalar least = 1;

    for (const scalar radius : {0.01, 0.04, 0.08, 0.15, 0.25})
    {
        for
        (
            const point& centre
          : randomPoints(6, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7})
        )
        {
            const scalarField points
            (
                sharesOfPoints(mesh, pointsIn(nPoints, centre, radius))
            );
            const scalarField exact
            (
                sharesOfSphere
                (
                    overlap, cellByTetrahedra(mesh, centre), centre, radius
                )
            );
            worst = max(worst, max(mag(points - exact)));
            lost = max(lost, mag(sum(exact) - 1));
            least = min(least, min(exact));
        }
    }

    testNumber((std::string(what) + ": largest difference").c_str(), worst);
    testNumber((std::string(what) + ": error of the sum").c_str(), lost);

    // Four standard deviations of the points in a half
    EXPECT_LT(worst, 4*0.5/std::sqrt(scalar(nPoints))) << what;
    EXPECT_LT(lost, 1e-12) << what;
    EXPECT_GT(least, -1e-9) << what;
}


//- Number of spheres whose cap behind one face is known, after each has been
//  compared with what all faces give
label nCapsAsByAllFaces(const polyMesh& mesh)
{
    const meshWalker walker(mesh);
    const sphereOverlap overlap(walker);
    label n = 0;

    for
    (
        const point& centre : randomPoints(60, {0.4, 0.4, 0.4}, {0.6, 0.6, 0.6})
    )
    {
        const label cell = cellByTetrahedra(mesh, centre);
        const scalar radius = 0.04;
        const sphereOverlap::cap cap(overlap.capOf(centre, radius, cell));

        if (cap.known)
        {
            const scalarField shares
            (
                sharesOfSphere(overlap, cell, centre, radius)
            );
            const scalar share = cap.volume/volumeOf(radius);

            EXPECT_NEAR(shares[cell], 1 - share, 1e-10);
            EXPECT_NEAR(cap.behind < 0 ? 0 : shares[cap.behind], share, 1e-10);
            n += cap.behind >= 0;
        }
    }
    return n;
}

} // End anonymous namespace


TEST(sphereOverlap, theCapBehindOneFlatFaceIsWhatAllFacesGive)
{
    testMesh straight(box());
    EXPECT_GT(nCapsAsByAllFaces(straight.mesh()), 10);

    testMesh leaning(box());
    skew(leaning.mesh());
    EXPECT_GT(nCapsAsByAllFaces(leaning.mesh()), 5);

    // Spheres at cut faces are not mistaken for those at whole ones
    testMesh refined(box());
    refineBeyond(refined.mesh(), 0.5);
    EXPECT_GT(nCapsAsByAllFaces(refined.mesh()), 3);
}


TEST(sphereOverlap, noCapIsTakenBehindAFaceThatIsNotFlat)
{
    testMesh test(box());
    movePoints
    (
        test.mesh(),
        [](const point& p) { return crumpled(p, 0.012); }
    );
    EXPECT_EQ(nCapsAsByAllFaces(test.mesh()), 0);
}


TEST(sphereOverlap, isTheVolumeOfRandomPointsInABox)
{
    testMesh test(box());
    expectVolumesOfPoints("box", test.mesh());
}


TEST(sphereOverlap, isTheVolumeOfRandomPointsAtRefinedCells)
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    ASSERT_EQ(test.mesh().nCells(), 108 + 8*108);
    expectVolumesOfPoints("refined", test.mesh());
}


TEST(sphereOverlap, isTheVolumeOfRandomPointsInBentCells)
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    movePoints(test.mesh(), bent);
    expectVolumesOfPoints("bent", test.mesh());
}


TEST(sphereOverlap, isTheVolumeOfRandomPointsInConcaveWarpedCells)
{
    testMesh test(box());
    refineBeyond(test.mesh(), 0.5);
    movePoints
    (
        test.mesh(),
        [](const point& p) { return crumpled(p, 0.012); }
    );
    expectVolumesOfPoints("crumpled", test.mesh());
}


TEST(sphereOverlap, aSphereOnACornerIsSharedByEightCellsFarFromTheOriginToo)
{
    for (const scalar off : {0.0, 300.0, 1e4})
    {
        testBox far(box());
        far.origin = point(off, 2*off, 0.3*off);
        testMesh test(far);
        const meshWalker walker(test.mesh());
        const sphereOverlap overlap(walker);
        const point corner(far.origin + vector::uniform(0.5));
        label cell = 0;
        while (!overlap.inside(corner, cell))
        {
            ++cell;
        }

        const scalarField shares(sharesOfSphere(overlap, cell, corner, 0.05));
        label n = 0;
        for (const scalar share : shares)
        {
            n += mag(share - 0.125) < 1e-6*max(off, scalar(1));
        }
        EXPECT_EQ(n, 8) << off << " m away";
        EXPECT_NEAR(sum(shares), 1, 1e-9) << off << " m away";
    }
}
