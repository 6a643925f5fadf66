// SPDX-License-Identifier: GPL-3.0-or-later
// The volume of grains that does not fit into their cells, and where it goes.

#include "excessVolume.H"

void Foam::excessVolume::moveOn(scalarField& solidFraction)
{
    const scalarField& volume = mesh_.V();
    DynamicList<transfer> round;
    scalarField part(volume.size(), Zero);
    scalar movedVolume = 0;

    // A rank may have no cells: all count in the same round
    if (!nRounds_)
    {
        nNeighbours_ = sumOverNeighbours(labelField(volume.size(), 1));
    }

    forAll(solidFraction, cell)
    {
        const scalar excess = solidFraction[cell] - most_;
        const label n = nNeighbours_[cell];

        // In equal parts
        if (excess > 0 && n)
        {
            part[cell] = excess*volume[cell]/n;
            round.append({cell, excess/solidFraction[cell]/n});
            movedVolume += excess*volume[cell];
        }
    }

    const scalarField come(sumOverNeighbours(part));
    forAll(solidFraction, cell)
    {
        solidFraction[cell] +=
            (come[cell] - nNeighbours_[cell]*part[cell])/volume[cell];
    }

    if (nRounds_++ < mostKept)
    {
        rounds_.append(List<transfer>(std::move(round)));
    }
    movedVolume_ += returnReduce(movedVolume, sumOp<scalar>());
}


void Foam::excessVolume::distribute(scalarField& solidFraction)
{
    // Rounds grow with the square of the cells across what is too full
    const label mostRounds = 1000;
    const scalar roundOff = 1e-9;
    const auto excess = [&]
    {
        return max(gMax(solidFraction) - most_, scalar(0));
    };

    rounds_.clearStorage();
    nRounds_ = 0;
    movedVolume_ = 0;

    for
    (
        largestExcess_ = excess();
        largestExcess_ >= roundOff && nRounds_ < mostRounds;
        largestExcess_ = excess()
    )
    {
        moveOn(solidFraction);
    }
}
