// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosity of the fluid at a wall, on a running case and on written times.

#include "wallShear.H"

#include "IOdictionary.H"
#include "Time.H"
#include "fvMesh.H"
#include "turbulenceModel.H"

namespace
{

using namespace Foam;

//- Density and kinematic viscosity of one of the liquids
struct liquid
{
    scalar rho;
    scalar nu;

    explicit liquid(const dictionary& dict)
    :
        rho(dimensionedScalar("rho", dimDensity, dict).value()),
        nu(dimensionedScalar("nu", dimViscosity, dict).value())
    {}
};


tmp<scalarField> viscosityFromProperties
(
    const volScalarField& alpha,
    const volScalarField* nut,
    const label patchi
)
{
    const fvMesh& mesh = alpha.mesh();
    const IOdictionary properties
    (
        IOobject
        (
            "transportProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    const wordList phases(properties.get<wordList>("phases"));
    const liquid first(properties.subDict(phases[0]));
    const liquid second(properties.subDict(phases[1]));

    const scalarField& share = alpha.boundaryField()[patchi];
    tmp<scalarField> mu(new scalarField(share.size()));

    forAll(share, i)
    {
        const scalar a = max(min(share[i], scalar(1)), scalar(0));
        const scalar rho = a*first.rho + (1 - a)*second.rho;

        mu.ref()[i] = a*first.rho*first.nu + (1 - a)*second.rho*second.nu;

        if (nut)
        {
            mu.ref()[i] += rho*nut->boundaryField()[patchi][i];
        }
    }

    return mu;
}

} // End anonymous namespace


Foam::tmp<Foam::scalarField> Foam::wallViscosity
(
    const volScalarField& alpha,
    const volScalarField* nut,
    const label patchi
)
{
    const fvMesh& mesh = alpha.mesh();
    const auto* turbulence =
        mesh.cfindObject<turbulenceModel>(turbulenceModel::propertiesName);
    const auto* rho = mesh.cfindObject<volScalarField>("rho");

    if (turbulence && rho)
    {
        return rho->boundaryField()[patchi]*turbulence->nuEff(patchi);
    }

    return viscosityFromProperties(alpha, nut, patchi);
}


Foam::tmp<Foam::vectorField> Foam::wallShear
(
    const volVectorField& U,
    const scalarField& viscosity,
    const label patchi
)
{
    const fvPatchVectorField& Uw = U.boundaryField()[patchi];
    const vectorField n(Uw.patch().nf());
    const vectorField gradient(Uw.snGrad());

    return -viscosity*(gradient - n*(n & gradient));
}


Foam::fluidOnPatch::fluidOnPatch
(
    const volScalarField& p,
    const volVectorField& U,
    const volScalarField& alpha,
    const volScalarField& voidFraction,
    const volScalarField* nut,
    const label patchi
)
:
    pressure
    (
        p.boundaryField()[patchi]*p.mesh().boundary()[patchi].Sf()
    ),
    viscous
    (
        voidFraction.boundaryField()[patchi]
       *wallShear(U, wallViscosity(alpha, nut, patchi)(), patchi)
       *p.mesh().boundary()[patchi].magSf()
    )
{}
