// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects on a mesh, live and on written grains.

#include "basalStress.H"
#include "bedErosion.H"
#include "collisionLoad.H"
#include "grainStress.H"
#include "massBalance.H"
#include "porePressureProbes.H"
#include "sideView.H"
#include "standingGrains.H"
#include "surgeFront.H"
#include "testMesh.H"

#include "IFstream.H"
#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "mathematicalConstants.H"
#include "surfaceFields.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

//- A level tank of 1 m, half full of water, with a few grains in it
class tank
:
    public testing::Test
{
protected:

    testMesh box_;

    volScalarField alpha_;

    volScalarField voidFraction_;

    volScalarField p_;

    surfaceScalarField alphaPhi_;

    standingGrains grains_;

    volScalarField field(const word& name, const scalar value)
    {
        return volScalarField
        (
            IOobject(name, box_.time().timeName(), box_.mesh()),
            box_.mesh(),
            dimensionedScalar(dimless, Zero) + value
        );
    }

    tank()
    :
        alpha_(field("alpha.water", 0)),
        voidFraction_(field("voidFraction", 0.8)),
        p_(field("p", 4905)),
        alphaPhi_
        (
            IOobject("alphaPhi", box_.time().timeName(), box_.mesh()),
            box_.mesh(),
            dimensionedScalar(dimVolume/dimTime, Zero)
        ),
        grains_(box_.mesh())
    {
        mkDir(box_.folder()/"constant");
        OFstream(box_.folder()/"constant"/"g")()
            << "FoamFile { version 2.0; format ascii;"
            << " class uniformDimensionedVectorField; object g; }\n"
            << "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n";

        forAll(alpha_, i)
        {
            alpha_[i] = box_.mesh().C()[i].z() < 0.5 ? 1 : 0;
        }

        placeGrains();
    }

    //- A hundred grains of 20 mm at rest on the base, at z = 10 mm
    void placeGrains()
    {
        grainSnapshot& g = grains_.grains;
        g = grainSnapshot(100);
        grains_.radii.setSize(100, 0.01);
        vectorField wall(100, vector(0, 0, 2));

        forAll(g.id, i)
        {
            g.id[i] = i;
            g.type[i] = 1;
            g.d[i] = 0.02;
            g.mass[i] = 0.5;
            g.position[i] =
                vector(0.05 + 0.1*(i % 10), 0.05 + 0.1*(i/10), 0.01);
            g.contactForce[i] = vector(3, 0, 4);
            g.stressMoment[i] = symmTensor(-1, 0, 0, -1, 0, -1);
        }
        g.wallForce.insert("zMin", wall);
    }

    //- Grains of 20 mm in a cubic lattice from x = 0 to n*20 mm, over the
    //  width of the tank, five layers from the base up
    void placeLattice(const label n)
    {
        constexpr scalar d = 0.02;
        grainSnapshot& g = grains_.grains;
        g = grainSnapshot(n*50*5);
        grains_.radii = scalarField(g.size(), d/2);
        g.d = d;
        g.type = 1;

        forAll(g.position, i)
        {
            g.position[i] =
                d*vector(i % n + 0.5, i/n % 50 + 0.5, i/n/50 + 0.5);
        }
    }

    dictionary dict(const string& entries) const
    {
        return dictionary(IStringStream(entries + " rhoWater 1000; log no;")());
    }

    //- Rows of numbers of a file of the start time
    List<scalarList> table(const word& object, const word& file) const
    {
        std::ifstream is
        (
            box_.folder()/"postProcessing"/object/"0"/(file + ".dat")
        );
        DynamicList<scalarList> rows;

        for (std::string line; std::getline(is, line);)
        {
            if (line.empty() || line[0] == '#')
            {
                continue;
            }

            DynamicList<scalar> numbers;
            std::istringstream words(line);
            for (double x; words >> x;)
            {
                numbers.append(x);
            }
            rows.append(scalarList(std::move(numbers)));
        }
        return List<scalarList>(std::move(rows));
    }

    //- Numbers of the last line of a file of the start time
    scalarList lastLine(const word& object, const word& file) const
    {
        const List<scalarList> rows(table(object, file));
        return rows.empty() ? scalarList() : rows.last();
    }
};


