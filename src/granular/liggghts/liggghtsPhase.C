// SPDX-License-Identifier: GPL-3.0-or-later
// Grains computed by LIGGGHTS in this program: making them and moving them.

#include "liggghtsPhase.H"

#include "IFstream.H"
#include "OStringStream.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#include "fixFluidForce.H"
#include "fixLocalDamping.H"
#include "fixStepForce.H"
#include "fixStyles.H"
#include "foamCompatibility.H"
#include "keywords.H"
#include "liggghtsArrays.H"
#include "liggghtsChecks.H"

#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/fix.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/universe.h>
#include <liggghts/update.h>

namespace Foam
{
    defineTypeName(liggghtsPhase);
    addToRunTimeSelectionTable(granularPhase, liggghtsPhase, dictionary);
}


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
    outflow_
    (
        keywords::patterns(dict_, "outflow", mesh.boundaryMesh().names())
    ),
    openings_(openings()),
    images_(mesh),
    liggghts_(mesh.time().globalPath()/"log.liggghts"),
    walls_(mesh, keywords::sub(dict_, "walls"), physicsScript_),
    fluid_(nullptr),
    damping_(nullptr),
    eachStep_(eachStep),
    restarted_(false),
    nGrains_(0),
    nInserted_(0),
    nEntered_(0),
    nLeft_(0),
    warnedOfVanished_(false),
    movingGroups_(0)
{
    Info<< "Grains: LIGGGHTS" << endl;

    chooseContacts();
    setVariables();
    createGrains();
    liggghtsChecks::units(liggghts_, initialScript_);
    liggghtsChecks::domain(liggghts_, mesh, initialScript_);
    walls_.makeRoom(liggghts_);

    liggghts_.script(physicsScript_, mesh.time().globalPath());
    addOwnFixes();
    liggghtsChecks::timeStep(liggghts_, physicsScript_);

    liggghts_.setup();
    refresh();
    tellIfStill();

    nGrains_ = nTotal();
    nInserted_ = nInserted();

    Info<< "    " << nGrains_ << " grains, step " << timeStep()
        << " s, exchange every " << stepsPerExchange << " steps = "
        << exchangeInterval() << " s" << nl;

    const std::string stock(liggghts_.whyContactsAreStock());
    const std::string contacts
    (
        stock.empty() ? "vectorised" : "by LIGGGHTS's own loop: " + stock
    );
    Info<< "    contacts " << contacts.c_str() << nl << endl;
}


Foam::fileName Foam::liggghtsPhase::script
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
    path = dict.lookupOrDefault<fileName>(key, path);
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


