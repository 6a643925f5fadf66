// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of neighbours by size class, with a skin for each grain: no contact is
// missed, and grains move as with LIGGGHTS's own.

#include "liggghtsInstance.H"
#include "temporaryFolder.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neigh_list.h>
#include <liggghts/neighbor.h>

using namespace Foam;

namespace
{

//- LIGGGHTS with grains in a box that is periodic along x and y
struct stirredBox
{
    temporaryFolder folder;

    liggghtsInstance liggghts;

    //- Empty, or with the grains of a written state
    explicit stirredBox(const bool sizeClasses, const std::string& state = "")
    :
        liggghts(fileName(folder)/"log.liggghts")
    {
        EXPECT_TRUE(liggghts.vectoriseContacts());
        if (sizeClasses)
        {
            EXPECT_TRUE(liggghts.useNeighbourLists());
        }
        commands
        (
            state.size()
          ? "newton off\nread_restart " + state + "\ncommunicate single vel yes\n"
          : "units si\natom_style granular\natom_modify map array\n"
            "boundary p p f\nnewton off\ncommunicate single vel yes\n"
            "region box block 0 0.08 0 0.08 0 0.16 units box\ncreate_box 1 box\n"
            "neighbor 1e-3 bin\n"
        );
    }

    void commands(const std::string& lines)
    {
        std::istringstream is(lines);
        for (std::string line; std::getline(is, line);)
        {
            liggghts.command(line);
        }
    }

    //- Contacts, walls and gravity
    void physics(const std::string& young = "5e6")
    {
        commands
        (
            "timestep 2e-5\nneigh_modify delay 0\n"
            "fix a all property/global youngsModulus peratomtype " + young + "\n"
            "fix b all property/global poissonsRatio peratomtype 0.3\n"
            "fix c all property/global coefficientRestitution peratomtypepair 1 0.6\n"
            "fix d all property/global coefficientFriction peratomtypepair 1 0.5\n"
            "pair_style gran model hertz tangential history\npair_coeff * *\n"
            "fix f all gravity 9.81 vector 0 0 -1\nfix g all nve/sphere\n"
            "fix w1 all wall/gran model hertz tangential history primitive type 1"
            " zplane 0\n"
            "fix w2 all wall/gran model hertz tangential history primitive type 1"
            " zplane 0.16\n"
        );
    }

    //- A grain at x, of that radius, and its velocity along x
    void place(const double x, const double radius, const double U)
    {
        std::ostringstream line;
        line.precision(17);
        line<< "create_atoms 1 single " << x << " 0.04 0.08 units box\nset atom "
            << ++nPlaced << " diameter " << 2*radius << " vx " << U << " density 2500\n";
        commands(line.str());
    }

    int nPlaced = 0;

    //- Grains of the radii in equal numbers per size class, apart from each other
    //  and fast
    void scatter(const double smallest, const double ratio, const int n)
    {
        std::mt19937 numbers(7);
        std::uniform_real_distribution<double> part(0, 1);
        std::vector<std::array<double, 4>> grains;

        for (int k = 0; k < n; ++k)
        {
            // The large ones first, a hundredth of all
            const double r =
                smallest*(k < n/100 + 1 ? ratio : std::pow(ratio, 0.4*part(numbers)));

            for (int attempt = 0; attempt < 1000; ++attempt)
            {
                std::array<double, 4> g{0, 0, 0, r};
                for (int d = 0; d < 3; ++d)
                {
                    const double side = d == 2 ? 0.16 : 0.08;
                    g[d] = 1.01*r + (side - 2.02*r)*part(numbers);
                }

                const auto meets = [&](const std::array<double, 4>& b)
                {
                    return
                        std::hypot(g[0] - b[0], g[1] - b[1], g[2] - b[2]) < r + b[3];
                };
                if (std::none_of(grains.begin(), grains.end(), meets))
                {
                    grains.push_back(g);
                    break;
                }
            }
        }

        for (std::size_t k = 0; k < grains.size(); ++k)
        {
            std::ostringstream line;
            line.precision(17);
            line<< "create_atoms 1 single " << grains[k][0] << ' ' << grains[k][1]
                << ' ' << grains[k][2] << " units box\nset atom " << k + 1
                << " diameter " << 2*grains[k][3] << " vx "
                << 2*part(numbers) - 1 << " vy " << 2*part(numbers) - 1 << " vz "
                << 2*part(numbers) - 1 << '\n';
            commands(line.str());
        }
        commands("set group all density 2500\n");
    }

    //- Of all grains by their number, three numbers each [m]
    std::vector<double> positions() const
    {
        const LAMMPS_NS::Atom& atom = *liggghts->atom;
        std::vector<double> result(3*atom.nlocal);
        for (int i = 0; i < atom.nlocal; ++i)
        {
            std::copy_n(atom.x[i], 3, result.begin() + 3*(atom.tag[i] - 1));
        }
        return result;
    }

