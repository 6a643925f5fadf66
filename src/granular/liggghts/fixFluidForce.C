// SPDX-License-Identifier: GPL-3.0-or-later
// A LIGGGHTS fix that adds the fluid's force and torque in each DEM step.

#include "fixFluidForce.H"

#include "vectorProperty.H"

#include <liggghts/atom.h>
#include <liggghts/lammps.h>

const char* const Foam::fixFluidForce::styleName = "interDEMFoam/fluidForce";


Foam::fixFluidForce::fixFluidForce
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg
)
:
    fixFluidForce(lmp, narg, arg, "fluidForce", "fluidTorque")
{}


Foam::fixFluidForce::fixFluidForce
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg,
    const char* forceName,
    const char* torqueName
)
:
    LAMMPS_NS::Fix(lmp, narg, arg),
    force_(nullptr),
    torque_(nullptr),
    forceName_(forceName),
    torqueName_(torqueName)
{}


void Foam::fixFluidForce::post_create()
{
    force_ = addVectorProperty(*modify, forceName_, "0.");
    torque_ = addVectorProperty(*modify, torqueName_, "0.");
}


int Foam::fixFluidForce::setmask()
{
    return LAMMPS_NS::FixConst::POST_FORCE;
}


void Foam::fixFluidForce::setup(int vflag)
{
    post_force(vflag);
}


void Foam::fixFluidForce::post_force(int)
{
    double** f = atom->f;
    double** t = atom->torque;
    double** fluidForce = force();
    double** fluidTorque = torque();

    for (int i = 0; i < atom->nlocal; ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            f[i][k] += fluidForce[i][k];
            t[i][k] += fluidTorque[i][k];
        }
    }
}
