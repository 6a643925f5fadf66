// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres that LIGGGHTS moves: what of each a sphere stands for.

#include "liggghtsClumps.H"

#include "clumpInsertion.H"
#include "clumpRemoval.H"
#include "clumpSums.H"
#include "clumpTemplate.H"
#include "fixStyles.H"
#include "fpeGuard.H"
#include "liggghtsErrors.H"
#include "liggghtsScript.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/domain.h>
#include <liggghts/fix_multisphere.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neighbor.h>
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
    addFixStyle<clumpInsertion>(lmp);
    addFixStyle<clumpRemoval>(lmp);
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
        restarted && liggghts_->modify->have_restart_data_style(clumpStyle)
     && !liggghts_->modify->have_restart_data(fix_)
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

    // As a run of LIGGGHTS begins. Fixes send to other ranks in their setup, in which
    // they forget all grains: what goes where must be known
    liggghts_->init();
    liggghts_->domain->pbc();
    liggghts_->domain->reset_box();
    liggghts_->comm->setup();
    liggghts_->neighbor->setup_bins();
    liggghts_->comm->exchange();
    liggghts_->comm->borders();
    modify.setup(0);

    // Those that wait for a later step do so
    const bigint firstStep = liggghts_->update->ntimestep + 1;
    for (label i = 0; i < modify.nfix; ++i)
    {
        LAMMPS_NS::Fix& fix = *modify.fix[i];

        if (isInsertion(fix) && fix.next_reneighbor == firstStep)
        {
            fix.setup(0);
            fix.next_reneighbor = liggghts_->update->ntimestep;
            fix.pre_exchange();
        }
    }
}


void Foam::liggghtsClumps::addRemoval(liggghtsInstance& liggghts) const
{
    if (fix_)
    {
        liggghts.command
        (
            "fix interDEMFoamClumpRemoval all " + string(clumpRemoval::styleName)
        );
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
    const bool stepForces,
    const fileName& physicsScript
)
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
    script_ = physicsScript;
    checkInsertedOnce();
    checkMovedOnce();
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


Foam::label Foam::liggghtsClumps::nBodies() const
{
    // LIGGGHTS breaks up a clump that has lost a sphere, and takes out the others a
    // few steps later
    const scalar* broken = fix_->fix_delflag()->vector_atom;
    label n = 0;

    forAll(clump_, i)
    {
        n += clump_[i] <= 0 && broken[i] == 0;
    }
    return returnReduce(n, sumOp<label>()) + n_;
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
    const label n = fix_->n_body_all();
    if (n > n_)
    {
        checkFree();
        checkMovedOnce();
    }
    n_ = n;
    setSpheres();
    shareForces(total, fluid, g);
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
