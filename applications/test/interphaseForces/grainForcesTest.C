// SPDX-License-Identifier: GPL-3.0-or-later
// What grains take from the fluid around them, and what their forces sum to.

#include "grainsInWater.H"
#include "scatteredGrains.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Grains of 20 mm anywhere in a unit cube; the first at x = 1/2, where two
//  ranks meet
struct cubeOfGrains
{
    testMesh box;

    standingGrains phase;

    grainExchange exchange;

    solidFractionField solids;

    cubeOfGrains()
    :
        phase(box.mesh()),
        exchange(box.mesh()),
        solids(exchange, entries("model sphereCaps; smoothing { model none; }"))
    {
        pointField places(randomPoints(200));
        places = 0.1*vector::one + 0.8*places;
        places[0].x() = 0.499;
        place(phase, places, 0.01);
        locate();
    }

    void locate()
    {
        exchange.locate(phase);
        solids.update();
    }

    const grainMeshMapping& mapping() const
    {
        return solids.mapping();
    }

    //- Mean of cell values around each grain
    template<class T>
    Field<T> around(const Field<T>& cells) const
    {
        return mapping().gather(cells);
    }

    //- Mean of a member of what was reached around each grain
    template<class Set, class T>
    Field<T> around(const List<List<Set>>& reached, T Set::*member) const
    {
        Field<T> result(exchange.grains().size());
        forAll(result, i)
        {
            result[i] = mapping().mean(reached, i).*member;
        }
        return result;
    }

    forceModels laws(const string& text) const
    {
        return forceModels
        (
            exchange.mesh(), entries("drag { model none; } " + text)
        );
    }

    //- Water whose density and velocity change along x
    fluidFields layers() const
    {
        const scalarField x
        (
            exchange.mesh().C().primitiveField().component(vector::X)
        );
        fluidFields fluid(water(x.size()));
        fluid.rho = 1000 + 100*x;
        fluid.U = x*vector(0.4, 0.1, 0);
        fluid.vorticity = x*vector(0, 0, 5);
        fluid.convection = x*vector(0.2, 0.1, 0);
        fluid.viscousForce = x*vector(30, 0, -7);
        return fluid;
    }
};


template<class T>
void expectSame(const Field<T>& is, const Field<T>& should)
{
    ASSERT_EQ(is.size(), should.size());
    EXPECT_LE(sum(mag(is - should)), 1e-13*sum(mag(should)));
}


void expectTheCells()
{
    const cubeOfGrains grains;
    const fluidFields fluid(grains.layers());
    const List<List<fluidAtGrain>> is(fluidAround(grains.mapping(), fluid));
    const auto around = [&](const auto member)
    {
        return grains.around(is, member);
    };

    expectSame(around(&fluidAtGrain::rho), grains.around(fluid.rho));
    expectSame(around(&fluidAtGrain::rhoAround), grains.around(fluid.rho));
    expectSame(around(&fluidAtGrain::mu), grains.around(fluid.mu));
    expectSame
    (
        around(&fluidAtGrain::voidFraction), grains.around(fluid.voidFraction)
    );
    expectSame
    (
        around(&fluidAtGrain::momentum),
        grains.around(vectorField(fluid.rho*fluid.U))
    );
    expectSame
    (
        around(&fluidAtGrain::vorticity),
        grains.around(vectorField(fluid.rho*fluid.vorticity))
    );
}


void expectFlowWhereAClosureLooks()
{
    const cubeOfGrains grains;
    const fluidFields fluid(grains.layers());
    const auto flow = [&]
    (
        const string& laws,
        const vectorField& acceleration,
        const vectorField& viscousForce
    )
    {
        return flowAround
        (
            grains.mapping(),
            grains.laws(laws),
            fluid.rho,
            acceleration,
            viscousForce
        );
    };

    // A field that no law reads is not there
    const vectorField none;
    const auto carried =
        flow("virtualMass { model constant; }", fluid.convection, none);
    const auto sheared =
        flow("viscousForce { strength 1; }", none, fluid.viscousForce);
    const vectorField zero(grains.exchange.grains().size(), Zero);

    EXPECT_TRUE(flow("", none, none).empty());
    expectSame
    (
        grains.around(carried, &flowAtGrain::acceleration),
        grains.around(vectorField(fluid.rho*fluid.convection))
    );
    expectSame(grains.around(carried, &flowAtGrain::viscousForce), zero);
    expectSame
    (
        grains.around(sheared, &flowAtGrain::viscousForce),
        grains.around(fluid.viscousForce)
    );
    expectSame(grains.around(sheared, &flowAtGrain::acceleration), zero);
}

} // End anonymous namespace


