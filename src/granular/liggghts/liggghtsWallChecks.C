// SPDX-License-Identifier: GPL-3.0-or-later
// What is checked of walls and surfaces of the LIGGGHTS scripts before a run.

#include "liggghtsChecks.H"

#include "keywords.H"
#include "liggghtsInstance.H"
#include "liggghtsScript.H"

#include <liggghts/fix_mesh_surface.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/tri_mesh.h>

namespace
{
    using namespace Foam;

    //- The surface that the fix of this number is; null where it is none, or -1
    LAMMPS_NS::FixMeshSurface* surfaceOf
    (
        const LAMMPS_NS::Modify& modify,
        const label i
    )
    {
        return
            i < 0
          ? nullptr
          : dynamic_cast<LAMMPS_NS::FixMeshSurface*>(modify.fix[i]);
    }

    //- True where a wall, a flux through it, or an insertion takes a surface
    bool isUsed(LAMMPS_NS::FixMeshSurface& surface)
    {
        return
            surface.hasNeighList()
         || surface.hasOtherNeighList()
         || surface.triMesh()->isInsertionMesh();
    }

    //- True where a point is on a wall of a script. Of a surface only the
    //  bounds count, and only if they are flat
    bool isAt
    (
        const liggghtsScript::wall& wall,
        LAMMPS_NS::Modify& modify,
        const point& p,
        const scalar tolerance
    )
    {
        if (wall.normal >= 0)
        {
            return mag(p[wall.normal] - wall.at) < tolerance;
        }

        for (const word& name : wall.surfaces)
        {
            auto* surface = surfaceOf(modify, modify.find_fix(name.c_str()));

            if (surface)
            {
                boundBox box;
                surface->triMesh()->getGlobalBoundingBox()
                    .getBoxBounds(&box.min()[0], &box.max()[0]);

                const bool flat = box.minDim() < tolerance;
                box.min() -= vector::uniform(tolerance);
                box.max() += vector::uniform(tolerance);

                if (flat && box.contains(p))
                {
                    return true;
                }
            }
        }

        return false;
    }

    //- True where all corners of a face of the patch are on the wall
    bool hasFace
    (
        const liggghtsScript::wall& wall,
        LAMMPS_NS::Modify& modify,
        const polyPatch& patch,
        const scalar tolerance
    )
    {
        for (const face& f : patch.localFaces())
        {
            bool on = true;
            for (const label p : f)
            {
                on = on
                 && isAt(wall, modify, patch.localPoints()[p], tolerance);
            }

            if (on)
            {
                return true;
            }
        }

        return false;
    }
}


void Foam::liggghtsChecks::checkNoDuplicateWall
(
    liggghtsInstance& liggghts,
    const polyPatch& patch,
    const wordList& surfaces,
    const fileName& script
)
{
    LAMMPS_NS::Modify& modify = *liggghts->modify;
    const scalar tolerance = 1e-6*patch.boundaryMesh().mesh().bounds().mag();

    DynamicList<liggghtsScript::wall> walls(liggghtsScript::walls(script));
    for (const word& surface : surfaces)
    {
        walls.append
        (
            liggghtsScript::wall{surface, -1, 0, wordList(1, surface)}
        );
    }

    for (const liggghtsScript::wall& wall : walls)
    {
        if
        (
            returnReduce
            (
                hasFace(wall, modify, patch, tolerance), orOp<bool>()
            )
        )
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " is a wall of the grains twice:"
                << " fix " << wall.fix << " of " << script
                << " stands where the patch makes one." << nl
                << "    Take the fix out, or name in LIGGGHTS/walls/patches of"
                << " constant/granularProperties the other patches only."
                << exit(FatalError);
        }
    }
}


void Foam::liggghtsChecks::checkNoOtherSurfaces(const fileName& script)
{
    for (const liggghtsScript::wall& wall : liggghtsScript::walls(script))
    {
        if (wall.surfaces.size())
        {
            FatalErrorInFunction
                << "LIGGGHTS takes one wall made of surfaces, but fix "
                << wall.fix << " of " << script << " is one, and patches of"
                << " the mesh that are not whole sides of its box make another."
                << nl << "    Take fix " << wall.fix << " out, and name its"
                << " surfaces in LIGGGHTS/walls/surfaces of"
                << " constant/granularProperties: " << wall.surfaces
                << exit(FatalError);
        }
    }
}


void Foam::liggghtsChecks::checkSurfaces
(
    liggghtsInstance& liggghts,
    const wordList& names,
    const fileName& script
)
{
    const LAMMPS_NS::Modify& modify = *liggghts->modify;

    DynamicList<word> there;
    for (label i = 0; i < modify.nfix; ++i)
    {
        if (surfaceOf(modify, i))
        {
            there.append(modify.fix[i]->id);
        }
    }

    for (const word& name : names)
    {
        if (!there.found(name))
        {
            FatalErrorInFunction
                << name << " in LIGGGHTS/walls/surfaces of"
                << " constant/granularProperties is no fix mesh/surface of "
                << script << nl << "    Those that are there:"
                << keywords::listed(wordList(there)).c_str()
                << exit(FatalError);
        }
    }
}


void Foam::liggghtsChecks::checkNoUnusedSurfaces
(
    liggghtsInstance& liggghts,
    const fileName& script
)
{
    const LAMMPS_NS::Modify& modify = *liggghts->modify;

    for (label i = 0; i < modify.nfix; ++i)
    {
        auto* surface = surfaceOf(modify, i);

        if (surface && !isUsed(*surface))
        {
            FatalErrorInFunction
                << "Grains go through the surface " << surface->id << " of "
                << script << ": no wall is made of it." << nl
                << "    Name it in LIGGGHTS/walls/surfaces of"
                << " constant/granularProperties, or take the fix out."
                << exit(FatalError);
        }
    }
}
