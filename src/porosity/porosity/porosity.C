// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction from the grains, and the way between grains and cells.

#include "porosity.H"

#include "keywords.H"
#include "mathematicalConstants.H"
#include "syncTools.H"

Foam::porosity::porosity(const grainExchange& exchange, const dictionary& dict)
:
    exchange_(exchange),
    model_(porosityModel::New(dict)),
    smoothing_
    (
        smoothingModel::New(exchange.mesh(), keywords::sub(dict, "smoothing"))
    ),
    minimum_(dict.lookupOrDefault<scalar>("minimum", 0.3)),
    weights_(exchange.overlap()),
    solidFraction_(exchange.mesh().nCells(), Zero),
    spreadVolume_(0),
    totalVolume_(0)
{
    keywords::check(dict, {"model", "minimum", "smoothing"});

    if (minimum_ <= 0 || minimum_ >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "minimum is " << minimum_ << ": the least void fraction lies"
            << " between 0 and 1 (default 0.3)." << exit(FatalIOError);
    }
}


void Foam::porosity::measure()
{
    const List<locatedGrain>& grains = exchange_.grains();

    volumes_.setSize(grains.size());
    // Equal numbers added one by one all round the same way: in double precision
    // 1e5 grains would be wrong by 1e-12
    long double volumeSum = 0;
    scalar diameterSum = 0;

    forAll(grains, i)
    {
        const scalar radius = grains[i].radius;

        volumes_[i] = 4*constant::mathematical::pi/3*pow3(radius);
        volumeSum += volumes_[i];
        diameterSum += volumes_[i]*2*radius;
    }

    totalVolume_ = returnReduce(scalar(volumeSum), sumOp<scalar>());
    reduce(diameterSum, sumOp<scalar>());
    smoothing_->setDiameter(diameterSum/max(totalVolume_, VSMALL));
}


void Foam::porosity::update()
{
    measure();
    weights_.clear();

    for (const locatedGrain& grain : exchange_.grains())
    {
        model_->addShares(grain, exchange_.walker(), weights_);
        weights_.endGrain();
    }

    weights_.finish();

    solidFraction_ = spread(volumes_);
    spreadExcess();
}


Foam::scalarField Foam::porosity::sumOverNeighbours
(
    const scalarField& cells
) const
{
    const fvMesh& mesh = exchange_.mesh();
    scalarField sum(cells.size(), Zero);

    for (label f = 0; f < mesh.nInternalFaces(); ++f)
    {
        sum[mesh.owner()[f]] += cells[mesh.neighbour()[f]];
        sum[mesh.neighbour()[f]] += cells[mesh.owner()[f]];
    }

    scalarField behind;
    syncTools::swapBoundaryCellList(mesh, cells, behind);

    for (const fvPatch& patch : mesh.boundary())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                sum[patch.faceCells()[i]] +=
                    behind[patch.start() + i - mesh.nInternalFaces()];
            }
        }
    }

    return sum;
}


void Foam::porosity::spreadExcess()
{
    const scalarField& volume = exchange_.mesh().V();
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
            << 100*spreadVolume_/totalVolume_ << " %" << endl;
    }
}


Foam::scalarField Foam::porosity::sauterDiameter() const
{
    const List<locatedGrain>& grains = exchange_.grains();
    scalarField areas(grains.size());

    forAll(grains, i)
    {
        areas[i] = volumes_[i]/(2*grains[i].radius);
    }

    return gather(spread(volumes_))/gather(spread(areas));
}
