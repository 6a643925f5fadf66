// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing by diffusion over a width tied to the grains.

#include "diffusion.H"

#include "addToRunTimeSelectionTable.H"
#include "cyclicFvPatch.H"
#include "keywords.H"
#include "processorFvPatch.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace Foam
{
namespace smoothingModels
{
    defineTypeName(diffusion);
    addToRunTimeSelectionTable(smoothingModel, diffusion, dictionary);
}
}


Foam::smoothingModels::diffusion::diffusion
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    width_(dict.lookupOrDefault<scalar>("width", 3)),
    conductance_(mesh.nFaces(), Zero),
    longestStep_(GREAT),
    step_(0),
    nSteps_(0)
{
    keywords::check(dict, {"model", "width"});

    if (width_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "width is " << width_ << " grain diameters: give 0 or more"
            << " (default 3; Sun & Xiao use 6)." << exit(FatalIOError);
    }

    scalarField perCell(mesh.nCells(), Zero);

    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        conductance_[f] = mesh.magSf()[f]*mesh.deltaCoeffs()[f];
        perCell[mesh.owner()[f]] += conductance_[f];
        perCell[mesh.neighbour()[f]] += conductance_[f];
    }

    for (const fvPatch& patch : mesh.boundary())
    {
        if (isA<processorFvPatch>(patch) || isA<cyclicFvPatch>(patch))
        {
            const scalarField g(patch.magSf()*patch.deltaCoeffs());

            forAll(g, i)
            {
                conductance_[patch.start() + i] = g[i];
                perCell[patch.faceCells()[i]] += g[i];
            }
        }
    }

    forAll(perCell, cell)
    {
        longestStep_ =
            min(longestStep_, 0.5*mesh.V()[cell]/(perCell[cell] + VSMALL));
    }
    reduce(longestStep_, minOp<scalar>());
}


void Foam::smoothingModels::diffusion::setDiameter(const scalar d)
{
    // A point becomes exp(-r^2/(4 t)) after the time t
    const scalar duration = sqr(width_*d)/4;

    nSteps_ = label(std::ceil(duration/longestStep_));
    step_ = nSteps_ ? duration/nSteps_ : 0;
}


template<class T>
void Foam::smoothingModels::diffusion::swap
(
    const Field<T>& cells,
    Field<T>& behind
) const
{
    const auto commsType = Pstream::commsTypes::nonBlocking;
    const label firstRequest = Pstream::nRequests();

    for (const fvPatch& patch : mesh_.boundary())
    {
        if (isA<processorFvPatch>(patch))
        {
            refCast<const processorFvPatch>(patch).send
            (
                commsType,
                Field<T>(cells, patch.faceCells())
            );
        }
    }

    Pstream::waitRequests(firstRequest);

    for (const fvPatch& patch : mesh_.boundary())
    {
        SubField<T> values
        (
            behind,
            patch.size(),
            patch.start() - mesh_.nInternalFaces()
        );

        if (isA<processorFvPatch>(patch))
        {
            refCast<const processorFvPatch>(patch).receive(commsType, values);
        }
        else if (isA<cyclicFvPatch>(patch))
        {
            values = Field<T>
            (
                cells,
                refCast<const cyclicFvPatch>(patch).neighbFvPatch().faceCells()
            );
        }
    }
}


template<class T>
void Foam::smoothingModels::diffusion::diffuse(Field<T>& cells) const
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const labelUList& faceOwner = mesh_.faceOwner();
    const scalarField& volume = mesh_.V();

    Field<T> gain(cells.size());
    Field<T> behind(mesh_.nFaces() - nInternal, Zero);

    for (label n = 0; n < nSteps_; ++n)
    {
        gain = Zero;

        for (label f = 0; f < nInternal; ++f)
        {
            const T flux
            (
                conductance_[f]*(cells[neighbour[f]] - cells[owner[f]])
            );
            gain[owner[f]] += flux;
            gain[neighbour[f]] -= flux;
        }

        swap(cells, behind);

        forAll(behind, i)
        {
            const label f = nInternal + i;

            if (conductance_[f] > 0)
            {
                gain[faceOwner[f]] +=
                    conductance_[f]*(behind[i] - cells[faceOwner[f]]);
            }
        }

        forAll(cells, cell)
        {
            cells[cell] += step_/volume[cell]*gain[cell];
        }
    }
}
