// SPDX-License-Identifier: GPL-3.0-or-later
// A LIGGGHTS fix that inserts clumps where a file has them.

#include "clumpInsertion.H"

#include "liggghtsErrors.H"
#include "PstreamReduceOps.H"
#include "error.H"

#include <algorithm>
#include <cstring>

#include <liggghts/atom.h>
#include <liggghts/domain.h>
#include <liggghts/error.h>
#include <liggghts/fix_multisphere.h>
#include <liggghts/fix_template_multisphere.h>
#include <liggghts/irregular.h>
#include <liggghts/modify.h>
#include <liggghts/particleToInsert_multisphere.h>
#include <liggghts/update.h>

const char* const Foam::clumpInsertion::styleName = "insert/clumps";


Foam::clumpInsertion::clumpInsertion
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg
)
:
    LAMMPS_NS::Fix(lmp, narg, arg),
    file_(narg == 5 && std::strcmp(arg[3], "file") == 0 ? arg[4] : ""),
    nInserted_(0)
{
    if (file_.empty())
    {
        error->all(FLERR, "fix insert/clumps needs: file, and its name");
    }
    if (!modify->find_fix_style("multisphere", 0))
    {
        error->all(FLERR, "fix insert/clumps needs a fix multisphere before it");
    }
    liggghtsErrors::runOutside([this]() { read(); });

    vector_flag = 1;
    size_vector = 1;
    force_reneighbor = 1;
    next_reneighbor = update->ntimestep + 1;
}


void Foam::clumpInsertion::read()
{
    clumps_ = readClumpTable(file_);
    LAMMPS_NS::FixTemplateMultisphere* last = nullptr;
    std::string name;

    for (const placedClump& clump : clumps_)
    {
        if (clump.kind != name)
        {
            name = clump.kind;
            last = findTemplate(name);
        }
        templates_.push_back(last);
    }
}


LAMMPS_NS::FixTemplateMultisphere* Foam::clumpInsertion::findTemplate
(
    const std::string& name
) const
{
    const int at = modify->find_fix(name.c_str());
    auto* result =
        at < 0
      ? nullptr
      : dynamic_cast<LAMMPS_NS::FixTemplateMultisphere*>(modify->fix[at]);

    if (!result)
    {
        FatalErrorInFunction
            << "The clumps of " << file_ << " need a template " << name.c_str()
            << ", but no fix particletemplate/multisphere above has this name." << nl
            << "    Write before fix " << id << ": include"
            << " constant/grains/clumpTemplates, which preparePacking writes."
            << exit(FatalError);
    }
    return result;
}


int Foam::clumpInsertion::setmask()
{
    return LAMMPS_NS::FixConst::PRE_EXCHANGE;
}


Foam::label Foam::clumpInsertion::lastSphere() const
{
    label last = 0;
    for (label i = 0; i < atom->nlocal; ++i)
    {
        last = max(last, label(atom->tag[i]));
    }
    return returnReduce(last, maxOp<label>());
}


void Foam::clumpInsertion::pre_exchange()
{
    if (next_reneighbor != update->ntimestep)
    {
        return;
    }
    next_reneighbor = 0;

    for (label i = 0; i < modify->nfix; ++i)
    {
        if (modify->fix[i]->create_attribute)
        {
            modify->fix[i]->pre_set_arrays();
        }
    }

    auto& bodies = *static_cast<LAMMPS_NS::FixMultisphere*>
    (
        modify->find_fix_style("multisphere", 0)
    );
    nInserted_ = insertMine(bodies);
    liggghtsErrors::runOutside([this]()
    {
        reduce(nInserted_, sumOp<label>());
        checkCount();
    });
    mapSpheres();
    bodies.add_body_finalize();

    // What is inserted needs no table; the kinds of clumps are still known
    clumps_.clearStorage();
    std::sort(templates_.begin(), templates_.end());
    templates_.erase(std::unique(templates_.begin(), templates_.end()), templates_.end());

    // A sphere may be on another rank than the centre: insertions to come look for it
    // there
    LAMMPS_NS::Irregular spheres(lmp);
    if (spheres.migrate_check())
    {
        spheres.migrate_atoms();
    }
}


