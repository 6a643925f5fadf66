// SPDX-License-Identifier: GPL-3.0-or-later
// A LIGGGHTS fix that damps each grain against its own motion.

#include "fixLocalDamping.H"

#include <cmath>
#include <cstdlib>

#include <liggghts/atom.h>
#include <liggghts/error.h>

const char* const Foam::fixLocalDamping::styleName =
    "interDEMFoam/localDamping";


Foam::fixLocalDamping::fixLocalDamping
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg
)
:
    LAMMPS_NS::Fix(lmp, narg, arg),
    alpha_(narg == 4 ? std::atof(arg[3]) : -1)
{
    if (!(alpha_ >= 0 && alpha_ < 1))
    {
        error->all(FLERR, "local damping needs one number from 0 to below 1");
    }
}


int Foam::fixLocalDamping::setmask()
{
    return LAMMPS_NS::FixConst::POST_FORCE;
}


void Foam::fixLocalDamping::setup(int vflag)
{
    post_force(vflag);
}


void Foam::fixLocalDamping::damp(double* force, const double* motion) const
{
    for (int k = 0; k < 3; ++k)
    {
        const double size = alpha_*std::fabs(force[k]);
        force[k] += motion[k] > 0 ? -size : motion[k] < 0 ? size : 0;
    }
}


void Foam::fixLocalDamping::post_force(int)
{
    added_.assign(3*atom->nlocal, 0);

    for (int i = 0; i < atom->nlocal; ++i)
    {
        if (atom->mask[i] & groupbit)
        {
            double* force = atom->f[i];
            const double before[] = {force[0], force[1], force[2]};
            damp(force, atom->v[i]);
            for (int k = 0; k < 3; ++k)
            {
                added_[3*i + k] = force[k] - before[k];
            }
            damp(atom->torque[i], atom->omega[i]);
        }
    }
}
