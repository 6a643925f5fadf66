// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the granular method and what all methods share.

#include "granularPhase.H"

#include "Time.H"
#include "cloud.H"
#include "grainSnapshot.H"
#include "keywords.H"
#include "wedgePolyPatch.H"

namespace Foam
{
    defineTypeNameAndDebug(granularPhase, 0);
    defineRunTimeSelectionTable(granularPhase, dictionary);
}

const Foam::fileName Foam::granularPhase::stateFolder("uniform/granular");


Foam::granularPhase::granularPhase
(
    const fvMesh& mesh,
    const dictionary& dict,
    const label stepsPerExchange
)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            mesh.time().constant(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    coarseGraining_(dict.getOrDefault<scalar>("coarseGraining", 1)),
    stepsPerExchange_(stepsPerExchange),
    startTime_(mesh.time().value()),
    nIntervals_(0)
{
    if (coarseGraining_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "coarseGraining is " << coarseGraining_
            << ": one computed grain cannot stand for less than one grain."
            << " Give 1 or more." << exit(FatalIOError);
    }
}


void Foam::granularPhase::checkNoStateLost
(
    const string& beginning,
    const word& stateName
) const
{
    if (mesh_.time().value() <= SMALL)
    {
        return;
    }

    // Written beside the state by each run with grains, the first beside a fluid
    // only; but not where it began
    const fileName folder(cloud::prefix/grainSnapshot::cloudName);

    for (const fileName& trace : {fileName("voidFraction"), folder/"positions"})
    {
        const bool exists =
            !fileHandler().filePath(mesh_.time().timePath()/trace).empty();

        if (returnReduce(exists, orOp<bool>()))
        {
            FatalErrorInFunction
                << "The state of the grains, " << stateFolder/stateName
                << ", is not"
                << " in time " << mesh_.time().timeName()
                << " of a run with grains." << nl
                << "    Go on from a time that has it. To begin with the grains"
                << " of " << beginning << " there, remove voidFraction and "
                << folder << " from that time." << exit(FatalError);
        }
    }
}


Foam::word Foam::granularPhase::methodOf(const dictionary& dict)
{
    return keywords::choice
    (
        dict,
        typeName,
        "granular method",
        dictionaryConstructorTablePtr_->sortedToc()
    );
}


Foam::wordList Foam::granularPhase::keywordsIn(const dictionary& dict)
{
    return wordList({typeName, methodOf(dict), "coarseGraining"});
}


void Foam::granularPhase::checkPatches(const fvMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " is a wedge, and grains are not"
                << " the same around an axis: they would fall out of the mesh there."
                << nl << "    Use the whole mesh around the axis, or a slice with"
                << " 'empty' or 'cyclic' patches, in which grains repeat."
                << exit(FatalError);
        }
    }
}


Foam::autoPtr<Foam::granularPhase> Foam::granularPhase::New
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g,
    const label stepsPerExchange
)
{
    checkPatches(mesh);
    return dictionaryConstructorTablePtr_->cfind(methodOf(dict)).val()
    (
        mesh, dict, g, stepsPerExchange
    );
}


Foam::dictionary Foam::granularPhase::activePhysics() const
{
    dictionary result;
    result.add("coarseGraining", coarseGraining_);
    result.add("exchangeInterval", exchangeInterval());
    return result;
}


Foam::word Foam::granularPhase::timeName() const
{
    return Time::timeName(time());
}


Foam::label Foam::granularPhase::nTotal() const
{
    return returnReduce(size(), sumOp<label>());
}
