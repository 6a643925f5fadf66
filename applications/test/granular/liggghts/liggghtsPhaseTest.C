// SPDX-License-Identifier: GPL-3.0-or-later
// Grains of LIGGGHTS as a phase: damping, its DEM step, its bins.

#include "boxOfWater.H"
#include "grainSnapshot.H"
#include "granularProperties.H"
#include "liggghtsScript.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;


TEST(localDamping, isNoContactForceOfAGrainThatFalls)
{
    boxOfWater w("LIGGGHTS { localDamping 0.7; }");
    const granularProperties dict(w.box().mesh());
    autoPtr<granularPhase> grains(dict.makePhase(w.box().mesh(), g));
    grains->advance();
    grains->advance();

    const scalar weight = grains->mass()[0]*mag(g);
    EXPECT_LT(grains->velocity()[0].z(), 0);
    EXPECT_NEAR(grains->totalForce()[0].z(), -0.3*weight, 1e-9*weight);

    // Kept: the loop alone would not
    const autoPtr<grainSnapshot> snapshot(grains->snapshot());
    for (const vector& force : snapshot->contactForce)
    {
        EXPECT_LT(mag(force), 1e-9*weight);
    }
}


TEST(liggghtsPhase, refusesADEMStepThatChangesMeanwhile)
{
    boxOfWater w;
    w.addPhysics("fix own all dt/reset 10 1e-6 2e-5 1e-4 units box");
    const std::string output
    (
        refusal([&]{ demCoupling(w.box().mesh(), hydrostatics(g)); })
    );

    expectHolds(output, "constant/grains/physics");
    expectHolds(output, "changes the DEM step");
    expectHolds(output, "(fix own)");
    expectHolds(output, "Take the fix out");
}


// A box of 1 m with bins of 0.1 mm
TEST(liggghtsPhase, binsAreAsManyAsTheGrainsWhateverTheirBox)
{
    boxOfWater w;
    w.placeGrains(0.5, 1e-4);
    w.addPhysics("neighbor 1e-4 bin\ntimestep 1e-7");
    demCoupling coupling(w.box().mesh(), hydrostatics(g));
    coupling.start(w.water());
    exchangeOnce(coupling, w);
    EXPECT_TRUE(coupling.write());
}


TEST(liggghtsPhase, farTooManyBinsOfLiggghtsAreAnErrorBeforeTheyTakeTheMemory)
{
    boxOfWater w("LIGGGHTS { contacts stock; }");
    w.placeGrains(0.5, 1e-4);
    w.addPhysics("neighbor 1e-4 bin\ntimestep 1e-7");
    const std::string output
    (
        refusal([&]{ demCoupling(w.box().mesh(), hydrostatics(g)); })
    );

    expectHolds(output, "1e+12 bins of 0.0001 m");
    expectHolds(output, "8000 GB of memory");
    expectHolds(output, "make the box");
}


TEST(liggghtsScript, optionsStandBehindTheModelsOfAContact)
{
    const auto parts = [](const string& text)
    {
        const auto p = liggghtsScript::parts(text);
        return p.models + " |" + p.options;
    };

    EXPECT_EQ
    (
        parts("model hertz tangential history"),
        " model hertz tangential history |"
    );
    EXPECT_EQ
    (
        parts("model  hertz rolling_friction cdt limitForce on torsionTorque on"),
        " model hertz rolling_friction cdt | limitForce on torsionTorque on"
    );
    EXPECT_EQ(parts("${contact} limitForce on"), " ${contact} | limitForce on");
    EXPECT_EQ(parts("model ${normal} tangential"), " model ${normal} tangential |");
}


// In a wall by 0.1 mm and away from it at 1 m/s, where the damping pulls
TEST(liggghtsPhase, limitForceHoldsAtPlanesAndAtSurfaces)
{
    const auto force = [](const bool plane, const std::string& options)
    {
        const scalar base = plane ? 0 : 0.5;
        boxOfWater w
        (
            std::string("LIGGGHTS { walls { ")
          + (plane ? "" : "patches (zMax); surfaces (base); ")
          + "contactModel \"model hertz tangential history " + options + "\"; } }"
        );
        w.placeGrains(base + 0.0099);
        if (!plane)
        {
            w.write
            (
                "base.stl",
                "solid base\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0.1 0.5\n"
                "vertex 0.9 0.1 0.5\nvertex 0.9 0.9 0.5\nendloop\nendfacet\n"
                "facet normal 0 0 1\nouter loop\nvertex 0.1 0.1 0.5\n"
                "vertex 0.9 0.9 0.5\nvertex 0.1 0.9 0.5\nendloop\nendfacet\n"
                "endsolid base\n"
            );
            w.addPhysics("fix base all mesh/surface file base.stl type 1");
        }
        w.addPhysics("velocity all set 0 0 1 units box");
        const granularProperties dict(w.box().mesh());
        autoPtr<granularPhase> grains(dict.makePhase(w.box().mesh(), Zero));

        return grains->totalForce()[0].z();
    };

    for (const bool plane : {true, false})
    {
        EXPECT_LT(force(plane, ""), -1) << plane;
        EXPECT_NEAR(force(plane, "limitForce on"), 0, 1e-12) << plane;
        EXPECT_EQ(force(plane, "limitForce off"), force(plane, "")) << plane;
    }
}
