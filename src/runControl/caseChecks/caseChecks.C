// SPDX-License-Identifier: GPL-3.0-or-later
// What is checked of the fluid's case before a run.

#include "caseChecks.H"

#include "IFstream.H"
#include "OSspecific.H"

void Foam::checkMeshAtRest(const Time& runTime)
{
    const fileName constant(runTime.globalPath()/runTime.constant());
    const fileName moving(constant/"dynamicMeshDict");
    const fileName turning(constant/"MRFProperties");

    const bool moves =
        isFile(moving)
     && dictionary(IFstream(moving)()).getOrDefault<word>
        (
            "dynamicFvMesh",
            "staticFvMesh"
        ) != "staticFvMesh";

    if (moves || isFile(turning))
    {
        FatalErrorInFunction
            << (moves ? moving : turning) << " is of a mesh that "
            << (moves ? "moves" : "turns") << ", but that of interDEMFoam is at rest."
            << nl << "    Remove the file, or use interFoam." << exit(FatalError);
    }
}


void Foam::checkNumerics(const fvMesh& mesh, const word& alphaName)
{
    for (const word term : {"ddt(alpha)", "ddt(rho,U)"})
    {
        const word scheme(mesh.ddtScheme(term));

        if (scheme != "Euler")
        {
            FatalErrorInFunction
                << term << " is " << scheme << " in " << mesh.time().system()
                << "/fvSchemes" << nl
                << "    interDEMFoam advances void fraction, alpha and U with"
                << " Euler: set 'default Euler'." << exit(FatalError);
        }
    }

    for (const word term : {"div(rhoPhi,U)", "div(phi,alpha)", "div(phirb,alpha)"})
    {
        mesh.divScheme(term);
    }

    const dictionary pimple(mesh.solutionDict().subOrEmptyDict("PIMPLE"));
    DynamicList<word> solved({alphaName, "p_rghFinal"});
    if
    (
        pimple.getOrDefault<label>("nCorrectors", 1) > 1
     || pimple.getOrDefault<label>("nOuterCorrectors", 1) > 1
     || pimple.getOrDefault<label>("nNonOrthogonalCorrectors", 0) > 0
    )
    {
        solved.append("p_rgh");
    }
    if (pimple.getOrDefault("momentumPredictor", true))
    {
        solved.append("UFinal");
    }

    for (const word& field : solved)
    {
        mesh.solverDict(field);
    }
    mesh.time().controlDict().get<scalar>("maxAlphaCo");
}


void Foam::checkFunctionObjects(Time& runTime)
{
    if (!runTime.functionObjects().read())
    {
        FatalIOErrorInFunction(runTime.controlDict())
            << "A function object cannot be made: the warning above names"
            << " it and the cause." << nl
            << "    Correct it in system/controlDict, or set 'enabled no' in it."
            << exit(FatalIOError);
    }
}
