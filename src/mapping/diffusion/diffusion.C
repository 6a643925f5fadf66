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


namespace
{
    //- What passes between cells whose water fractions differ by this much [-]: nothing
    //  across a sharp surface, a 250th across one that is smeared over a cell. A factor
    //  that is smooth: with max(1 - 2 |..|, 0) the void fraction of a surge jumped where
    //  its front went from cell to cell, and the pressure with it
    Foam::scalar passes(const Foam::scalar difference)
    {
        return Foam::pow4(1 - Foam::min(Foam::mag(difference), Foam::scalar(1)));
    }

    //- exp(-x) from 0 to 2 r in Chebyshev polynomials of x/r - 1: coefficients
    //  2 (-1)^k e^-r I_k(r), half of it for k = 0, to where the rest is below
    //  1e-10. By Miller's backward recurrence; their sum at x = 0 is 1, which
    //  keeps the integral
    Foam::scalarList exponential(const Foam::scalar r)
    {
        using namespace Foam;

        // e^-r I_k(r) falls as exp(-k^2/(2 r)), and faster for k > r
        const label most = label(std::ceil(10*std::sqrt(r))) + 40;
        scalarList coefficients(most, Zero);
        scalar later = 0;
        scalar present = 1e-280;

        for (label k = most - 1; k >= 0; --k)
        {
            coefficients[k] = present;
            const scalar earlier = later + 2*k/r*present;
            later = present;
            present = earlier;
        }

        label n = most;
        scalar rest = 0;
        const scalar all = 2*sum(coefficients) - coefficients[0];
        while (n > 1 && rest + 2*coefficients[n - 1] < 1e-10*all)
        {
            rest += 2*coefficients[--n];
        }

        coefficients.setSize(n);
        forAll(coefficients, k)
        {
            coefficients[k] *= (k ? (k % 2 ? -2 : 2) : 1)/(all - rest);
        }

        return coefficients;
    }
}


Foam::smoothingModels::diffusion::diffusion
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    width_(dict.getOrDefault<scalar>("width", 3)),
    diameter_(dict.getOrDefault<scalar>("diameter", 0)),
    warnedOfJump_(false),
    conductance_(mesh.nFaces(), Zero),
    longestStep_(GREAT)
{
    keywords::check(dict, {"model", "width", "diameter", "drag"});

    if (width_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "width is " << width_ << " grain diameters: give 0 or more"
            << " (default 3; Sun & Xiao use 6)." << exit(FatalIOError);
    }
    if (dict.found("diameter") && !(diameter_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "diameter is " << diameter_ << " m; it must be above zero."
            << " Without it the width goes by the mean of the grains."
            << exit(FatalIOError);
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
    open_ = conductance_;
}


void Foam::smoothingModels::diffusion::warnOfJump(const scalar next)
{
    if (width_ == 0 || next <= 0)
    {
        return;
    }

    const label octave = std::ilogb(next);
    firstDiameters_.insert(octave, next);
    const scalar first = firstDiameters_[octave];

    if (mag(next - first) > 0.01*first && !warnedOfJump_)
    {
        warnedOfJump_ = true;
        WarningInFunction
            << "The mean diameter of grains of like size went from " << first
            << " to " << next << " m (reported once), and with it the width"
            << " of their smoothing: the void fraction also changes where"
            << " no grain moves, and drives water there." << nl
            << "    Give voidFraction/smoothing of constant/granularProperties a"
            << " diameter of its own, as: diameter " << first << ";"
            << endl;
    }
}


Foam::smoothingModels::diffusion::schedule
Foam::smoothingModels::diffusion::scheduleOf(const scalar diameter) const
{
    // A point becomes exp(-r^2/(4 t)) after the time t
    const scalar duration = sqr(width_*diameter)/4;

    schedule how;
    how.width = width_*diameter;
    how.nSteps = label(std::ceil(duration/longestStep_));
    how.step = how.nSteps ? duration/how.nSteps : 0;

    // The steps keep what is positive so, and are fewer where they are few
    if (how.nSteps > 20)
    {
        how.series = exponential(duration/longestStep_/2);
        if (how.series.size() > how.nSteps)
        {
            how.series.clear();
        }
    }

    return how;
}


void Foam::smoothingModels::diffusion::setDiameters(const UList<scalar>& d)
{
    schedules_.setSize(d.size());

    forAll(d, i)
    {
        const scalar diameter = diameter_ > 0 ? diameter_ : d[i];
        warnOfJump(diameter);
        schedules_[i] = scheduleOf(diameter);
    }
}


void Foam::smoothingModels::diffusion::setWater(const scalarField& water)
{
    open_ = conductance_;

    if (!returnReduce(water.size(), sumOp<label>()))
    {
        return;
    }

    const label nInternal = mesh_.nInternalFaces();
    scalarField behind(mesh_.nFaces() - nInternal, Zero);
    swap(water, behind);

    for (label f = 0; f < nInternal; ++f)
    {
        open_[f] *=
            passes(water[mesh_.owner()[f]] - water[mesh_.neighbour()[f]]);
    }
    forAll(behind, i)
    {
        const label f = nInternal + i;
        open_[f] *= passes(water[mesh_.faceOwner()[f]] - behind[i]);
    }
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
void Foam::smoothingModels::diffusion::computeGain
(
    const Field<T>& cells,
    Field<T>& gain
) const
{
    const label nInternal = mesh_.nInternalFaces();
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const labelUList& faceOwner = mesh_.faceOwner();

    gain = Zero;

    for (label f = 0; f < nInternal; ++f)
    {
        const T flux
        (
            open_[f]*(cells[neighbour[f]] - cells[owner[f]])
        );
        gain[owner[f]] += flux;
        gain[neighbour[f]] -= flux;
    }

    Field<T> behind(mesh_.nFaces() - nInternal, Zero);
    swap(cells, behind);

    forAll(behind, i)
    {
        const label f = nInternal + i;

        if (open_[f] > 0)
        {
            gain[faceOwner[f]] +=
                open_[f]*(behind[i] - cells[faceOwner[f]]);
        }
    }
}


template<class T>
void Foam::smoothingModels::diffusion::sumSeries
(
    Field<T>& cells,
    const scalarList& series
) const
{
    const scalarField& volume = mesh_.V();

    // x is the diffusion over its whole time, at most 2 r; x/r of a cell:
    const scalar perR = 2*longestStep_;
    Field<T> earlier(cells);
    Field<T> present(cells.size());
    Field<T> gain(cells.size());

    computeGain(earlier, gain);
    forAll(cells, cell)
    {
        present[cell] = -perR/volume[cell]*gain[cell] - earlier[cell];
        cells[cell] =
            series[0]*earlier[cell] + series[1]*present[cell];
    }

    for (label k = 2; k < series.size(); ++k)
    {
        computeGain(present, gain);
        forAll(cells, cell)
        {
            const T next
            (
               -2*(perR/volume[cell]*gain[cell] + present[cell]) - earlier[cell]
            );
            earlier[cell] = present[cell];
            present[cell] = next;
            cells[cell] += series[k]*next;
        }
    }
}


template<class T>
void Foam::smoothingModels::diffusion::diffuse
(
    Field<T>& cells,
    const schedule& how
) const
{
    if (how.series.size())
    {
        sumSeries(cells, how.series);
        return;
    }

    const scalarField& volume = mesh_.V();
    Field<T> gain(cells.size());

    for (label n = 0; n < how.nSteps; ++n)
    {
        computeGain(cells, gain);

        forAll(cells, cell)
        {
            cells[cell] += how.step/volume[cell]*gain[cell];
        }
    }
}
