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
#include "grainCoupling.H"
#include "slidingGate.H"
#include "solverChecks.H"
#include "stopSignal.H"
#include "timeFolders.H"

namespace Foam
{
namespace fvc
{
    // OpenFOAM's own instance: compiled here it would add in another order,
    // and a run without grains would not be interFoam's to the last bit
    extern template tmp<GeometricField<vector, fvPatchField, volMesh>>
    reconstruct<scalar>
    (
        const GeometricField<scalar, fvsPatchField, surfaceMesh>&
    );
}
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Air and water (volume of fluid) with grains (discrete elements),"
        " unresolved: cells are larger than grains."
    );

    grainCoupling::moving = !argList::postProcess(argc, argv);
    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    #include "createTime.H"
    timeFolders::takeLastComplete(runTime);
    #include "createMesh.H"
    checkEuler(mesh);

    pimpleControl pimple(mesh);
    #include "initContinuityErrs.H"
    #include "createTimeControls.H"
    #include "createFields.H"
    #include "startGrains.H"

    turbulence->validate();

    const stopSignal stop;

    // The fluid step as the Courant numbers have it [s]
    scalar wanted = runTime.deltaTValue();

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "timeStep.H"

        if (grains.due())
        {
            grains.moveGrains();
            grains.locateGrains();
            grains.findPorosity();
            grains.prepareForces(fluidNow());
        }

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        {
            const stageTimes::stage stage(grains.times(), "fluidSolution");
            #include "fluidStep.H"
        }

        if (grains.active())
        {
            grains.addFluidStep
            (
                U,
                pressureGradient(),
                viscousForce(),
                runTime.deltaTValue()
            );

            if (grains.due())
            {
                grains.giveForces(U);
            }
        }

        if (stop.requested() && (!grains.active() || grains.due()))
        {
            Info<< "Asked to stop: writing, then ending" << endl;
            runTime.writeAndEnd();
        }

        #include "write.H"

        runTime.printExecutionTime(Info);
    }

    grains.times().print();
    Info<< "End\n" << endl;

    return 0;
}
