// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the places of the probes, and the heights of profiles, lie in the mesh.

#include "observer.H"
#include "keywords.H"
#include "polyMesh.H"
#include "StringStream.H"

namespace Foam::misfit
{

//- Nearer to a face of these patches than half the size of that face
static bool isAt
(
    const polyMesh& mesh,
    const point& p,
    const labelUList& patches
)
{
    const pointField& points = mesh.points();
    for (const label patch : patches)
    {
        for (const face& f : mesh.boundaryMesh()[patch])
        {
            const pointHit hit = f.nearestPoint(p, points);
            if (sqr(hit.distance()) < 0.25*f.mag(points))
            {
                return true;
            }
        }
    }
    return false;
}


//- In a cell, or at a boundary
static bool isInside(const polyMesh& mesh, const point& p)
{
    return
        mesh.findCell(p) != -1
     || isAt(mesh, p, identity(mesh.boundaryMesh().size()));
}


//- What is wrong with a place; empty: nothing
static string fault
(
    const polyMesh& mesh,
    const observer& o,
    const point& p
)
{
    OStringStream os;
    if (o.patches.empty())
    {
        if (!isInside(mesh, p))
        {
            os << "is outside the mesh, whose bounds are " << mesh.bounds();
        }
        return os.str();
    }
    const word name(o.patches.first());
    const labelList on(mesh.boundaryMesh().indices(name));
    if (on.empty())
    {
        os << "names the patch " << name
            << ", but the mesh has the patches"
            << keywords::listed(mesh.boundaryMesh().names()).c_str();
    }
    else if (!isAt(mesh, p, on))
    {
        os << "is farther than half a cell from its patch " << name;
    }
    return os.str();
}

//- What is wrong with the height given for a channel; empty: nothing. The function does
//  not know which way is up: only more than the diagonal is surely wrong
static string faultOfHeight(const polyMesh& mesh, const observer& o)
{
    const scalar height = o.of.simulated.getOrDefault<scalar>("height", 0);
    const scalar most = 1.001*mesh.bounds().mag();
    OStringStream os;
    if (height > most)
    {
        os << "\n    " << o.of.name << " has the height " << height
            << " m, more than the diagonal of the mesh, whose bounds are "
            << mesh.bounds();
    }
    return os.str();
}

} // End namespace Foam::misfit


void Foam::misfit::checkPlaces
(
    const polyMesh& mesh,
    const std::vector<observer>& observers,
    const word& experiment
)
{
    OStringStream wrong;
    for (const observer& o : observers)
    {
        if (o.of.experiment != experiment)
        {
            continue;
        }
        wrong << faultOfHeight(mesh, o).c_str();
        for (const point& p : o.places)
        {
            const string problem(fault(mesh, o, p));
            if (problem.size())
            {
                wrong << "\n    " << o.of.name << " at " << p << ' '
                    << problem.c_str();
                break;
            }
        }
    }
    if (!wrong.str().empty())
    {
        FatalErrorInFunction
            << "Channels do not fit the mesh:" << wrong.str().c_str()
            << nl << "    Correct them in system/misfitDict: in metres, in the"
            << " coordinates of the mesh" << exit(FatalError);
    }
}
