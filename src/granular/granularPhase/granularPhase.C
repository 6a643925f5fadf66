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


Foam::granularPhase::granularPhase(const fvMesh& mesh, const dictionary& dict)
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
    stepsPerExchange_
    (
        keywords::sub(dict, "exchange", {"interval"})
            .lookupOrDefault<label>("interval", 10)
    )
{
    if (coarseGraining_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "coarseGraining is " << coarseGraining_
            << ": one computed grain cannot stand for less than one grain."
            << " Give 1 or more." << exit(FatalIOError);
    }

    if (stepsPerExchange_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "exchange/interval is " << stepsPerExchange_
            << ": give the number of DEM steps between two exchanges,"
            << " 1 or more (default 10)." << exit(FatalIOError);
    }
}


Foam::autoPtr<Foam::granularPhase> Foam::granularPhase::New
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word modelType
    (
        keywords::choice(dict, typeName, "granular method", table.sortedToc())
    );

    keywords::check
    (
        dict,
        {
            "FoamFile", typeName, modelType, "coarseGraining", "exchange",
            "porosity", "interphaseForces"
        }
    );

    return table.cfind(modelType).val()(mesh, dict, g);
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
