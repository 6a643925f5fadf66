// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts computed several in one instruction are LIGGGHTS's to the last bit.

#include "liggghtsInstance.H"
#include "temporaryFolder.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "vectorField.H"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/compute.h>
#include <liggghts/fix.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>

using namespace Foam;

namespace
{

const std::string hertzHistory("model hertz tangential history");


//- Where the grains of this rank are, how they move and what pushes them
struct motion
{
    vectorField position, velocity, spin, force, torque, wallForce;

    bool operator==(const motion& b) const
    {
        return
            position == b.position && velocity == b.velocity
         && spin == b.spin && force == b.force && torque == b.torque
         && wallForce == b.wallForce;
    }
};


//- Grains of two sizes and materials of three that fall into a tilted box, collide, slide
//  and come to rest; it is periodic across
struct tiltedBox
{
    temporaryFolder folder;

    liggghtsInstance liggghts;

    explicit tiltedBox(const std::string& model, const bool vectorised)
    :
        liggghts(fileName(folder)/"log.liggghts")
    {
        if (vectorised)
        {
            EXPECT_TRUE(liggghts.vectoriseContacts());
        }

        commands
        (
            "units si\n"
            "atom_style granular\n"
            "atom_modify map array\n"
            "boundary f p f\n"
            "newton off\n"
            "communicate single vel yes\n"
            "region box block 0 0.069 0 0.046 0 0.092 units box\n"
            "create_box 3 box\n"
            "lattice sc 0.0115 origin 0.5 0.5 0.5\n"
            "create_atoms 1 region box\n"
            "set group all type/fraction 2 0.4 51803\n"
            "set group all density 2650\n"
            "set type 1 diameter 0.0105\n"
            "set type 2 diameter 0.0085\n"
            // At each step, since LIGGGHTS keeps the spring of a contact that
            // opened until lists are built
            "neighbor 0.003 bin\n"
            "neigh_modify delay 0 every 1 check no\n"
            "fix a all property/global youngsModulus peratomtype 5e6 8e6 8e6\n"
            "fix b all property/global poissonsRatio peratomtype 0.3 0.2 0.2\n"
            "fix c all property/global coefficientRestitution"
            " peratomtypepair 3 0.4 0.6 0.6 0.6 0.8 0.8 0.6 0.8 0.8\n"
            "fix d all property/global coefficientFriction"
            " peratomtypepair 3 0.7 0.3 0.3 0.3 0.5 0.5 0.3 0.5 0.5\n"
            "fix e all property/global coefficientRollingFriction"
            " peratomtypepair 3 0.1 0.3 0.3 0.3 0.2 0.2 0.3 0.2 0.2\n"
            "pair_style gran " + model + "\n"
            "pair_coeff * *\n"
            "timestep 1e-4\n"
            "fix f all gravity 9.81 vector 0.5 0.1 -0.86\n"
            "fix g all nve/sphere\n"
        );

        // Options of the pairs alone
        const std::string wall
        (
            model.find(" on") == std::string::npos ? model : hertzHistory
        );
        int n = 0;
        for (const std::string side : {"xplane 0", "xplane 0.069", "zplane 0"})
        {
            liggghts.command
            (
                "fix wall" + std::to_string(n++) + " all wall/gran "
              + wall + " primitive type 1 " + side + " store_force yes"
            );
        }

        scatterVelocities();
        liggghts.setup();
    }

    void commands(const std::string& lines)
    {
        std::istringstream is(lines);
        for (std::string line; std::getline(is, line);)
        {
            liggghts.command(line);
        }
    }

    //- No two grains alike, on any number of ranks
    void scatterVelocities()
    {
        LAMMPS_NS::Atom& atom = *liggghts->atom;

        for (int i = 0; i < atom.nlocal; ++i)
        {
            for (int d = 0; d < 3; ++d)
            {
                const double number = atom.tag[i] + 0.37*d;
                atom.v[i][d] = 0.5*std::sin(12.9898*number);
                atom.omega[i][d] = 20*std::sin(78.233*number);
            }
        }
    }

    vectorField copy(double** array) const
    {
        vectorField result(liggghts->atom->nlocal);
        forAll(result, i)
        {
            result[i] = vector(array[i][0], array[i][1], array[i][2]);
        }
        return result;
    }

    //- Of a wall on each grain, as its fix keeps it [N]
    double** forceOf(const std::string& wall) const
    {
        LAMMPS_NS::Modify& modify = *liggghts->modify;
        return modify.fix[modify.find_fix(("force_" + wall).c_str())]->array_atom;
    }

    motion now() const
    {
        const LAMMPS_NS::Atom& atom = *liggghts->atom;

        return motion
        {
            copy(atom.x), copy(atom.v), copy(atom.omega), copy(atom.f),
            copy(atom.torque), copy(forceOf("wall2"))
        };
    }

    //- LIGGGHTS's command run, in which each seventh step wants the pressure
    void runWithPressure(const label n)
    {
        commands
        (
            "compute temperature all temp\n"
            "compute pressure all pressure temperature\n"
            "thermo_style custom step c_pressure\n"
            "thermo 7\n"
            "run " + std::to_string(n) + "\n"
        );
    }

    //- The pressure that was wanted last [Pa]; 0 where none was
    double pressure() const
    {
        const LAMMPS_NS::Modify& modify = *liggghts->modify;

        for (int i = 0; i < modify.ncompute; ++i)
        {
            if (modify.compute[i]->id == std::string("pressure"))
            {
                return modify.compute[i]->scalar;
            }
        }
        return 0;
    }
};


//- The same after n steps, whichever way contacts are computed
void expectSame(const std::string& model, const label n, const bool pressure)
{
    tiltedBox box(model, true);
    tiltedBox stock(model, false);
    EXPECT_TRUE(box.now() == stock.now());

    for (tiltedBox* one : {&box, &stock})
    {
        if (pressure)
        {
            one->runWithPressure(n);
        }
        else
        {
            one->liggghts.run(n);
        }
    }

    EXPECT_GT(returnReduce(box.now().position.size(), sumOp<label>()), 150);
    EXPECT_TRUE(box.now() == stock.now()) << model;
    EXPECT_GT(gSum(mag(box.now().wallForce)), 0);
    EXPECT_EQ(box.pressure(), stock.pressure());
    EXPECT_EQ(box.pressure() > 0, pressure);
}

} // End anonymous namespace


TEST(vectorisedContacts, areLiggghtsOwnToTheLastBit)
{
    for
    (
        const char* rolling :
        {"", " rolling_friction cdt", " rolling_friction epsd2"}
    )
    {
        const std::string model(hertzHistory + rolling);

        const tiltedBox box(model, true);
        EXPECT_EQ(box.liggghts.whyContactsAreStock(), "");
        EXPECT_EQ(box.liggghts.nVectorisedWalls(), 3);
        expectSame(model, UPstream::parRun() ? 500 : 10000, false);
    }
}


TEST(vectorisedContacts, takeTurnsWithLiggghtsWhereAStepNeedsMore)
{
    expectSame(hertzHistory + " rolling_friction epsd2", 500, true);
}


TEST(vectorisedContacts, areLeftToLiggghtsWhereTheModelIsAnother)
{
    for
    (
        const std::string& model :
        {
            std::string("model hertz tangential no_history"),
            hertzHistory + " limitForce on",
            hertzHistory + " rolling_friction epsd2 torsionTorque on"
        }
    )
    {
        EXPECT_NE(tiltedBox(model, true).liggghts.whyContactsAreStock(), "")
            << model;
        expectSame(model, 300, false);
    }
}
