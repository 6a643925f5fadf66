// SPDX-License-Identifier: GPL-3.0-or-later
// Grains computed by LIGGGHTS: snapshots, writing and reading.

#include "liggghtsPhase.H"

#include "Map.H"
#include "OSspecific.H"
#include "clumpSums.H"
#include "fixLocalDamping.H"
#include "foamCompatibility.H"
#include "grainSnapshot.H"
#include "fpeGuard.H"
#include "liggghtsScript.H"
#include "periodicity.H"

#include <fstream>

#include <liggghts/atom.h>
#include <liggghts/atom_vec.h>
#include <liggghts/fix.h>
#include <liggghts/domain.h>
#include <liggghts/fix_contact_property_atom_wall.h>
#include <liggghts/fix_mesh_surface.h>
#include <liggghts/lammps.h>
#include <liggghts/library.h>
#include <liggghts/modify.h>
#include <liggghts/compute.h>
#include <liggghts/update.h>

namespace
{
    using namespace Foam;

    //- Name of our list of contacts in LIGGGHTS
    const char* const contactList = "interDEMFoamContacts";

    //- Its columns: positions of both, ids of both, periodic, force on first
    enum { FIRST = 0, SECOND = 3, FIRST_ID = 6, SECOND_ID = 7, FORCE = 9 };

    //- True where a restart file ends with n numbers and their count, as
    //  LIGGGHTS writes them: it does not look whether the disk took them
    bool endsWith(const std::string& path, const int n)
    {
        std::ifstream is(path, std::ios::binary | std::ios::ate);
        const std::streamoff tail = n*sizeof(double) + sizeof(int);

        if (!is || is.tellg() < tail)
        {
            return false;
        }

        int count = -1;
        is.seekg(-tail, std::ios::end);
        is.read(reinterpret_cast<char*>(&count), sizeof(int));

        return is && count == n;
    }


    //- Add forces in contacts with other grains to the snapshot
    void addContacts
    (
        LAMMPS_NS::LAMMPS& lmp,
        const periodicity& images,
        grainSnapshot& grains
    )
    {
        const int at = lmp.modify->find_compute(contactList);

        if (at < 0)
        {
            return;
        }

        const fpeGuard guard;

        double** rows = static_cast<double**>
        (
            lammps_extract_compute(&lmp, contactList, 2, 2)
        );
        const label n = lmp.modify->compute[at]->size_local_rows;

        Map<label> mine(2*grains.size());
        forAll(grains.id, i)
        {
            mine.insert(grains.id[i], i);
        }

        for (label row = 0; row < n; ++row)
        {
            const double* c = rows[row];
            const vector force(c[FORCE], c[FORCE + 1], c[FORCE + 2]);
            const vector branch
            (
                images.shortest
                (
                    vector
                    (
                        c[FIRST] - c[SECOND],
                        c[FIRST + 1] - c[SECOND + 1],
                        c[FIRST + 2] - c[SECOND + 2]
                    )
                )
            );

            // Grains that push each other apart give pressure, negative
            const symmTensor moment(-symm(branch*force));

            const auto first = mine.cfind(label(c[FIRST_ID]));
            const auto second = mine.cfind(label(c[SECOND_ID]));

            // A contact stands once in all lists: where one grain is another
            // rank's, all of it counts here
            const scalar share = first.found() && second.found() ? 0.5 : 1;

            if (first.found())
            {
                grains.stressMoment[*first] += share*moment;
            }
            if (second.found())
            {
                grains.stressMoment[*second] += share*moment;
            }
        }
    }


    //- Take the places of contacts from the centres of clumps, not of their spheres
    void seeFromClumps(LAMMPS_NS::LAMMPS& lmp, grainSnapshot& grains)
    {
        // Beyond a side that repeats, beside the others of its clump
        vectorField places(grains.position);
        forAll(places, i)
        {
            lmp.domain->unmap(lmp.atom->x[i], lmp.atom->image[i], places[i].data());
        }

        const vectorField moments(grains.mass*places);
        const vectorField masses(grains.mass*vector::one);
        const auto sums(clumpSums(grains.clump).sum(moments, masses));

        forAll(grains.clump, i)
        {
            if (grains.clump[i])
            {
                const auto& sum = sums[grains.clump[i]];
                const point centre(sum.first()/sum.second().x());

                grains.stressMoment[i] +=
                    symm((places[i] - centre)*grains.contactForce[i]);
            }
        }
    }


