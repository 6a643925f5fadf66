// SPDX-License-Identifier: GPL-3.0-or-later
// Forces on the water by fvOptions, and the permeable wall.

#include "localisedMomentumSource.H"
#include "permeableWallFvPatchVectorField.H"
#include "terminalOutput.H"
#include "sideWallFriction.H"
#include "testMesh.H"

#include "IStringStream.H"
#include "OSspecific.H"
#include "fvOptionList.H"
#include "fvmDdt.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

dictionary entries(const string& text)
{
    return dictionary(IStringStream(text)());
}


//- A box of water 2 m long, filled to a half, with void fraction 0.8
struct halfFull
{
    testMesh box;

    autoPtr<volScalarField> alpha;

    autoPtr<volScalarField> voidFraction;

    autoPtr<volScalarField> p;

    static testBox shape()
    {
        testBox b;
        b.span = vector(2, 1, 1);
        b.cells = labelVector(40, 2, 4);
        return b;
    }

    autoPtr<volScalarField> field(const word& name, const dimensionSet& d)
    {
        return autoPtr<volScalarField>::New
        (
            IOobject(name, "0", box.mesh()),
            box.mesh(),
            dimensionedScalar(name, d, 0)
        );
    }

    halfFull()
    :
        box(shape()),
        alpha(field("alpha.water", dimless)),
        voidFraction(field("voidFraction", dimless)),
        p(field("p", dimPressure))
    {
        forAll(*alpha, cell)
        {
            (*alpha)[cell] = box.mesh().C()[cell].z() < 0.5;
        }
        *voidFraction == dimensionedScalar("pores", dimless, 0.8);
    }

    vectorField push(const string& at, const scalar t)
    {
        box.time().setTime(t, label(1));
        return fv::localisedMomentumSource
        (
            "push", "localisedMomentumSource",
            entries
            (
                "type localisedMomentumSource; direction (2 0 0); force -30;"
                " reach (0.5 0.5); time 1; lasting (0.5 1);" + at
            ),
            box.mesh()
        ).force();
    }

    //- Velocity of fluid that nothing but an option acts on, after n steps; its
    //  mass per volume is that of water and air times a void fraction that
    //  varies along x
    vectorField moved
    (
        const string& option,
        const vector& U0,
        const scalar deltaT,
        const label n
    )
    {
        const fvMesh& mesh = box.mesh();
        forAll(*voidFraction, cell)
        {
            (*voidFraction)[cell] = 0.5 + 0.2*mesh.C()[cell].x();
        }
        const volScalarField mass
        (
            "mass",
            *voidFraction
           *(
                *alpha*dimensionedScalar("water", dimDensity, 1000)
              + (1 - *alpha)*dimensionedScalar("air", dimDensity, 1.2)
            )
        );
        volVectorField U
        (
            IOobject("U", "0", mesh),
            mesh,
            dimensionedVector("U", dimVelocity, U0)
        );
        fv::optionList options(mesh, entries("only { " + option + " }"));

        box.time().setDeltaT(deltaT, false);
        for (label i = 0; i < n; ++i)
        {
            ++box.time();
            fvVectorMatrix UEqn(fvm::ddt(mass, U) == options(mass, U));
            UEqn.solve();
        }
        return U.primitiveField();
    }
};


//- The half filled box with a base of conductance 2e-6 m/(Pa s) and 100 Pa below it
class permeableBase
{
    halfFull w_;

    volVectorField U_;

    static constexpr label patch_ = 4;

public:

    permeableBase()
    :
        U_
        (
            IOobject("U", "0", w_.box.mesh()),
            w_.box.mesh(),
            dimensionedVector(dimVelocity, Zero)
        )
    {
        const fileName constant(w_.box.time().constantPath());
        mkDir(constant);
        std::ofstream(constant/"g")
            << "FoamFile { version 2.0; format ascii;"
            " class uniformDimensionedVectorField; object g; }\n"
            "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n";
    }

    //- Its condition, with entries more
    permeableWallFvPatchVectorField wall(const string& more = "") const
    {
        return permeableWallFvPatchVectorField
        (
            U_.mesh().boundary()[patch_],
            U_.internalField(),
            entries
            (
                "type permeableWall; conductance 2e-6; outside 100;"
                " value uniform (0 0 0);" + more
            )
        );
    }

