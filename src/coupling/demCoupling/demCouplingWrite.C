// SPDX-License-Identifier: GPL-3.0-or-later
// The grains beside the fluid: what is written.

#include "demCoupling.H"

#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "foamCompatibility.H"
#include "grainSnapshot.H"
#include "timeOnDisk.H"

bool Foam::demCoupling::writeCloud() const
{
    if (!hasGrains())
    {
        return true;
    }

    // A snapshot stands on the ranks that move the grains, a cloud on those
    // of their cells
    const autoPtr<grainSnapshot> moved(phase_->snapshot());
    grainSnapshot located;

    const auto locate = [&](const char*, const auto member)
    {
        located.*member = exchange_->toCells((*moved).*member);
    };
    grainSnapshot::forEachField(locate);
    if (phase_->hasClumps())
    {
        grainSnapshot::forEachClumpField(locate);
    }

    for (const word& wall : moved->wallForce.sortedToc())
    {
        located.wallForce.insert
        (
            wall,
            vectorField(exchange_->toCells(moved->wallForce[wall]))
        );
    }

    const List<locatedGrain>& grains = exchange_->grains();
    labelList cells(grains.size());
    located.position.setSize(grains.size());

    forAll(grains, i)
    {
        cells[i] = grains[i].cell;
        located.position[i] = grains[i].position;
    }

    return located.write(mesh_, cells);
}


bool Foam::demCoupling::write()
{
    if (!hasGrains())
    {
        return true;
    }

    const stageTimes::stage stage(times_, "writeGrains");

    const bool cloudComplete = writeCloud();

    // One state of all ranks, with the files of the first
    fileName folder(timeOnDisk(mesh_.time())/granularPhase::stateFolder);
    compatibility::broadcast(folder);
    if (Pstream::master())
    {
        mkDir(folder);
    }

    const bool forcesComplete = !forces_ || forces_->writeState(folder);
    const bool stateComplete = phase_->writeState(folder) && forcesComplete;

    // Writing the state may bring grains to other ranks and in another order.
    // Sums in that order are what a restart finds, to the last bit
    if (forces_)
    {
        locateGrains();
        solids_->update();
        solidAfter_ = solids_->solidFraction();
    }

    return returnReduce(cloudComplete && stateComplete, andOp<bool>());
}
