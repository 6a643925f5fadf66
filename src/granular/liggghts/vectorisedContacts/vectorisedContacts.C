// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS's pair style gran with several contacts in one instruction.

#include "vectorisedContacts.H"

#include <algorithm>

#include <liggghts/atom.h>
#include <liggghts/fix_property_atom.h>
#include <liggghts/force.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neigh_list.h>
#include <liggghts/neighbor.h>
#include <liggghts/update.h>

namespace
{
    // LIGGGHTS's numbers for models, which are in its restart files too
    constexpr int hertz = 3, history = 2, cdt = 1, epsd2 = 3;

    //- Number of a contact model without cohesion, of spheres
    constexpr int64_t modelNumber(const int rolling)
    {
        return hertz | (history << 6) | (rolling << 18);
    }

    // LIGGGHTS's marks of the models that take part in a contact
    constexpr int normalModel = 1, tangentialModel = 4, rollingModel = 8;


    LAMMPS_NS::Pair* newVectorisedContacts(LAMMPS_NS::LAMMPS* lmp)
    {
        return new Foam::vectorisedContacts(lmp);
    }

    Foam::triple at(const double* const vectors, const int i)
    {
        return Foam::tripleAt(vectors + 3*i);
    }

    void addTo(double* const vectors, const int i, const Foam::triple& v)
    {
        vectors[3*i] += v.x;
        vectors[3*i + 1] += v.y;
        vectors[3*i + 2] += v.z;
    }
}


void Foam::vectorisedContacts::addStyle(LAMMPS_NS::LAMMPS* lmp)
{
    (*lmp->force->pair_map)["gran"] = newVectorisedContacts;
}


Foam::vectorisedContacts::vectorisedContacts(LAMMPS_NS::LAMMPS* lmp)
:
    PairGranProxy(lmp)
{}


int Foam::vectorisedContacts::placeOf(const char* name) const
{
    for (int i = int(history_arg.size()) - 1; i >= 0; --i)
    {
        if (history_arg[i].name == name)
        {
            return i;
        }
    }

    return -1;
}


bool Foam::vectorisedContacts::knowsModel()
{
    const int64_t number = hashcode();

    return
        number == modelNumber(0)
     || number == modelNumber(cdt)
     || number == modelNumber(epsd2);
}


std::string Foam::vectorisedContacts::reason()
{
    if (!knowsModel())
    {
        return "the model is not hertz tangential history, alone or with"
            " rolling_friction cdt or epsd2";
    }

    if (options_)
    {
        return "pair_style has options behind the names of the models";
    }

    if (force->nktv2p != 1 || force->newton_pair)
    {
        return "units are not si, or newton is on";
    }

    if (neighbor->contactDistanceFactor != 1)
    {
        return "neigh_modify contact_distance_factor is not 1";
    }

    if (fix_rigid || freeze_group_bit_ || store_multicontact_data_)
    {
        return "a fix freezes grains, joins them, or changes their radii";
    }

    if
    (
        store_contact_forces_ || store_contact_forces_stress_
     || fix_sum_normal_force_ || modify->n_fixes_style("insert/stream/predefined")
    )
    {
        return "a command keeps the force of each contact, or sets its memory";
    }

    return std::string();
}


bool Foam::vectorisedContacts::forcesAlone
(
    const int eflag,
    const int vflag,
    const int addflag
) const
{
    return !eflag && !vflag && !addflag && computeflag_ && shearupdate_;
}


void Foam::vectorisedContacts::settings(int narg, char** arg)
{
    PairGranProxy::settings(narg, arg);

    options_ = false;
    for (int i = 0; i < narg; i += 2)
    {
        const std::string word(arg[i]);
        options_ =
            options_
         || !(
                word == "model" || word == "tangential" || word == "cohesion"
             || word == "rolling_friction" || word == "surface"
             );
    }
}


void Foam::vectorisedContacts::init_granular()
{
    PairGranProxy::init_granular();

    if (!knowsModel())
    {
        return;
    }

    const int rolling = hashcode() >> 18;
    rolling_ =
        rolling == cdt ? rollingFriction::cdt
      : rolling == epsd2 ? rollingFriction::epsd2
      : rollingFriction::off;

    properties_.connect(force->registry, rolling_);
    stretchAt_ = placeOf("shearx");
    springTorqueAt_ = placeOf("r_torquex_old");
}


