// SPDX-License-Identifier: GPL-3.0-or-later
// Grains computed by LIGGGHTS in this program: making them and moving them.

#include "liggghtsPhase.H"

#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#include "fixFluidForce.H"
#include "keywords.H"
#include "liggghtsArrays.H"
#include "liggghtsChecks.H"

#include <liggghts/atom.h>
#include <liggghts/fix.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neighbor.h>
#include <liggghts/update.h>

namespace Foam
{
    defineTypeName(liggghtsPhase);
    addToRunTimeSelectionTable(granularPhase, liggghtsPhase, dictionary);
}


namespace
{

using namespace Foam;

//- Path of a script named in the dictionary; an error where it is absent
fileName script
(
    const fvMesh& mesh,
    const dictionary& dict,
    const word& key
)
{
    const fileName root(mesh.time().globalPath());
    fileName path("constant/grains/" + key);

    // In constant itself OpenFOAM's postProcess misses a header in it
    if (!isFile(root/path) && isFile(root/"constant/grains." + key))
    {
        path = "constant/grains." + key;
    }
    path = dict.getOrDefault<fileName>(key, path);
    path.expand();

    if (!path.isAbsolute())
    {
        path = root/path;
    }

    if (!isFile(path))
    {
        FatalIOErrorInFunction(dict)
            << "No LIGGGHTS script " << path << nl
            << "    Write it, or name another with the keyword " << key
            << " in this dictionary." << exit(FatalIOError);
    }

    return path;
}


//- Fatal unless the share is from 0 to below 1
scalar readLocalDamping(const dictionary& dict)
{
    const scalar share = dict.getOrDefault<scalar>("localDamping", 0);

    if (!(share >= 0 && share < 1))
    {
        FatalIOErrorInFunction(dict)
            << "localDamping is " << share << nl
            << "    It is the share of the force on a grain that acts against its"
            << " motion: from 0 (none) to below 1; PFC has 0.7."
            << exit(FatalIOError);
    }

    return share;
}

} // End anonymous namespace


Foam::liggghtsPhase::liggghtsPhase
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g,
    const label stepsPerExchange,
    const stepForce& eachStep
)
:
    granularPhase(mesh, dict, stepsPerExchange),
    dict_
    (
        keywords::sub
        (
            dict,
            typeName,
            {
                "initial", "physics", "contacts", "localDamping", "variables",
                "walls", "outflow"
            }
        )
    ),
    g_(g),
    localDamping_(readLocalDamping(dict_)),
    initialScript_(script(mesh, dict_, "initial")),
    physicsScript_(script(mesh, dict_, "physics")),
    liggghts_(mesh.time().globalPath()/"log.liggghts"),
    clumps_(liggghts_),
    outlet_
    (
        *this,
        mesh,
        liggghts_,
        keywords::patterns(dict_, "outflow", mesh.boundaryMesh().names())
    ),
    walls_(mesh, keywords::sub(dict_, "walls"), physicsScript_),
    fluid_(nullptr),
    damping_(nullptr),
    eachStep_(eachStep),
    restarted_(false),
    movingGroups_(0)
{
    Info<< "Grains: LIGGGHTS" << endl;

    chooseContacts();
    setVariables();
    createGrains();
    clumps_.find(restarted_, initialScript_);
    liggghtsChecks::checkUnits(liggghts_, initialScript_);
    liggghtsChecks::checkSizes(liggghts_, initialScript_);
    liggghtsChecks::checkDomain(liggghts_, mesh, initialScript_);
    walls_.enlargeBox(liggghts_);
    liggghts_.chooseSkin();

    liggghts_.script(physicsScript_, mesh.time().globalPath());
    addCouplingFixes();
    clumps_.check
    (
        localDamping_, coarseGraining_, bool(eachStep_), physicsScript_
    );
    liggghtsChecks::checkTimeStep(liggghts_, physicsScript_);

    liggghts_.setup();
    last_.restore();
    clumps_.sumForces();
    if (!restarted_)
    {
        liggghtsChecks::checkOverlaps(liggghts_, initialScript_);
    }
    refresh();
    outlet_.begin();

    report();
}


