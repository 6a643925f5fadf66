// SPDX-License-Identifier: GPL-3.0-or-later
// A continuum of material points in the place of grains: walls and open sides.

#include "materialPointsPhase.H"

#include "foamCompatibility.H"
#include "keywords.H"
#include "wallPolyPatch.H"

bool Foam::materialPointsPhase::isWall(const polyPatch& patch) const
{
    return isA<wallPolyPatch>(patch) && patches_.match(patch.name());
}


Foam::List<Foam::pointField> Foam::materialPointsPhase::faces
(
    const polyPatch& patch
)
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


void Foam::materialPointsPhase::addWalls()
{
    const dictionary walls(keywords::sub(dict_, "walls"));
    const dictionary frictions(keywords::sub(walls, "frictions"));
    const scalar friction = walls.getOrDefault<scalar>("friction", 0);
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    // Those behind are cuts between ranks, other ones on each
    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];

        if (isWall(patch))
        {
            const label wall = method_.walls().add
            (
                patch.name(),
                frictions.getOrDefault<scalar>(patch.name(), friction)
            );

            for (const pointField& face : faces(patch))
            {
                method_.walls().addFace(wall, face);
            }
        }
    }
    keywords::checkPatterns(frictions, method_.walls().names());

    method_.walls().findNodes();
}


void Foam::materialPointsPhase::setWallFriction()
{
    const wordList& walls = method_.walls().names();
    const dictionary all(keywords::sub(dict_, "walls"));
    const dictionary frictions(keywords::sub(all, "frictions"));
    List<scalarField> friction(method_.bodies().size());

    forAll(friction, body)
    {
        const dictionary& settings =
            dict_.subDict("bodies").subDict(method_.bodies()[body]);
        const dictionary own
        (
            keywords::sub(settings, "walls", {"friction", "frictions"})
        );
        const dictionary ownFrictions(keywords::sub(own, "frictions"));
        keywords::checkPatterns(ownFrictions, walls);

        if (own.size() && !method_.hasContact())
        {
            FatalIOErrorInFunction(settings)
                << "Body " << method_.bodies()[body] << " has walls of its own,"
                << " but bodies without contact have one velocity at a node,"
                << " and one friction." << nl
                << "    Give materialPoints/contact, or the friction in"
                << " materialPoints/walls." << exit(FatalIOError);
        }

        friction[body].setSize(walls.size());
        forAll(walls, wall)
        {
            const scalar ofAll = own.getOrDefault<scalar>
            (
                "friction",
                frictions.getOrDefault<scalar>
                (
                    walls[wall],
                    all.getOrDefault<scalar>("friction", 0)
                )
            );
            friction[body][wall] =
                ownFrictions.getOrDefault<scalar>(walls[wall], ofAll);

            if (!(friction[body][wall] >= 0))
            {
                FatalIOErrorInFunction(settings)
                    << "The friction of wall " << walls[wall] << " for body "
                    << method_.bodies()[body] << " is "
                    << friction[body][wall] << "; it may not be below zero."
                    << exit(FatalIOError);
            }
        }
    }

    if (method_.hasContact())
    {
        method_.walls().setFriction(friction);
    }
}


bool Foam::materialPointsPhase::liesIn
(
    const boundBox& bounds,
    const label side
) const
{
    const boundBox& box = mesh_.bounds();
    const direction d = side/2;
    const scalar at = (side % 2 ? box.max() : box.min())[d];
    const scalar little = 1e-6*box.mag();

    return
        mag(bounds.min()[d] - at) < little
     && mag(bounds.max()[d] - at) < little;
}


void Foam::materialPointsPhase::checkAllOpen
(
    const label side,
    const word& opened,
    const wordRes& outflow
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        bool shares = false;

        for (const face& f : patch)
        {
            shares =
                shares || liesIn(boundBox(patch.points(), f, false), side);
        }

        if (!outflow.match(patch.name()) && returnReduce(shares, orOp<bool>()))
        {
            FatalIOErrorInFunction(dict_)
                << "Patch " << opened << " of outflow is not the whole side of"
                << " the mesh's box: faces of " << patch.name() << " are in it,"
                << " too, and points would leave there as well." << nl
                << "    Name both in outflow, or shape the mesh so that "
                << opened << " is alone in its side." << exit(FatalIOError);
        }
    }
}


void Foam::materialPointsPhase::openSides()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const wordRes outflow
    (
        keywords::patterns(dict_, "outflow", patches.names())
    );

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        if (!outflow.match(patch.name()))
        {
            continue;
        }

        const boundBox bounds(patch.localPoints(), true);
        bool found = false;

        for (label side = 0; side < 6; ++side)
        {
            if (liesIn(bounds, side))
            {
                checkAllOpen(side, patch.name(), outflow);
                method_.open(side);
                found = true;
            }
        }

        if (!found)
        {
            FatalIOErrorInFunction(dict_)
                << "Patch " << patch.name() << " of outflow is in no side of the"
                << " mesh's box " << mesh_.bounds() << nl
                << "    Points leave where they cross such a side: end the mesh"
                << " there." << exit(FatalIOError);
        }
    }
}
