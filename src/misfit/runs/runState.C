// SPDX-License-Identifier: GPL-3.0-or-later
// What distinguishes one run of a diagnosis from another, in words.

#include "runState.H"

#include "StringStream.H"

Foam::string Foam::misfit::describe(const runState& state)
{
    // Whatever precision a case that was read has set for all streams
    OStringStream os;
    os.precision(6);
    os << "experiment " << state.experiment;
    for (const auto* numbers : {&state.parameters, &state.strengths})
    {
        for (const word& name : numbers->sortedToc())
        {
            if (numbers == &state.parameters || (*numbers)[name] != 0)
            {
                os << ", " << name << ' ' << (*numbers)[name];
            }
        }
    }
    if (state.replicate)
    {
        os << ", replicate " << state.replicate;
    }
    if (!state.isBase())
    {
        os << ", other " << state.resolution;
    }
    if (state.noting)
    {
        os << ", the water noted";
    }
    return os.str();
}
