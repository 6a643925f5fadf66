// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres that LIGGGHTS moves: what of each a sphere stands for.

#include "liggghtsClumps.H"

#include "clumpSums.H"
#include "clumpTemplate.H"
#include "fixStyles.H"
#include "fpeGuard.H"
#include "liggghtsErrors.H"
#include "liggghtsScript.H"
#include "OStringStream.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/domain.h>
#include <liggghts/fix_multisphere.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/update.h>

namespace
{
    const char* const clumpStyle = "multisphere";

    bool isInsertion(const LAMMPS_NS::Fix& fix)
    {
        return Foam::string(fix.style).substr(0, 7) == "insert/";
    }
}


Foam::liggghtsClumps::liggghtsClumps(const liggghtsInstance& liggghts)
:
    liggghts_(liggghts),
    fix_(nullptr),
    weights_(nullptr),
    n_(0)
{}


void Foam::liggghtsClumps::addStyle(LAMMPS_NS::LAMMPS* lmp)
{
    addFixStyle<clumpTemplate>(lmp);
}


Foam::DynamicList<std::string> Foam::liggghtsClumps::commands
(
    const fileName& initialScript
)
{
    DynamicList<std::string> result;

    for (const std::string& line : liggghtsScript::commands(initialScript, "fix"))
    {
        std::istringstream words(line);
        std::string fix, id, group, style;

        if (words >> fix >> id >> group >> style && style == clumpStyle)
        {
            result.append(line);
        }
    }

    return result;
}


void Foam::liggghtsClumps::find(const bool restarted, const fileName& script)
{
    LAMMPS_NS::Modify& modify = *liggghts_->modify;

    fix_ = dynamic_cast<LAMMPS_NS::FixMultisphere*>
    (
        modify.find_fix_style(clumpStyle, 0)
    );
    if (fix_)
    {
        if (!restarted)
        {
            insert();
        }
        n_ = fix_->n_body_all();
        checkFound(restarted, script);
        weights_ = const_cast<LAMMPS_NS::FixPropertyAtom*>(fix_->get_volumeweight());
    }
}


void Foam::liggghtsClumps::checkFound
(
    const bool restarted,
    const fileName& script
) const
{
    // By the name of its fix: LIGGGHTS leaves spheres alone where that is another
    if
    (
        restarted && n_ == 0
     && liggghts_->modify->have_restart_data_style(clumpStyle)
    )
    {
        refuse
        (
            "those of the written state do not belong to it.",
            "Keep the line 'fix ID group multisphere' of the first run in "
          + string(script) + " itself."
        );
    }

    for (const std::string& line : commands(script))
    {
        if (line.find("CAddRhoFluid") != std::string::npos)
        {
            refuse
            (
                "'CAddRhoFluid', a mass that they carry along in LIGGGHTS.",
                "Take it out, and name interphaseForces/virtualMass in"
                " constant/granularProperties."
            );
        }
    }
}


void Foam::liggghtsClumps::insert()
{
    const fpeGuard guard;
    const liggghtsErrors::activity now
    (
        "inserting clumps",
        "Correct the insertion in the initial script."
    );

    LAMMPS_NS::Modify& modify = *liggghts_->modify;

    liggghts_->init();
    liggghts_->domain->pbc();
    liggghts_->comm->setup();
    // Fixes forget all grains in their first setup
    modify.setup(0);

    for (label i = 0; i < modify.nfix; ++i)
    {
        LAMMPS_NS::Fix& fix = *modify.fix[i];

        if (isInsertion(fix) && fix.next_reneighbor > 0)
        {
            fix.setup(0);
            fix.next_reneighbor = liggghts_->update->ntimestep;
            fix.pre_exchange();
        }
    }
}


void Foam::liggghtsClumps::refuse(const string& what, const string& remedy) const
{
    FatalErrorInFunction
        << "There are clumps of spheres (fix " << fix_->id << " of style "
        << fix_->style << ") and " << what.c_str() << nl << "    "
        << remedy.c_str() << exit(FatalError);
}


void Foam::liggghtsClumps::check
(
    const scalar localDamping,
    const scalar coarseGraining,
    const bool outflow,
    const bool stepForces,
    const fileName& physicsScript
) const
{
    checkNoOthers();
    if (!fix_)
    {
        return;
    }

    if (localDamping > 0)
    {
        refuse
        (
            "localDamping, which is written for single grains.",
            "Take LIGGGHTS/localDamping out of constant/granularProperties."
        );
    }
    if (coarseGraining != 1)
    {
        refuse
        (
            "coarseGraining, which is written for single grains.",
            "Take coarseGraining out of constant/granularProperties."
        );
    }
    if (outflow)
    {
        refuse
        (
            "an outflow: a clump would leave sphere by sphere.",
            "Take LIGGGHTS/outflow out of constant/granularProperties."
        );
    }
    if (stepForces)
    {
        refuse
        (
            "material points, whose contacts are written for single grains.",
            "Take granularPhase LIGGGHTS, or grains that are spheres."
        );
    }
    checkRoom();
    checkFree();
    checkNoInsertion();
    checkMovedOnce(physicsScript);
}