void expectRow(const scalarList& row, const scalarList& expected)
{
    ASSERT_EQ(row.size(), expected.size());
    forAll(row, i)
    {
        EXPECT_NEAR(row[i], expected[i], 1e-6) << "column " << i;
    }
}

} // End anonymous namespace


TEST_F(tank, waterAtRestHasNoExcessPressure)
{
    functionObjects::porePressureProbes probes
    (
        "probes",
        box_.time(),
        dict("probes ((0.45 0.45 0)); patch zMin; radius 0.31;")
    );
    probes.execute();
    probes.write();

    const scalarList line(lastLine("probes", "porePressureProbes"));
    ASSERT_EQ(line.size(), 7);
    EXPECT_NEAR(line[1], 4905, 1e-3);
    EXPECT_NEAR(line[2], 1000*9.81*0.5, 1e-3);
    EXPECT_NEAR(line[3], 0, 1e-2);
    EXPECT_NEAR(line[4], 0.5, 1e-6);

    // 29 grains press with 2 N each on the disc
    const scalar area = constant::mathematical::pi*sqr(0.31);
    EXPECT_NEAR(line[5] - 4905, 29*2/area, 0.01*29*2/area);
    EXPECT_NEAR(line[6], 4905/line[5], 1e-5);
}


TEST_F(tank, aProbeFarFromThePatchIsAnError)
{
    EXPECT_THROW
    (
        functionObjects::porePressureProbes
        (
            "probes",
            box_.time(),
            dict("probes ((0.4 0.4 0.5)); patch zMin;")
        ),
        Foam::IOerror
    );
    EXPECT_THROW
    (
        functionObjects::porePressureProbes
        (
            "probes", box_.time(), dict("probes ((0 0 0)); patch floor;")
        ),
        Foam::IOerror
    );
}


TEST_F(tank, outflowIsCountedInTheWaterBalance)
{
    functionObjects::massBalance balance("balance", box_.time(), dict(""));

    // Per step 0.01 s: 0.2 m3/s leave through each of the faces of zMin
    const label base = box_.mesh().boundaryMesh().findPatchID("zMin");
    alphaPhi_.boundaryFieldRef()[base] = 0.2;
    box_.time().setDeltaT(0.01, false);

    const scalar out = 16*0.2*0.01;
    for (label step = 0; step < 3; ++step)
    {
        ++box_.time();
        alpha_ -= dimensionedScalar(dimless, Zero) + out/0.8;
        grains_.left += 2;
        balance.execute();
    }
    balance.write();

    const scalarList line(lastLine("balance", "massBalance"));
    ASSERT_EQ(line.size(), 9);
    EXPECT_NEAR(line[2], 3*out, 1e-6);
    EXPECT_NEAR(line[3], 0, 1e-14);
    EXPECT_EQ(line[7], 6);

    // No grain is gone from the list, so six are too many
    EXPECT_EQ(line[8], -6);
}


TEST_F(tank, aStepThatTheWaterBalanceMissesIsAnError)
{
    functionObjects::massBalance balance("balance", box_.time(), dict(""));
    ++box_.time();
    balance.execute();
    ++box_.time();
    ++box_.time();
    EXPECT_THROW(balance.execute(), Foam::error);
}


TEST_F(tank, oneSnapshotServesAllFunctionObjectsOfATime)
{
    functionObjects::surgeFront front("front", box_.time(), dict(""));
    functionObjects::collisionLoad load
    (
        "load",
        box_.time(),
        dict("types (1); range (0 1); window (0 1); surgeFront front;")
    );

    ++box_.time();
    front.execute();
    load.execute();
    front.write();
    load.write();
    EXPECT_EQ(grains_.nSnapshots, 1);

    ++box_.time();
    load.execute();
    EXPECT_EQ(grains_.nSnapshots, 2);
}


