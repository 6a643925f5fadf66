// SPDX-License-Identifier: GPL-3.0-or-later
// Time, of which results are written at ends of exchange intervals only.

#include "exchangeTime.H"

#include "IOdictionary.H"

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

    scalar value;
    if
    (
        written.readIfPresent("value", value)
     && timeName(timeToUserTime(value)) == timeName()
    )
    {
        setTime(value, timeIndex());
    }
}
