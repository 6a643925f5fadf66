// SPDX-License-Identifier: GPL-3.0-or-later
// Water, air and grains: interFoam with the void fraction that the grains
// leave, coupled with a granular method in the same program.

#include "fvCFD.H"
#include "CMULES.H"
#include "EulerDdtScheme.H"
#include "subCycle.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"
#include "turbulentTransportModel.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "CorrectPhi.H"
#include "divergence.H"
#include "exchangeTime.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "masterErrorsFirst.H"
#include "fpeGuard.H"
#include "functionState.H"
#include "granularProperties.H"
#include "demCoupling.H"
#include "heightChecks.H"
#include "heldMemory.H"
#include "reconstructionCheck.H"
#include "slidingGate.H"
#include "solverChecks.H"
#include "stopSignal.H"
#include "timeFolders.H"


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Air and water (volume of fluid) with grains (discrete elements),"
        " unresolved: cells are larger than grains."
    );

    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    const masterErrorsFirst errors;
    timeFolders::putIncompleteAside(args);
    Info<< "Create time\n" << endl;
    exchangeTime runTime(Time::controlDictName, args);
    #include "createMesh.H"

    if (granularProperties::withoutFluid(mesh))
    {
        #include "grainsAlone.H"
        return 0;
    }

    pimpleControl pimple(mesh);
    #include "initContinuityErrs.H"
    #include "createTimeControls.H"
    #include "createFields.H"
    #include "startGrains.H"
    timeFolders::markStart(runTime);

    const stopSignal stop;
    bool asked = false;
    bool toWrite = false;

    // Grains and water are at the same time only where an interval ends
    const auto together = [&]() -> bool
    {
        return !grains.active() || grains.due();
    };

    // The fluid step as the Courant numbers have it [s]
    scalar wanted = runTime.deltaTValue();

    Info<< "\nStarting time loop\n" << endl;
    grains.times().begin();

    while (runTime.run())
    {
        // Now that function objects have seen it
        if (toWrite)
        {
            #include "write.H"
        }

        #include "readTimeControls.H"
        #include "timeStep.H"

        if (grains.due())
        {
            blameFlow
            (
                U,
                phiU,
                g.value(),
                [&]()
                {
                    grains.moveGrains(fluidNow);
                    grains.locateGrains();
                }
            );
            grains.findVoidFraction(alpha1);
            grains.prepareForces(fluidNow());
        }

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        {
            const stageTimes::stage stage(grains.times(), "fluidSolution");
            #include "fluidStep.H"
        }
        checkSpeed(U, lastLook);

        if (grains.active())
        {
            grains.addFluidStep
            (
                U,
                rho,
                netForce,
                pressureForce,
                viscousForce(),
                runTime.deltaTValue()
            );

            if (grains.due())
            {
                grains.setParticleForces(U);
            }
        }

        runTime.writeWhere(together());
        toWrite = runTime.writeTime();
        asked = together() && stop.requested();

        if (asked)
        {
            Info<< "Asked to stop: writing, then ending" << endl;
            runTime.setEndTime(runTime.value());
        }
        else if
        (
            !together()
         && runTime.value()
          > runTime.endTime().value() - 0.5*runTime.deltaTValue()
        )
        {
            // stopAt writeNow: the interval is finished first
            runTime.setEndTime(runTime.value() + runTime.deltaTValue());
        }

        runTime.printExecutionTime(Info);
    }

    // The end is written wherever it is: times to write count from the start
    if (!together())
    {
        Warning
            << "The run ended at " << runTime.timeName() << " s, between two"
            << " exchanges: grains and water are not at the same time, so this"
            << " time is not written." << nl
            << "    Go on from the latest time that is; end a run with stopAt"
            << " writeNow or SIGTERM." << endl;
    }
    else if
    (
        runTime.timeIndex() > runTime.startTimeIndex()
     && (toWrite || asked || grains.active())
    )
    {
        #include "write.H"
    }

    grains.times().print();
    Info<< "End\n" << endl;

    return 0;
}