TEST_F(tank, thePointLoadIsTheMeanMagnitudeOfForce)
{
    functionObjects::collisionLoad load
    (
        "load",
        box_.time(),
        dict("types (1); range (0.2 0.4); window (0 1);")
    );
    load.execute();
    load.write();

    const scalarList line(lastLine("load", "collisionLoad"));
    ASSERT_EQ(line.size(), 6);
    EXPECT_NEAR(line[1], 5, 1e-6);
    EXPECT_EQ(line[3], 20);
    EXPECT_NEAR(lastLine("load", "summary")[1], 5, 1e-6);
}


TEST_F(tank, theGrainsThatPassHaveTheirVelocityAndHeight)
{
    forAll(grains_.grains.U, i)
    {
        grains_.grains.U[i] = vector(grains_.grains.position[i].x(), 0, 1);
    }

    functionObjects::collisionLoad load
    (
        "load",
        box_.time(),
        dict("types (1); range (0.2 0.4); window (0 1);")
    );
    load.execute();
    load.write();

    const scalarList first(lastLine("load", "collisionLoad"));

    // Those beyond the range do not count. At the next look they are slower, half
    // of them have gone by, and the others fly at two heights
    forAll(grains_.grains.U, i)
    {
        vector& p = grains_.grains.position[i];
        grains_.grains.U[i].x() *= 0.5;
        if (i/10 % 2)
        {
            p.x() = 0.9;
        }
        p.z() = i/10 % 4 ? 0.01 : 0.11;
    }
    ++box_.time();
    load.execute();
    load.write();

    const scalarList line(lastLine("load", "collisionLoad"));
    const scalarList summary(lastLine("load", "summary"));
    EXPECT_NEAR(line[4], 0.15, 1e-6);
    EXPECT_NEAR(first[5], 0.016, 0.002);
    EXPECT_NEAR(line[5], 0.13, 0.01);

    // Twenty grains, then ten
    EXPECT_EQ(line[3], 10);
    EXPECT_NEAR(summary[6], (20*0.3 + 10*0.15)/30, 1e-6);
    EXPECT_NEAR(summary[7], (20*first[5] + 10*line[5])/30, 1e-6);
}


TEST_F(tank, aMovingFrontHasItsVelocityAndFroudeNumber)
{
    functionObjects::surgeFront front
    (
        "front",
        box_.time(),
        dict("stripWidth 0.1; headLength 0.3; grainThreshold 1e-4;")
    );

    grains_.grains.position *= 0.5;
    box_.time().setDeltaT(0.01, false);
    for (label step = 0; step < 5; ++step)
    {
        ++box_.time();
        for (vector& p : grains_.grains.position)
        {
            p.x() += 0.1;
        }
        front.execute();
    }
    front.write();

    const scalarList line(lastLine("front", "surgeFront"));
    ASSERT_EQ(line.size(), 12);
    EXPECT_NEAR(line[6], 10, 1e-3);
    EXPECT_NEAR(line[11], line[6]/Foam::sqrt(9.81*line[10]), 1e-3);
}


