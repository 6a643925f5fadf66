// SPDX-License-Identifier: GPL-3.0-or-later
// Where a gate stands and how it is drawn, for the fluid and for material points.

#include "gateMotion.H"

#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"
#include "keywords.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

Foam::dictionary Foam::gateMotion::settings(const fvMesh& mesh)
{
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


Foam::gateMotion::gateMotion(const fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    exists_(false),
    onPlane_(Zero),
    normal_(Zero),
    direction_(Zero),
    edge_(0),
    start_(dict.getOrDefault<scalar>("start", 0)),
    strength_(dict.getOrDefault<scalar>("strength", 1))
{
    if (dict.empty())
    {
        return;
    }

    checkSettings(dict);
    onPlane_ = dict.get<point>("point");
    normal_ = keywords::unitVector(dict, "normal");
    direction_ = keywords::unitVector(dict, "direction", vector(0, 0, 1));

    if (mag(normal_ ^ direction_) < 1e-3)
    {
        FatalIOErrorInFunction(dict)
            << "The gate is drawn along its own normal, " << normal_ << ": it"
            << " would never leave its place." << nl
            << "    Give a direction that lies in its plane (without one it is"
            << " (0 0 1))." << exit(FatalIOError);
    }
    speed_ = Function1<scalar>::New("speed", dict);

    if (strength_ > 0)
    {
        exists_ = true;
        findFaces();
        findExtents();
    }
}


void Foam::gateMotion::checkSettings(const dictionary& dict)
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

    const scalar strength = dict.getOrDefault<scalar>("strength", 1);

    if (!(strength >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "strength of a gate is " << strength << nl
            << "    It stretches the time of opening: 0 (no gate), 1 (as"
            << " speed has it) or any number above 0." << exit(FatalIOError);
    }
}


void Foam::gateMotion::findFaces()
{
    // 1 beyond the plane, 0 before it
    labelList side(mesh_.nCells());
    forAll(side, cell)
    {
        side[cell] = ((mesh_.C()[cell] - onPlane_) & normal_) > 0;
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
            << "The gate's plane through " << onPlane_ << " m with the normal "
            << normal_ << " has no faces of the mesh: all cells are on one side"
            << " of it." << nl
            << "    The mesh is in " << mesh_.bounds() << " m; put point in"
            << " constant/slidingGate inside." << exit(FatalError);
    }
}


void Foam::gateMotion::findExtents()
{
    low_.setSize(faces_.size(), GREAT);
    high_.setSize(faces_.size(), -GREAT);
    edge_ = GREAT;

    forAll(faces_, i)
    {
        for (const label p : mesh_.faces()[faces_[i]])
        {
            const scalar s = mesh_.points()[p] & direction_;
            low_[i] = min(low_[i], s);
            high_[i] = max(high_[i], s);
        }
        edge_ = min(edge_, low_[i]);
    }

    reduce(edge_, minOp<scalar>());
}


Foam::scalar Foam::gateMotion::travel(const scalar t) const
{
    return
        t > start_ && exists_
      ? speed_->integrate(0, (t - start_)/strength_)
      : 0;
}


Foam::scalar Foam::gateMotion::openShare
(
    const label i,
    const scalar edge
) const
{
    const scalar height = high_[i] - low_[i];
    return
        height > SMALL
      ? min(max((edge - low_[i])/height, scalar(0)), scalar(1))
      : scalar(edge > low_[i]);
}