TEST(grainForces, takeTheFluidFromTheCells)
{
    expectTheCells();
}


TEST(ParallelGrainForces, takeTheFluidFromTheCellsOfAllRanks)
{
    expectTheCells();
}


TEST(grainForces, takeTheFlowWhereAClosureLooksAtIt)
{
    expectFlowWhereAClosureLooks();
}


TEST(ParallelGrainForces, takeTheFlowWhereAClosureLooksAtIt)
{
    expectFlowWhereAClosureLooks();
}


TEST(grainForces, weighTheMeanOfAnIntervalWithTheDensityAtItsStart)
{
    const cubeOfGrains grains;
    const fluidFields fluid(grains.layers());
    const fluidMeans means
    {
        fluid.U, fluid.convection, fluid.viscousForce, fluid.viscousForce,
        scalarField(2*fluid.rho), Zero
    };
    const List<List<meanAtGrain>> is(meansAround(grains.mapping(), means, fluid.rho));

    expectSame
    (
        grains.around(is, &meanAtGrain::rhoAround), grains.around(means.rho)
    );
    expectSame
    (
        grains.around(is, &meanAtGrain::momentum),
        grains.around(vectorField(fluid.rho*fluid.U))
    );
    expectSame
    (
        grains.around(is, &meanAtGrain::pressureGradient),
        grains.around(means.pressureGradient)
    );
}


TEST(grainForces, areNoneInAnyCellWhereGrainsMoveWithTheFluidAroundThem)
{
    // Smoothed over three diameters, so that many cells have a share in each grain
    testMesh box;
    standingGrains phase(box.mesh());
    pointField places(randomPoints(200));
    place(phase, 0.1*vector::one + 0.8*places, 0.02);
    grainExchange exchange(box.mesh());
    solidFractionField solids(exchange, entries("model sphereCaps;"));
    exchange.locate(phase);
    solids.update();

    // Velocity is curved: that of the cell of a grain is not the one around it
    fluidFields fluid(water(box.mesh().nCells()));
    const vectorField& at = box.mesh().C();
    forAll(fluid.U, cell)
    {
        fluid.U[cell] = vector(std::sin(6*at[cell].z()), 0, 0);
        fluid.rho[cell] = 1000 + 100*at[cell].x();
    }

    const grainMeshMapping& mapping = solids.mapping();
    const vectorField momentum
    (
        mapping.gather(vectorField(fluid.rho*fluid.U))
    );
    const scalarField rho(mapping.gather(fluid.rho));
    forAll(momentum, i)
    {
        phase.grains.U[exchange.grains()[i].id] = momentum[i]/rho[i];
    }
    exchange.locate(phase);
    solids.update();

    interphaseForces forces
    (
        exchange, solids, entries("drag { model Ergun; }"), vector(Zero), 1
    );
    forces.prepare(fluid, interval);

    const vectorField drag(forces.dragCoefficient()*fluid.U);
    EXPECT_GT(max(mag(drag)), 0);
    EXPECT_LT
    (
        max(mag(drag + forces.explicitForce())), 1e-12*max(mag(drag))
    );
}


//- Power that grains at rest take from water whose velocity changes its sign from
//  cell to cell, over that which they take from water with one velocity
scalar dragOnTheShortestWave(const string& smoothing)
{
    testMesh box;
    standingGrains phase(box.mesh());
    place(phase, 0.1*vector::one + 0.8*pointField(randomPoints(200)), 0.02);
    phase.grains.U = Zero;
    grainExchange exchange(box.mesh());
    exchange.locate(phase);
    solidFractionField solids(exchange, entries("model centroid; " + smoothing));
    solids.update();

    fluidFields fluid(water(box.mesh().nCells()));
    const vectorField& at = box.mesh().C();
    const auto power = [&](const bool wave)
    {
        forAll(fluid.U, cell)
        {
            const label layer = label(4*at[cell].z());
            fluid.U[cell] = vector(wave && layer % 2 ? -1 : 1, 0, 0);
        }
        interphaseForces forces
        (
            exchange, solids, entries("drag { model Ergun; }"), vector(Zero), 1
        );
        forces.prepare(fluid, interval);
        const vectorField force
        (
            forces.dragCoefficient()*fluid.U + forces.explicitForce()
        );
        return sum(force & fluid.U);
    };

    return power(true)/power(false);
}


