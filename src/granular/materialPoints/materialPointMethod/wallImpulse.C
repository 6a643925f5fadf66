// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: the impulse of walls on points.

#include "materialPointMethod.H"
#include "sharedNodes.H"

template<int D>
void Foam::materialPointMethod::addWallImpulses
(
    const label field,
    List<vectorField>& impulses
) const
{
    const pointSet& p = points_;
    nodeLanes mass(grid_.nNodes(), lanes(lanes::Zero()));
    lanes flat[D];
    std::fill(flat, flat + D, lanes(lanes::Zero()));

    forAll(p.x, i)
    {
        if (fieldOf(i) == field)
        {
            splineStencil<D>(grid_, p.x[i]).add
            (
                mass, lanes(p.mass[i], 0, 0, 0), flat
            );
        }
    }
    sumShared(grid_, mass);

    // A grid may have many more nodes than walls hold: only these change
    nodeLanes perMass(grid_.nNodes(), lanes(lanes::Zero()));
    forAll(impulses, wall)
    {
        const auto held = walls_.impulses(wall, field);
        for (const auto& at : held)
        {
            const scalar m = mass[at.node][0];
            perMass[at.node] += at.impulse/(m > 0 ? m : 1);
        }
        forAll(p.x, i)
        {
            if (fieldOf(i) == field)
            {
                impulses[wall][i] =
                    p.mass[i]
                   *toVector(splineStencil<D>(grid_, p.x[i]).mean(perMass));
            }
        }
        for (const auto& at : held)
        {
            perMass[at.node] = lanes::Zero();
        }
    }
}


Foam::List<Foam::vectorField> Foam::materialPointMethod::wallImpulses() const
{
    List<vectorField> result
    (
        walls_.names().size(), vectorField(points_.size(), Zero)
    );
    for (label field = 0; field < nFields(); ++field)
    {
        if (grid_.nDims() == 2)
        {
            addWallImpulses<2>(field, result);
        }
        else
        {
            addWallImpulses<3>(field, result);
        }
    }
    return result;
}