    //- Force of the surface of a wall on each of n grains [N]
    vectorField surfaceForce
    (
        LAMMPS_NS::Modify& modify,
        const word& surface,
        const label n
    )
    {
        auto* mesh = static_cast<LAMMPS_NS::FixMeshSurface*>
        (
            modify.fix[modify.find_fix(surface.c_str())]
        );
        LAMMPS_NS::FixContactPropertyAtomWall* contacts = mesh->meshforceContact();

        vectorField result(n, Zero);

        forAll(result, i)
        {
            for (label k = 0; k < contacts->get_npartners(i); ++k)
            {
                // Force, then torque
                const double* c = contacts->contacthistory(i, k);
                result[i] += vector(c[0], c[1], c[2]);
            }
        }

        return result;
    }
}


void Foam::liggghtsPhase::addWallForces(grainSnapshot& grains) const
{
    forAllConstIters(walls_.fixes(), wall)
    {
        LAMMPS_NS::Modify& modify = *liggghts_->modify;
        vectorField force(size(), Zero);

        for (const word& id : wall.val())
        {
            const int at = modify.find_fix(("force_" + id).c_str());

            forAll(force, i)
            {
                const double* c = modify.fix[at]->array_atom[i];
                const vector f(c[0], c[1], c[2]);

                force[i] += f;
                grains.stressMoment[i] +=
                    symm(walls_.toPlane(id, position_[i])*f);
            }
        }

        grains.wallForce.insert(wall.key(), force);
    }

    forAllConstIters(walls_.surfaces(), wall)
    {
        grains.wallForce.insert
        (
            wall.key(),
            surfaceForce(*liggghts_->modify, wall.val(), size())
        );
    }
}


Foam::autoPtr<Foam::grainSnapshot> Foam::liggghtsPhase::snapshot() const
{
    auto result = autoPtr<grainSnapshot>::New(size());
    grainSnapshot& grains = *result;

    grains.id = id_;
    grains.type = type_;
    grains.position = position_;
    grains.U = velocity_;
    grains.omega = angularVelocity_;
    grains.mass = mass_;
    grains.force = fluidForce_;
    if (clump_.size())
    {
        grains.clump = clump_;
        grains.share = share_;
        grains.clumpDiameter = 2*scalarField(clumpRadius_);
    }

    forAll(radius_, i)
    {
        grains.d[i] = 2*radius_[i];
        grains.contactForce[i] = totalForce_[i] - fluidForce_[i];
        if (!grains.clump[i])
        {
            // Of a clump LIGGGHTS adds it to the whole
            grains.contactForce[i] -= mass_[i]*g_;
        }

        // Touching nothing a grain is damped, too
        if (damping_)
        {
            const double* c = damping_->added(i);
            grains.contactForce[i] -= vector(c[0], c[1], c[2]);
        }
    }

    addWallForces(grains);
    addContacts(*liggghts_, outlet_.images(), grains);
    if (hasClumps())
    {
        clumps_.setAxes(grains);
        seeFromClumps(*liggghts_, grains);
    }

    return result;
}


void Foam::liggghtsPhase::readState(const fileName& state)
{
    Info<< "    from " << state << endl;

    // Not part of a written state, and to be given before it is read. The physics
    // script may name a grain by its number
    for
    (
        const std::string& line
      : liggghtsScript::commands(initialScript_, "atom_modify")
    )
    {
        liggghts_.command(line);
    }

    liggghts_.command("read_restart " + state);
    for (const std::string& line : liggghtsClumps::commands(initialScript_))
    {
        liggghts_.command(line);
    }

    // Nor this. The physics script may choose another
    liggghts_.command("communicate single vel yes");
    restarted_ = true;
}


bool Foam::liggghtsPhase::writeState(const fileName& folder)
{
    const fileName aside(folder/"state.incomplete");

    outlet_.note();
    outlet_.endInsertions();
    last_.keep();
    liggghts_.command("write_restart " + aside);

    // The last rank's grains come last in the file
    labelList sizes(Pstream::nProcs());
    sizes[Pstream::myProcNo()] = liggghts_->atom->avec->size_restart();
    Pstream::gatherList(sizes);

    bool complete = true;
    if (Pstream::master())
    {
        complete = endsWith(aside, sizes.last()) && mv(aside, folder/"state");
    }
    compatibility::broadcast(complete);

    // Writing moves grains between ranks without making neighbour lists, and takes
    // out those that are beyond a side
    liggghts_.setup();
    last_.restore();
    clumps_.sumForces();
    refresh();
    outlet_.count();

    return complete;
}
