// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres that LIGGGHTS moves: which way they are turned.

#include "liggghtsClumps.H"

#include "clumpSums.H"
#include "grainSnapshot.H"

#include <algorithm>
#include <cmath>

#include <liggghts/fix_multisphere.h>

namespace
{

using namespace Foam;

typedef LAMMPS_NS::VectorContainer<double, 3> vectors;
typedef LAMMPS_NS::VectorContainer<double, 4> quaternions;
typedef LAMMPS_NS::ScalarContainer<double> scalars;


//- Vector part of the quaternion w x y z with a scalar part that is not negative
vector vectorPart(const double* q)
{
    return (q[0] < 0 ? -1 : 1)*vector(q[1], q[2], q[3]);
}


//- Lengths of the ellipsoid with these principal moments [kg m2]: of the axis k it is
//  2 sqrt(5/2 (I_i + I_j - I_k)/m)
vector lengths(const double* moments, const scalar mass)
{
    const scalar sum = moments[0] + moments[1] + moments[2];
    vector result;

    for (direction k = 0; k < 3; ++k)
    {
        result[k] = 2*std::sqrt(2.5*std::max(sum - 2*moments[k], 0.0)/mass);
    }

    return result;
}

} // End anonymous namespace


void Foam::liggghtsClumps::setAxes(grainSnapshot& grains) const
{
    // A clump is on one rank, its spheres may be on others: behind those of this rank
    // stand the clumps of this rank, which alone add something to the sums
    auto& properties = fix_->data().prop();
    auto& quat = *properties.getElementProperty<quaternions>("quat");
    auto& moments = *properties.getElementProperty<vectors>("inertia");
    auto& mass = *properties.getElementProperty<scalars>("masstotal");

    const label nSpheres = grains.size();
    const label n = nSpheres + fix_->n_body();
    labelList clumps(n);
    vectorField turned(n, Zero);
    vectorField axes(n, Zero);

    std::copy(grains.clump.begin(), grains.clump.end(), clumps.begin());
    for (label i = 0; i < fix_->n_body(); ++i)
    {
        clumps[nSpheres + i] = fix_->data().tag(i);
        turned[nSpheres + i] = vectorPart(quat(i));
        axes[nSpheres + i] = lengths(moments(i), mass(i));
    }

    const Map<Pair<vector>> sums(clumpSums(clumps).sum(turned, axes));

    grains.orientation.setSize(grains.size());
    grains.axes.setSize(grains.size());
    forAll(grains.clump, i)
    {
        const bool alone = !grains.clump[i];
        const Pair<vector> of
        (
            alone
          ? Pair<vector>(Zero, grains.d[i]*vector::one)
          : sums[grains.clump[i]]
        );
        grains.orientation[i] = of.first();
        grains.axes[i] = of.second();
    }
}