void Foam::liggghtsClumps::checkNoOthers() const
{
    const LAMMPS_NS::Modify& modify = *liggghts_->modify;

    for (label i = 0; i < modify.nfix; ++i)
    {
        const LAMMPS_NS::Fix* fix = modify.fix[i];
        const string style(fix->style);
        const bool isRigid =
            style.substr(0, 5) == "rigid"
         || dynamic_cast<const LAMMPS_NS::FixMultisphere*>(fix);

        if (isRigid && (fix != fix_ || style != clumpStyle))
        {
            FatalErrorInFunction
                << "Fix " << fix->id << " of style " << style.c_str()
                << " makes rigid bodies of which the fluid would know nothing." << nl
                << "    Clumps are made by one 'fix multisphere' in the initial script,"
                << " and templates and insertions behind it." << exit(FatalError);
        }
    }
}


void Foam::liggghtsClumps::checkRoom() const
{
    // LIGGGHTS tells images and ranks of a clump apart by the nearest one
    const LAMMPS_NS::Domain& domain = *liggghts_->domain;
    const scalar size = 2*fix_->max_r_bound();

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


void Foam::liggghtsClumps::checkNoInsertion() const
{
    const LAMMPS_NS::Modify& modify = *liggghts_->modify;

    for (label i = 0; i < modify.nfix; ++i)
    {
        const LAMMPS_NS::Fix& fix = *modify.fix[i];

        if
        (
            isInsertion(fix)
         && fix.next_reneighbor > liggghts_->update->ntimestep
        )
        {
            refuse
            (
                "fix " + string(fix.id) + " is to insert grains while the run goes on.",
                "Insert all grains in the initial script, with 'insert_every once'."
            );
        }
    }
}


void Foam::liggghtsClumps::checkMovedOnce(const fileName& script) const
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
        if (returnReduce(moves, orOp<bool>()))
        {
            refuse
            (
                "fix " + string(fix.id) + " (" + string(fix.style) + ") of "
              + string(script) + " moves their spheres, too.",
                "fix multisphere moves clumps: take that fix out, or give it a group"
                " of the other grains alone."
            );
        }
    }
}


Foam::label Foam::liggghtsClumps::clumpOf(const label i) const
{
    return fix_ ? max(fix_->belongs_to(i), 0) : 0;
}


Foam::label Foam::liggghtsClumps::nSpheres() const
{
    label n = 0;
    for (const label clump : clump_)
    {
        n += clump > 0;
    }
    return returnReduce(n, sumOp<label>());
}


void Foam::liggghtsClumps::setSpheres()
{
    const LAMMPS_NS::Atom& atom = *liggghts_->atom;
    const label n = atom.nlocal;

    clump_.setSize(n);
    share_.setSize(n);
    radius_.setSize(n);
    mass_.setSize(n);

    for (label i = 0; i < n; ++i)
    {
        clump_[i] = clumpOf(i);

        if (clump_[i])
        {
            const scalar volume = atom.rmass[i]/atom.density[i];
            share_[i] = weights_->vector_atom[i];
            radius_[i] = cbrt(3*volume/(4*constant::mathematical::pi));
            mass_[i] = share_[i]*atom.rmass[i];
        }
        else
        {
            share_[i] = 1;
            radius_[i] = atom.radius[i];
            mass_[i] = atom.rmass[i];
        }
    }
}


void Foam::liggghtsClumps::shareForces
(
    const UList<vector>& total,
    const UList<vector>& fluid,
    const vector& g
)
{
    totalForce_ = total;
    fluidForce_ = fluid;

    const Map<Pair<vector>> sums(clumpSums(clump_).sum(total, fluid));

    forAll(clump_, i)
    {
        if (clump_[i])
        {
            // LIGGGHTS adds gravity to the clump, not to its spheres
            const Pair<vector>& sum = sums[clump_[i]];
            totalForce_[i] = share_[i]*sum.first() + mass_[i]*g;
            fluidForce_[i] = share_[i]*sum.second();
        }
    }
}


void Foam::liggghtsClumps::refresh
(
    const UList<vector>& total,
    const UList<vector>& fluid,
    const vector& g
)
{
    if (any())
    {
        n_ = fix_->n_body_all();
        setSpheres();
        shareForces(total, fluid, g);
    }
}


void Foam::liggghtsClumps::sumForces() const
{
    if (any())
    {
        const fpeGuard guard;

        fix_->data().reset_forces(false);
        fix_->comm_correct_force(false);
        fix_->calc_force(false);
    }
}
