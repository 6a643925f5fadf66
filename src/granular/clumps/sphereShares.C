// SPDX-License-Identifier: GPL-3.0-or-later
// Which share of the volume of a clump each of its spheres stands for.

#include "sphereShares.H"

#include "boundBox.H"
#include "error.H"

#include <Eigen/Dense>

#include <cmath>

namespace
{

using namespace Foam;

//- Points of the grid along each side of the spheres' box
constexpr label nPoints = 60;


//- By points of a grid, each shared by the spheres that hold it
scalarField byPoints(const UList<point>& centres, const UList<scalar>& radii)
{
    boundBox box;
    forAll(centres, i)
    {
        box.add(centres[i] - vector::uniform(radii[i]));
        box.add(centres[i] + vector::uniform(radii[i]));
    }

    // A small sphere may lie between the points
    scalarField result(1e-3*pow3(scalarField(radii)/Foam::cbrt(box.volume())));
    DynamicList<label> holders;

    for (label n = 0; n < nPoints*nPoints*nPoints; ++n)
    {
        const vector at
        (
            n % nPoints + 0.5,
            n/nPoints % nPoints + 0.5,
            n/nPoints/nPoints + 0.5
        );
        const point p(box.min() + cmptMultiply(at/nPoints, box.span()));

        holders.clear();
        forAll(centres, i)
        {
            if (magSqr(p - centres[i]) < sqr(radii[i]))
            {
                holders.append(i);
            }
        }
        for (const label i : holders)
        {
            result[i] += 1.0/holders.size()/pow3(scalar(nPoints));
        }
    }

    return result/sum(result);
}


//- Change shares by factors exp(slope & place) until their mean place is zero;
//  how far it is from that
scalar balance(scalarField& shares, const UList<vector>& places)
{
    vector mean(Zero);

    for (label iteration = 0; iteration < 200; ++iteration)
    {
        mean = sum(shares*vectorField(places));
        Eigen::Matrix3d variance(Eigen::Matrix3d::Zero());
        const Eigen::Vector3d m(mean.x(), mean.y(), mean.z());

        forAll(shares, i)
        {
            const Eigen::Vector3d x(places[i].x(), places[i].y(), places[i].z());
            variance += shares[i]*(x - m)*(x - m).transpose();
        }

        // Spheres in a plane or a line have no variance across it
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> solver;
        solver.setThreshold(1e-10);
        const Eigen::Vector3d step(solver.compute(variance).solve(m));
        const vector slope(step[0], step[1], step[2]);

        scalar largest = 0;
        forAll(shares, i)
        {
            largest = max(largest, mag(slope & places[i]));
        }
        const scalar damping = max(largest, scalar(1));

        scalarField next(shares.size());
        forAll(shares, i)
        {
            next[i] = shares[i]*std::exp(-(slope & places[i])/damping);
        }
        next /= sum(next);

        if (iteration > 2 && largest < 1e-15)
        {
            break;
        }
        shares = next;
    }

    return mag(sum(shares*vectorField(places)));
}

} // End anonymous namespace


Foam::scalarField Foam::sphereShares
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const sphereUnion& all
)
{
    const scalar size = max(radii);
    const vectorField places((pointField(centres) - all.centre())/size);
    scalarField result(byPoints(centres, radii));

    if (!(balance(result, places) < 1e-12) || min(result) < 1e-9)
    {
        FatalErrorInFunction
            << "The centre of the volume of a clump, " << all.centre()
            << " m, is not between the centres of its " << centres.size()
            << " spheres, or one of them counts for nothing." << nl
            << "    Take those out that lie almost within others."
            << exit(FatalError);
    }

    return result;
}
