// SPDX-License-Identifier: GPL-3.0-or-later
// The film between a grain and a wall: against the exact solution for a sphere,
// and a grain that comes to rest in it.

#include "interphaseForces.H"
#include "standingGrains.H"
#include "testMesh.H"
#include "testNumber.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar pi = M_PI;

dictionary entries(const string& text)
{
    return dictionary(IStringStream(text)());
}


//- Drag of a sphere towards a plane wall over Stokes's (Brenner 1961, eq. 2.19),
//  at the distance of its centre in radii
scalar Brenner(const scalar distance)
{
    const scalar a = std::acosh(distance);
    scalar sum = 0;
    for (int n = 1; n < 400 && n*a < 300; ++n)
    {
        const scalar above =
            2*std::sinh((2*n + 1)*a) + (2*n + 1)*std::sinh(2*a);
        const scalar below =
            4*sqr(std::sinh((n + 0.5)*a)) - sqr((2*n + 1)*std::sinh(a));
        sum += n*(n + 1.0)/((2*n - 1.0)*(2*n + 3.0))*(above/below - 1);
    }
    return 4.0/3*std::sinh(a)*sum;
}


//- A grain in a box of fluid, which its forces move
struct approach
{
    testMesh box;

    standingGrains phase;

    grainExchange exchange;

    autoPtr<solidFractionField> solids;

    autoPtr<interphaseForces> forces;

    static constexpr scalar r = 0.02;

    static constexpr scalar mu = 0.4;

    scalar mass = 1120*4.0/3*pi*pow3(r);

    //- At a gap from the wall x = 0 [m], with that velocity [m/s]
    approach(const scalar gap, const scalar v, const string& laws)
    :
        phase(box.mesh()),
        exchange(box.mesh())
    {
        phase.grains = grainSnapshot(1);
        phase.grains.id = identity(1);
        phase.grains.position = point(r + gap, 0.4, 0.4);
        phase.grains.mass = mass;
        phase.grains.U = vector(v, 0, 0);
        phase.radii = scalarField(1, r);
        exchange.locate(phase);
        solids.reset
        (
            new solidFractionField
            (
                exchange, entries("model centroid; smoothing { model none; }")
            )
        );
        solids->update();
        forces.reset
        (
            new interphaseForces
            (
                exchange, *solids,
                entries
                (
                    "drag { model none; } rotationalDrag { model none; }" + laws
                ),
                vector(Zero), 1
            )
        );
    }

    vector force(const scalar interval)
    {
        const vectorField none(box.mesh().nCells(), Zero);
        const scalarField one(box.mesh().nCells(), 1);
        exchange.locate(phase);
        solids->update();
        forces->prepare
        (
            fluidFields{970*one, mu*one, one, none, none, none, none}, interval
        );
        forces->finish(fluidMeans{none, none, none, none, 970*one, Zero});
        return forces->force()[0];
    }

    scalar gap() const
    {
        return phase.grains.position[0].x() - r;
    }
};

} // End anonymous namespace


TEST(lubrication, isTheExactForceOfASphereAtSmallGaps)
{
    testMesh box;
    const wallLubrication film(box.mesh(), entries("strength 1; range 1e6;"));

    for (const scalar gap : {0.002, 0.01, 0.03})
    {
        const scalar r = 0.0075;
        const scalar stokes = 6*pi*0.373*r;
        const scalar ratio =
            film.coefficient((1 + gap)*r, r, 0.373)/stokes/Brenner(1 + gap);
        testNumber("film over exact drag", ratio);
        EXPECT_NEAR(ratio, 1, 0.06) << gap;
    }
    EXPECT_NEAR(Brenner(1.5431), 3.0361, 1e-3) << "Brenner's table";
}


TEST(lubrication, bringsAGrainToRestAsTheFilmHasIt)
{
    // m dv/dt = -6 pi mu r^2 (1/h - 1/h0) v has
    // v(h) = v0 + 6 pi mu r^2/m (ln(h/h0) - (h - h0)/h0) from h0 on
    const scalar h0 = approach::r;
    const scalar v0 = 0.5;
    approach a(h0, -v0, "lubrication { }");
    const scalar c = 6*pi*approach::mu*sqr(approach::r)/a.mass;
    const scalar interval = 1e-5;

    label compared = 0;
    for (label step = 0; step < 8000 && a.gap() > 0.02*h0; ++step)
    {
        vector& v = a.phase.grains.U[0];
        v += interval/a.mass*a.force(interval);
        a.phase.grains.position[0] += interval*v;

        const scalar h = a.gap();
        const scalar exact = v0 + c*(std::log(h/h0) - (h - h0)/h0);
        if (step % 300 == 299)
        {
            EXPECT_NEAR(-v.x()/exact, 1, 2e-3) << h/h0;
            ++compared;
        }
    }
    EXPECT_GT(compared, 5);
}


TEST(lubrication, isNothingAtStrengthZeroFarOffAndPastTheWall)
{
    EXPECT_EQ(approach(0.001, -1, "").force(1e-5), vector(Zero));
    EXPECT_EQ
    (
        approach(0.001, -1, "lubrication { strength 0; }").force(1e-5),
        vector(Zero)
    );
    EXPECT_EQ(approach(0.03, -1, "lubrication { }").force(1e-5), vector(Zero));

    testMesh box;
    const plateWalls walls(box.mesh(), wordRes());
    ASSERT_EQ(walls.plates().size(), 6);
    for (const plateWalls::plate& p : walls.plates())
    {
        const point beside(p.bounds.max() + vector(0.3, 0.3, 0.3) - 0.1*p.normal);
        EXPECT_EQ(plateWalls::distance(p, beside, 0.01), GREAT);
    }
}


TEST(lubrication, doesNotOvershootWithLongIntervals)
{
    approach a(1e-6, -1, "lubrication { }");
    const scalar interval = 1;
    const scalar after = -1 + interval/a.mass*a.force(interval).x();
    EXPECT_LE(after, 0);
    EXPECT_GT(after, -0.01);
}


TEST(lubrication, nowhereToBeHasAnError)
{
    testMesh box;
    EXPECT_THROW
    (
        wallLubrication(box.mesh(), entries("range 1e-4;")), Foam::error
    );
    EXPECT_THROW
    (
        wallLubrication(box.mesh(), entries("patches (nowhere);")), Foam::error
    );
    EXPECT_THROW(wallLubrication(box.mesh(), entries("gap 1;")), Foam::error);
}
