// SPDX-License-Identifier: GPL-3.0-or-later
// What a run is asked to measure for a channel, and reading it afterwards.

#include "observer.H"
#include "keywords.H"

namespace Foam::misfit
{
    defineTypeNameAndDebug(observer, 0);
    defineRunTimeSelectionTable(observer, channel);
}


Foam::autoPtr<Foam::misfit::observer>
Foam::misfit::observer::New(const channel& c)
{
    const auto& table = *channelConstructorTablePtr_;
    const word type
    (
        keywords::choice
        (
            c.simulated,
            "type",
            "way to observe " + c.name,
            table.sortedToc()
        )
    );
    return table[type](c);
}
