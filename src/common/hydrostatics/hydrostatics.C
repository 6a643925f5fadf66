// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure gradient of fluids at rest, on a mesh that may repeat itself along
// gravity.

#include "hydrostatics.H"

#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "volFields.H"

namespace
{

using namespace Foam;

//- Share of gravity that is rounding [-]
const scalar rounding = 1e-6;

//- How far the two sides of a cyclic patch may miss each other, as a share of the
//  size of a face: some times OpenFOAM's matchTolerance
const scalar mismatch = 1e-3;


scalar faceSize(const fvPatch& patch)
{
    return std::sqrt(max(patch.magSf()));
}


volVectorField cellCentres(const fvMesh& mesh)
{
    volVectorField result
    (
        IOobject
        (
            "cellCentres",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedVector(dimLength, Zero)
    );
    result.primitiveFieldRef() = mesh.cellCentres();
    result.correctBoundaryConditions();

    return result;
}


//- From a face of a patch to its image [m], the mean of all; none where the patch
//  joins neighbours, or is no plane one that repeats the mesh
vector stepOf(const fvPatchVectorField& centres)
{
    const fvPatch& patch = centres.patch();
    const auto* cyclic = isA<cyclicPolyPatch>(patch.patch());
    const auto* cut = isA<processorCyclicPolyPatch>(patch.patch());

    const bool repeats =
        patch.size()
     && ((cyclic && cyclic->parallel()) || (cut && cut->parallel()));

    if (!repeats)
    {
        return Zero;
    }

    const vectorField delta(patch.delta());
    const vector step
    (
        average
        (
            centres.patchNeighbourField() - centres.patchInternalField() - delta
        )
    );

    // A mesh that repeats itself does so after a cell at least
    return mag(step) > 0.5*mag(average(delta)) ? step : vector(Zero);
}


//- Unless the density differs between cells by more than a thousandth
bool uniform(const scalarField& rho)
{
    const scalar most = gMax(rho);

    return most - gMin(rho) <= 1e-3*most;
}

} // End anonymous namespace


Foam::vector Foam::hydrostatics::periodicPart
(
    const fvMesh& mesh,
    const vector& g
)
{
    const volVectorField centres(cellCentres(mesh));
    vector rest(g);

    for (direction k = 0; k < 3; ++k)
    {
        // The step from a cell to its image that has most of what is left of g
        vector step(Zero);

        for (const fvPatchVectorField& patch : centres.boundaryField())
        {
            const vector s(stepOf(patch));
            const scalar along = mag(rest & s)/(mag(s) + VSMALL);

            if
            (
                along > mag(rest & step)/(mag(step) + VSMALL)
             && along*mag(s) > mismatch*faceSize(patch.patch())*mag(g)
            )
            {
                step = s;
            }
        }

        // The rank with the largest share of g along its step decides
        vector part(step*(rest & step)/(magSqr(step) + VSMALL));
        reduce(part, maxMagSqrOp<vector>());

        if (mag(part) <= rounding*mag(g))
        {
            break;
        }
        rest -= part;
    }

    return g - rest;
}


void Foam::hydrostatics::checkContinuous(const fvMesh& mesh) const
{
    const volVectorField centres(cellCentres(mesh));
    const volScalarField potential("potential", normal_ & centres);

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const fvPatchScalarField& onPatch = potential.boundaryField()[patchi];
        scalar jump = 0;
        scalar allowed = 0;

        if (patch.coupled() && patch.size())
        {
            jump = max
            (
                mag
                (
                    onPatch.patchNeighbourField() - onPatch.patchInternalField()
                  - (normal_ & patch.delta())
                )
            );

            // Faces that only overlap see a mean of those beyond
            allowed =
                mag(normal_)*faceSize(patch)
               *(isA<cyclicAMIPolyPatch>(patch.patch()) ? 1 : mismatch);
        }

        if (jump > allowed)
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of type " << patch.type()
                << " repeats the mesh, and gravity times height differs by "
                << jump << " m2/s2 between its two sides." << nl
                << "    With two fluids, gravity can drive the flow along plane"
                << " 'cyclic' patches only." << nl
                << "    Make the patches cyclic, or change the direction of"
                << " gravity in constant/g." << exit(FatalError);
        }
    }
}


Foam::hydrostatics::hydrostatics(const vector& g)
:
    g_(g),
    normal_(g),
    along_(Zero),
    rhoLight_(0),
    oneFluid_(false)
{}


Foam::hydrostatics::hydrostatics
(
    const fvMesh& mesh,
    const vector& g,
    const scalarField& rho,
    const scalar rhoLight
)
:
    hydrostatics(g)
{
    const vector part(periodicPart(mesh, g));

    if (uniform(rho))
    {
        oneFluid_ = mag(part) > 0;

        if (oneFluid_)
        {
            Info<< "Gravity along the cyclic patches, " << part << " m/s2, is"
                << " balanced by the pressure gradient of the one fluid in the"
                << " mesh" << nl << endl;
        }
        return;
    }

    if (mag(part) > 0)
    {
        along_ = part;
        normal_ = g - part;
        rhoLight_ = rhoLight;

        Info<< "Gravity along the cyclic patches, " << part << " m/s2, drives the"
            << " flow. Along it the pressure rises as in the lighter fluid at rest"
            << nl << endl;
    }
    checkContinuous(mesh);
}


Foam::vectorField Foam::hydrostatics::gradient(const scalarField& rho) const
{
    vectorField result(rho.size());

    forAll(rho, cell)
    {
        result[cell] = gradient(rho[cell]);
    }

    return result;
}


void Foam::hydrostatics::check(const scalarField& rho) const
{
    if (oneFluid_ && !uniform(rho))
    {
        FatalErrorInFunction
            << "A second fluid has come into a mesh that one fluid filled at the"
            << " start, and whose cyclic patches repeat it along gravity: there"
            << " the pressure of the one fluid at rest balanced gravity, which"
            << " is wrong for two." << nl
            << "    Start with both fluids in the mesh: then gravity drives the"
            << " flow along the cyclic patches." << exit(FatalError);
    }
}