Foam::scalar Foam::liggghtsPhase::readLocalDamping(const dictionary& dict)
{
    const scalar share = dict.lookupOrDefault<scalar>("localDamping", 0);

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


Foam::labelVector Foam::liggghtsPhase::cuts() const
{
    labelVector n(Zero);

    if (!Pstream::parRun())
    {
        return labelVector(1, 1, 1);
    }

    const fileName path
    (
        mesh_.time().globalPath()/mesh_.time().system()/"decomposeParDict"
    );

    if (isFile(path))
    {
        const dictionary dict{IFstream(path)()};
        const word method(dict.lookupOrDefault<word>("method", "none"));
        const dictionary& coeffs = dict.optionalSubDict
        (
            dict.found(method + "Coeffs") ? method + "Coeffs" : word("coeffs")
        );

        if (coeffs.found("n"))
        {
            const Vector<label> cut(coeffs.lookup("n"));

            if (cut.x()*cut.y()*cut.z() == Pstream::nProcs())
            {
                n = labelVector(cut.x(), cut.y(), cut.z());
            }
        }
    }

    return n;
}


void Foam::liggghtsPhase::chooseContacts()
{
    const word contacts
    (
        keywords::choice
        (
            dict_,
            "contacts",
            "way to compute contacts",
            {"vectorised", "stock"},
            "vectorised"
        )
    );

    if
    (
        contacts == "vectorised" && !liggghts_.vectoriseContacts()
     && dict_.found("contacts")
    )
    {
        FatalIOErrorInFunction(dict_)
            << "Vectorised contacts are those of LIGGGHTS 3.8, but this is "
            << liggghts_->universe->version << nl
            << "    Write: contacts stock;" << exit(FatalIOError);
    }
}


void Foam::liggghtsPhase::createGrains()
{
    addFixStyle<fixFluidForce>(&*liggghts_);
    addFixStyle<fixLocalDamping>(&*liggghts_);
    addFixStyle<fixStepForce>(&*liggghts_);

    // Contacts with history need it, and a written state does not keep it
    liggghts_.command("newton off");

    const string boundary(liggghtsWalls::boundary(mesh_));
    liggghts_.command("boundary " + boundary);

    const labelVector cut(cuts());
    if (cut.x())
    {
        std::ostringstream os;
        // OpenFOAM numbers its parts with x as the fastest
        os  << "processors " << cut.x() << ' ' << cut.y() << ' ' << cut.z()
            << " map xyz";
        liggghts_.command(os.str());
    }

    // That of the first rank, wherever the file handler keeps it
    fileName state
    (
        fileHandler().filePath(mesh_.time().timePath()/stateFolder/"state")
    );
    compatibility::broadcast(state);

    if (state.size())
    {
        readState(state);
    }
    else
    {
        checkNoStateLost(initialScript_);
        liggghts_.script(initialScript_, mesh_.time().globalPath());
    }

    liggghtsChecks::boundary(liggghts_, boundary, initialScript_);
}


Foam::dictionary Foam::liggghtsPhase::variables() const
{
    dictionary result(dict_.subOrEmptyDict("variables"));

    // The header of a file that was included
    result.remove("FoamFile");

    return result;
}


void Foam::liggghtsPhase::setVariables()
{
    const dictionary all(variables());

    for (const entry& variable : all)
    {
        if (variable.isDict() || variable.stream().size() != 1)
        {
            FatalIOErrorInFunction(all)
                << "A variable of the LIGGGHTS scripts is a name and one number"
                << " or word, but " << variable.keyword() << " is not." << nl
                << "    Write for instance: rollingFriction 0.1;"
                << exit(FatalIOError);
        }

        OStringStream value;
        value.precision(17);
        value << variable.stream()[0];
        liggghts_.command
        (
            "variable " + variable.keyword() + " index " + value.str()
        );
    }
}


Foam::dictionary Foam::liggghtsPhase::activePhysics() const
{
    dictionary result(granularPhase::activePhysics());
    result.add("contactModel", walls_.contactModel());
    result.add("localDamping", localDamping_);
    result.add("variables", variables());

    return result;
}


void Foam::liggghtsPhase::addOwnFixes()
{
    liggghtsChecks::noOwnFixes(liggghts_, physicsScript_);

    if (mag(g_) > SMALL)
    {
        std::ostringstream os;
        os.precision(17);
        os  << "fix interDEMFoamGravity all gravity " << mag(g_) << " vector "
            << g_.x()/mag(g_) << ' ' << g_.y()/mag(g_) << ' ' << g_.z()/mag(g_);
        liggghts_.command(os.str());
    }

    walls_.add(liggghts_);

    // Evaluated only where a snapshot asks for it
    liggghts_.command
    (
        "compute interDEMFoamContacts all pair/gran/local pos id force"
    );

    liggghts_.command
    (
        "fix interDEMFoamFluid all " + string(fixFluidForce::styleName)
    );

    LAMMPS_NS::Modify& modify = *liggghts_->modify;
    fluid_ = dynamic_cast<fixFluidForce*>
    (
        modify.fix[modify.find_fix("interDEMFoamFluid")]
    );

    if (eachStep_)
    {
        liggghts_.command
        (
            "fix interDEMFoamStep all " + string(fixStepForce::styleName)
        );
        dynamic_cast<fixStepForce&>
        (
            *modify.fix[modify.find_fix("interDEMFoamStep")]
        ).set(eachStep_);
    }

    // Behind all other forces, since it takes a share of their sum
    if (localDamping_ > 0)
    {
        std::ostringstream os;
        os.precision(17);
        os  << "fix interDEMFoamDamping all " << fixLocalDamping::styleName
            << ' ' << localDamping_;
        liggghts_.command(os.str());
        damping_ = dynamic_cast<fixLocalDamping*>
        (
            modify.fix[modify.find_fix("interDEMFoamDamping")]
        );
    }
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

    movingGroups_ = 0;
    for (label i = 0; i < liggghts_->modify->nfix; ++i)
    {
        const LAMMPS_NS::Fix& fix = *liggghts_->modify->fix[i];

        movingGroups_ |= fix.time_integrate ? fix.groupbit : 0;
    }
}


void Foam::liggghtsPhase::tellIfStill() const
{
    // As an obstacle should, or as where the fix was forgotten
    if (!movingGroups_)
    {
        Info<< "    grains stand still: no fix of " << physicsScript_
            << " moves them, as nve/sphere would" << endl;
    }
}


bool Foam::liggghtsPhase::mobile(const label i) const
{
    return liggghts_->atom->mask[i] & movingGroups_;
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
}


void Foam::liggghtsPhase::advance()
{
    before_.note(id_, position_, velocity_);
    liggghts_.run(stepsPerExchange());

    refresh();
    countGrains();
}
