// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and open sides of material points, from the patches of the mesh.

#include "materialPointsWalls.H"

#include "foamCompatibility.H"
#include "keywords.H"
#include "wallPolyPatch.H"

namespace
{

using namespace Foam;

//- Faces of a patch on all ranks, as corners
List<pointField> faces(const polyPatch& patch)
{
    List<List<pointField>> ofRanks(Pstream::nProcs());
    List<pointField>& mine = ofRanks[Pstream::myProcNo()];
    mine.setSize(patch.size());

    forAll(patch, i)
    {
        mine[i] = patch[i].points(patch.points());
    }
    Pstream::gatherList(ofRanks);
    compatibility::broadcast(ofRanks);

    DynamicList<pointField> result;
    for (const List<pointField>& some : ofRanks)
    {
        result.append(some);
    }
    return List<pointField>(std::move(result));
}


//- True where bounds lie in a side of the mesh's box: -x +x -y +y -z +z
bool liesIn(const boundBox& bounds, const boundBox& box, const label side)
{
    const direction d = side/2;
    const scalar at = (side % 2 ? box.max() : box.min())[d];
    const scalar tolerance = 1e-6*box.mag();

    return
        mag(bounds.min()[d] - at) < tolerance
     && mag(bounds.max()[d] - at) < tolerance;
}


//- True where a side of the mesh's box has faces of patches of outflow alone
bool isAllOpen(const fvMesh& mesh, const label side, const wordRes& outflow)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    bool others = false;

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        if (outflow.match(patch.name()))
        {
            continue;
        }

        for (const face& f : patch)
        {
            const boundBox bounds(patch.points(), f, false);
            others = others || liesIn(bounds, mesh.bounds(), side);
        }
    }

    return !returnReduce(others, orOp<bool>());
}


//- The side of the mesh's box that a patch lies in and that outflow opens as a whole;
//  -1 where there is none
label openedSide
(
    const fvMesh& mesh,
    const polyPatch& patch,
    const wordRes& outflow
)
{
    const boundBox bounds(patch.localPoints(), true);

    for (label side = 0; side < 6; ++side)
    {
        if
        (
            liesIn(bounds, mesh.bounds(), side)
         && isAllOpen(mesh, side, outflow)
        )
        {
            return side;
        }
    }
    return -1;
}


//- Fatal where a patch of outflow cannot let points out
void checkOutflow
(
    const polyPatch& patch,
    const wordRes& walls,
    const dictionary& dict
)
{
    const char* reason =
        patch.coupled() ? "the mesh repeats there, or goes on on another rank"
      : materialPointsWalls::isWall(patch, walls) ? "it is a wall that holds them"
      : !returnReduce(patch.size(), sumOp<label>()) ? "it has no faces"
      : nullptr;

    if (reason)
    {
        FatalIOErrorInFunction(dict)
            << "Points cannot leave through patch " << patch.name()
            << " of outflow: " << reason << "." << nl
            << "    Leave it out of outflow; or make it of type patch in the mesh,"
            << " with faces, and no part of walls/patches." << exit(FatalIOError);
    }
}

} // End anonymous namespace


bool Foam::materialPointsWalls::isWall
(
    const polyPatch& patch,
    const wordRes& patches
)
{
    return isA<wallPolyPatch>(patch) && patches.match(patch.name());
}


void Foam::materialPointsWalls::add
(
    materialPointMethod& method,
    const polyBoundaryMesh& boundary,
    const wordRes& patches,
    const dictionary& dict
)
{
    const dictionary walls(keywords::sub(dict, "walls"));
    const dictionary frictions(keywords::sub(walls, "frictions"));
    const scalar friction = walls.getOrDefault<scalar>("friction", 0);

    // Those behind are cuts between ranks, other ones on each
    for (label i = 0; i < boundary.nNonProcessor(); ++i)
    {
        const polyPatch& patch = boundary[i];

        if (isWall(patch, patches))
        {
            const label wall = method.walls().add
            (
                patch.name(),
                frictions.getOrDefault<scalar>(patch.name(), friction)
            );

            for (const pointField& face : faces(patch))
            {
                method.walls().addFace(wall, face);
            }
        }
    }
    keywords::checkPatterns(frictions, method.walls().names());

    method.walls().findNodes();
}


void Foam::materialPointsWalls::setFriction
(
    materialPointMethod& method,
    const dictionary& dict
)
{
    const wordList& walls = method.walls().names();
    const dictionary all(keywords::sub(dict, "walls"));
    const dictionary frictions(keywords::sub(all, "frictions"));
    List<scalarField> friction(method.bodies().size());

    forAll(friction, body)
    {
        const dictionary& settings =
            dict.subDict("bodies").subDict(method.bodies()[body]);
        const dictionary bodyWalls
        (
            keywords::sub(settings, "walls", {"friction", "frictions"})
        );
        const dictionary bodyFrictions(keywords::sub(bodyWalls, "frictions"));
        keywords::checkPatterns(bodyFrictions, walls);

        if (bodyWalls.size() && !method.hasContact())
        {
            FatalIOErrorInFunction(settings)
                << "Body " << method.bodies()[body] << " has walls of its own,"
                << " but bodies without contact have one velocity at a node,"
                << " and one friction." << nl
                << "    Give materialPoints/contact, or the friction in"
                << " materialPoints/walls." << exit(FatalIOError);
        }

        friction[body].setSize(walls.size());
        forAll(walls, wall)
        {
            const scalar ofAll = bodyWalls.getOrDefault<scalar>
            (
                "friction",
                frictions.getOrDefault<scalar>
                (
                    walls[wall],
                    all.getOrDefault<scalar>("friction", 0)
                )
            );
            friction[body][wall] =
                bodyFrictions.getOrDefault<scalar>(walls[wall], ofAll);

            if (!(friction[body][wall] >= 0))
            {
                FatalIOErrorInFunction(settings)
                    << "The friction of wall " << walls[wall] << " for body "
                    << method.bodies()[body] << " is "
                    << friction[body][wall] << "; it may not be below zero."
                    << exit(FatalIOError);
            }
        }
    }

    if (method.hasContact())
    {
        method.walls().setFriction(friction);
    }
}


void Foam::materialPointsWalls::open
(
    materialPointMethod& method,
    const fvMesh& mesh,
    const wordRes& walls,
    const dictionary& dict
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const wordRes outflow
    (
        keywords::patterns(dict, "outflow", patches.names())
    );

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        if (!outflow.match(patch.name()))
        {
            continue;
        }

        checkOutflow(patch, walls, dict);
        const label side = openedSide(mesh, patch, outflow);
        if (side >= 0)
        {
            method.outlets().open(side);
        }
        else
        {
            method.outlets().add(patch.name(), faces(patch));
        }
    }
    if (!method.outlets().hasFaces())
    {
        return;
    }

    // With the walls beside them, so that it is known what is beyond an edge
    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        if (isWall(patches[i], walls))
        {
            method.outlets().addWallBeside(patches[i].name(), faces(patches[i]));
        }
    }
    method.outlets().findNodes();
}
