// SPDX-License-Identifier: GPL-3.0-or-later
// The dictionary of the grains, constant/granularProperties.

#include "granularProperties.H"

#include "DynamicList.H"
#include "OSspecific.H"
#include "Time.H"
#include "dragModel.H"
#include "hasFluid.H"
#include "keywords.H"
#include "smoothingModel.H"

Foam::granularProperties::granularProperties(const fvMesh& mesh)
:
    IOdictionary
    (
        IOobject
        (
            "granularProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    stepsPerExchange_
    (
        keywords::sub(*this, "exchange", {"interval", "relaxationTime"})
            .getOrDefault<label>("interval", 10)
    ),
    relaxationTime_
    (
        subOrEmptyDict("exchange").getOrDefault<scalar>("relaxationTime", 0)
    )
{
    DynamicList<word> known(granularPhase::keywordsIn(*this));
    for
    (
        const word key :
        {"FoamFile", "fluid", "exchange", "voidFraction", "interphaseForces"}
    )
    {
        known.append(key);
    }
    keywords::checkRenamed(*this, {{"porosity", "voidFraction"}});
    keywords::check(*this, known);

    if (stepsPerExchange_ < 1)
    {
        FatalIOErrorInFunction(*this)
            << "exchange/interval is " << stepsPerExchange_
            << ": give the number of DEM steps between two exchanges,"
            << " 1 or more (default 10)." << exit(FatalIOError);
    }
    if (!(relaxationTime_ >= 0))
    {
        FatalIOErrorInFunction(*this)
            << "exchange/relaxationTime is " << relaxationTime_
            << " s: give 0 (default) for the exchange interval, or a longer time"
            << " constant with which the fluid takes up the noise of their void fraction."
            << exit(FatalIOError);
    }
}


bool Foam::granularProperties::present(const fvMesh& mesh)
{
    const fileName path
    (
        mesh.time().globalPath()/mesh.time().constant()/"granularProperties"
    );

    return returnReduce(isFile(path), orOp<bool>());
}


bool Foam::granularProperties::withoutFluid(const fvMesh& mesh)
{
    return
        present(mesh)
     && keywords::choice
        (
            granularProperties(mesh),
            "fluid",
            "fluid",
            {defaultFluid, "none"},
            defaultFluid
        ) == "none";
}


Foam::autoPtr<Foam::granularPhase> Foam::granularProperties::makePhase
(
    const fvMesh& mesh,
    const vector& g
) const
{
    return granularPhase::New(mesh, *this, g, stepsPerExchange_);
}


void Foam::granularProperties::checkSmoothing(const granularPhase& phase) const
{
    const dictionary smoothing
    (
        subOrEmptyDict("voidFraction").subOrEmptyDict("smoothing")
    );
    const dictionary drag
    (
        subOrEmptyDict("interphaseForces").subOrEmptyDict("drag")
    );

    if
    (
        !phase.hasContactRadius()
     && drag.getOrDefault<word>("model", dragModel::defaultModel) != "none"
     && smoothing.getOrDefault<word>("model", smoothingModel::defaultModel) != "none"
     && !smoothing.found("drag")
    )
    {
        IOWarningInFunction(*this)
            << "voidFraction/smoothing also smooths the drag of the material points,"
            << " whose solid and liquid can then part in single cells." << nl
            << "    Write  drag off;  in it, or  drag on;  if that is meant."
            << nl << endl;
    }
}
