// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries and walls for the grains, made from the patches of the mesh.

#include "liggghtsWalls.H"

#include "Time.H"
#include "keywords.H"
#include "liggghtsChecks.H"
#include "liggghtsInstance.H"
#include "liggghtsScript.H"
#include "periodicity.H"
#include "wallPolyPatch.H"

#include <liggghts/atom.h>
#include <liggghts/domain.h>
#include <liggghts/lammps.h>

Foam::liggghtsWalls::liggghtsWalls
(
    const fvMesh& mesh,
    const dictionary& dict,
    const fileName& script
)
:
    mesh_(mesh),
    script_(script),
    patches_
    (
        keywords::patterns
        (
            dict,
            "patches",
            mesh.boundaryMesh().names(),
            wordRes({wordRe(".*", wordRe::REGEX)})
        )
    ),
    type_(dict.getOrDefault<label>("type", 1)),
    types_(keywords::sub(dict, "types")),
    contactModel_
    (
        dict.found("contactModel")
      ? dict.get<string>("contactModel")
      : liggghtsScript::contactModel(script)
    ),
    scriptSurfaces_(dict.getOrDefault<wordList>("surfaces", wordList())),
    nWalls_(0)
{
    keywords::check
    (
        dict,
        {"patches", "type", "types", "contactModel", "surfaces"}
    );
    keywords::checkPatterns(types_, mesh.boundaryMesh().names());
}


Foam::label Foam::liggghtsWalls::material
(
    const liggghtsInstance& liggghts,
    const polyPatch& patch
) const
{
    const label type = types_.getOrDefault<label>(patch.name(), type_);
    const label nTypes = liggghts->atom->ntypes;

    if (type < 1 || type > nTypes)
    {
        FatalErrorInFunction
            << "The wall " << patch.name() << " has the material " << type
            << ", but LIGGGHTS knows the materials 1 to " << nTypes << nl
            << "    See LIGGGHTS/walls in constant/granularProperties. The"
            << " number of materials is that of create_box in the script, or"
            << nl << "    the atom types of the file that read_data reads"
            << " (materials in packingDict)" << exit(FatalError);
    }

    return type;
}


Foam::string Foam::liggghtsWalls::boundary(const fvMesh& mesh)
{
    const Vector<bool> along(periodicity(mesh).along());

    string result;
    for (direction k = 0; k < 3; ++k)
    {
        result += along[k] ? "p " : "f ";
    }

    return result;
}


void Foam::liggghtsWalls::addPlanes
(
    liggghtsInstance& liggghts,
    const polyPatch& patch,
    const labelList& sides
)
{
    static const char* const planes[] = {"xplane", "yplane", "zplane"};
    const boundBox& box = mesh_.bounds();
    const label type = material(liggghts, patch);
    const auto contact = liggghtsScript::parts(contactModel_);

    for (const label i : sides)
    {
        // LIGGGHTS keeps room for nine letters of a wall's id
        const word id("wall" + Foam::name(nWalls_++));
        const scalar place = (i % 2 ? box.max() : box.min())[i/2];

        std::ostringstream os;
        os.precision(17);
        os  << "fix " << id << " all wall/gran" << contact.models
            << " primitive type " << type << ' ' << planes[i/2] << ' ' << place
            << " store_force yes" << contact.options;
        liggghts.command(os.str());

        fixes_(patch.name()).append(id);
        planes_.insert(id, Tuple2<direction, scalar>(i/2, place));
    }

    Info<< "    wall " << patch.name() << ": " << sides.size() << " planes"
        << endl;
}


