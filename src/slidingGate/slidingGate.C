// SPDX-License-Identifier: GPL-3.0-or-later
// A gate that holds the fluid back and is drawn out of its way.

#include "slidingGate.H"

#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"
#include "activePhysics.H"
#include "keywords.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"
#include "volFields.H"

namespace
{

//- The dictionary of the case; empty where there is none
Foam::dictionary settings(const Foam::fvMesh& mesh)
{
    using namespace Foam;

    IOobject io
    (
        "slidingGate",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    // A file that exists is read; an error in it is reported
    const fileName path
    (
        mesh.time().globalPath()/mesh.time().constant()/io.name()
    );

    return
        returnReduce(isFile(path), orOp<bool>())
      ? dictionary(IOdictionary(io))
      : dictionary();
}

} // End anonymous namespace


Foam::slidingGate::slidingGate(const fvMesh& mesh)
:
    slidingGate(mesh, settings(mesh))
{}


Foam::slidingGate::slidingGate(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    edge_(0),
    start_(dict.lookupOrDefault<scalar>("start", 0)),
    strength_(dict.lookupOrDefault<scalar>("strength", 1))
{
    if (dict.empty())
    {
        return;
    }

    checkSettings(dict);

    dictionary inUse(dict);
    inUse.set("strength", strength_);
    writeActivePhysics(mesh_, "slidingGate", inUse);

    const point onPlane(dict.get<point>("point"));
    const vector normal(keywords::unitVector(dict, "normal"));
    const vector direction
    (
        keywords::unitVector(dict, "direction", vector(0, 0, 1))
    );
    if (mag(normal ^ direction) < 1e-3)
    {
        FatalIOErrorInFunction(dict)
            << "The gate is drawn along its own normal, " << normal << ": it"
            << " would never leave its place." << nl
            << "    Give a direction that lies in its plane (without one it is"
            << " (0 0 1))." << exit(FatalIOError);
    }
    speed_ = Function1<scalar>::New("speed", dict);

    if (strength_ == 0)
    {
        return;
    }

    findFaces(onPlane, normal);
    checkPlane(onPlane, normal);
    findExtents(direction);

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

    Info<< "Gate: " << returnReduce(faces_.size(), sumOp<label>())
        << " faces, drawn " << drawn(mesh.time().value()) << " m" << nl
        << endl;
}


void Foam::slidingGate::checkSettings(const dictionary& dict)
{
    keywords::check
    (
        dict,
        {
            "FoamFile", "point", "normal", "direction", "speed", "speedCoeffs",
            "start", "strength"
        },
        "\n    They are those of constant/slidingGate."
    );

    const scalar strength = dict.lookupOrDefault<scalar>("strength", 1);

    if (!(strength >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "strength of a gate is " << strength << nl
            << "    It stretches the time of opening: 0 (no gate), 1 (as"
            << " speed has it) or any number above 0." << exit(FatalIOError);
    }
}


void Foam::slidingGate::findFaces(const point& onPlane, const vector& normal)
{
    // 1 beyond the plane, 0 before it
    labelList side(mesh_.nCells());
    forAll(side, cell)
    {
        side[cell] = ((mesh_.C()[cell] - onPlane) & normal) > 0;
    }

    const labelList& owner = mesh_.faceOwner();
    DynamicList<label> faces;

    for (label face = 0; face < mesh_.nInternalFaces(); ++face)
    {
        if (side[owner[face]] != side[mesh_.faceNeighbour()[face]])
        {
            faces.append(face);
        }
    }

    // Faces between ranks; the two sides of a periodic direction are no gate
    labelList other;
    syncTools::swapBoundaryCellList(mesh_, side, other);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if
        (
            isA<processorPolyPatch>(patch)
         && !isA<processorCyclicPolyPatch>(patch)
        )
        {
            forAll(patch, i)
            {
                const label face = patch.start() + i;

                if (side[owner[face]] != other[face - mesh_.nInternalFaces()])
                {
                    faces.append(face);
                }
            }
        }
    }

    faces_.transfer(faces);

    if (!returnReduce(faces_.size(), sumOp<label>()))
    {
        FatalErrorInFunction
            << "The gate's plane through " << onPlane << " m with the normal "
            << normal << " has no faces of the mesh: all cells are on one side"
            << " of it." << nl
            << "    The mesh is in " << mesh_.bounds() << " m; put point in"
            << " constant/slidingGate inside." << exit(FatalError);
    }
}


void Foam::slidingGate::checkPlane
(
    const point& onPlane,
    const vector& normal
) const
{
    scalar beside = 0;
    scalar cell = GREAT;
    for (const label face : faces_)
    {
        const point& centre = mesh_.faceCentres()[face];
        beside = max(beside, mag((centre - onPlane) & normal));
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


void Foam::slidingGate::findExtents(const vector& direction)
{
    low_.setSize(faces_.size(), GREAT);
    high_.setSize(faces_.size(), -GREAT);
    edge_ = GREAT;

    forAll(faces_, i)
    {
        for (const label p : mesh_.faces()[faces_[i]])
        {
            const scalar s = mesh_.points()[p] & direction;
            low_[i] = min(low_[i], s);
            high_[i] = max(high_[i], s);
        }
        edge_ = min(edge_, low_[i]);
    }

    reduce(edge_, minOp<scalar>());
}


Foam::scalar Foam::slidingGate::drawn(const scalar t) const
{
    return
        t > start_ && exists()
      ? speed_->integrate(0, (t - start_)/strength_)
      : 0;
}


void Foam::slidingGate::move(const scalar t)
{
    if (!exists())
    {
        return;
    }

    const scalar edge = edge_ + drawn(t);
    const label nInternal = mesh_.nInternalFaces();

    forAll(faces_, i)
    {
        const scalar height = high_[i] - low_[i];
        const scalar share =
            height > SMALL
          ? min(max((edge - low_[i])/height, scalar(0)), scalar(1))
          : scalar(edge > low_[i]);

        if (faces_[i] < nInternal)
        {
            (*open_)[faces_[i]] = share;
        }
        else
        {
            const label patch = mesh_.boundaryMesh().whichPatch(faces_[i]);
            open_->boundaryFieldRef()[patch]
            [
                mesh_.boundaryMesh()[patch].whichFace(faces_[i])
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
