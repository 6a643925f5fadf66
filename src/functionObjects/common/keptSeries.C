// SPDX-License-Identifier: GPL-3.0-or-later
// Histories of a function object, kept for a run that goes on.

#include "keptSeries.H"

#include "Time.H"

Foam::keptSeries::keptSeries
(
    const word& name,
    const Time& runTime,
    const bool read
)
:
    compatibility::textDictionary
    (
        IOobject
        (
            name + "Series",
            runTime.timeName(),
            "uniform"/word("functionObjects"),
            runTime,
            read ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    )
{}


void Foam::keptSeries::keep(const word& name, sampleSeries& series)
{
    const dictionary read(subOrEmptyDict(name));

    series = sampleSeries
    (
        read.getOrDefault("times", scalarList()),
        read.getOrDefault("values", scalarList())
    );
    series_.set(name, &series);
}


bool Foam::keptSeries::writeData(Ostream& os) const
{
    // Every digit, so that a run that goes on has the same series; numbers become
    // text where they are added
    const unsigned int digits = IOstream::defaultPrecision(17);
    dictionary all;

    forAllConstIters(series_, iter)
    {
        dictionary one;
        one.add("times", (*iter)->times());
        one.add("values", (*iter)->values());
        all.add(iter.key(), one);
    }

    const int precision = os.precision(17);
    all.write(os, false);
    os.precision(precision);
    IOstream::defaultPrecision(digits);

    return os.good();
}
