// SPDX-License-Identifier: GPL-3.0-or-later
// Brings each grain to the rank whose cells hold it, and results back.

#include "grainExchange.H"

#include "granularPhase.H"

Foam::grainExchange::grainExchange(const fvMesh& mesh)
:
    mesh_(mesh),
    walker_(mesh),
    bins_(mesh, walker_),
    images_(mesh),
    bounds_(Pstream::nProcs()),
    sent_(Pstream::nProcs()),
    received_(Pstream::nProcs() + 1, Zero),
    nOutside_(0)
{
    bounds_[Pstream::myProcNo()] = bins_.bounds();
    Pstream::gatherList(bounds_);
    Pstream::scatterList(bounds_);

    for (boundBox& box : bounds_)
    {
        box.inflate(1e-6);
    }
}


Foam::locatedGrain Foam::grainExchange::record
(
    const granularPhase& phase,
    const label i
) const
{
    return locatedGrain
    {
        images_.wrap(phase.position()[i]),
        phase.velocity()[i],
        phase.angularVelocity()[i],
        phase.totalForce()[i],
        phase.fluidForce()[i],
        phase.radius()[i],
        phase.mass()[i],
        -1,
        phase.id()[i],
        phase.mobile(i)
    };
}


void Foam::grainExchange::outside(const granularPhase& phase, const label i)
{
    const point& p = phase.position()[i];

    if (!phase.mayLeave(p, phase.velocity()[i]))
    {
        FatalErrorInFunction
            << "Grain " << phase.id()[i] << " is outside the mesh, at " << p
            << " m with velocity " << phase.velocity()[i] << " m/s, time "
            << mesh_.time().timeName() << " s." << nl
            << "    The mesh is " << mesh_.bounds() << nl
            << "    If grains pass a wall: shorten the DEM step or make the"
            << " grains stiffer. If they start outside: place them in the"
            << " initial script, in metres. If they may leave: name the"
            << " patches in"
            << " LIGGGHTS/outflow of constant/granularProperties."
            << exit(FatalError);
    }

    ++nOutside_;
}


void Foam::grainExchange::findElsewhere
(
    const granularPhase& phase,
    const labelUList& strangers
)
{
    // Ask the ranks whose bounds hold the point; the lowest that has it in a
    // cell gets the grain
    List<DynamicList<point>> questions(Pstream::nProcs());
    List<DynamicList<label>> asked(Pstream::nProcs());

    for (const label i : strangers)
    {
        const point p(images_.wrap(phase.position()[i]));

        forAll(questions, rank)
        {
            if (rank != Pstream::myProcNo() && bounds_[rank].contains(p))
            {
                questions[rank].append(p);
                asked[rank].append(i);
            }
        }
    }

    const List<List<point>> theirs(swapLists(questions));
    List<List<label>> answers(Pstream::nProcs());

    forAll(theirs, rank)
    {
        answers[rank].setSize(theirs[rank].size());
        forAll(theirs[rank], q)
        {
            answers[rank][q] = bins_.find(theirs[rank][q]);
        }
    }

    const List<List<label>> found(swapLists(std::move(answers)));
    Map<bool> placed(2*strangers.size());

    forAll(found, rank)
    {
        forAll(found[rank], q)
        {
            const label i = asked[rank][q];

            if (found[rank][q] >= 0 && !placed.found(i))
            {
                placed.insert(i, true);
                sent_[rank].append(i);
            }
        }
    }

    for (const label i : strangers)
    {
        if (!placed.found(i))
        {
            outside(phase, i);
        }
    }
}


void Foam::grainExchange::collect
(
    const granularPhase& phase,
    const labelUList& ownCells
)
{
    const label me = Pstream::myProcNo();
    List<List<locatedGrain>> toRanks(Pstream::nProcs());

    forAll(toRanks, rank)
    {
        toRanks[rank].setSize(sent_[rank].size());
        forAll(toRanks[rank], j)
        {
            toRanks[rank][j] = record(phase, sent_[rank][j]);
        }
    }

    const List<List<locatedGrain>> fromRanks(swapLists(std::move(toRanks)));

    received_ = Zero;
    forAll(fromRanks, rank)
    {
        received_[rank + 1] = received_[rank] + fromRanks[rank].size();
    }
    grains_.setSize(received_.last());

    forAll(fromRanks, rank)
    {
        forAll(fromRanks[rank], k)
        {
            locatedGrain& grain = grains_[received_[rank] + k];

            grain = fromRanks[rank][k];
            grain.cell =
                rank == me ? ownCells[k] : bins_.find(grain.position);
        }
    }
}


void Foam::grainExchange::locate(const granularPhase& phase)
{
    for (auto& list : sent_)
    {
        list.clear();
    }
    nOutside_ = 0;

    const label me = Pstream::myProcNo();
    DynamicList<label> ownCells(phase.size());
    DynamicList<label> strangers;

    const UList<point>& position = phase.position();

    forAll(position, i)
    {
        const label cell = bins_.find(images_.wrap(position[i]));

        if (cell >= 0)
        {
            sent_[me].append(i);
            ownCells.append(cell);
        }
        else
        {
            strangers.append(i);
        }
    }

    if (returnReduce(strangers.size(), sumOp<label>()))
    {
        findElsewhere(phase, strangers);
        reduce(nOutside_, sumOp<label>());
    }

    collect(phase, ownCells);
}


Foam::vectorField Foam::grainExchange::toPhase
(
    const vectorField& values,
    const label nPhase
) const
{
    List<List<vector>> toRanks(Pstream::nProcs());

    forAll(toRanks, rank)
    {
        toRanks[rank] = SubList<vector>
        (
            values,
            received_[rank + 1] - received_[rank],
            received_[rank]
        );
    }

    const List<List<vector>> fromRanks(swapLists(std::move(toRanks)));
    vectorField result(nPhase, Zero);

    forAll(fromRanks, rank)
    {
        forAll(fromRanks[rank], k)
        {
            result[sent_[rank][k]] = fromRanks[rank][k];
        }
    }

    return result;
}