Foam::label Foam::clumpInsertion::insertMine(LAMMPS_NS::FixMultisphere& bodies)
{
    label sphere = lastSphere() + 1;
    const label firstBody = bodies.tag_max_body() + 1;
    label n = 0;

    forAll(clumps_, k)
    {
        point centre(clumps_[k].centre);
        domain->remap(centre.data());

        if (domain->is_in_subdomain(centre.data()))
        {
            insertOne(bodies, k, sphere, firstBody + k);
            ++n;
        }
        sphere += templates_[k]->number_spheres();
    }
    return n;
}


void Foam::clumpInsertion::insertOne
(
    LAMMPS_NS::FixMultisphere& bodies,
    const label k,
    const label firstSphere,
    const label body
)
{
    templates_[k]->randomize_single();
    auto& clump =
        static_cast<LAMMPS_NS::ParticleToInsertMultisphere&>(*templates_[k]->pti);

    const quaternion& q = clumps_[k].orientation;
    double turned[4] = {q.w(), q.v().x(), q.v().y(), q.v().z()};
    double atRest[3] = {0, 0, 0};
    point centre(clumps_[k].centre);
    domain->remap(centre.data());

    clump.set_x_v_omega(centre.data(), atRest, atRest, turned);
    const label first = atom->nlocal;
    clump.insert();

    // LIGGGHTS would number them rank by rank
    typedef LAMMPS_NS::ScalarContainer<int> numbers;
    numbers& id = *bodies.data().prop().getElementProperty<numbers>("id_multisphere");
    id(bodies.n_body() - 1) = body;

    for (label i = 0; i < clump.nparticles; ++i)
    {
        atom->tag[first + i] = firstSphere + i;
        bodies.set_body_displace
        (
            first + i, clump.displace[i], body, clump.volumeweight[i]
        );
    }
}


void Foam::clumpInsertion::checkCount() const
{
    if (nInserted_ != clumps_.size())
    {
        const point low(domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]);
        const point high(domain->boxhi[0], domain->boxhi[1], domain->boxhi[2]);

        FatalErrorInFunction
            << clumps_.size() - nInserted_ << " of the " << clumps_.size()
            << " clumps of " << file_ << " have their centres outside of the grains'"
            << " box " << low << ' ' << high << " m." << nl
            << "    Make the region of create_box larger, or run preparePacking again"
            << " for this mesh." << exit(FatalError);
    }
}


void Foam::clumpInsertion::mapSpheres()
{
    for (const auto* each : templates_)
    {
        atom->natoms +=
            const_cast<LAMMPS_NS::FixTemplateMultisphere*>(each)->number_spheres();
    }
    if (atom->map_style)
    {
        atom->nghost = 0;
        atom->map_init();
        atom->map_set();
    }
}


double Foam::clumpInsertion::compute_vector(int)
{
    return nInserted_;
}


double Foam::clumpInsertion::min_rad(int type)
{
    double result = 0;
    for (auto* each : templates_)
    {
        if (each->mintype() == type)
        {
            const double r = each->min_rad();
            result = result > 0 ? std::min(result, r) : r;
        }
    }
    return result;
}


double Foam::clumpInsertion::max_rad(int type)
{
    double result = 0;
    for (auto* each : templates_)
    {
        if (each->maxtype() == type)
        {
            result = std::max(result, each->max_rad());
        }
    }
    return result;
}


int Foam::clumpInsertion::min_type()
{
    int result = 0;
    for (auto* each : templates_)
    {
        result = result > 0 ? std::min(result, each->mintype()) : each->mintype();
    }
    return result;
}


int Foam::clumpInsertion::max_type()
{
    int result = 0;
    for (auto* each : templates_)
    {
        result = std::max(result, each->maxtype());
    }
    return result;
}


double Foam::clumpInsertion::extend_cut_ghost()
{
    double result = 0;
    for (auto* each : templates_)
    {
        result = std::max(result, 2*each->max_r_bound());
    }
    return result;
}
