// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries and walls for the grains, made from the patches of the mesh.

#include "liggghtsWalls.H"

#include "ListListOps.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "keywords.H"
#include "liggghtsChecks.H"
#include "liggghtsInstance.H"
#include "liggghtsScript.H"
#include "periodicity.H"
#include "wallPolyPatch.H"

#include <fstream>

#include <liggghts/atom.h>
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
    type_(dict.lookupOrDefault<label>("type", 1)),
    types_(keywords::sub(dict, "types")),
    contactModel_
    (
        dict.found("contactModel")
      ? dict.get<string>("contactModel")
      : liggghtsScript::contactModel(script)
    ),
    own_(dict.lookupOrDefault<wordList>("surfaces", wordList())),
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


Foam::labelList Foam::liggghtsWalls::sides(const polyPatch& patch) const
{
    const boundBox& box = mesh_.bounds();
    const scalar tolerance = 1e-6*box.mag();

    label nFacesOn = 0;
    FixedList<scalar, 6> area(0.0);

    forAll(patch, facei)
    {
        for (label i = 0; i < 6; ++i)
        {
            const direction k = i/2;
            const scalar plane = i % 2 ? box.max()[k] : box.min()[k];

            bool on = true;
            for (const label p : patch[facei])
            {
                on = on && mag(mesh_.points()[p][k] - plane) < tolerance;
            }

            if (on)
            {
                area[i] += mag(patch.faceAreas()[facei]);
                ++nFacesOn;
                break;
            }
        }
    }

    // A plane has no end: it serves only where the patch has the whole side
    bool planes = returnReduce(nFacesOn == patch.size(), andOp<bool>());
    DynamicList<label> result;

    for (label i = 0; i < 6; ++i)
    {
        const vector span(box.span());
        const scalar whole = span[(i/2 + 1) % 3]*span[(i/2 + 2) % 3];

        reduce(area[i], sumOp<scalar>());

        if (area[i] > 0)
        {
            result.append(i);
            planes = planes && area[i] > (1 - 1e-6)*whole;
        }
    }

    return planes ? labelList(std::move(result)) : labelList();
}


Foam::fileName Foam::liggghtsWalls::writeSurface(const polyPatch& patch) const
{
    List<pointField> triangles(Pstream::nProcs());
    DynamicList<point> mine;

    for (const face& f : patch.localFaces())
    {
        for (label i = 1; i + 1 < f.size(); ++i)
        {
            mine.append(patch.localPoints()[f[0]]);
            mine.append(patch.localPoints()[f[i]]);
            mine.append(patch.localPoints()[f[i + 1]]);
        }
    }

    triangles[Pstream::myProcNo()] = mine;
    Pstream::gatherList(triangles);

    const fileName path
    (
        mesh_.time().globalPath()/"constant"/"grainWalls"/(patch.name() + ".stl")
    );

    if (Pstream::master())
    {
        const pointField all
        (
            ListListOps::combine<pointField>(triangles, accessOp<pointField>())
        );

        mkDir(path.path());
        std::ofstream os(path);
        os.precision(12);
        os << "solid " << patch.name() << '\n';

        for (label i = 0; i + 2 < all.size(); i += 3)
        {
            os << "facet normal 0 0 0\nouter loop\n";
            for (label k = i; k < i + 3; ++k)
            {
                os  << "vertex " << all[k].x() << ' ' << all[k].y() << ' '
                    << all[k].z() << '\n';
            }
            os << "endloop\nendfacet\n";
        }

        os << "endsolid\n";
        os.close();

        if (!os)
        {
            FatalErrorInFunction
                << "Cannot write the wall of the grains to " << path << nl
                << "    Is the disk full, or the folder read-only?"
                << exit(FatalError);
        }
    }

    return path;
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

    for (const label i : sides)
    {
        // LIGGGHTS keeps room for nine letters of a wall's id
        const word id("wall" + Foam::name(nWalls_++));
        const scalar place = (i % 2 ? box.max() : box.min())[i/2];

        std::ostringstream os;
        os.precision(17);
        os  << "fix " << id << " all wall/gran " << contactModel_
            << " primitive type " << type << ' ' << planes[i/2] << ' ' << place
            << " store_force yes";
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
    const polyPatch& patch
)
{
    const word id("mesh" + Foam::name(nWalls_++));

    liggghts.command
    (
        "fix " + id + " all mesh/surface file " + writeSurface(patch)
      + " type " + Foam::name(material(liggghts, patch))
    );
    surfaces_.insert(patch.name(), id);

    Info<< "    wall " << patch.name() << ": surface" << endl;
}


void Foam::liggghtsWalls::addWallOfSurfaces(liggghtsInstance& liggghts) const
{
    liggghtsChecks::noOtherSurfaces(script_);

    string meshes;
    for (const word& patch : surfaces_.sortedToc())
    {
        meshes += " " + surfaces_[patch];
    }
    for (const word& id : own_)
    {
        meshes += " " + id;
    }

    liggghts.command
    (
        "fix surfaces all wall/gran " + contactModel_ + " mesh n_meshes "
      + Foam::name(surfaces_.size() + own_.size()) + " meshes" + meshes
      + " store_force_contact yes"
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


void Foam::liggghtsWalls::add(liggghtsInstance& liggghts)
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!isWall(patch) || !returnReduce(patch.size(), sumOp<label>()))
        {
            continue;
        }

        liggghtsChecks::noOwnWall(liggghts, patch, script_);

        const labelList on(sides(patch));

        if (on.size())
        {
            addPlanes(liggghts, patch, on);
        }
        else
        {
            addSurface(liggghts, patch);
        }
    }

    if (surfaces_.size() || own_.size())
    {
        addWallOfSurfaces(liggghts);
    }
}
