// SPDX-License-Identifier: GPL-3.0-or-later
// Which share of each grain lies in which cell, on this rank or another.

#include "cellWeights.H"

#include "swapLists.H"

Foam::cellWeights::cellWeights(const sphereOverlap& overlap)
:
    walker_(overlap.walker()),
    overlap_(overlap),
    nCells_(walker_.mesh().nCells()),
    leaving_(Pstream::nProcs()),
    reaching_(Pstream::nProcs()),
    theirs_(Pstream::nProcs()),
    ours_(Pstream::nProcs())
{
    clear();
}


void Foam::cellWeights::clear()
{
    start_.clear();
    start_.append(0);
    slots_.clear();
    weights_.clear();
    pieces_.clear();

    forAll(leaving_, rank)
    {
        leaving_[rank].clear();
        reaching_[rank].clear();
        theirs_[rank].clear();
        ours_[rank].clear();
    }
}


void Foam::cellWeights::add
(
    const point& p,
    const meshWalker::place& place,
    const scalar weight
)
{
    leaving_[place.rank].append
    (
        traveller{p, place.cell, Pstream::myProcNo(), slots_.size()}
    );

    // The slot is known when the traveller has arrived
    add(-1, weight);
}


Foam::DynamicList<Foam::cellWeights::arrival> Foam::cellWeights::follow()
{
    const label me = Pstream::myProcNo();
    DynamicList<arrival> home;

    // Irregular cells could send a walk round in circles over ranks
    const label most = 1000;

    for (label round = 0; ; ++round)
    {
        label n = 0;

        for (const DynamicList<traveller>& toRank : leaving_)
        {
            n += toRank.size();
        }

        if (!returnReduce(n, sumOp<label>()))
        {
            return home;
        }

        List<DynamicList<arrival>> answers(Pstream::nProcs());

        for (const List<traveller>& from : swapLists(leaving_))
        {
            for (traveller t : from)
            {
                const meshWalker::place end = walker_.walk(t.position, t.cell);

                if (end.rank != me && round < most)
                {
                    t.cell = end.cell;
                    leaving_[end.rank].append(t);
                }
                else
                {
                    const arrival a
                    {
                        t.homeEntry, me, end.rank == me ? end.cell : t.cell
                    };

                    answers[t.homeRank].append(a);
                }
            }
        }

        for (const List<arrival>& from : swapLists(answers))
        {
            home.append(from);
        }
    }
}


void Foam::cellWeights::numberSlots(const UList<arrival>& arrivals)
{
    const label me = Pstream::myProcNo();
    List<Map<label>> number(Pstream::nProcs());
    List<DynamicList<label>> cells(Pstream::nProcs());

    for (const arrival& a : arrivals)
    {
        if (a.rank != me && number[a.rank].insert(a.cell, cells[a.rank].size()))
        {
            cells[a.rank].append(a.cell);
        }
    }
    forAll(cells, rank)
    {
        theirs_[rank].transfer(cells[rank]);
    }

    labelList first(Pstream::nProcs(), nCells_);
    for (label rank = 1; rank < Pstream::nProcs(); ++rank)
    {
        first[rank] = first[rank - 1] + theirs_[rank - 1].size();
    }

    for (const arrival& a : arrivals)
    {
        slots_[a.entry] =
            a.rank == me ? a.cell : first[a.rank] + number[a.rank][a.cell];
    }

    ours_ = swapLists(theirs_);
}


void Foam::cellWeights::finish()
{
    if (Pstream::parRun())
    {
        // A model brings walkers or spheres: insert() moves the entries that
        // follow() has noted
        DynamicList<arrival> arrivals(follow());
        insert(followSpheres(), arrivals);
        numberSlots(arrivals);
    }
}
