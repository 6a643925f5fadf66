// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS's plane walls with several contacts in one instruction.

#include "vectorisedWall.H"

#include "fixStyles.H"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <liggghts/atom.h>
#include <liggghts/fix_property_atom.h>
#include <liggghts/force.h>
#include <liggghts/neighbor.h>
#include <liggghts/primitive_wall.h>
#include <liggghts/update.h>

namespace
{
    bool same(const char* a, const char* b)
    {
        return !std::strcmp(a, b);
    }

    //- Springs of the models hertz and history come first, then that of epsd2
    constexpr int springTorqueAt = 3;
}


void Foam::vectorisedWall::addStyle(LAMMPS_NS::LAMMPS* lmp)
{
    addFixStyle
    (
        lmp,
        "wall/gran",
        [](LAMMPS_NS::LAMMPS* l, int narg, char** arg) -> LAMMPS_NS::Fix*
        {
            return new vectorisedWall(l, narg, arg);
        }
    );
}


Foam::vectorisedWall::vectorisedWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg)
:
    FixWallGran(lmp, narg, arg)
{
    const int first = 3;
    const auto primitive = std::find_if
    (
        arg + first,
        arg + narg,
        [](const char* word) { return same(word, "primitive"); }
    );

    isKnown_ =
        readModel(int(primitive - arg) - first, arg + first)
     && readPlane(int(arg + narg - primitive), primitive);
}


bool Foam::vectorisedWall::readModel(const int n, char** words)
{
    bool hertz = false, history = false;

    for (int k = 0; k + 1 < n; k += 2)
    {
        const char* const model = words[k + 1];

        if (same(words[k], "model"))
        {
            hertz = same(model, "hertz");
        }
        else if (same(words[k], "tangential"))
        {
            history = same(model, "history");
        }
        else if (same(words[k], "rolling_friction") && same(model, "cdt"))
        {
            rolling_ = rollingFriction::cdt;
        }
        else if (same(words[k], "rolling_friction") && same(model, "epsd2"))
        {
            rolling_ = rollingFriction::epsd2;
        }
        else if
        (
            !(same(words[k], "rolling_friction") && same(model, "off"))
         && !(same(words[k], "cohesion") && same(model, "off"))
        )
        {
            return false;
        }
    }

    return n % 2 == 0 && hertz && history;
}


bool Foam::vectorisedWall::readPlane(const int n, char** words)
{
    // primitive type <t> <axis>plane <place>, perhaps store_force yes
    const bool stores =
        n == 7 && same(words[5], "store_force") && same(words[6], "yes");

    if ((n != 5 && !stores) || !same(words[3] + 1, "plane"))
    {
        return false;
    }

    axis_ = words[3][0] - 'x';
    place_ = force->numeric(FLERR, words[4]);

    return axis_ >= 0 && axis_ < 3;
}


bool Foam::vectorisedWall::forcesAlone() const
{
    const int springs = rolling_ == rollingFriction::epsd2 ? 6 : 3;

    return
        isKnown_ && !update->setupflag && dnum_ == springs && !fix_rigid_
     && !fix_store_multicontact_data_ && !fix_sum_normal_force_
     && !store_force_contact_ && !store_force_contact_stress_ && !shear_
     && force->nktv2p == 1 && neighbor->contactDistanceFactor == 1;
}


void Foam::vectorisedWall::init()
{
    FixWallGran::init();

    if (isKnown_)
    {
        properties_.connect(force->registry, rolling_);
    }
}


void Foam::vectorisedWall::pre_force(int vflag)
{
    // What is no longer near the wall keeps no force
    if (rebuildPrimitiveNeighlist_ && store_force_ && atom->nlocal)
    {
        std::fill_n(fix_wallforce_->array_atom[0], 3*atom->nlocal, 0.0);
    }

    FixWallGran::pre_force(vflag);
}


void Foam::vectorisedWall::flush(const int n)
{
    contactBatch& c = batch_;
    const bool remembersTorque = rolling_ == rollingFriction::epsd2;

    for (int k = 0; k < n; ++k)
    {
        const int i = c.i[k];
        const auto& p = properties_(atom->type[i], atom_type_wall_);

        c.velocity.set(k, tripleAt(atom->v[i]));
        c.spinI.set(k, tripleAt(atom->omega[i]));
        c.massI[k] = atom->rmass[i];
        c.young[k] = p.young;
        c.shear[k] = p.shear;
        c.damping[k] = p.damping;
        c.friction[k] = p.friction;
        c.rollingFriction[k] = p.rollingFriction;
        c.stretch.set(k, tripleAt(c.history[k]));
        if (remembersTorque)
        {
            c.springTorque.set(k, tripleAt(c.history[k] + springTorqueAt));
        }
    }

    hertzHistory(c, n, update->dt, rolling_, true);

    for (int k = 0; k < n; ++k)
    {
        const int i = c.i[k];
        store(c.history[k], c.stretch(k));
        if (remembersTorque)
        {
            store(c.history[k] + springTorqueAt, c.springTorque(k));
        }

        // LIGGGHTS reports the wall's force as the change of the grain's force
        const triple before = tripleAt(atom->f[i]);
        const triple after = before + c.force(k);
        store(atom->f[i], after);
        store(atom->torque[i], tripleAt(atom->torque[i]) + c.torqueI(k));
        if (store_force_)
        {
            store(fix_wallforce_->array_atom[i], after - before);
        }
    }
}


void Foam::vectorisedWall::post_force(int vflag)
{
    if (!forcesAlone())
    {
        return FixWallGran::post_force(vflag);
    }

    properties_.copy();

    contactBatch& c = batch_;
    int* near;
    const int nNear = primitiveWall_->getNeighbors(near);
    int n = 0;

    for (int m = 0; m < nNear; ++m)
    {
        const int i = near[m];
        if (store_force_)
        {
            std::fill_n(fix_wallforce_->array_atom[i], 3, 0.0);
        }
        if (!(atom->mask[i] & groupbit))
        {
            continue;
        }

        const double away = atom->x[i][axis_] - place_;
        const double overlap = atom->radius[i] - std::fabs(away);
        double* const history = fix_history_primitive_->array_atom[i];

        if (!(overlap >= 0))
        {
            std::fill_n(history, dnum_, 0.0);
            continue;
        }

        triple d{0, 0, 0};
        (axis_ == 0 ? d.x : axis_ == 1 ? d.y : d.z) = away;
        c.i[n] = i;
        c.history[n] = history;
        c.distance.set(n, d);
        c.overlap[n] = overlap;
        c.radiusI[n] = atom->radius[i];

        if (++n == contactBatch::capacity)
        {
            flush(n);
            n = 0;
        }
    }

    if (n)
    {
        flush(n);
    }
}
