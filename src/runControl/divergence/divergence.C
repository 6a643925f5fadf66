// SPDX-License-Identifier: GPL-3.0-or-later
// Stops a run whose flow has diverged, with its fields written for inspection.

#include "divergence.H"

#include "OStringStream.H"
#include "exceptionGuard.H"
#include "foamCompatibility.H"
#include "fpeGuard.H"

#include <cmath>

Foam::scalar Foam::fastestComponent(const vector& u)
{
    scalar largest = 0;

    for (direction d = 0; d < vector::nComponents; ++d)
    {
        largest = std::isfinite(u[d]) ? max(largest, mag(u[d])) : VGREAT;
        if (largest == VGREAT)
        {
            break;
        }
    }

    return largest;
}


void Foam::stopDiverged
(
    const volVectorField& U,
    const string& why,
    const std::function<void()>& writeState
)
{
    // A trap would stop at a number that is none
    const fpeGuard noTraps;

    scalar fastest = 0;
    label where = 0;

    forAll(U, cell)
    {
        const scalar speed = fastestComponent(U[cell]);

        if (speed > fastest)
        {
            fastest = speed;
            where = cell;
        }
    }

    const scalar fastestOfAll = returnReduce(fastest, maxOp<scalar>());
    writeState();

    // No rank ends the others before they have written
    compatibility::barrier();

    if (fastest == fastestOfAll)
    {
        const Time& runTime = U.time();

        FatalErrorInFunction
            << "The flow has diverged at time " << runTime.timeName() << " s: "
            << why.c_str() << nl
            << "    The fluid is fastest in cell " << where << " at "
            << U.mesh().C()[where] << " m, with U = " << U[where] << " m/s." << nl
            << "    The fields of this time are written, to look at: a run with"
            << " startFrom latestTime goes on from the last time before." << nl
            << "    Look there for poor cells (checkMesh), properties of the fluids or"
            << " conditions of U and p_rgh that do not fit each other, or a mesh far"
            << " from height zero (constant/hRef); else take shorter steps (deltaT,"
            << " maxCo, maxAlphaCo) or more nCorrectors."
            << exit(FatalError);
    }
    compatibility::barrier();
}


void Foam::checkSpeed(const volVectorField& U, const std::function<void()>& writeState)
{
    // Of sound in air [m/s]: neither fluid would be incompressible
    const scalar sound = 340;
    const fpeGuard noTraps;
    bool calm = true;

    for (const vector& u : U.primitiveField())
    {
        calm = calm && fastestComponent(u) <= sound;
    }

    if (!returnReduce(calm, andOp<bool>()))
    {
        stopDiverged(U, "the fluid is faster than sound (340 m/s).", writeState);
    }
}


void Foam::checkLeastStep
(
    const volVectorField& U,
    const scalar courantStep,
    const std::function<void()>& writeState
)
{
    const dictionary& control = U.time().controlDict();
    const scalar least = control.getOrDefault<scalar>
    (
        "minDeltaT",
        1e-6*control.get<scalar>("deltaT")
    );

    if (!(courantStep >= least))
    {
        OStringStream why;
        why << "the Courant numbers ask for fluid steps of " << courantStep
            << " s, less than minDeltaT of system/controlDict, " << least
            << " s (without it, a millionth of deltaT).";
        stopDiverged(U, why.str(), writeState);
    }
}


Foam::scalar Foam::unlikelySpeed(const volVectorField& U, const vector& g)
{
    scalar patchSpeed = 0;

    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        // What flows in and out under a pressure follows from the flow
        if (patch.fixesValue() && !patch.assignable() && patch.size())
        {
            patchSpeed = max(patchSpeed, max(mag(patch)));
        }
    }

    return 1.5*max
    (
        returnReduce(patchSpeed, maxOp<scalar>()),
        std::sqrt(2*mag(g)*U.mesh().bounds().mag())
    );
}


void Foam::runExplainingErrors
(
    const volVectorField& U,
    const surfaceScalarField& phiU,
    const vector& g,
    const std::function<void()>& moving
)
{
    // Through faces: what oscillates from cell to cell shows there
    const scalar most = unlikelySpeed(U, g);
    const scalar fastest =
        gMax((mag(phiU.primitiveField())/U.mesh().magSf().primitiveField())());

    try
    {
        const exceptionGuard guard(FatalError);
        moving();
    }
    catch (const error& problem)
    {
        OStringStream flow;

        if (most > 0 && fastest > most)
        {
            flow<< nl
                << "    But it seems that the flow has diverged: the fluid reaches "
                << fastest << " m/s. 1.5 times the speed of a free fall through the"
                << " mesh, or of what is given on patches, is " << most
                << " m/s. Look at the last times for where that began:"
                << " poor cells (checkMesh), properties of the fluids or conditions"
                << " of U and p_rgh that do not fit each other; else take shorter"
                << " steps (deltaT, maxCo, maxAlphaCo) or more nCorrectors.";
        }

        FatalError
        (
            problem.functionName().c_str(),
            problem.sourceFileName().c_str(),
            problem.sourceFileLineNumber()
        )
            << problem.message().c_str() << flow.str().c_str()
            << exit(FatalError);
    }
}
