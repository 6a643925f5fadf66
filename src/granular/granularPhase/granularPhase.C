// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the granular method and what all methods share.

#include "granularPhase.H"

#include "keywords.H"

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
    coarseGraining_(dict.lookupOrDefault<scalar>("coarseGraining", 1)),
    stepsPerExchange_(stepsPerExchange)
{
    if (coarseGraining_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "coarseGraining is " << coarseGraining_
            << ": one computed grain cannot stand for less than one grain."
            << " Give 1 or more." << exit(FatalIOError);
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


Foam::autoPtr<Foam::granularPhase> Foam::granularPhase::New
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g,
    const label stepsPerExchange
)
{
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


Foam::label Foam::granularPhase::nTotal() const
{
    return returnReduce(size(), sumOp<label>());
}