    //- Sixty steps with that pressure in the water at it [Pa]
    void settle(permeableWallFvPatchVectorField& wall, const scalar pressure)
    {
        w_.p->boundaryFieldRef()[patch_] == pressure;
        for (label i = 0; i < 60; ++i)
        {
            ++w_.box.time();
            wall.updateCoeffs();
            wall.evaluate();
        }
    }
};

} // End anonymous namespace


TEST(localisedMomentumSource, actsOnWaterAtItsPlaceAndTime)
{
    halfFull w;
    const scalarField& V = w.box.mesh().V();
    const vectorField f(w.push("place 1;", 1));

    // 30 N/m3 on water of 0.8 x 0.5 x 1 m2, half of it within 1 m
    EXPECT_NEAR(sum(V*f).x(), -30*0.8*0.5*0.5, 1e-3);
    EXPECT_LT(mag(sum(V*f).y()) + mag(sum(V*f).z()), 1e-12);
    forAll(f, cell)
    {
        const point& c = w.box.mesh().C()[cell];
        if (c.z() > 0.5 || mag(c.x() - 1) > 0.5)
        {
            EXPECT_EQ(f[cell], vector(Zero)) << c.x();
        }
    }

    EXPECT_NEAR(sum(V*w.push("place 1;", 0.75)).x()/sum(V*f).x(), 0.5, 1e-12);
    EXPECT_NEAR(sum(V*w.push("place 1;", 1.75)).x()/sum(V*f).x(), 0.25, 1e-12);
    EXPECT_EQ(max(mag(w.push("place 1;", 0.4))), 0);
    EXPECT_EQ(max(mag(w.push("place 1; strength 0;", 1))), 0);
}


TEST(localisedMomentumSource, neighboursAddUpToAUniformOne)
{
    halfFull w;
    const vectorField f(w.push("place 0.75;", 1) + w.push("place 1.25;", 1));
    forAll(f, cell)
    {
        const point& c = w.box.mesh().C()[cell];
        if (c.z() < 0.5 && c.x() > 0.75 && c.x() < 1.25)
        {
            EXPECT_NEAR(f[cell].x(), -24, 1e-12);
        }
    }
}


TEST(localisedMomentumSource, givesItsImpulseToTheWaterAndNoneToTheAir)
{
    // From 0.1 s to 1 s, strongest at 0.4 s: of even rise and fall the steps
    // have the exact sum
    constexpr scalar impulse = -30*(0.3 + 0.6)/2;
    halfFull w;
    const vectorField U
    (
        w.moved
        (
            "type localisedMomentumSource; direction (2 0 0); force -30;"
            " place 1; reach (0.5 1); time 0.4; lasting (0.3 0.6);",
            vector(0.2, 0.1, 0),
            0.05,
            30
        )
    );
    forAll(U, cell)
    {
        const point& c = w.box.mesh().C()[cell];
        const scalar share =
            c.z() > 0.5 ? 0 : c.x() < 1 ? max(2*c.x() - 1, 0.0) : 2 - c.x();
        const vector exact(0.2 + share*impulse/1000, 0.1, 0);
        EXPECT_LT(mag(U[cell] - exact), 1e-12) << c.x() << ' ' << c.z();
    }
}


TEST(localisedMomentumSource, outsideTheMeshOrWithoutReachIsRefused)
{
    halfFull w;
    EXPECT_THROW(w.push("place 7;", 1), Foam::error);
    EXPECT_THROW(w.push("place 1; reach (0 1);", 1), Foam::error);
    EXPECT_THROW(w.push("place 1; width 1;", 1), Foam::error);
}


