// SPDX-License-Identifier: GPL-3.0-or-later
// Solid fraction of the cells, from the grains.

#include "solidFractionField.H"

#include "OStringStream.H"
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
    minimum_(dict.getOrDefault<scalar>("minimum", 0.3)),
    solidFraction_(mesh_.nCells(), Zero),
    excess_(mesh_, 1 - minimum_),
    mostSpread_(dict.getOrDefault<scalar>("largestSpread", 0.25))
{
    wordList known({"model", "minimum", "largestSpread", "smoothing"});
    known.append(model_->modelKeywords());
    keywords::check(dict, known);

    if (minimum_ <= 0 || minimum_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "minimum is " << minimum_ << ": the least void fraction lies"
            << " between 0 and 1 (default 0.3)." << exit(FatalIOError);
    }
    if (!(mostSpread_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "largestSpread is " << mostSpread_ << ": the share of the solid"
            << " volume that may be spread over neighbouring cells is above 0"
            << " (default 0.25)." << exit(FatalIOError);
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
    findFullest();
    const scalarField before(solidFraction_);
    excess_.distribute(solidFraction_);
    report(before);
}


void Foam::solidFractionField::findFullest()
{
    fullest_ = solidFraction_.size() ? findMax(solidFraction_) : -1;
    fullestFraction_ = fullest_ >= 0 ? solidFraction_[fullest_] : 0;
}


Foam::string Foam::solidFractionField::fullest() const
{
    const scalar most = returnReduce(fullestFraction_, maxOp<scalar>());
    const bool here = fullest_ >= 0 && fullestFraction_ >= most;

    // The first of the ranks that have it
    const label rank = returnReduce
    (
        here ? Pstream::myProcNo() : Pstream::nProcs(), minOp<label>()
    );
    const point place = returnReduce
    (
        rank == Pstream::myProcNo() ? mesh_.cellCentres()[fullest_] : point(Zero),
        sumOp<point>()
    );

    OStringStream os;
    os  << "The fullest cell is at " << place << " m, with a solid fraction of "
        << most;
    return os.str();
}


void Foam::solidFractionField::reportSpread(const scalar share)
{
    if (share < min(max(warnFrom, 2*warnedOfSpread_), mostSpread_))
    {
        return;
    }

    const string where(fullest());
    OStringStream os;
    os  << 100*share << " % of the solid volume is spread over neighbouring cells"
        << ", since the void fraction would be below the minimum of " << minimum_ << "."
        << nl
        << "    " << where.c_str() << "." << nl;
    const string what(os.str());
    const char* const advice =
        "    A packing of spheres has 0.64 at most. Below that take larger cells,"
        " more smoothing or a lower voidFraction/minimum; above it grains or"
        " material points are pressed into each other: take a stiffer contact, a"
        " smaller step, or points with 'shifting on'.";

    if (share > mostSpread_)
    {
        FatalErrorInFunction
            << what.c_str() << advice << nl
            << "    Forces then act in other cells than those of the grains. To go"
            << " on, raise voidFraction/largestSpread above " << mostSpread_ << "."
            << exit(FatalError);
    }

    warnedOfSpread_ = share;
    WarningInFunction
        << what.c_str() << advice << nl
        << "    The run stops at " << 100*mostSpread_ << " %." << endl;
}


void Foam::solidFractionField::report(const scalarField& before)
{
    if (excess_.largestExcess() > max(1e-3*minimum_, 2*warnedOf_))
    {
        warnedOf_ = excess_.largestExcess();
        WarningInFunction
            << "The void fraction is below the minimum of " << minimum_ << " by "
            << warnedOf_ << ": the grains do not fit into the cells around either."
            << nl << "    Take a lower minimum or larger cells" << endl;
    }

    if (excess_.hasMoved())
    {
        // What goes from full cells to full cells changes none
        const scalarField moved(mesh_.V().field()*mag(solidFraction_ - before));
        const scalar share = 0.5*gSum(moved)/mapping_.totalVolume();
        Info<< "    grain volume spread over neighbouring cells, since the"
            << " void fraction would be below " << minimum_ << ": "
            << 100*share << " %" << endl;
        reportSpread(share);
    }
}
