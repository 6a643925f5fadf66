// SPDX-License-Identifier: GPL-3.0-or-later
// A uniform velocity, its flux through all faces, and the velocity of that.

#include "reconstructionCheck.H"
#include "fpeGuard.H"
#include "fvcReconstruct.H"
#include "surfaceFields.H"
#include "volFields.H"

#include <cmath>

namespace
{

// Error of the velocity that comes back, relative; a number that is none counts
// as GREAT
Foam::scalarField errors(const Foam::fvMesh& mesh)
{
    using namespace Foam;

    // Nothing flows along an empty direction
    vector uniform(1, 2, 3);
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] < 0)
        {
            uniform[d] = 0;
        }
    }

    // A cell without volume divides by zero; the error below reports where it is
    const fpeGuard noTraps;
    const surfaceScalarField flux
    (
        dimensionedVector("uniform", dimVelocity, uniform) & mesh.Sf()
    );
    const volVectorField back(fvc::reconstruct(flux));

    scalarField error(mag(back.primitiveField() - uniform)/mag(uniform));
    for (scalar& e : error)
    {
        e = std::isfinite(e) ? e : GREAT;
    }

    return error;
}

} // End anonymous namespace


Foam::reconstructionError Foam::reconstructionErrorOf(const fvMesh& mesh)
{
    const scalarField error(errors(mesh));
    reconstructionError result{0, gMax(error), point(Zero)};

    label first = Pstream::nProcs();
    forAll(error, cell)
    {
        result.nCells += error[cell] > reconstructionError::allowed;
        if (error[cell] == result.largest)
        {
            // Not mesh.C(): ranks make that together
            result.at = mesh.cellCentres()[cell];
            first = Pstream::myProcNo();
        }
    }
    result.at *= (returnReduce(first, minOp<label>()) == Pstream::myProcNo());
    reduce(result.at, sumOp<point>());
    reduce(result.nCells, sumOp<label>());

    return result;
}


void Foam::checkReconstruction(const fvMesh& mesh)
{
    const reconstructionError error(reconstructionErrorOf(mesh));

    if (!error.nCells)
    {
        return;
    }

    FatalErrorInFunction
        << "A uniform velocity does not come back from its flux"
        << " (fvc::reconstruct): in " << error.nCells << " cells it is off by more"
        << " than " << reconstructionError::allowed << " of it, most by "
        << error.largest << " at " << error.at << " m." << nl
        << "    Either these cells are all but flat: see what checkMesh says of"
        << " them. Or the products of fields of this OpenFOAM are wrong, as"
        << " those of Debian's v1912 are, and all that is computed from"
        << " here would be:" << nl
        << "    build with the options of etc/options.mk (./Allwclean &&"
        << " ./Allwmake), and load no library ahead of libinterDEMCommon.so"
        << " (LD_PRELOAD)." << exit(FatalError);
}
