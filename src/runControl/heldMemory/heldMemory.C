// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that a run holds.

#include "heldMemory.H"

#include "PstreamReduceOps.H"
#include "memInfo.H"

#include <malloc.h>

void Foam::releaseFreeMemory()
{
    malloc_trim(0);
}


void Foam::printHeldMemory()
{
    const scalar here = memInfo().rss()/1024.0;

    Info<< "Memory [MiB]: " << returnReduce(here, sumOp<scalar>())
        << " in all, " << returnReduce(here, maxOp<scalar>())
        << " on one rank at most" << endl;
}
