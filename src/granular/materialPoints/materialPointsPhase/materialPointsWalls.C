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
    const scalar little = 1e-6*box.mag();

    return
        mag(bounds.min()[d] - at) < little
     && mag(bounds.max()[d] - at) < little;
}


//- Fatal: the side that a patch of outflow opens has faces of patches that are
//  none
void checkAllOpen
(
    const fvMesh& mesh,
    const dictionary& dict,
    const label side,
    const word& opened,
    const wordRes& outflow
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        bool shares = false;

        for (const face& f : patch)
        {
            const boundBox bounds(patch.points(), f, false);
            shares = shares || liesIn(bounds, mesh.bounds(), side);
        }

        if (!outflow.match(patch.name()) && returnReduce(shares, orOp<bool>()))
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << opened << " of outflow is not the whole side of"
                << " the mesh's box: faces of " << patch.name() << " are in it,"
                << " too, and points would leave there as well." << nl
                << "    Name both in outflow, or shape the mesh so that "
                << opened << " is alone in its side." << exit(FatalIOError);
        }
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

        const boundBox bounds(patch.localPoints(), true);
        bool isOnSide = false;

        for (label side = 0; side < 6; ++side)
        {
            if (liesIn(bounds, mesh.bounds(), side))
            {
                checkAllOpen(mesh, dict, side, patch.name(), outflow);
                method.open(side);
                isOnSide = true;
            }
        }

        if (!isOnSide)
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << patch.name() << " of outflow is in no side of the"
                << " mesh's box " << mesh.bounds() << nl
                << "    Points leave where they cross such a side: end the mesh"
                << " there." << exit(FatalIOError);
        }
    }
}