TEST(grainForces, dragTheShortestWaveWhereDragIsNotSmoothed)
{
    EXPECT_LT(dragOnTheShortestWave("smoothing { width 25; }"), 0.01);
    EXPECT_NEAR
    (
        dragOnTheShortestWave("smoothing { width 25; drag off; }"), 1, 1e-9
    );
}


TEST(grainForces, sumUpWithoutWhatWallsGive)
{
    // Close to the wall x = 0, towards which it goes
    constexpr scalar d = 0.02;
    const auto sumOf = [&](const string& lubrication, vector& force)
    {
        testMesh box;
        standingGrains phase(box.mesh());
        put(phase, pointField(1, point(0.52*d, 0.4, 0.4)), d);
        phase.grains.U = vector(-0.1, 0, 0);
        grainExchange exchange(box.mesh());
        exchange.locate(phase);
        solidFractionField solids(exchange, entries(inOneCellEach));
        solids.update();

        grainForces forces
        (
            exchange,
            solids,
            entries("drag { model SchillerNaumann; } " + lubrication),
            g,
            1
        );
        const fluidFields fluid(water(box.mesh().nCells()));
        const vectorField none(box.mesh().nCells(), Zero);
        forces.prepare(fluid, interval);
        const auto sums = forces.finish
        (
            fluidMeans{fluid.U, none, none, none, fluid.rho, Zero}, fluid.rho
        );
        EXPECT_DOUBLE_EQ(sums.second(), mag(sums.first()));
        force = forces.force()[0];
        return sums.first();
    };

    vector force;
    EXPECT_EQ(sumOf("", force), force);
    const vector sum(sumOf("lubrication { strength 1; }", force));

    // 6 pi mu r^2 (1/h - 1/r) v: little of the velocity is lost in an interval
    const scalar film =
        6*constant::mathematical::pi*muWater*sqr(d/2)
       *(1/(0.02*d) - 2/d)*0.1;
    EXPECT_NEAR(force.x() - sum.x(), film, 0.05*film);
}


TEST(grainForces, thePhaseAroundAGrainActsOnItHoweverNearTheSurface)
{
    // Water up to z = 1/2, with a cell that is half full above it or without, in cells
    // of two diameters; smoothed over three
    testBox b;
    b.span = vector(0.4, 0.4, 1);
    b.cells = labelVector(8, 8, 20);
    testMesh box(b);
    const scalar d = 0.025;
    const label n = box.mesh().nCells();
    const scalarField z(box.mesh().C().primitiveField().component(vector::Z));

    for (const scalar atSurface : {0.0, 0.5})
    for (const scalar depth : {-4.0, -2.6, 0.51, 0.8, 1.0, 2.0, 4.0})
    {
        const scalarField alpha(neg(z - 0.5) + atSurface*pos(z - 0.5)*neg(z - 0.55));
        fluidFields fluid(water(n));
        fluid.rho = 1 + 999*alpha;
        fluid.U = vectorField(n, Zero);
        standingGrains phase(box.mesh());
        put(phase, pointField(1, point(0.21, 0.19, 0.5 - depth*d)), d);
        phase.grains.U = vector(0, 0, 0);
        grainExchange exchange(box.mesh());
        exchange.locate(phase);
        solidFractionField solids(exchange, entries(""));
        solids.setWater(alpha);
        solids.update();
        grainForces forces
        (
            exchange, solids, entries("drag { model SchillerNaumann; }"), g, 1
        );

        const vectorField none(n, Zero);
        forces.prepare(fluid, interval);
        forces.finish
        (
            fluidMeans{fluid.U, none, fluid.rho*g, none, fluid.rho, Zero}, fluid.rho
        );

        // The drag of what weight does in the interval is implicit. With smoothing
        // through the surface 13 to 20 % are amiss
        const scalar displaced = (depth > 0 ? 1000 : 1)*volumeOf(d)*mag(g);
        const scalar drag = 1e-4*2650*volumeOf(d)*mag(g);
        const scalar leak = atSurface > 0 ? 0.02*1000*volumeOf(d)*mag(g) : 0;
        EXPECT_NEAR(forces.force()[0].z(), displaced, drag + leak) << depth;

        // And displaces it
        const scalarField solid(box.mesh().V()*solids.solidFraction());
        const scalar inWater = sum(solid*alpha);
        EXPECT_LE
        (
            mag(depth > 0 ? sum(solid) - inWater : inWater),
            (atSurface > 0 ? 0.02 : 1e-14)*volumeOf(d)
        )   << depth;
    }
}
