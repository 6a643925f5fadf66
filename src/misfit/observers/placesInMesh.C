// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the places of the probes lie in the mesh.

#include "placesInMesh.H"

namespace Foam
{
namespace misfit
{

//- True in a cell, or nearer to a boundary face than its size
static bool isInside(const polyMesh& mesh, const point& p)
{
    if (mesh.findCell(p) != -1)
    {
        return true;
    }
    const pointField& points = mesh.points();
    for (label i = mesh.nInternalFaces(); i < mesh.nFaces(); ++i)
    {
        const face& f = mesh.faces()[i];
        const pointHit hit = f.nearestPoint(p, points);
        if (sqr(hit.distance()) < 0.25*f.mag(points))
        {
            return true;
        }
    }
    return false;
}

} // End namespace misfit
} // End namespace Foam


void Foam::misfit::checkPlaces
(
    const polyMesh& mesh,
    const UPtrList<observer>& observers
)
{
    OStringStream outside;
    for (const observer& o : observers)
    {
        for (const point& p : o.places())
        {
            if (!isInside(mesh, p))
            {
                outside << "\n    " << o.of().name() << " at " << p;
                break;
            }
        }
    }
    if (!outside.str().empty())
    {
        FatalErrorInFunction
            << "These channels are outside the mesh, whose bounds are "
            << mesh.bounds() << ':' << outside.str().c_str() << nl
            << "    Mend their places in system/misfitDict: metres, in the"
            << " coordinates of the mesh" << exit(FatalError);
    }
}
