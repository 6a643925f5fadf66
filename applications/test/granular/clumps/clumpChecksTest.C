// SPDX-License-Identifier: GPL-3.0-or-later
// What is refused for clumps of spheres, and one that is lost.

#include "clumpsInBox.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace clumpsInBox;

namespace
{

//- The error of a case with clumps
std::string refused
(
    const std::string& dict,
    const settings& s = settings(),
    const testBox& box = testBox()
)
{
    return refusal([&]
    {
        boxOfWater w(dict, box);
        place(w, s);
        demCoupling coupling(w.box().mesh(), hydrostatics(g));
    });
}

} // End anonymous namespace


TEST(clumps, refuseWhatIsNotWrittenForThem)
{
    testBox narrow;
    narrow.patches[0] = narrow.patches[1] = "cyclic";
    narrow.span.x() = 0.05;
    settings within;
    within.x = "0 0.05";
    within.region = "0.02 0.03 0.4 0.6 0.4 0.6";
    expectHolds(refused("", within, narrow), "sides that repeat after 0.05 m");

    expectHolds(refused("LIGGGHTS { localDamping 0.5; }"), "localDamping");
    expectHolds(refused("coarseGraining 2;"), "coarseGraining");
    expectHolds(refused("interphaseForces { lubrication {} }"), "lubrication");

    settings s;
    s.physics = "fix integrate all nve/sphere\n";
    const std::string twice(refused("", s));
    expectHolds(twice, "fix integrate (nve/sphere)");
    expectHolds(twice, "take that fix out");
}


TEST(clumps, thatAreHeldOrCarryAMassAlongInLIGGGHTSAreRefused)
{
    settings s;
    s.physics = "fix_modify clumps fflag on off on\n";
    expectHolds(refused("", s), "'fflag off' or 'tflag off'");

    s = settings();
    s.fix = "clumps all multisphere CAddRhoFluid 0.5 1000";
    expectHolds(refused("", s), "interphaseForces/virtualMass");
}


TEST(clumps, madeBehindTheInitialScriptAreRefused)
{
    const std::string output
    (
        refusal([&]
        {
            boxOfWater w;
            w.writeInitial(1, "");
            w.addPhysics("fix late all multisphere");
            demCoupling coupling(w.box().mesh(), hydrostatics(g));
        })
    );
    expectHolds(output, "Fix late of style multisphere");
    expectHolds(output, "in the initial script");
}


TEST(clumps, aTemplateWithAMassOfItsOwnIsRefused)
{
    settings s;
    s.initial =
        "fix other all particletemplate/multisphere 86028121 atom_type 1 density"
        " constant 2000 nspheres 2 ntry 1000 spheres 0 0 0 0.01 0.01 0 0 0.01 type 2"
        " mass 1 inertia_tensor 1 0 0 1 0 1 use_volume\n";
    expectHolds(refused("", s), "take them out");
}


TEST(clumps, oneThatLeavesTheBoxCountsOnce)
{
    const std::string output
    (
        refusal([&]
        {
            boxOfWater w("fluid none; LIGGGHTS { walls { patches (); } }");
            settings s;
            s.region = "0.93 0.96 0.4 0.6 0.4 0.6";
            s.velocity = "200 0 0";
            place(w, s);
            demCoupling alone(w.box().mesh(), vector(Zero));
            for (label k = 0; k < 5; ++k)
            {
                alone.moveGrains();
            }
        })
    );

    expectHolds(output, "It is a sphere of clump 1, which counts once");
    expectHolds(output, "1 of 1 grains left so");
}

