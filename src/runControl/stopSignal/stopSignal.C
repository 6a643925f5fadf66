// SPDX-License-Identifier: GPL-3.0-or-later
// Remembers a request to stop the run.

#include "stopSignal.H"

#include "PstreamReduceOps.H"

#include <csignal>

namespace
{
    volatile std::sig_atomic_t caught = 0;

    void note(int)
    {
        caught = 1;
    }
}


Foam::stopSignal::stopSignal()
{
    caught = 0;

    for (const int number : {SIGUSR1, SIGTERM, SIGINT})
    {
        std::signal(number, note);
    }
}


bool Foam::stopSignal::requested() const
{
    return returnReduce(caught != 0, orOp<bool>());
}