TEST_F(tank, theFrontAndThicknessOfALatticeInWaterAreItsOwn)
{
    // Water 0.1 m deep as far as x = 0.5, of half that as far as 0.75
    forAll(alpha_, i)
    {
        const point& c = box_.mesh().C()[i];
        alpha_[i] =
            c.z() > 0.25 || c.x() > 0.75 ? 0 : c.x() < 0.5 ? 0.4 : 0.2;
    }
    const scalar deep = 0.8*0.1;

    functionObjects::surgeFront front
    (
        "front",
        box_.time(),
        dict("stripWidth 0.05; headLength 0.3; thickness mixture;")
    );

    // It ends where a strip does
    placeLattice(30);
    ++box_.time();
    front.execute();
    front.write();
    const scalarList even(lastLine("front", "surgeFront"));
    ASSERT_EQ(even.size(), 12);
    EXPECT_NEAR(even[1], 0.6, 1e-6);
    EXPECT_NEAR(even[2], 0.99*0.6, 1e-6);
    EXPECT_NEAR(even[3], 0.59, 1e-6);
    EXPECT_NEAR(even[4], 0.75, 1e-6);
    EXPECT_NEAR(even[5], 0.6, 1e-6);

    // A quarter of the lowest and of the highest layer is left out: of a sphere
    // of radius 1 it lies up to x with x^3 - 3 x^2 + 1 = 0
    const scalar x = 1 - 2*Foam::cos(degToRad(80));
    ASSERT_NEAR(pow3(x) - 3*sqr(x) + 1, 0, 1e-12);
    EXPECT_NEAR(even[7], (0.1 - 2*0.01*x)/0.9, 5e-5);

    // From x = 0.3 to 0.6
    const scalar water = deep*(2 + 0.5)/3;
    const scalar solid = 0.1*constant::mathematical::pi/6;
    EXPECT_NEAR(even[8], water, 1e-6);
    EXPECT_NEAR(even[9], water + solid, 1e-6);
    EXPECT_NEAR(even[10], even[9], 1e-6);

    // Within a strip
    placeLattice(29);
    ++box_.time();
    front.execute();
    front.write();
    const scalarList within(lastLine("front", "surgeFront"));
    EXPECT_NEAR(within[1], 0.58, 1e-6);
    EXPECT_NEAR(within[3], 0.57, 1e-6);
    EXPECT_NEAR(within[4], 0.75, 1e-6);
    EXPECT_NEAR(within[8], deep*(0.22 + 0.5*0.08)/0.3, 1e-6);
}


TEST_F(tank, aCouetteFlowDragsItsWallsAlong)
{
    constexpr scalar shear = 20;
    OFstream(box_.folder()/"constant"/"transportProperties")()
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object transportProperties; }\n"
        << "phases (water air); water { nu 2e-6; rho 1000; }"
        << " air { nu 1.5e-5; rho 1; }\n";

    // Along x and y, faster with z
    const fvMesh& mesh = box_.mesh();
    const vector along(0.6, 0.8, 0);
    volVectorField U
    (
        IOobject("U", box_.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        "fixedValue"
    );
    U.primitiveFieldRef() = shear*along*mesh.C().component(vector::Z)
       ().primitiveField();
    for (fvPatchVectorField& patch : U.boundaryFieldRef())
    {
        patch ==
            shear*along*patch.patch().Cf().component(vector::Z);
    }
    for (scalarField& patch : alpha_.boundaryFieldRef())
    {
        patch = 0.75;
    }

    const scalar mu = 0.75*1000*2e-6 + 0.25*1*1.5e-5;
    const scalar tau = 0.8*mu*shear;

    // The water drags the base along, and holds back the lid
    label n = 0;
    for (const word side : {"zMin", "zMax"})
    {
        for (const vector& to : {vector(1, 0, 0), vector(-1, 2, 0)})
        {
            const word name("stress" + Foam::name(n++));
            dictionary settings(dict("patches (" + side + "); binWidth 10;"));
            settings.add("direction", to);
            functionObjects::basalStress stress(name, box_.time(), settings);
            stress.write();

            const scalarList line(lastLine(name, "basalStress"));
            ASSERT_EQ(line.size(), 9);
            const scalar expected =
                (side == "zMin" ? tau : -tau)*(along & to)/mag(to);
            EXPECT_NEAR(line[6]/expected, 1, 1e-5) << side << to.y();
            EXPECT_NEAR(line[8]/expected, 1, 1e-5) << side << to.y();

            // A hundred grains press on 1 m2 of the base, each with 2 N
            const scalar grains = side == "zMin" ? 200 : 0;
            EXPECT_NEAR(line[2], 1, 1e-9);
            EXPECT_NEAR(line[3], grains, 1e-3);
            EXPECT_NEAR(line[4], 0, 1e-9);
            EXPECT_NEAR(line[5], 4905, 1e-3);
            EXPECT_NEAR(line[7], grains + 4905, 1e-2);
        }
    }
}


