// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres that LIGGGHTS moves: whether they have room and are free to move.

#include "liggghtsClumps.H"

#include "OStringStream.H"
#include "clumpInsertion.H"

#include <liggghts/atom.h>
#include <liggghts/domain.h>
#include <liggghts/fix_multisphere.h>
#include <liggghts/fix_template_multisphere.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>


Foam::DynamicList<LAMMPS_NS::FixTemplateMultisphere*>
Foam::liggghtsClumps::templates() const
{
    const LAMMPS_NS::Modify& modify = *liggghts_->modify;
    DynamicList<LAMMPS_NS::FixTemplateMultisphere*> result;

    for (label i = 0; i < modify.nfix; ++i)
    {
        auto* clump = dynamic_cast<LAMMPS_NS::FixTemplateMultisphere*>(modify.fix[i]);
        if (clump)
        {
            result.append(clump);
        }
    }
    return result;
}


void Foam::liggghtsClumps::checkRoom() const
{
    // LIGGGHTS distinguishes images and ranks of a clump by the nearest one
    const LAMMPS_NS::Domain& domain = *liggghts_->domain;
    scalar size = 2*fix_->max_r_bound();
    for (LAMMPS_NS::FixTemplateMultisphere* clump : templates())
    {
        size = max(size, scalar(2*clump->max_r_bound()));
    }

    for (direction k = 0; k < 3; ++k)
    {
        OStringStream what;
        if (domain.periodicity[k] && domain.prd[k] < 2*size)
        {
            what<< "sides that repeat after " << domain.prd[k] << " m along "
                << "xyz"[k] << ", less than twice the size of the largest, " << size
                << " m.";
            refuse
            (
                what.str(),
                "Make the mesh wider there, or give it walls in place of cyclic or"
                " empty patches."
            );
        }

        const scalar width = returnReduce
        (
            scalar(domain.subhi[k] - domain.sublo[k]), minOp<scalar>()
        );
        if (width < size && Pstream::parRun())
        {
            what<< "ranks that are only " << width << " m wide along " << "xyz"[k]
                << ", less than the largest of them, " << size << " m.";
            refuse(what.str(), "Take fewer ranks, or cut the mesh another way.");
        }
    }
}


void Foam::liggghtsClumps::checkFree() const
{
    typedef LAMMPS_NS::VectorContainer<bool, 3> flags;
    bool held = false;

    for (const char* name : {"fflag", "tflag"})
    {
        const flags& free =
            *fix_->data().prop().getElementProperty<flags>(name);

        for (label i = 0; i < fix_->n_body(); ++i)
        {
            for (label k = 0; k < 3; ++k)
            {
                held = held || !free(i)[k];
            }
        }
    }

    if (returnReduce(held, orOp<bool>()))
    {
        refuse
        (
            "'fflag off' or 'tflag off' holds some of them in a direction.",
            "Take it out of the scripts; make an obstacle of grains that no fix moves."
        );
    }
}


void Foam::liggghtsClumps::checkInsertedOnce() const
{
    const LAMMPS_NS::Modify& modify = *liggghts_->modify;

    for (label k = 0; k < modify.nfix; ++k)
    {
        const LAMMPS_NS::Fix& fix = *modify.fix[k];

        // Those of the initial script are done
        if (string(fix.style) == clumpInsertion::styleName && fix.next_reneighbor > 0)
        {
            refuse
            (
                "fix " + string(fix.id) + " (" + string(fix.style) + ") of "
              + string(script_) + " would insert them again at each restart.",
                "Move it to the initial script, behind the templates."
            );
        }
    }
}


void Foam::liggghtsClumps::checkMovedOnce() const
{
    const LAMMPS_NS::Modify& modify = *liggghts_->modify;
    const LAMMPS_NS::Atom& atom = *liggghts_->atom;

    for (label k = 0; k < modify.nfix; ++k)
    {
        const LAMMPS_NS::Fix& fix = *modify.fix[k];
        bool moves = false;

        for (label i = 0; fix.time_integrate && i < atom.nlocal; ++i)
        {
            moves = moves || (clumpOf(i) && (atom.mask[i] & fix.groupbit));
        }
        for (const LAMMPS_NS::FixTemplateMultisphere* clump : templates())
        {
            // 1 is the group all, of each grain
            const int groups = 1 | clump->groupbit;
            moves = moves || (fix.time_integrate && (groups & fix.groupbit));
        }
        if (returnReduce(moves, orOp<bool>()))
        {
            refuse
            (
                "fix " + string(fix.id) + " (" + string(fix.style) + ") of "
              + string(script_) + " moves their spheres, too.",
                "fix multisphere moves clumps: take that fix out, or give it a group"
                " of the other grains alone."
            );
        }
    }
}
