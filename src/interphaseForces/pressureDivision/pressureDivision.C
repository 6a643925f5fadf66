// SPDX-License-Identifier: GPL-3.0-or-later
// Divides the pressure force that stands at faces between fluid and grains.

#include "pressureDivision.H"

Foam::pressureDivision::pressureDivision(const fvMesh& mesh)
:
    mesh_(mesh),
    B_
    (
        IOobject
        (
            "pressureDivisionB",
            mesh.time().constant(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedSymmTensor(dimLength, Zero)
    ),
    weight_
    (
        IOobject
        (
            "pressureDivisionWeight",
            mesh.time().constant(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("one", dimless, 1)
    )
{
    symmTensorField sum(mesh.nCells(), Zero);

    forAll(mesh.owner(), f)
    {
        const symmTensor part(sqr(mesh.Sf()[f])/mesh.magSf()[f]);
        sum[mesh.owner()[f]] += part;
        sum[mesh.neighbour()[f]] += part;
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        forAll(patch, i)
        {
            sum[patch.faceCells()[i]] += sqr(patch.Sf()[i])/patch.magSf()[i];
        }
    }

    B_.primitiveFieldRef() = inv(sum);
    B_.primitiveFieldRef() *= mesh.V().field();
    B_.correctBoundaryConditions();

    const auto along = [](const symmTensor& B, const vector& S)
    {
        return S & (B & S);
    };

    forAll(mesh.owner(), f)
    {
        const scalar own = along(B_[mesh.owner()[f]], mesh.Sf()[f]);
        const scalar other = along(B_[mesh.neighbour()[f]], mesh.Sf()[f]);
        weight_[f] = own/(own + other);
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled())
        {
            continue;
        }

        const symmTensorField behind
        (
            B_.boundaryField()[patch.index()].patchNeighbourField()
        );
        forAll(patch, i)
        {
            const scalar own = along(B_[patch.faceCells()[i]], patch.Sf()[i]);
            const scalar other = along(behind[i], patch.Sf()[i]);
            weight_.boundaryFieldRef()[patch.index()][i] = own/(own + other);
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::pressureDivision::atFaces
(
    const volScalarField& share
) const
{
    tmp<surfaceScalarField> result
    (
        new surfaceScalarField("shareAtFaces", weight_)
    );
    surfaceScalarField& faces = result.ref();

    forAll(mesh_.owner(), f)
    {
        faces[f] =
            weight_[f]*share[mesh_.owner()[f]]
          + (1 - weight_[f])*share[mesh_.neighbour()[f]];
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        scalarField& values = faces.boundaryFieldRef()[patch.index()];
        const fvPatchScalarField& shares = share.boundaryField()[patch.index()];

        if (patch.coupled())
        {
            values =
                values*shares.patchInternalField()
              + (1 - values)*shares.patchNeighbourField();
        }
        else
        {
            values = shares.patchInternalField();
        }
    }

    return result;
}


Foam::vectorField Foam::pressureDivision::atCells
(
    const surfaceScalarField& net
) const
{
    vectorField cells(mesh_.nCells(), Zero);

    forAll(mesh_.owner(), f)
    {
        const label own = mesh_.owner()[f];
        const label other = mesh_.neighbour()[f];
        const vector n(mesh_.Sf()[f]/mesh_.magSf()[f]);
        const vector force(net[f]*((B_[own] + B_[other]) & n));

        cells[own] += weight_[f]*force;
        cells[other] += (1 - weight_[f])*force;
    }

    for (const fvPatch& patch : mesh_.boundary())
    {
        const label at = patch.index();
        const symmTensorField behind
        (
            patch.coupled()
          ? B_.boundaryField()[at].patchNeighbourField()
          : tmp<symmTensorField>(new symmTensorField(patch.size(), Zero))
        );

        forAll(patch, i)
        {
            const label own = patch.faceCells()[i];
            const vector n(patch.Sf()[i]/patch.magSf()[i]);

            cells[own] +=
                weight_.boundaryField()[at][i]*net.boundaryField()[at][i]
               *((B_[own] + behind[i]) & n);
        }
    }

    return cells/mesh_.V().field();
}