void Foam::vectorisedContacts::gather(const int n)
{
    contactBatch& c = batch_;
    const double* const velocity = atom->v[0];
    const double* const spin = atom->omega[0];
    const double* const mass = atom->rmass;
    const int* const type = atom->type;
    const bool rolls = rolling_ != rollingFriction::off;
    const bool remembersTorque = rolling_ == rollingFriction::epsd2;

    for (int k = 0; k < n; ++k)
    {
        const int i = c.i[k];
        const int j = c.j[k];

        c.velocity.set(k, at(velocity, i) - at(velocity, j));
        c.spinI.set(k, at(spin, i));
        c.spinJ.set(k, at(spin, j));
        c.massI[k] = mass[i];
        c.massJ[k] = mass[j];

        const auto& p = properties_(type[i], type[j]);
        c.young[k] = p.young;
        c.shear[k] = p.shear;
        c.damping[k] = p.damping;
        c.friction[k] = p.friction;
        c.stretch.set(k, tripleAt(c.history[k] + stretchAt_));

        if (rolls)
        {
            c.rollingFriction[k] = p.rollingFriction;
        }
        if (remembersTorque)
        {
            c.springTorque.set(k, tripleAt(c.history[k] + springTorqueAt_));
        }
    }
}


void Foam::vectorisedContacts::scatter(const int n)
{
    contactBatch& c = batch_;
    double* const force = atom->f[0];
    double* const torque = atom->torque[0];

    const bool remembersTorque = rolling_ == rollingFriction::epsd2;
    const int marks =
        normalModel | tangentialModel | (remembersTorque ? rollingModel : 0);

    // One after the other, in LIGGGHTS's order: sums round the same
    for (int k = 0; k < n; ++k)
    {
        *c.flag[k] |= marks;
        store(c.history[k] + stretchAt_, c.stretch(k));
        if (remembersTorque)
        {
            store(c.history[k] + springTorqueAt_, c.springTorque(k));
        }

        const triple F = c.force(k);
        addTo(force, c.i[k], F);
        addTo(torque, c.i[k], c.torqueI(k));

        // What belongs to another rank, or is a periodic image, gets its force
        // there
        if (c.j[k] < atom->nlocal)
        {
            addTo(force, c.j[k], F*(-1));
            addTo(torque, c.j[k], c.torqueJ(k));
        }
    }
}


void Foam::vectorisedContacts::flush(const int n)
{
    gather(n);
    hertzHistory(batch_, n, update->dt, rolling_, false);
    scatter(n);
}


int Foam::vectorisedContacts::addContacts(const int i, int n)
{
    contactBatch& c = batch_;
    const int size = dnum();
    const double* const radius = atom->radius;
    const int* const neighbours = list->firstneigh[i];
    int* const flags = listgranhistory->firstneigh[i];
    double* const memory = listgranhistory->firstdouble[i];

    const triple x = at(atom->x[0], i);
    const double ri = radius[i];

    for (int jj = 0; jj < list->numneigh[i]; ++jj)
    {
        const int j = neighbours[jj] & NEIGHMASK;
        const triple d = x - at(atom->x[0], j);
        const double rj = radius[j];
        const double squared = dot(d, d);
        const bool touch = squared < (ri + rj)*(ri + rj);

        // Noted of each neighbour, kept of those that touch: to skip the
        // others by a branch would cost more
        c.i[n] = i;
        c.j[n] = j;
        c.flag[n] = flags + jj;
        c.history[n] = memory + size*jj;
        c.distance.set(n, d);
        c.distanceSquared[n] = squared;
        c.radiusI[n] = ri;
        c.radiusJ[n] = rj;
        n += touch;

        // Where a contact has opened: no spring when it closes again, whenever
        // the lists are built. LIGGGHTS keeps the spring until then
        if (flags[jj] && !touch)
        {
            flags[jj] = 0;
            std::fill_n(memory + size*jj, size, 0.0);
        }

        // What the force needs of j is on its way until the batch is full
        __builtin_prefetch(atom->v[0] + 3*j);
        __builtin_prefetch(atom->omega[0] + 3*j);
        __builtin_prefetch(atom->f[0] + 3*j, 1);
        __builtin_prefetch(atom->torque[0] + 3*j, 1);

        if (n == contactBatch::capacity)
        {
            flush(n);
            n = 0;
        }
    }
    return n;
}


void Foam::vectorisedContacts::compute_force
(
    int eflag,
    int vflag,
    int addflag
)
{
    if (!forcesAlone(eflag, vflag, addflag) || !reason().empty())
    {
        return PairGranProxy::compute_force(eflag, vflag, addflag);
    }

    evflag = vflag_fdotr = 0;
    if (!list->inum)
    {
        return;
    }
    properties_.copy();

    int n = 0;
    for (int ii = 0; ii < list->inum; ++ii)
    {
        n = addContacts(list->ilist[ii], n);
    }

    if (n)
    {
        flush(n);
    }
}