void Foam::liggghtsWalls::addSurface
(
    liggghtsInstance& liggghts,
    const polyPatch& patch,
    std::set<wallTriangles::corners, wallTriangles::before>& others
)
{
    // On the first rank
    List<wallTriangles::corners> faces(wallTriangles::faces(patch));
    const label twins =
        returnReduce(wallTriangles::dropTwins(faces, others), sumOp<label>());
    const label n = returnReduce(faces.size(), sumOp<label>());

    Info<< "    wall " << patch.name() << ": surface";
    if (twins)
    {
        Info<< " of " << n << " faces; " << twins << " more are the other side of"
            << " a thin plate and stand already";
    }
    Info<< endl;

    if (!n)
    {
        return;
    }

    const fileName path
    (
        mesh_.time().globalPath()/"constant"/"grainWalls"/(patch.name() + ".stl")
    );
    scalar angle;
    const DynamicList<point> triangles
    (
        wallTriangles::of(patch.name(), faces, angle)
    );
    reduce(angle, minOp<scalar>());

    if (Pstream::master())
    {
        wallTriangles::write(path, triangles);
    }

    // In degrees. Faces that differ by less are one plane: with a smaller one all
    // surfaces would have more edges
    const bool thin = angle < wallTriangles::smallestByDefault;
    const string curvature(thin ? " curvature 0.0573" : "");
    const word id("mesh" + Foam::name(nWalls_++));

    liggghts.command
    (
        "fix " + id + " all mesh/surface file " + path + " type "
      + Foam::name(material(liggghts, patch)) + curvature
    );
    surfaces_.insert(patch.name(), id);
}


void Foam::liggghtsWalls::addWallOfSurfaces(liggghtsInstance& liggghts) const
{
    liggghtsChecks::checkNoOtherSurfaces(script_);

    string meshes;
    for (const word& patch : surfaces_.sortedToc())
    {
        meshes += " " + surfaces_[patch];
    }
    for (const word& id : scriptSurfaces_)
    {
        meshes += " " + id;
    }

    const auto contact = liggghtsScript::parts(contactModel_);
    liggghts.command
    (
        "fix surfaces all wall/gran" + contact.models + " mesh n_meshes "
      + Foam::name(surfaces_.size() + scriptSurfaces_.size()) + " meshes" + meshes
      + " store_force_contact yes" + contact.options
    );
}


Foam::vector Foam::liggghtsWalls::toPlane
(
    const word& id,
    const point& p
) const
{
    vector to(Zero);
    const auto plane = planes_.cfind(id);

    if (plane.found())
    {
        const direction k = plane.val().first();
        to[k] = plane.val().second() - p[k];
    }

    return to;
}


bool Foam::liggghtsWalls::isWall(const polyPatch& patch) const
{
    return isA<wallPolyPatch>(patch) && patches_.match(patch.name());
}


bool Foam::liggghtsWalls::hasFaces(const polyPatch& patch)
{
    return returnReduce(patch.size(), sumOp<label>());
}


void Foam::liggghtsWalls::enlargeBox(liggghtsInstance& liggghts) const
{
    const LAMMPS_NS::Domain& domain = *liggghts->domain;
    boundBox walls;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isWall(patch) && hasFaces(patch) && sides(patch).empty())
        {
            walls.add(patch.localPoints());
        }
    }
    walls.reduce();

    if (walls.empty())
    {
        return;
    }

    std::ostringstream ends;
    ends.precision(17);

    for (direction k = 0; k < 3; ++k)
    {
        const scalar lo = min(walls.min()[k], domain.boxlo[k]);
        const scalar hi = max(walls.max()[k], domain.boxhi[k]);
        const bool larger = lo < domain.boxlo[k] || hi > domain.boxhi[k];

        if (larger && !domain.periodicity[k])
        {
            ends << ' ' << "xyz"[k] << " final " << lo << ' ' << hi;
        }
    }

    if (ends.tellp() > 0)
    {
        liggghts.command("change_box all" + ends.str() + " units box");
        Info<< "    box of the grains enlarged, as walls reach beyond it:"
            << ends.str().c_str() << endl;
    }
}


void Foam::liggghtsWalls::add(liggghtsInstance& liggghts)
{
    liggghtsChecks::checkSurfaces(liggghts, scriptSurfaces_, script_);

    std::set<wallTriangles::corners, wallTriangles::before> faces;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!isWall(patch) || !hasFaces(patch))
        {
            continue;
        }

        liggghtsChecks::checkNoDuplicateWall(liggghts, patch, scriptSurfaces_, script_);

        const labelList on(sides(patch));

        if (on.size())
        {
            addPlanes(liggghts, patch, on);
        }
        else
        {
            addSurface(liggghts, patch, faces);
        }
    }

    if (surfaces_.size() || scriptSurfaces_.size())
    {
        addWallOfSurfaces(liggghts);
    }

    liggghtsChecks::checkNoUnusedSurfaces(liggghts, script_);
}
