// SPDX-License-Identifier: GPL-3.0-or-later
// Time, of which results are written at ends of exchange intervals only.

#include "exchangeTime.H"

#include "IOdictionary.H"
#include "PstreamReduceOps.H"

void Foam::exchangeTime::restoreValue()
{
    const IOdictionary written
    (
        IOobject
        (
            "time",
            timeName(),
            "uniform",
            *this,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    scalar value = 0;
    const bool same =
        written.readIfPresent("value", value) && timeName(value) == timeName();

    if (returnReduce(same, andOp<bool>()))
    {
        setTime(value, timeIndex());
    }
}