void Foam::liggghtsPhase::report() const
{
    // As an obstacle should, or as where the fix was forgotten
    if (!movingGroups_ && !hasClumps())
    {
        Info<< "    grains stand still: no fix of " << physicsScript_
            << " moves them, as nve/sphere would" << endl;
    }

    Info<< "    " << nTotal() << " grains, step " << timeStep()
        << " s, exchange every " << stepsPerExchange() << " steps = "
        << exchangeInterval() << " s" << nl;

    if (clumps_.n())
    {
        Info<< "    " << clumps_.nSpheres() << " of them are the spheres of "
            << clumps_.n() << " clumps" << nl;
    }

    const std::string stock(liggghts_.whyContactsAreStock());
    const std::string contacts
    (
        stock.empty() ? "vectorised" : "by LIGGGHTS's own loop: " + stock
    );
    Info<< "    contacts " << contacts.c_str() << "; plane walls vectorised: "
        << liggghts_.nVectorisedWalls() << nl << "    neighbours "
        << (liggghts_.hasNeighbourLists() ? "by size class" : "by LIGGGHTS's own bins")
        << ", skin at most " << liggghts_->neighbor->skin << " m" << nl << endl;
}


Foam::dictionary Foam::liggghtsPhase::activePhysics() const
{
    dictionary result(granularPhase::activePhysics());
    result.add("contactModel", walls_.contactModel());
    result.add("localDamping", localDamping_);
    result.add("variables", variables());

    return result;
}


void Foam::liggghtsPhase::refresh()
{
    LAMMPS_NS::Atom& atom = *liggghts_->atom;
    const label n = atom.nlocal;

    position_.shallowCopy(vectors(atom.x, n));
    velocity_.shallowCopy(vectors(atom.v, n));
    angularVelocity_.shallowCopy(vectors(atom.omega, n));
    totalForce_.shallowCopy(vectors(atom.f, n));
    fluidForce_.shallowCopy(vectors(fluid_->force(), n));
    fluidTorque_.shallowCopy(vectors(fluid_->torque(), n));
    radius_.shallowCopy(UList<scalar>(atom.radius, n));
    mass_.shallowCopy(UList<scalar>(atom.rmass, n));
    id_.shallowCopy(UList<label>(atom.tag, n));
    type_.shallowCopy(UList<label>(atom.type, n));

    if (clumps_.any())
    {
        clumps_.refresh(totalForce_, fluidForce_, g_);
        clump_.shallowCopy(clumps_.clump());
        share_.shallowCopy(clumps_.share());
        clumpRadius_.shallowCopy(clumps_.radius());
        mass_.shallowCopy(clumps_.mass());
    }

    movingGroups_ = 0;
    for (label i = 0; i < liggghts_->modify->nfix; ++i)
    {
        const LAMMPS_NS::Fix& fix = *liggghts_->modify->fix[i];

        movingGroups_ |= fix.time_integrate ? fix.groupbit : 0;
    }
}


bool Foam::liggghtsPhase::mobile(const label i) const
{
    return
        (liggghts_->atom->mask[i] & movingGroups_)
     || (clump_.size() && clump_[i]);
}


Foam::label Foam::liggghtsPhase::nBodies() const
{
    return hasClumps() ? clumps_.nBodies() : nTotal();
}


Foam::scalar Foam::liggghtsPhase::timeStep() const
{
    return liggghts_->update->dt;
}


Foam::label Foam::liggghtsPhase::nTypes() const
{
    return liggghts_->atom->ntypes;
}


void Foam::liggghtsPhase::setFluidForce
(
    const UList<vector>& force,
    const UList<vector>& torque
)
{
    UList<vector> total(totalForce_);
    UList<vector> totalTorque(vectors(liggghts_->atom->torque, size()));

    // The first half of the next step uses the force of the last one: change
    // that too, so that the impulse is force times interval exactly
    forAll(force, i)
    {
        total[i] += force[i] - fluidForce_[i];
        totalTorque[i] += torque[i] - fluidTorque_[i];
        fluidForce_[i] = force[i];
        fluidTorque_[i] = torque[i];
    }
    clumps_.sumForces();
}


Foam::labelList Foam::liggghtsPhase::beyond(const label lastId) const
{
    DynamicList<label> result;

    forAll(id_, i)
    {
        if (id_[i] > lastId)
        {
            result.append(i);
        }
    }

    return labelList(std::move(result));
}


void Foam::liggghtsPhase::takeSteps(const entryHandler& onEntry)
{
    outlet_.note();

    label left = stepsPerExchange();
    while (onEntry && outlet_.nStepsToInsertion() < left)
    {
        // LIGGGHTS counts on from the largest
        label lastId = 0;
        for (const label id : id_)
        {
            lastId = max(lastId, id);
        }
        reduce(lastId, maxOp<label>());

        const label n = outlet_.nStepsToInsertion();
        liggghts_.run(n);
        left -= n;

        refresh();
        onEntry(beyond(lastId));
    }
    liggghts_.run(left);

    refresh();
    outlet_.count();
}


bool Foam::liggghtsPhase::isOutlet(const polyPatch& patch) const
{
    return
        keywords::patterns(dict_, "outflow", mesh_.boundaryMesh().names())
       .match(patch.name());
}
