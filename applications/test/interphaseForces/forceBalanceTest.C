// SPDX-License-Identifier: GPL-3.0-or-later
// What grains take from the fluid is what it gives, where neither drag is smoothed
// nor all of their volume stays in its cells.

#include "grainsInWater.H"
#include "scatteredGrains.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Relative error of what grains and fluid exchange where half of the grains' volume
//  does not fit into its cells, under a pressure and a viscous stress that change
//  along x
scalar residualOfFullCells(const string& smoothing)
{
    testMesh box;
    standingGrains phase(box.mesh());
    place
    (
        phase, randomPoints(200, 0.4*vector::one, 0.6*vector::one), 0.05
    );
    grainExchange exchange(box.mesh());
    exchange.locate(phase);
    solidFractionField solids
    (
        exchange, entries("minimum 0.7; largestSpread 1; smoothing { " + smoothing + " }")
    );
    solids.update();
    EXPECT_GT(solids.excess().movedVolume(), 0.5*solids.mapping().totalVolume());

    const vectorField& at = box.mesh().C();
    const scalarField x(at.component(vector::X));
    fluidFields fluid(water(x.size()));
    fluid.rho = 1000 - 900*x;
    fluid.viscousForce = sqr(x)*vector(3000, 0, 0);
    const vectorField none(x.size(), Zero);
    const fluidMeans means
    {
        fluid.U, none, sqr(x)*vector(2e5, 0, -1e5), fluid.viscousForce,
        scalarField(), Zero
    };

    interphaseForces forces
    (
        exchange,
        solids,
        entries
        (
            "drag { model Ergun; } viscousForce { strength 1; }"
        ),
        g,
        1
    );

    // Before the first exchange as well
    interphaseForces atStart(exchange, solids, entries("drag { model none; }"), g, 1);
    atStart.start(fluid, interval);
    const vector onCells
    (
        sum(box.mesh().V().field()*solids.solidFraction()*fluid.rho)*g
    );
    EXPECT_LT(mag(sum(atStart.force()) + onCells), 1e-12*mag(onCells));

    forces.prepare(fluid, interval);
    forces.finish(inEquation(means, fluid.rho, forces, solids, box.mesh(), g));
    return forces.residual();
}

} // End anonymous namespace


TEST(forceBalance, closesWhereDragIsNotSmoothed)
{
    testMesh box;
    standingGrains phase(box.mesh());
    place(phase, 0.1*vector::one + 0.8*pointField(randomPoints(200)), 0.02);
    phase.grains.U = vector(0.05, 0.1, 0);
    grainExchange exchange(box.mesh());
    exchange.locate(phase);
    solidFractionField solids(exchange, entries("smoothing { width 12; drag off; }"));
    solids.update();

    fluidFields fluid(water(box.mesh().nCells()));
    const vectorField& at = box.mesh().C();
    forAll(fluid.U, cell)
    {
        fluid.U[cell] = vector(std::sin(6*at[cell].z()), 0, 0.2);
        fluid.rho[cell] = 1000 - 900*at[cell].x();
    }

    for (const scalar N : {1, 3})
    {
        interphaseForces forces
        (
            exchange,
            solids,
            entries
            (
                "drag { model Ergun; } lift { model SaffmanMei; }"
                " virtualMass { model Zuber; }"
            ),
            g,
            N
        );
        forces.prepare(fluid, interval);
        const vectorField none(box.mesh().nCells(), Zero);
        forces.finish
        (
            inEquation
            (
                fluidMeans{fluid.U, none, none, none, scalarField(), Zero},
                fluid.rho, forces, solids, box.mesh(), g
            )
        );
        EXPECT_GT(max(mag(forces.force())), 0);
        EXPECT_LT(forces.residual(), 1e-12);
    }
}


TEST(forceBalance, closesWhereGrainsDoNotFitIntoTheirCells)
{
    EXPECT_LT(residualOfFullCells("model none;"), 1e-12);
    EXPECT_LT(residualOfFullCells("width 1;"), 1e-12);
}
