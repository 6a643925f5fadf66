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
        IOobject("ofGrains", mesh.time().timeName(), mesh),
        mesh,
        dimensioned<T>(dimless, Zero),
        "zeroGradient"
    );
    all.ref().primitiveFieldRef() = cells;
    all.ref().correctBoundaryConditions();
    return all;
}

} // End anonymous namespace


Foam::solidTransport::solidTransport(const fvMesh& mesh)
:
    mesh_(mesh),
    flux_
    (
        IOobject("fluxOfGrains", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    )
{}


void Foam::solidTransport::update
(
    const granularPhase& phase,
    const grainExchange& exchange,
    const particleMeshMapping& mapping
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
    const surfaceVectorField U
    (
        fvc::interpolate(momenta())/max(fraction, dimensionedScalar("small", dimless, SMALL))
    );

    flux_.primitiveFieldRef() =
        (U.primitiveField() & mesh_.Sf().primitiveField());
    forAll(mesh_.boundary(), patch)
    {
        fvsPatchScalarField& flux = flux_.boundaryFieldRef()[patch];
        flux = U.boundaryField()[patch] & mesh_.Sf().boundaryField()[patch];
        if (!flux.coupled())
        {
            // What comes in from outside is no grain of these cells
            flux = max(flux, scalar(0));
            if (phase.isWall(mesh_.boundary()[patch].patch()))
            {
                flux = 0;
            }
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::solidTransport::voidFractionRate
(
    const volScalarField& voidFraction
) const
{
    IStringStream scheme("limitedLinear 1");
    const surfaceScalarField transported
    (
        surfaceInterpolationScheme<scalar>::New(mesh_, flux_, scheme)
            ->interpolate(1 - voidFraction)*flux_
    );
    return tmp<scalarField>::New(fvc::surfaceIntegrate(transported)->primitiveField());
}
