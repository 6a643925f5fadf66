// SPDX-License-Identifier: GPL-3.0-or-later
// Where grains and fluid are in an exchange interval, and what fits it.

#include "exchangeClock.H"

#include "OStringStream.H"
#include "Time.H"

namespace
{
    using namespace Foam;

    //- The largest step, not above the longest, of which a time is a whole number [s]
    scalar stepIn(const scalar time, const scalar longest)
    {
        return time/std::ceil(time/longest*(1 - exchangeClock::roundOff));
    }
}


Foam::scalar Foam::exchangeClock::stepInInterval(const scalar longest) const
{
    return stepIn(interval() - (due() ? 0 : elapsed_), longest);
}


Foam::string Foam::exchangeClock::writingFault(const Time& runTime) const
{
    const dictionary& control = runTime.controlDict();
    const word writeControl
    (
        control.getOrDefault<word>("writeControl", "timeStep")
    );
    const scalar interval = phase_.exchangeInterval();
    OStringStream fault;

    const bool byTime =
        writeControl == "adjustable" || writeControl == "adjustableRunTime"
     || writeControl == "runTime";

    if (!byTime)
    {
        fault
            << "writeControl is " << writeControl
            << ": with grains, results are written at ends of exchange"
            << " intervals (" << interval << " s), where grains and water are"
            << " at the same time." << nl
            << "    Use writeControl adjustableRunTime, and a writeInterval"
            << " that is a whole number of intervals.";
        return fault.str();
    }

    if (control.getOrDefault<label>("purgeWrite", 0) == 1)
    {
        fault
            << "purgeWrite 1 removes the last time before the next one is"
            << " complete: a run killed just then has none to go on from." << nl
            << "    Use purgeWrite 2, or more, or 0 to keep all.";
        return fault.str();
    }

    for (const word key : {"writeInterval", "endTime"})
    {
        const scalar value =
            control.get<scalar>(key)
          - (key == word("endTime") ? runTime.startTime().value() : 0);
        const scalar n = value/interval;

        // As far as numbers of four digits can be wrong, but never as a whole
        if (mag(n - std::round(n)) > min(1e-4*max(n, scalar(1)), 0.01))
        {
            fault
                << key << " " << control.get<scalar>(key)
                << " s does not fit the exchange interval of " << interval
                << " s (" << phase_.stepsPerExchange() << " DEM steps of "
                << phase_.timeStep() << " s): it is " << n << " intervals."
                << nl << "    Make it a whole number of them.";
            return fault.str();
        }
    }

    return string();
}


Foam::string Foam::exchangeClock::stepFault(const Time& runTime) const
{
    const scalar interval = phase_.exchangeInterval();
    const scalar deltaT = runTime.controlDict().get<scalar>("deltaT");
    const scalar fitting = stepIn(interval, deltaT);

    if (mag(fitting - deltaT) <= roundOff*deltaT)
    {
        return string();
    }

    OStringStream fault;
    fault
        << "deltaT " << deltaT << " s does not fit the exchange interval"
        << " of " << interval << " s: a whole number of"
        << " fluid steps would be " << fitting << " s long." << nl
        << "    Give that as deltaT, or adjustTimeStep yes.";

    return fault.str();
}


void Foam::exchangeClock::check
(
    const Time& runTime,
    const bool adjustTimeStep
) const
{
    string fault(writingFault(runTime));
    if (fault.empty() && !adjustTimeStep)
    {
        fault = stepFault(runTime);
    }

    if (fault.size())
    {
        FatalIOErrorInFunction(runTime.controlDict())
            << fault.c_str() << exit(FatalIOError);
    }
}


void Foam::exchangeClock::warnOfChanges
(
    const Time& runTime,
    const bool adjustTimeStep
)
{
    const string writing(writingFault(runTime));
    const string step(adjustTimeStep ? string() : stepFault(runTime));
    const string all(writing + (writing.empty() ? "" : "\n    ") + step);

    if (all != lastFault_ && all.size())
    {
        IOWarningInFunction(runTime.controlDict())
            << all.c_str() << nl
            << "    The run goes on: it writes at the first end of an exchange"
            << " after each time to write, and takes the longest fluid step that"
            << " fits." << endl;
    }
    lastFault_ = all;
}
