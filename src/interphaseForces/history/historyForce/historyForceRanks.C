// SPDX-License-Identifier: GPL-3.0-or-later
// The past of a grain goes to the rank that the grain goes to.

#include "historyForce.H"

#include "DynamicList.H"
#include "HashSet.H"
#include "Pstream.H"
#include "swapLists.H"

namespace
{

using namespace Foam;

//- Pasts on their way between ranks: numbers of the grains, and as many vectors
//  for each
struct parcels
{
    List<DynamicList<label>> ids;

    List<DynamicList<vector>> numbers;

    parcels()
    :
        ids(Pstream::nProcs()),
        numbers(Pstream::nProcs())
    {}

    void add(const label rank, const label id, const vectorList& past)
    {
        ids[rank].append(id);
        numbers[rank].append(past);
    }

    //- Those that arrive go into the table
    void send(HashTable<vectorList, label, Hash<label>>& table)
    {
        const List<labelList> id(swapLists(ids));
        const List<vectorList> number(swapLists(numbers));
        forAll(id, rank)
        {
            const label n = id[rank].size();
            for (label i = 0; i < n; ++i)
            {
                const label width = number[rank].size()/n;
                table.insert
                (
                    id[rank][i],
                    vectorList(SubList<vector>(number[rank], width, i*width))
                );
            }
        }
    }
};

} // End anonymous namespace


void Foam::historyForce::follow(const List<locatedGrain>& grains)
{
    // Neither knows where the other is: each grain has a rank at which its past is
    // left and fetched
    const auto home = [](const label id) { return id % Pstream::nProcs(); };

    labelHashSet here(2*grains.size());
    List<DynamicList<label>> arrivals(Pstream::nProcs());
    bool moves = false;
    for (const locatedGrain& grain : grains)
    {
        here.insert(grain.id);
        if (!past_.found(grain.id))
        {
            arrivals[home(grain.id)].append(grain.id);
            moves = true;
        }
    }

    parcels leaving;
    for (const label id : past_.toc())
    {
        if (!here.found(id))
        {
            leaving.add(home(id), id, past_[id]);
            past_.erase(id);
            moves = true;
        }
    }
    if (!Pstream::parRun() || !returnReduce(moves, orOp<bool>()))
    {
        return;
    }

    HashTable<vectorList, label, Hash<label>> left;
    leaving.send(left);

    const List<labelList> requests(swapLists(arrivals));
    parcels fetched;
    forAll(requests, rank)
    {
        for (const label id : requests[rank])
        {
            if (left.found(id))
            {
                fetched.add(rank, id, left[id]);
            }
        }
    }
    fetched.send(past_);
}
