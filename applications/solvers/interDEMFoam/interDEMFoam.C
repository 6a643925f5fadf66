// SPDX-License-Identifier: GPL-3.0-or-later
// Water, air and grains: interFoam with the void fraction that the grains
// leave, coupled with a granular method in the same program.

#include "fvCFD.H"
#include "CMULES.H"
#include "CorrectPhi.H"
#include "EulerDdtScheme.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fvOptions.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"
#include "pimpleControl.H"
#include "subCycle.H"
#include "turbulentTransportModel.H"

#include "caseChecks.H"
#include "closedTank.H"
#include "demCoupling.H"
#include "divergence.H"
#include "fluidTimeStep.H"
#include "fpeGuard.H"
#include "granularProperties.H"
#include "lawLists.H"
#include "masterErrorsFirst.H"
#include "outputControl.H"
#include "pressureChecks.H"
#include "projectVersion.H"
#include "reconstructionCheck.H"
#include "slidingGate.H"
#include "timeFolders.H"


int main(int argc, char *argv[])
{
    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Air and water (volume of fluid) with grains (discrete elements),"
        " unresolved: cells are larger than grains.\n"
        "\n"
        "Example, in the folder of a case with mesh, water and grains:\n"
        "    decomposePar\n"
        "    mpirun -np 2 interDEMFoam -parallel"
    );
    lawLists::addOptions();

    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    if (lawLists::print(args))
    {
        return 0;
    }

    const masterErrorsFirst errors;
    timeFolders::putIncompleteAside(args);
    Info<< "Create time\n" << endl;
    exchangeTime runTime(Time::controlDictName, args);
    #include "createMesh.H"

    if (granularProperties::present(mesh))
    {
        runTime.restoreValue();
    }

    if (granularProperties::withoutFluid(mesh))
    {
        #include "grainsAlone.H"
        return 0;
    }

    pimpleControl pimple(mesh);
    #include "initContinuityErrs.H"
    #include "createTimeControls.H"
    #include "createFields.H"
    #include "startCoupling.H"

    fluidTimeStep fluidDeltaT(runTime.deltaTValue());
    #include "createOutput.H"

    Info<< "\nStarting time loop\n" << endl;
    coupling.times().begin();

    while (output.run())
    {
        #include "readTimeControls.H"
        #include "setDeltaT.H"
        #include "exchange.H"

        ++runTime;
        Info<< "Time = " << runTime.timeName() << nl << endl;

        {
            const stageTimes::stage stage(coupling.times(), "fluidSolution");
            #include "fluidStep.H"
        }
        checkSpeed(U, writeState);

        coupling.addFluidStep
        (
            U,
            rho,
            netForce,
            pressureForce,
            viscousForce(),
            runTime.deltaTValue()
        );
        if (coupling.due())
        {
            coupling.setGrainForces(U);
        }

        output.endStep();
    }
    output.end();

    return 0;
}
