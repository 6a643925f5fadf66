// SPDX-License-Identifier: GPL-3.0-or-later
// Brings each grain to the rank whose cells hold it, and results back.

#include "grainExchange.H"

#include "HashSet.H"
#include "ListOps.H"
#include "foamCompatibility.H"
#include "granularPhase.H"

Foam::grainExchange::grainExchange(const fvMesh& mesh)
:
    mesh_(mesh),
    walker_(mesh),
    overlap_(walker_),
    bins_(overlap_),
    images_(mesh),
    bounds_(Pstream::nProcs()),
    sent_(Pstream::nProcs()),
    cells_(Pstream::nProcs()),
    received_(Pstream::nProcs() + 1, Zero),
    nOutside_(0)
{
    bounds_[Pstream::myProcNo()] = bins_.bounds();
    Pstream::gatherList(bounds_);
    compatibility::broadcast(bounds_);

    for (boundBox& box : bounds_)
    {
        box.inflate(1e-6);
    }
}


struct Foam::grainExchange::phaseLists
{
    const granularPhase& phase;
    const periodicity& images;

    const UList<point>& position = phase.position();
    const UList<vector>& velocity = phase.velocity();
    const UList<vector>& angularVelocity = phase.angularVelocity();
    const UList<vector>& totalForce = phase.totalForce();
    const UList<vector>& fluidForce = phase.fluidForce();
    const UList<scalar>& radius = phase.radius();
    const UList<scalar>& mass = phase.mass();
    const UList<scalar>& clumpRadius = phase.clumpRadius();
    const UList<scalar>& share = phase.share();
    const UList<label>& id = phase.id();

    //- Write what is known of grain i, which is in the cell, where it belongs
    void write(locatedGrain& grain, const label i, const label cell) const
    {
        grain.position = images.wrap(position[i]);
        grain.velocity = velocity[i];
        grain.angularVelocity = angularVelocity[i];
        grain.totalForce = totalForce[i];
        grain.fluidForce = fluidForce[i];
        grain.radius = radius[i];
        grain.mass = mass[i];
        grain.clumpRadius = clumpRadius.size() ? clumpRadius[i] : radius[i];
        grain.share = share.size() ? share[i] : 1;
        grain.cell = cell;
        grain.id = id[i];
        grain.mobile = phase.mobile(i);
    }
};


void Foam::grainExchange::checkMayLeave
(
    const granularPhase& phase,
    const label i
) const
{
    const point& p = phase.position()[i];

    if (phase.mayLeave(p, phase.velocity()[i]))
    {
        return;
    }

    FatalErrorInFunction
        << "Grain " << phase.id()[i] << " is outside the mesh, at " << p
        << " m with velocity " << phase.velocity()[i] << " m/s, time "
        << phase.timeName() << " s." << nl
        << "    The mesh is " << mesh_.bounds() << nl
        << "    The place is "
        << (
               mesh_.bounds().contains(images_.wrap(p))
             ? "within these bounds, but in none of the cells: behind a wall or"
               " in an obstacle."
             : "beyond these bounds."
           )
        << nl
        << "    If grains pass a wall: shorten the time step or, with LIGGGHTS,"
        << " make the grains stiffer. If they start outside: place them in"
        << " the mesh, in metres (LIGGGHTS does so by its initial script)."
        << " If they may leave: name the patches in "
        << phase.outflowEntry().c_str()
        << " of constant/granularProperties."
        << exit(FatalError);
}


Foam::label Foam::grainExchange::cellOf(const point& p, const search how) const
{
    return
        how == search::planes ? bins_.find(p)
      : how == search::shape ? bins_.findByShape(p)
      : bins_.findAtWall(p);
}


