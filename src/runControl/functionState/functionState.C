// SPDX-License-Identifier: GPL-3.0-or-later
// What the function objects keep for a run that goes on.

#include "functionState.H"

#include "IOdictionary.H"
#include "foamCompatibility.H"

bool Foam::writeFunctionState(Time& runTime)
{
    const auto* state =
        runTime.cfindObject<IOdictionary>("functionObjectProperties");

    if (!state)
    {
        return true;
    }

    const unsigned int precision = IOstream::defaultPrecision(16);
    const bool success = compatibility::writeObject
    (
        *state,
        IOstream::ASCII,
        runTime.writeCompression()
    );
    IOstream::defaultPrecision(precision);

    return success;
}
