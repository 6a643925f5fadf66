// SPDX-License-Identifier: GPL-3.0-or-later
// The forces of the last DEM step, kept while LIGGGHTS sets itself up again.

#include "lastForces.H"

#include "fpeGuard.H"
#include "liggghtsErrors.H"
#include "liggghtsInstance.H"
#include "vectorProperty.H"

#include <algorithm>

#include <liggghts/atom.h>
#include <liggghts/lammps.h>

namespace
{
    //- Stands where none was kept [N]
    constexpr double none = 1e300;
    const char* const noneText = "1e300";
}


void Foam::lastForces::add(liggghtsInstance& liggghts)
{
    liggghts_ = &liggghts;
    const fpeGuard guard;
    const liggghtsErrors::activity now("the forces of the last DEM step");
    LAMMPS_NS::Modify& modify = *liggghts->modify;
    force_ = addVectorProperty(modify, "interDEMFoamLastForce", noneText);
    torque_ = addVectorProperty(modify, "interDEMFoamLastTorque", noneText);
}


void Foam::lastForces::keep()
{
    const LAMMPS_NS::Atom& atom = *(*liggghts_)->atom;

    for (int i = 0; i < atom.nlocal; ++i)
    {
        std::copy_n(atom.f[i], 3, force_->array_atom[i]);
        std::copy_n(atom.torque[i], 3, torque_->array_atom[i]);
    }
}


void Foam::lastForces::restore()
{
    const LAMMPS_NS::Atom& atom = *(*liggghts_)->atom;

    for (int i = 0; i < atom.nlocal; ++i)
    {
        if (force_->array_atom[i][0] != none)
        {
            std::copy_n(force_->array_atom[i], 3, atom.f[i]);
            std::copy_n(torque_->array_atom[i], 3, atom.torque[i]);
        }
    }
}
