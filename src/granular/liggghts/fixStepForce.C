// SPDX-License-Identifier: GPL-3.0-or-later
// A LIGGGHTS fix that calls the program for forces on grains in each DEM step.

#include "fixStepForce.H"

#include "liggghtsArrays.H"
#include "liggghtsErrors.H"

#include <liggghts/atom.h>

const char* const Foam::fixStepForce::styleName = "interDEMFoam/stepForce";


Foam::fixStepForce::fixStepForce
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg
)
:
    fixFluidForce(lmp, narg, arg, "stepForce", "stepTorque")
{}


void Foam::fixStepForce::setup(int vflag)
{
    fixFluidForce::post_force(vflag);
}


void Foam::fixStepForce::post_force(int vflag)
{
    const label n = atom->nlocal;
    grainsInStep grains
    {
        vectors(atom->x, n),
        vectors(atom->v, n),
        vectors(atom->omega, n),
        UList<scalar>(atom->radius, n),
        UList<scalar>(atom->rmass, n),
        vectors(force(), n),
        vectors(torque(), n)
    };
    grains.force = vector(Zero);
    grains.torque = vector(Zero);

    liggghtsErrors::runOutside([&]() { forces_(grains); });

    fixFluidForce::post_force(vflag);
}
