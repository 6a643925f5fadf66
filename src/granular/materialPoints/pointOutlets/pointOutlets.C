// SPDX-License-Identifier: GPL-3.0-or-later
// Where material points leave.

#include "pointOutlets.H"

namespace
{
    using namespace Foam;

    //- Give one of the walls its faces
    void addFaces
    (
        pointWalls& walls,
        const label wall,
        const UList<pointField>& faces
    )
    {
        for (const pointField& face : faces)
        {
            walls.addFace(wall, face);
        }
    }
}


Foam::pointOutlets::pointOutlets(const pointGrid& grid)
:
    grid_(grid),
    faces_(grid),
    open_(false)
{}


void Foam::pointOutlets::add(const word& name, const UList<pointField>& faces)
{
    addFaces(faces_, faces_.addOutlet(name), faces);
    hasFaces_ = true;
}


void Foam::pointOutlets::addWallBeside
(
    const word& name,
    const UList<pointField>& faces
)
{
    addFaces(faces_, faces_.add(name, 0), faces);
}


bool Foam::pointOutlets::isBeyond(const point& p, const label cell) const
{
    const boundBox& box = grid_.box();
    bool result = hasFaces_ && faces_.isBehindOutlet(p, cell);

    for (direction d = 0; d < 3; ++d)
    {
        result =
            result
         || (open_[2*d] && p[d] < box.min()[d])
         || (open_[2*d + 1] && p[d] > box.max()[d]);
    }

    return result;
}
