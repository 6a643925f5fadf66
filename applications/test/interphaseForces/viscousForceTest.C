// SPDX-License-Identifier: GPL-3.0-or-later
// The force of the viscous stress of the water on grains.

#include "grainsInWater.H"
#include "testMesh.H"
#include "testNumber.H"

#include "fvc.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Divergence of the viscous stress where U = a (z^2, 0, 0) [N/m3]
vectorField viscousStress(const fvMesh& mesh, const scalar a)
{
    volVectorField U
    (
        IOobject("U", "0", mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        "fixedValue"
    );
    U.primitiveFieldRef() = a*sqr(mesh.C().component(vector::Z)().primitiveField())
       *vector(1, 0, 0);
    for (fvPatchVectorField& patch : U.boundaryFieldRef())
    {
        patch == a*sqr(patch.patch().Cf().component(vector::Z))*vector(1, 0, 0);
    }

    const dimensionedScalar mu("mu", dimDynamicViscosity, muWater);
    const volVectorField stress
    (
        fvc::laplacian(mu, U)
      + fvc::div
        (
            mesh.Sf()
          & fvc::interpolate(mu*dev2(T(fvc::grad(U))))
        )
    );
    return stress.primitiveField();
}


//- Force of the viscous stress on grains where U = a (z^2, 0, 0), nothing else
//  acting; strength is that in the dictionary
vectorField viscousForces
(
    testMesh& box,
    const pointField& places,
    const scalar d,
    const scalar a,
    const word& strength
)
{
    const fvMesh& mesh = box.mesh();
    standingGrains phase(mesh);
    put(phase, places, d);
    grainExchange exchange(mesh);
    exchange.locate(phase);
    solidFractionField solids
    (
        exchange, entries("model sphereCaps; smoothing { model none; }")
    );
    solids.update();

    interphaseForces forces
    (
        exchange,
        solids,
        entries
        (
            "drag { model none; } pressureGradient { strength 0; }"
            " rotationalDrag { model none; }"
            " viscousForce { strength " + strength + "; }"
        ),
        vector(Zero),
        1
    );

    fluidFields fluid(water(mesh.nCells()));
    fluid.viscousForce = viscousStress(mesh, a);
    forces.prepare(fluid, interval);

    const vectorField none(mesh.nCells(), Zero);
    forces.finish
    (
        fluidMeans{none, none, none, fluid.viscousForce, fluid.rho, Zero}
    );

    EXPECT_EQ(forces.force().size(), places.size());
    return forces.force();
}

} // End anonymous namespace


TEST(viscousForce, isVolumeTimesTheDivergenceOfTheStress)
{
    constexpr scalar d = 0.05;
    constexpr scalar a = 30;
    testBox cells;
    cells.cells = labelVector(4, 4, 8);
    testMesh box(cells);

    // In one cell, over the face of two, over the corner of eight
    const pointField places({{0.4, 0.4, 0.4}, {0.5, 0.4, 0.6}, {0.5, 0.5, 0.5}});

    // mu d2u/dz2 = 2 mu a
    const vector exact(volumeOf(d)*2*muWater*a, 0, 0);

    for (const vector& force : viscousForces(box, places, d, a, "1"))
    {
        testNumber("relative error", mag(force - exact)/mag(exact));
        EXPECT_LT(mag(force - exact), 1e-10*mag(exact));
    }
    for (const vector& force : viscousForces(box, places, d, a, "0.25"))
    {
        EXPECT_LT(mag(force - 0.25*exact), 1e-10*mag(exact));
    }
    for (const vector& force : viscousForces(box, places, d, a, "0"))
    {
        EXPECT_EQ(force, vector(Zero));
    }
}
