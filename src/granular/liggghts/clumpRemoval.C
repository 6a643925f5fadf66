// SPDX-License-Identifier: GPL-3.0-or-later
// A LIGGGHTS fix that takes out whole clumps as they leave the grains' box.

#include "clumpRemoval.H"

#include "PstreamReduceOps.H"
#include "foamCompatibility.H"
#include "liggghtsErrors.H"

#include <cstring>

#include <liggghts/atom.h>
#include <liggghts/atom_vec.h>
#include <liggghts/domain.h>
#include <liggghts/fix_multisphere.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>

const char* const Foam::clumpRemoval::styleName = "interDEMFoam/clumpRemoval";


Foam::clumpRemoval::clumpRemoval
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg
)
:
    LAMMPS_NS::Fix(lmp, narg, arg)
{}


Foam::clumpRemoval* Foam::clumpRemoval::of(const liggghtsInstance& liggghts)
{
    LAMMPS_NS::Modify& modify = *liggghts->modify;

    for (label i = 0; i < modify.nfix; ++i)
    {
        if (!std::strcmp(modify.fix[i]->style, styleName))
        {
            return static_cast<clumpRemoval*>(modify.fix[i]);
        }
    }
    return nullptr;
}


LAMMPS_NS::FixMultisphere& Foam::clumpRemoval::bodies() const
{
    return *static_cast<LAMMPS_NS::FixMultisphere*>
    (
        modify->find_fix_style("multisphere", 0)
    );
}


int Foam::clumpRemoval::setmask()
{
    return LAMMPS_NS::FixConst::PRE_EXCHANGE;
}


bool Foam::clumpRemoval::isBeyond(const double* place) const
{
    for (label k = 0; k < 3; ++k)
    {
        const bool inside =
            domain->periodicity[k]
         || (place[k] >= domain->boxlo[k] && place[k] < domain->boxhi[k]);

        if (!inside)
        {
            return true;
        }
    }
    return false;
}


Foam::clumpRemoval::departures Foam::clumpRemoval::leaving() const
{
    departures result;
    LAMMPS_NS::FixMultisphere& all = bodies();
    LAMMPS_NS::Multisphere& data = all.data();
    const auto add = [&](const label clump, const double* x, const double* v)
    {
        if (isBeyond(x))
        {
            result.insert
            (
                clump,
                {vector(x[0], x[1], x[2]), vector(v[0], v[1], v[2])}
            );
        }
    };

    for (label i = 0; i < atom->nlocal; ++i)
    {
        if (all.belongs_to(i) > 0)
        {
            add(all.belongs_to(i), atom->x[i], atom->v[i]);
        }
    }

    // LIGGGHTS has a clump on the rank of the centre of its bounding sphere, and loses
    // it where no rank has that
    for (label i = 0; i < all.n_body(); ++i)
    {
        double centre[3], velocity[3];
        data.x_bound(centre, i);
        data.vcm(velocity, i);
        add(data.tag(i), centre, velocity);
    }

    return result;
}


void Foam::clumpRemoval::remove(const departures& all)
{
    LAMMPS_NS::FixMultisphere& multisphere = bodies();
    LAMMPS_NS::Multisphere& data = multisphere.data();

    label i = 0;
    while (i < atom->nlocal)
    {
        if (all.found(multisphere.belongs_to(i)))
        {
            atom->avec->copy(atom->nlocal - 1, i, 1);
            --atom->nlocal;
        }
        else
        {
            ++i;
        }
    }

    i = 0;
    while (i < data.n_body())
    {
        if (all.found(data.tag(i)))
        {
            data.remove_body(i);
        }
        else
        {
            ++i;
        }
    }
    data.calc_nbody_all();
    data.generate_map();
}


void Foam::clumpRemoval::pre_exchange()
{
    departures all(leaving());

    liggghtsErrors::runOutside([&]()
    {
        if (returnReduce(all.size(), sumOp<label>()))
        {
            // The same clump, seen on another rank
            const auto first = [](Pair<vector>&, const Pair<vector>&) {};
            Pstream::mapCombineGather(all, first);
            compatibility::broadcast(all);
        }
    });

    if (all.size())
    {
        remove(all);
        forAllConstIters(all, one)
        {
            departed_.set(one.key(), *one);
        }
    }
}
