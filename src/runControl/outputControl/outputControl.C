// SPDX-License-Identifier: GPL-3.0-or-later
// When a run writes, and when it stops.

#include "outputControl.H"

#include "functionState.H"
#include "heldMemory.H"
#include "timeFolders.H"

void Foam::outputControl::write()
{
    if (actions_.prepare)
    {
        actions_.prepare();
    }

    const auto writing = [this]() -> bool
    {
        const bool complete = actions_.write();

        return writeFunctionState(runTime_) && complete;
    };

    timeFolders::unmark(runTime_);
    timeFolders::markWritten(runTime_, timeFolders::attempt(runTime_, writing));

    times_.print();
    releaseFreeMemory();
    printHeldMemory();
}


Foam::outputControl::outputControl
(
    exchangeTime& runTime,
    const stageTimes& times,
    const actions& what
)
:
    runTime_(runTime),
    times_(times),
    actions_(what)
{}


bool Foam::outputControl::run()
{
    const bool goesOn = runTime_.run();

    if (goesOn && writeDue_)
    {
        write();
    }

    return goesOn;
}


void Foam::outputControl::endStep()
{
    const bool atOneTime = actions_.atOneTime();

    runTime_.writeWhere(atOneTime);
    writeDue_ = runTime_.writeTime();

    if (atOneTime && stop_.requested())
    {
        stops_ = true;
        Info<< "Stop requested: writing, then ending" << endl;
        runTime_.setEndTime(runTime_.value());
    }
    else if
    (
        !atOneTime
     && runTime_.value() > runTime_.endTime().value() - 0.5*runTime_.deltaTValue()
    )
    {
        // stopAt writeNow: the interval is finished first
        runTime_.setEndTime(runTime_.value() + runTime_.deltaTValue());
    }

    runTime_.printExecutionTime(Info);
}


void Foam::outputControl::end()
{
    if (!actions_.atOneTime())
    {
        Warning
            << "The run ended at " << runTime_.timeName() << " s, between two"
            << " exchanges: grains and water are not at the same time, so this"
            << " time is not written." << nl
            << "    Go on from the latest time that is; end a run with stopAt"
            << " writeNow or SIGTERM." << endl;
    }
    else if
    (
        runTime_.timeIndex() > runTime_.startTimeIndex()
     && (writeDue_ || actions_.writeEnd || stop_.requested())
    )
    {
        write();
    }

    if (stops_)
    {
        timeFolders::markStopRequested(runTime_);
    }
    times_.print();
    Info<< "End\n" << endl;
}