TEST_F(tank, grainsTakenAwayAreErosionAgainstTheStart)
{
    const string entries
    (
        "bedTypes (1); depthRange (0.2 0.4); rateRange (0.2 0.4);"
        " xStart 0; packing 0.5; planWidth 0.1;"
    );
    const scalar V = 100*constant::mathematical::pi*pow3(0.02)/6;

    {
        functionObjects::bedErosion erosion("bed", box_.time(), dict(entries));
        grains_.grains.d /= Foam::cbrt(2.0);
        ++box_.time();
        erosion.execute();
        erosion.write();

        const scalarList line(lastLine("bed", "bedErosion"));
        ASSERT_EQ(line.size(), 15);
        EXPECT_NEAR(line[1], V/2/0.5, 1e-8);
        EXPECT_NEAR(line[13], V/2, 1e-8);
        EXPECT_EQ(line[14], 0);

        // What is not there any more has left at the end of the flume
        EXPECT_NEAR(line[6], 1, 0.02);
    }

    // A run that goes on measures against the same start
    functionObjects::bedErosion again("bed", box_.time(), dict(entries));
    ++box_.time();
    again.execute();
    again.write();
    const scalarList summary(lastLine("bed", "summary_0"));
    ASSERT_EQ(summary.size(), 9);
    EXPECT_NEAR(summary[1], V/2/0.5, 1e-8);
}


TEST_F(tank, aBedWithoutGrainsIsAnError)
{
    EXPECT_THROW
    (
        functionObjects::bedErosion("bed", box_.time(), dict("bedTypes (7);")),
        Foam::error
    );
    EXPECT_THROW
    (
        functionObjects::bedErosion("bed", box_.time(), dict("")),
        Foam::IOerror
    );
}


TEST_F(tank, meanStressIsTheSumOfMomentsOverTheVolume)
{
    functionObjects::grainStress stress
    (
        "stress",
        box_.time(),
        dict("boxes (((0 0 0) (0.5 1 0.1)));")
    );
    stress.write();

    const scalarList line(lastLine("stress", "grainStress"));
    ASSERT_EQ(line.size(), 11);
    EXPECT_EQ(line[1], 50);
    EXPECT_NEAR(line[3], -50/0.05, 1e-3);
    EXPECT_NEAR(line[9], 50/0.05, 1e-3);
    EXPECT_NEAR(line[10], 0, 1e-9);
}


TEST_F(tank, theTablesForPicturesHoldEveryGrainAndCell)
{
    volVectorField U
    (
        IOobject("U", box_.time().timeName(), box_.mesh()),
        box_.mesh(),
        dimensionedVector("U", dimVelocity, vector(0, 3, 4))
    );
    grains_.grains.U = vector(1, 2, 2);
    grains_.grains.type[7] = 2;

    functionObjects::sideView view("view", box_.time(), dict(""));
    view.write();

    const List<scalarList> grains(table("view", "grains"));
    ASSERT_EQ(grains.size(), 100);
    expectRow(grains[7], {0.75, 0.05, 0.01, 0.02, 3, 2});

    const List<scalarList> cells(table("view", "cells"));
    ASSERT_EQ(cells.size(), 64);
    expectRow(cells[0], {0.125, 0.125, 0.125, 0.25, 1, 5});
    expectRow(cells[63], {0.875, 0.875, 0.875, 0.25, 0, 5});
}


TEST_F(tank, aSideViewTakesGrainsNearTheSideInFlumeCoordinates)
{
    volVectorField U
    (
        IOobject("U", box_.time().timeName(), box_.mesh()),
        box_.mesh(),
        dimensionedVector(dimVelocity, Zero)
    );

    // x of the flume along y of the mesh: across it is -x, its side at x = 1
    functionObjects::sideView view
    (
        "view",
        box_.time(),
        dict("nearest 0.2; downslope (0 1 0); origin (0 0.5 0);")
    );
    view.write();

    const List<scalarList> grains(table("view", "grains"));
    ASSERT_EQ(grains.size(), 20);
    expectRow(grains[0], {-0.45, -0.85, 0.01, 0.02, 0, 1});
    for (const scalarList& row : grains)
    {
        EXPECT_LT(row[1], -0.8);
    }

    EXPECT_THROW
    (
        functionObjects::sideView("view", box_.time(), dict("near 0.2;")),
        Foam::IOerror
    );
}
