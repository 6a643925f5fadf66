// SPDX-License-Identifier: GPL-3.0-or-later
// A gate that holds the fluid back and is drawn out of its way.

#include "slidingGate.H"

#include "Time.H"
#include "activePhysics.H"
#include "volFields.H"

Foam::slidingGate::slidingGate(const fvMesh& mesh)
:
    slidingGate(mesh, gateMotion::settings(mesh))
{}


Foam::slidingGate::slidingGate(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    motion_(mesh, dict)
{
    if (dict.empty())
    {
        return;
    }

    dictionary inUse(dict);
    inUse.set("strength", motion_.strength());
    writeActivePhysics(mesh_, "slidingGate", inUse);

    if (!motion_.exists())
    {
        return;
    }

    checkPlane();
    open_.reset
    (
        new surfaceScalarField
        (
            IOobject("gateOpen", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar("open", dimless, 1)
        )
    );
    move(mesh.time().value());

    const labelList& faces = motion_.faces();
    Info<< "Gate: " << returnReduce(faces.size(), sumOp<label>())
        << " faces, drawn " << travel(mesh.time().value()) << " m" << nl
        << endl;
}


void Foam::slidingGate::checkPlane() const
{
    scalar beside = 0;
    scalar cell = GREAT;
    for (const label face : motion_.faces())
    {
        const point& centre = mesh_.faceCentres()[face];
        beside = max(beside, mag((centre - motion_.onPlane()) & motion_.normal()));
        cell = min(cell, cbrt(mesh_.V()[mesh_.faceOwner()[face]]));
    }
    reduce(beside, maxOp<scalar>());
    reduce(cell, minOp<scalar>());

    if (beside > 0.05*cell)
    {
        WarningInFunction
            << "The gate stands on faces of the mesh up to " << beside
            << " m beside its plane: fluid is held back there, and let go from"
            << " there." << nl
            << "    Let faces of the mesh lie in the plane." << endl;
    }
}


void Foam::slidingGate::move(const scalar t)
{
    if (!exists())
    {
        return;
    }

    const labelList& faces = motion_.faces();
    const scalar edge = motion_.edge(t);
    const label nInternal = mesh_.nInternalFaces();

    forAll(faces, i)
    {
        const scalar share = motion_.openShare(i, edge);

        if (faces[i] < nInternal)
        {
            (*open_)[faces[i]] = share;
        }
        else
        {
            const label patch = mesh_.boundaryMesh().whichPatch(faces[i]);
            open_->boundaryFieldRef()[patch]
            [
                mesh_.boundaryMesh()[patch].whichFace(faces[i])
            ] = share;
        }
    }
}


void Foam::slidingGate::close(surfaceScalarField& throughFaces) const
{
    if (exists())
    {
        throughFaces *= *open_;
    }
}