    //- Contacts that are in no list, and all of them
    std::pair<label, label> missedContacts() const
    {
        const LAMMPS_NS::Atom& atom = *liggghts->atom;
        const LAMMPS_NS::NeighList& list = *liggghts->neighbor->lists[0];
        label nMissed = 0, nAll = 0;

        for (int i = 0; i < atom.nlocal; ++i)
        {
            const int* const first = list.firstneigh[i];
            const int* const end = first + list.numneigh[i];

            for (int j = i + 1; j < atom.nlocal + atom.nghost; ++j)
            {
                const double apart = std::hypot
                (
                    atom.x[i][0] - atom.x[j][0],
                    atom.x[i][1] - atom.x[j][1],
                    atom.x[i][2] - atom.x[j][2]
                );

                if (apart < atom.radius[i] + atom.radius[j])
                {
                    ++nAll;
                    nMissed += std::find(first, end, j) == end;
                }
            }
        }

        return
        {
            returnReduce(nMissed, sumOp<label>()),
            returnReduce(nAll, sumOp<label>())
        };
    }
};


//- No contact is missed in any of the steps
void expectNoneMissed(const double ratio, const std::string& skin)
{
    stirredBox box(true);
    box.scatter(1e-3, ratio, 500);
    if (skin.empty())
    {
        box.liggghts.chooseSkin();
    }
    box.physics();
    box.commands(skin);
    box.liggghts.setup();

    label nContacts = 0;
    const label nSteps = 600;
    const auto built = box.liggghts->neighbor->ncalls;
    for (label step = 0; step < nSteps; ++step)
    {
        box.liggghts.run(1);
        const auto [nMissed, nAll] = box.missedContacts();
        ASSERT_EQ(nMissed, 0) << "step " << step << ", ratio " << ratio;
        nContacts += nAll;
    }

    EXPECT_GT(nContacts, nSteps/2);
    EXPECT_LT(box.liggghts->neighbor->ncalls - built, nSteps/3);
    EXPECT_EQ(returnReduce(label(box.liggghts->atom->nlocal), sumOp<label>()),
        label(box.liggghts->atom->natoms));
}

} // End anonymous namespace


TEST(neighbourLists, missNoContact)
{
    for (const double ratio : {1., 4., 20.})
    {
        expectNoneMissed(ratio, "");
    }
}


TEST(ParallelNeighbourLists, missNoContact)
{
    expectNoneMissed(20, "");
}


TEST(neighbourLists, haveTheMeanDiameterAsSkinUnlessOneIsGiven)
{
    for (const std::string given : {"", "neighbor 3e-3 bin\n"})
    {
        stirredBox box(true);
        box.place(0.01, 4e-3, 0);
        box.place(0.04, 6e-3, 0);
        box.liggghts.chooseSkin();
        box.commands(given);
        box.physics();
        box.liggghts.setup();
        EXPECT_NEAR(box.liggghts->neighbor->skin, given.empty() ? 1e-2 : 3e-3, 1e-15);
    }
}


// A boulder of 20 radii has more neighbours than LIGGGHTS has room for otherwise
TEST(neighbourLists, haveANarrowSkinAroundBoulders)
{
    stirredBox box(true);
    for (int k = 0; k < 75; ++k)
    {
        box.place(1e-3*(k + 0.5), 5e-4, 0);
    }
    box.place(0.07, 1e-2, 0);
    box.liggghts.chooseSkin();
    box.physics();
    box.liggghts.setup();
    EXPECT_LT(box.liggghts->neighbor->skin, 1e-3);
    EXPECT_GT(box.liggghts->neighbor->skin, 1e-4);
}


TEST(neighbourLists, chooseTheirSkinWhenTheFirstGrainsAreKnown)
{
    stirredBox box(true);
    box.liggghts.chooseSkin();
    box.place(0.01, 4e-3, 0);
    box.physics();
    box.liggghts.setup();
    EXPECT_NEAR(box.liggghts->neighbor->skin, 8e-3, 1e-15);
}


TEST(neighbourLists, takeTheSkinThatIsGiven)
{
    expectNoneMissed(4, "neighbor 1e-3 bin\n");

    // Checked each tenth step, or not at all: one skin for all
    expectNoneMissed(4, "neighbor 2e-3 bin\nneigh_modify delay 10\n");
    expectNoneMissed(4, "neighbor 2e-3 bin\nneigh_modify every 10 check no\n");
}


// A grain at rest on each side of the periodic side, and a fast one that pushes the
// second onto the first: from so far away that its image is not seen there
TEST(neighbourLists, knowHowFarGrainsBeyondASideMayMove)
{
    const double r = 5e-3;
    stirredBox box(true);
    box.place(0.08 - 0.09*r, r, 0);
    box.place(2*r, r, 0);
    box.place(4.17*r, r, -20);
    box.liggghts.chooseSkin();
    box.physics("1e9");
    box.liggghts.setup();

    label nTouching = 0;
    for (label step = 0; step < 20; ++step)
    {
        box.liggghts.run(1);
        const auto [nMissed, nAll] = box.missedContacts();
        ASSERT_EQ(nMissed, 0) << "step " << step;
        nTouching = max(nTouching, nAll);
    }

    // The fast one's, and the others' in the list of each
    EXPECT_EQ(nTouching, 3);
}


// A bed that has come to rest does not make a difference in the last digit grow
TEST(neighbourLists, moveGrainsAsLiggghtssOwn)
{
    stirredBox settled(false);
    settled.scatter(2.5e-3, 4, 300);
    settled.physics();
    settled.liggghts.setup();
    settled.liggghts.run(40000);
    const std::string state(fileName(settled.folder)/"state");
    settled.commands("write_restart " + state + "\n");

    stirredBox bySize(true, state), stock(false, state);
    for (stirredBox* one : {&bySize, &stock})
    {
        one->physics();
        one->liggghts.setup();
        one->liggghts.run(10000);
    }

    const std::vector<double> x(bySize.positions()), y(stock.positions());
    ASSERT_EQ(x.size(), y.size());
    double most = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        most = std::max(most, std::fabs(x[k] - y[k]));
    }
    // Of the height of the box
    EXPECT_LT(most, 1e-12*0.16);
    EXPECT_EQ(bySize.missedContacts().first, 0);
    EXPECT_GT(bySize.missedContacts().second, label(x.size()/3));
}
