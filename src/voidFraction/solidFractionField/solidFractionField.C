// SPDX-License-Identifier: GPL-3.0-or-later
// Solid fraction of the cells, from the grains.

#include "solidFractionField.H"

#include "keywords.H"

Foam::solidFractionField::solidFractionField
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
    excess_(mesh_, 1 - minimum_)
{
    wordList known({"model", "minimum", "smoothing"});
    known.append(model_->modelKeywords());
    keywords::check(dict, known);

    if (minimum_ <= 0 || minimum_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "minimum is " << minimum_ << ": the least void fraction lies"
            << " between 0 and 1 (default 0.3)." << exit(FatalIOError);
    }
}


void Foam::solidFractionField::share(const bool keepClasses)
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
        },
        keepClasses
    );
}


void Foam::solidFractionField::update()
{
    share(false);
    solidFraction_ = mapping_.spread(mapping_.volumes());
    excess_.distribute(solidFraction_);
    report();
}


void Foam::solidFractionField::report()
{
    if (excess_.left() > max(1e-3*minimum_, 2*warnedOf_))
    {
        warnedOf_ = excess_.left();
        WarningInFunction
            << "The void fraction is below the minimum of " << minimum_ << " by "
            << warnedOf_ << ": the grains do not fit into the cells around either."
            << nl << "    Take a lower minimum or larger cells" << endl;
    }

    if (excess_.moved())
    {
        Info<< "    grain volume spread over neighbouring cells, since the"
            << " void fraction would be below " << minimum_ << ": "
            << 100*excess_.volume()/mapping_.totalVolume() << " %" << endl;
    }
}