void Foam::grainExchange::searchOtherRanks
(
    const granularPhase& phase,
    DynamicList<label>& strangers,
    const search how
)
{
    // Ask the ranks whose bounds hold the point; the lowest that has it in a
    // cell gets the grain
    List<DynamicList<point>> questions(Pstream::nProcs());
    List<DynamicList<label>> requests(Pstream::nProcs());

    for (const label i : strangers)
    {
        const point p(images_.wrap(phase.position()[i]));

        forAll(questions, rank)
        {
            // This rank has looked among the planes already
            const bool done =
                rank == Pstream::myProcNo() && how == search::planes;

            if (!done && bounds_[rank].contains(p))
            {
                questions[rank].append(p);
                requests[rank].append(i);
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
            answers[rank][q] = cellOf(theirs[rank][q], how);
        }
    }

    const List<List<label>> cells(swapLists(std::move(answers)));
    labelHashSet placed(2*strangers.size());

    forAll(cells, rank)
    {
        forAll(cells[rank], q)
        {
            const label i = requests[rank][q];

            if (cells[rank][q] >= 0 && placed.insert(i))
            {
                sent_[rank].append(i);
                cells_[rank].append(cells[rank][q]);
            }
        }
    }

    inplaceSubsetList
    (
        strangers,
        [&](const label i) { return !placed.found(i); }
    );
}


void Foam::grainExchange::collect(const granularPhase& phase)
{
    const label me = Pstream::myProcNo();
    const phaseLists all{phase, images_};
    List<List<locatedGrain>> toRanks(Pstream::nProcs());

    forAll(toRanks, rank)
    {
        toRanks[rank].setSize(rank == me ? 0 : sent_[rank].size());
        forAll(toRanks[rank], j)
        {
            all.write(toRanks[rank][j], sent_[rank][j], cells_[rank][j]);
        }
    }

    const List<List<locatedGrain>> fromRanks(swapLists(std::move(toRanks)));

    received_ = Zero;
    forAll(fromRanks, rank)
    {
        const label n =
            rank == me ? sent_[me].size() : fromRanks[rank].size();
        received_[rank + 1] = received_[rank] + n;
    }
    grains_.setSize(received_.last());

    // Those that stay are written once
    forAll(sent_[me], k)
    {
        all.write(grains_[received_[me] + k], sent_[me][k], cells_[me][k]);
    }
    forAll(fromRanks, rank)
    {
        if (rank != me)
        {
            SubList<locatedGrain>
            (
                grains_,
                fromRanks[rank].size(),
                received_[rank]
            ) = fromRanks[rank];
        }
    }
}


void Foam::grainExchange::locate(const granularPhase& phase)
{
    for (const label i : locate(phase, identity(phase.size())))
    {
        checkMayLeave(phase, i);
    }
}


Foam::labelList Foam::grainExchange::locate
(
    const granularPhase& phase,
    const labelUList& some
)
{
    forAll(sent_, rank)
    {
        sent_[rank].clear();
        cells_[rank].clear();
    }

    const label me = Pstream::myProcNo();
    DynamicList<label> strangers;

    const UList<point>& position = phase.position();

    for (const label i : some)
    {
        const label cell = bins_.find(images_.wrap(position[i]));

        if (cell >= 0)
        {
            sent_[me].append(i);
            cells_[me].append(cell);
        }
        else
        {
            strangers.append(i);
        }
    }

    // What is slow is left to the few that nothing else finds
    nOutside_ = returnReduce(strangers.size(), sumOp<label>());

    for (const search how : {search::planes, search::shape, search::wall})
    {
        if (nOutside_)
        {
            searchOtherRanks(phase, strangers, how);
            nOutside_ = returnReduce(strangers.size(), sumOp<label>());
        }
    }

    collect(phase);
    return labelList(std::move(strangers));
}


Foam::vectorField Foam::grainExchange::toPhase
(
    const vectorField& values,
    const label nPhase
) const
{
    const label me = Pstream::myProcNo();
    List<List<vector>> toRanks(Pstream::nProcs());

    forAll(toRanks, rank)
    {
        if (rank != me)
        {
            toRanks[rank] = SubList<vector>
            (
                values,
                received_[rank + 1] - received_[rank],
                received_[rank]
            );
        }
    }

    const List<List<vector>> fromRanks(swapLists(std::move(toRanks)));
    vectorField result(nPhase, Zero);

    forAll(sent_[me], k)
    {
        result[sent_[me][k]] = values[received_[me] + k];
    }

    forAll(fromRanks, rank)
    {
        forAll(fromRanks[rank], k)
        {
            result[sent_[rank][k]] = fromRanks[rank][k];
        }
    }

    return result;
}
