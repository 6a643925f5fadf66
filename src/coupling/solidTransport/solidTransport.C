// SPDX-License-Identifier: GPL-3.0-or-later
// How the grains carry a solid fraction along.

#include "solidTransport.H"

#include "IStringStream.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceInterpolate.H"
#include "surfaceInterpolationScheme.H"

namespace
{

using namespace Foam;

//- A field of cells whose sides have the values of their cells
template<class T>
tmp<GeometricField<T, fvPatchField, volMesh>> onMesh
(
    const fvMesh& mesh,
    const Field<T>& cells
)
{
    auto all = tmp<GeometricField<T, fvPatchField, volMesh>>::New
    (
        IOobject
        (
            "ofGrains",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensioned<T>(dimless, Zero),
        "zeroGradient"
    );
    all.ref().primitiveFieldRef() = cells;
    all.ref().correctBoundaryConditions();
    return all;
}

} // End anonymous namespace


Foam::solidTransport::solidTransport(const fvMesh& mesh, const granularPhase& phase)
:
    mesh_(mesh),
    flux_
    (
        IOobject("fluxOfGrains", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    isOutlet_(mesh.boundary().size())
{
    forAll(isOutlet_, patch)
    {
        isOutlet_[patch] = phase.isOutlet(mesh.boundaryMesh()[patch]);
    }
}


void Foam::solidTransport::update
(
    const grainExchange& exchange,
    const grainMeshMapping& mapping
)
{
    const List<locatedGrain>& grains = exchange.grains();
    const scalarField& volumes = mapping.volumes();
    vectorField momentum(grains.size());
    forAll(grains, i)
    {
        momentum[i] = volumes[i]*grains[i].velocity;
    }

    // A face with grains on one side only has their velocity
    const auto solids = onMesh(mesh_, mapping.spread(volumes));
    const auto momenta = onMesh(mesh_, mapping.spread(momentum));
    const surfaceScalarField fraction(fvc::interpolate(solids()));
    const dimensionedScalar small("small", dimless, SMALL);
    const surfaceVectorField U(fvc::interpolate(momenta())/max(fraction, small));

    flux_.primitiveFieldRef() =
        (U.primitiveField() & mesh_.Sf().primitiveField());
    forAll(mesh_.boundary(), patch)
    {
        fvsPatchScalarField& flux = flux_.boundaryFieldRef()[patch];
        if (flux.coupled() || isOutlet_[patch])
        {
            flux = U.boundaryField()[patch] & mesh_.Sf().boundaryField()[patch];
        }
        if (isOutlet_[patch])
        {
            // What comes in from outside is no grain of these cells
            flux = max(flux, scalar(0));
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::solidTransport::voidFractionRate
(
    const volScalarField& voidFraction,
    const slidingGate& gate
) const
{
    IStringStream scheme("limitedLinear 1");
    surfaceScalarField transported
    (
        surfaceInterpolationScheme<scalar>::New(mesh_, flux_, scheme)
            ->interpolate(1 - voidFraction)*flux_
    );
    gate.close(transported);
    return tmp<scalarField>::New(fvc::surfaceIntegrate(transported)->primitiveField());
}
