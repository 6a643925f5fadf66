// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the places of the probes lie in the mesh.

#include "placesInMesh.H"

#include "FlatOutput.H"
#include "polyMesh.H"
#include "StringStream.H"
#include "wordReList.H"

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

//- Its shortest way to a face of these patches, over the size of that face
static scalar facesAway
(
    const polyMesh& mesh,
    const point& p,
    const labelHashSet& patches
)
{
    const pointField& points = mesh.points();
    scalar least = GREAT;
    for (const label patch : patches)
    {
        for (const face& f : mesh.boundaryMesh()[patch])
        {
            const scalar distance = f.nearestPoint(p, points).distance();
            least = min(least, distance/sqrt(f.mag(points)));
        }
    }
    return least;
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
    if (o.patches().empty())
    {
        if (!isInside(mesh, p))
        {
            os << "is outside the mesh, whose bounds are " << mesh.bounds();
        }
        return os.str();
    }
    wordReList names;
    for (const word& name : o.patches())
    {
        names.append(wordRe(name, wordRe::DETECT));
    }
    const labelHashSet on(mesh.boundaryMesh().patchSet(names, false));
    if (on.empty())
    {
        os << "is said to be on " << flatOutput(o.patches())
            << ", but the mesh has the patches "
            << flatOutput(mesh.boundaryMesh().names());
    }
    else if (facesAway(mesh, p, on) > 0.5)
    {
        os << "is farther than half a cell from its patch "
            << flatOutput(o.patches());
    }
    return os.str();
}

} // End namespace misfit
} // End namespace Foam


void Foam::misfit::checkPlaces
(
    const polyMesh& mesh,
    const UPtrList<observer>& observers
)
{
    OStringStream wrong;
    for (const observer& o : observers)
    {
        for (const point& p : o.places())
        {
            const string said(fault(mesh, o, p));
            if (said.size())
            {
                wrong << "\n    " << o.of().name() << " at " << p << ' '
                    << said.c_str();
                break;
            }
        }
    }
    if (!wrong.str().empty())
    {
        FatalErrorInFunction
            << "Places of channels do not fit the mesh:" << wrong.str().c_str()
            << nl << "    Mend them in system/misfitDict: metres, in the"
            << " coordinates of the mesh" << exit(FatalError);
    }
}
