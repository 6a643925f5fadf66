// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction from the grains.

#include "voidFraction.H"

#include "keywords.H"
#include "syncTools.H"

Foam::voidFraction::voidFraction
(
    const grainExchange& exchange,
    const dictionary& dict
)
:
    mesh_(exchange.mesh()),
    model_(voidFractionModel::New(dict)),
    mapping_(exchange, keywords::sub(dict, "smoothing")),
    minimum_(dict.lookupOrDefault<scalar>("minimum", 0.3)),
    solidFraction_(mesh_.nCells(), Zero),
    spreadVolume_(0)
{
    wordList known({"model", "minimum", "smoothing"});
    known.append(model_->ownKeywords());
    keywords::check(dict, known);

    if (minimum_ <= 0 || minimum_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "minimum is " << minimum_ << ": the least void fraction lies"
            << " between 0 and 1 (default 0.3)." << exit(FatalIOError);
    }
}


void Foam::voidFraction::update()
{
    mapping_.update
    (
        [&]
        (
            const locatedGrain& grain,
            const meshWalker& walker,
            cellWeights& weights
        )
        {
            model_->addShares(grain, walker, weights);
        }
    );

    solidFraction_ = mapping_.spread(mapping_.volumes());
    spreadExcess();
}


Foam::scalarField Foam::voidFraction::sumOverNeighbours
(
    const scalarField& cells
) const
{
    scalarField sum(cells.size(), Zero);

    for (label f = 0; f < mesh_.nInternalFaces(); ++f)
    {
        sum[mesh_.owner()[f]] += cells[mesh_.neighbour()[f]];
        sum[mesh_.neighbour()[f]] += cells[mesh_.owner()[f]];
    }

    scalarField behind;
    syncTools::swapBoundaryCellList(mesh_, cells, behind);

    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                sum[patch.faceCells()[i]] +=
                    behind[patch.start() + i - mesh_.nInternalFaces()];
            }
        }
    }

    return sum;
}


void Foam::voidFraction::spreadExcess()
{
    const scalarField& volume = mesh_.V();
    const scalar most = 1 - minimum_;

    // Rounds grow with the square of the cells across what is too full
    const label nRounds = 1000;
    const scalar roundOff = 1e-9;
    scalar largest = 0;

    spreadVolume_ = 0;

    // Most often there is nothing to spread
    scalarField nNeighbours;

    for (label round = 0; round <= nRounds; ++round)
    {
        const scalarField excess(max(solidFraction_ - most, scalar(0)));
        largest = gMax(excess);

        if (largest < roundOff || round == nRounds)
        {
            break;
        }

        // What does not fit goes in equal parts to the cells around
        if (!round)
        {
            nNeighbours = sumOverNeighbours(scalarField(excess.size(), 1));
        }
        const scalarField part(excess*volume/max(nNeighbours, scalar(1)));

        solidFraction_ +=
            (sumOverNeighbours(part) - nNeighbours*part)/volume;
        spreadVolume_ += gSum(nNeighbours*part);
    }

    if (largest > max(1e-3*minimum_, 2*warnedOf_))
    {
        warnedOf_ = largest;
        WarningInFunction
            << "The void fraction is below the minimum of " << minimum_ << " by "
            << largest << ": the grains do not fit into the cells around either."
            << nl << "    Take a lower minimum or larger cells" << endl;
    }

    if (spreadVolume_ > 0)
    {
        Info<< "    grain volume spread over neighbouring cells, since the"
            << " void fraction would be below " << minimum_ << ": "
            << 100*spreadVolume_/mapping_.totalVolume() << " %" << endl;
    }
}
