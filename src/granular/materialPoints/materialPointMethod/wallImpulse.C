// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: the impulse of walls on points.

#include "materialPointMethod.H"

template<int D>
Foam::vectorField Foam::materialPointMethod::fromNodes
(
    std::vector<nodeLanes>& fields
) const
{
    const pointSet& p = points_;
    std::vector<nodeLanes> mass
    (
        nFields(), nodeLanes(grid_.nNodes(), lanes(lanes::Zero()))
    );
    lanes flat[D];
    std::fill(flat, flat + D, lanes(lanes::Zero()));

    forAll(p.x, i)
    {
        splineStencil<D>(grid_, p.x[i]).add
        (
            mass[fieldOf(i)], lanes(p.mass[i], 0, 0, 0), flat
        );
    }
    share(mass);

    for (label field = 0; field < nFields(); ++field)
    {
        nodeLanes& nodes = fields[field];

        for (std::size_t i = 0; i < nodes.size(); ++i)
        {
            const scalar m = mass[field][i][0];
            nodes[i] /= m > 0 ? m : 1;
        }
    }

    vectorField result(p.size());
    forAll(result, i)
    {
        result[i] =
            p.mass[i]
           *toVector
            (
                splineStencil<D>(grid_, p.x[i]).mean(fields[fieldOf(i)])
            );
    }

    return result;
}


Foam::vectorField Foam::materialPointMethod::wallImpulse
(
    const label wall
) const
{
    std::vector<nodeLanes> impulses;
    for (label field = 0; field < nFields(); ++field)
    {
        impulses.push_back(walls_.impulseOnNodes(wall, field));
    }

    return grid_.nDims() == 2 ? fromNodes<2>(impulses) : fromNodes<3>(impulses);
}
