// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of the walls on both sides of a plane of material points.

#include "pointSideWalls.H"

#include "keywords.H"

#include <cmath>

Foam::pointSideWalls::pointSideWalls(const dictionary& dict, const pointGrid& grid)
{
    if (!dict.found("sideWalls"))
    {
        return;
    }

    const dictionary walls(keywords::sub(dict, "sideWalls", {"friction", "width"}));
    if (grid.nDims() != 2)
    {
        FatalIOErrorInFunction(walls)
            << "sideWalls are those of a plane, and the mesh is none: all its"
            << " directions are solved." << nl
            << "    Take sideWalls out, and give the patches of the walls friction."
            << exit(FatalIOError);
    }

    friction_ = walls.getOrDefault<scalar>("friction", -1);
    width_ = walls.getOrDefault<scalar>("width", 0);
    if (!(friction_ >= 0 && width_ > 0))
    {
        FatalIOErrorInFunction(walls)
            << "sideWalls need their friction, 0 or more, and width, the distance of"
            << " both walls across the plane, above 0 m." << nl
            << "    Give both: sideWalls { friction 0.5; width 2; }"
            << exit(FatalIOError);
    }
    across_[3 - grid.axes()[0] - grid.axes()[1]] = 1;
}


void Foam::pointSideWalls::setSize(const label nFields, const label nNodes)
{
    if (brake())
    {
        braking_.assign(nFields, scalarField(nNodes, Zero));
    }
}


void Foam::pointSideWalls::apply(std::vector<nodeLanes>& fields)
{
    for (std::size_t field = 0; field < braking_.size(); ++field)
    {
        nodeLanes& nodes = fields[field];
        for (std::size_t i = 0; i < nodes.size(); ++i)
        {
            lanes& node = nodes[i];
            const scalar speed = std::hypot(node[1], node[2]);
            if (speed > 0)
            {
                const scalar kept = max(1 - braking_[field][i]/speed, scalar(0));
                node[1] *= kept;
                node[2] *= kept;
            }
            braking_[field][i] = 0;
        }
    }
}