TEST(sideWallFriction, isPoiseuilleAtRestAndDarcyWeisbachInHaste)
{
    testMesh box;
    const fv::sideWallFriction walls
    (
        "walls", "sideWallFriction",
        entries("type sideWallFriction; width 0.1; friction 0.024;"), box.mesh()
    );

    EXPECT_TRUE
    (
        isFile(box.time().globalPath()/"postProcessing/activePhysics/0/walls")
    );

    // Plane Poiseuille flow: dp/dx = 12 mu U/W^2
    EXPECT_NEAR(walls.rate(1e-6, 0), 12e-6/0.01, 1e-15);

    // Two walls with f rho U^2/8 on W
    const scalar U = 3;
    const scalar turbulent = 2*0.024/8*sqr(U)/0.1/U;
    EXPECT_NEAR(walls.rate(0, U), turbulent, 1e-12);

    const fv::sideWallFriction none
    (
        "walls", "sideWallFriction",
        entries("type sideWallFriction; width 0.1; strength 0;"), box.mesh()
    );
    EXPECT_EQ(none.rate(1e-6, U), 0);
}


TEST(sideWallFriction, slowsAFlowAsItsLawsIntegrated)
{
    const vector U0(0.3, -0.4, 0);
    constexpr scalar deltaT = 0.1;
    constexpr label n = 50;
    constexpr scalar W = 0.1;
    constexpr scalar f = 0.024;
    constexpr scalar nuWater = 1e-4;
    constexpr scalar nuAir = 3e-4;

    halfFull turbulent;
    const autoPtr<volScalarField> none
    (
        turbulent.field("nu", dimViscosity)
    );

    // dU/dt = -f U^2/(4 W), of which each step makes the exact
    // 1/U = 1/U0 + f t/(4 W)
    const vector darcyWeisbach
    (
        U0/(1 + mag(U0)*f*n*deltaT/(4*W))
    );
    for
    (
        const vector& U :
        turbulent.moved
        (
            "type sideWallFriction; width 0.1; friction 0.024;", U0, deltaT, n
        )
    )
    {
        EXPECT_LT(mag(U - darcyWeisbach), 1e-12);
    }

    // dU/dt = -12 nu U/W^2, implicit
    halfFull laminar;
    autoPtr<volScalarField> nu(laminar.field("nu", dimViscosity));
    nu->primitiveFieldRef() =
        *laminar.alpha*nuWater + (1 - *laminar.alpha)*nuAir;
    const vectorField U
    (
        laminar.moved
        (
            "type sideWallFriction; width 0.1; friction 0; strength 0.5;",
            U0, deltaT, n
        )
    );
    forAll(U, cell)
    {
        const scalar rate = 0.5*12*(*nu)[cell]/sqr(W);
        const vector exact(U0*Foam::pow(1 + rate*deltaT, -scalar(n)));
        EXPECT_LT(mag(U[cell] - exact), 1e-12);
    }
}


TEST(permeableWall, letsOutWhatThePressureDrives)
{
    permeableBase base;
    permeableWallFvPatchVectorField wall(base.wall());

    // Superficial 2e-6 (600 - 100), between the grains more
    base.settle(wall, 600);
    const vectorField n(wall.patch().nf());
    for (const scalar out : scalarField(wall & n))
    {
        EXPECT_NEAR(out, 1e-3/0.8, 1e-12);
    }

    // Nothing comes in
    base.settle(wall, 50);
    EXPECT_LT(max(mag(wall)), 1e-12);
}


TEST(permeableWall, isTightWithoutStrengthAndRefusesAnUnknownKeyword)
{
    const permeableBase base;
    EXPECT_EQ(base.wall("strength 0;").outflow(1e5), 0);
    EXPECT_GT(base.wall("strength 1;").outflow(1e5), 0);
    EXPECT_THROW(base.wall("strenght 0;"), Foam::error);
}


TEST(fluidSources, formerNamesAreErrorsThatNameThePresentOnes)
{
    testMesh box;
    const fvMesh& mesh = box.mesh();
    const volVectorField U
    (
        IOobject("U", "0", mesh), mesh, dimensionedVector(dimVelocity, Zero)
    );

    EXPECT_NE
    (
        refusal
        (
            [&]
            {
                fv::optionList
                (
                    mesh,
                    entries("push { type locatedPush; force -30; place 1; }")
                );
            }
        ).find("Write localisedMomentumSource"),
        std::string::npos
    );
    EXPECT_NE
    (
        refusal
        (
            [&]
            {
                fvPatchVectorField::New
                (
                    mesh.boundary()[4],
                    U.internalField(),
                    entries("type leakyWall; conductance 2e-6;")
                );
            }
        ).find("Write permeableWall"),
        std::string::npos
    );
}
