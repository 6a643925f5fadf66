// SPDX-License-Identifier: GPL-3.0-or-later
// Grains computed by LIGGGHTS in this program: the commands for it at the start.

#include "liggghtsPhase.H"

#include "IFstream.H"
#include "OStringStream.H"
#include "Time.H"
#include "fixFluidForce.H"
#include "fixLocalDamping.H"
#include "fixStepForce.H"
#include "fixStyles.H"
#include "foamCompatibility.H"
#include "keywords.H"
#include "labelVector.H"
#include "liggghtsChecks.H"

#include <sstream>

#include <liggghts/fix.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/universe.h>

namespace
{

using namespace Foam;

//- Ranks in x, y, z as decomposePar cut the mesh, so that grains and their cells
//  are on the same rank; 0 0 0 where that is not known
labelVector cuts(const Time& runTime)
{
    labelVector n(Zero);

    if (!Pstream::parRun())
    {
        return labelVector(1, 1, 1);
    }

    const fileName path
    (
        runTime.globalPath()/runTime.system()/"decomposeParDict"
    );

    if (isFile(path))
    {
        const dictionary dict{IFstream(path)()};
        const word method(dict.getOrDefault<word>("method", "none"));
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

} // End anonymous namespace


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
        contacts == "vectorised"
     && !(liggghts_.vectoriseContacts() && liggghts_.useNeighbourLists())
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
    liggghtsClumps::addStyle(&*liggghts_);

    // Contacts with history need it, and a written state does not keep it
    liggghts_.command("newton off");

    const string boundary(liggghtsWalls::boundary(mesh_));
    liggghts_.command("boundary " + boundary);

    const labelVector cut(cuts(mesh_.time()));
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

    liggghtsChecks::checkBoundary(liggghts_, boundary, initialScript_);
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


void Foam::liggghtsPhase::addCouplingFixes()
{
    liggghtsChecks::checkNoConflictingFixes(liggghts_, physicsScript_);

    if (mag(g_) > SMALL)
    {
        std::ostringstream os;
        os.precision(17);
        os  << "fix interDEMFoamGravity all gravity " << mag(g_) << " vector "
            << g_.x()/mag(g_) << ' ' << g_.y()/mag(g_) << ' ' << g_.z()/mag(g_);
        liggghts_.command(os.str());
    }

    walls_.add(liggghts_);

    // Evaluated only where a snapshot needs it
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

    last_.add(liggghts_);
    clumps_.addRemoval(liggghts_);

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
