// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects that sample the water: pore pressure, stress, balance.

#include "basalStress.H"
#include "massBalance.H"
#include "porePressureProbes.H"
#include "tank.H"
#include "terminalOutput.H"

#include "unitConversion.H"

using namespace Foam;

namespace
{

//- The tank with the pressure of water at rest up to z = 1/2, in cells of 1/4 m
class tankAtRest
:
    public tank
{
protected:

    static scalar pressure(const point& at)
    {
        return 1000*9.81*max(0.5 - at.z(), scalar(0));
    }

    void SetUp() override
    {
        forAll(p_, cell)
        {
            p_[cell] = pressure(box_.mesh().C()[cell]);
        }
        forAll(p_.boundaryField(), patch)
        {
            const vectorField& at = box_.mesh().Cf().boundaryField()[patch];
            forAll(at, face)
            {
                p_.boundaryFieldRef()[patch][face] = pressure(at[face]);
            }
        }
    }

    //- A place on a wall of the unit cube
    static point onWall(const word& wall, const scalar across, const scalar z)
    {
        const scalar end = wall.substr(1) == "Max";
        return wall[0] == 'x' ? point(end, across, z) : point(across, end, z);
    }

    //- The line of a probe there, with a level of its water
    scalarList probed(const word& wall, const point& at, const word& level)
    {
        std::ostringstream place;
        place << at.x() << ' ' << at.y() << ' ' << at.z();
        const word name(wall + level + string(place.str()).replaceAll(" ", "_"));
        functionObjects::porePressureProbes probes
        (
            name,
            box_.time(),
            dict
            (
                "probes ((" + place.str() + ")); patch " + wall + "; radius 0.2;"
                " writePrecision 12; hydrostatic " + level + ";"
            )
        );
        probes.execute();
        probes.write();
        return lastLine(name, "porePressureProbes");
    }
};

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


TEST_F(tank, aLineOfProbesMayBeTheMeanOfItsSamples)
{
    const string settings("probes ((0.45 0.45 0)); patch zMin; radius 0.31;");
    functionObjects::porePressureProbes present
    (
        "present", box_.time(), dict(settings)
    );
    functionObjects::porePressureProbes mean
    (
        "mean", box_.time(), dict(settings + " average yes;")
    );
    const auto sampleAt = [&](const scalar pressure)
    {
        ++box_.time();
        p_ = dimensionedScalar("p", p_.dimensions(), pressure);
        p_.correctBoundaryConditions();
        for (fvPatchScalarField& wall : p_.boundaryFieldRef())
        {
            wall == pressure;
        }
        present.execute();
        mean.execute();
    };
    const auto pressures = [&]()
    {
        present.write();
        mean.write();
        return Pair<scalar>
        (
            lastLine("present", "porePressureProbes")[1],
            lastLine("mean", "porePressureProbes")[1]
        );
    };

    for (const scalar pressure : {1000, 3000, 5000})
    {
        sampleAt(pressure);
    }
    const Pair<scalar> first(pressures());
    EXPECT_NEAR(first.first(), 5000, 1e-6);
    EXPECT_NEAR(first.second(), 3000, 1e-6);

    // Written again without a new sample, and with one: the sums begin again
    EXPECT_EQ(pressures(), first);
    sampleAt(7000);
    EXPECT_NEAR(pressures().second(), 7000, 1e-6);

    const scalarList summary(lastLine("mean", "summary"));
    EXPECT_NEAR(summary[1], 7000, 1e-6);
}


TEST_F(tankAtRest, hasNoExcessPressureOnAnyWall)
{
    for (const word wall : {"xMin", "xMax", "yMin", "yMax"})
    {
        // Amid a face, off its middle, on the edge of two and the corner of four
        for (const scalar z : {0.375, 0.3, 0.25})
        for (const scalar across : {0.375, 0.43, 0.5})
        {
            const point at(onWall(wall, across, z));
            const std::string place
            (
                wall + " at height " + Foam::name(z) + ", " + Foam::name(across)
            );
            const scalarList upwards(probed(wall, at, "vertical"));
            ASSERT_EQ(upwards.size(), 7);
            EXPECT_NEAR(upwards[1], pressure(at), 1e-6) << place;
            EXPECT_NEAR(upwards[3], 0, 1e-6) << place;
            EXPECT_NEAR(upwards[4], 0.5 - z, 1e-9) << place;

            // Through the whole tank, once
            EXPECT_NEAR(probed(wall, at, "normal")[4], 1, 1e-9) << place;
        }
    }
}


TEST_F(tank, aProbeBetweenTwoColumnsOfWaterIsInOneOfThem)
{
    // Water 0.5 m deep on one side of x = 1/2, and 0.25 m on the other
    const auto depthAt = [](const scalar x) { return x < 0.5 ? 0.5 : 0.25; };
    forAll(alpha_, cell)
    {
        const point& at = box_.mesh().C()[cell];
        alpha_[cell] = at.z() < depthAt(at.x()) ? 1 : 0;
    }
    const label base = box_.mesh().boundaryMesh().findPatchID("zMin");
    const vectorField& at = box_.mesh().Cf().boundaryField()[base];
    forAll(at, face)
    {
        p_.boundaryFieldRef()[base][face] = 1000*9.81*depthAt(at[face].x());
    }

    functionObjects::porePressureProbes probes
    (
        "between",
        box_.time(),
        dict("probes ((0.5 0.45 0) (0.5 0.5 0)); patch zMin; writePrecision 12;")
    );
    probes.execute();
    probes.write();

    const scalarList line(lastLine("between", "porePressureProbes"));
    ASSERT_EQ(line.size(), 13);
    EXPECT_NEAR(line[3], 0, 1e-6);
    EXPECT_NEAR(line[9], 0, 1e-6);
}


TEST_F(tank, withoutFluidTheGrainsAlonePressOnTheBase)
{
    OFstream(box_.folder()/"constant"/"granularProperties")()
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object granularProperties; }\nfluid none;\n";
    p_.checkOut();
    alpha_.checkOut();

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
    const scalar area = constant::mathematical::pi*sqr(0.31);
    EXPECT_NEAR(line[5], 29*2/area, 0.01*29*2/area);
    for (const label column : {1, 2, 3, 4, 6})
    {
        EXPECT_EQ(line[column], 0);
    }
}


TEST_F(tank, withoutGravityAVerticalLevelIsAnErrorAndANormalOneNot)
{
    gravity(vector::zero);

    const auto probes = [&](const string& level)
    {
        functionObjects::porePressureProbes
        (
            "probes",
            box_.time(),
            dict("probes ((0.45 0.45 0)); patch zMin; hydrostatic " + level)
        );
    };
    EXPECT_THROW(probes("vertical;"), Foam::IOerror);
    EXPECT_NO_THROW(probes("normal;"));
}


TEST_F(tank, aLayerAlongASlopeHasNoExcessPressureInALayersMeasure)
{
    const scalar slope = degToRad(22.0);
    gravity(9.81*vector(std::sin(slope), 0, -std::cos(slope)));

    // Water 0.5 m deep, measured normal to the base, that flows along it
    const scalar p = 1000*9.81*std::cos(slope)*0.5;
    p_.boundaryFieldRef() = p;

    const auto hydrostatic = [&](const word& how)
    {
        functionObjects::porePressureProbes probes
        (
            how,
            box_.time(),
            dict
            (
                "probes ((0.45 0.45 0)); patch zMin; radius 0.31;"
                " writePrecision 12; excessPressure 0.5; hydrostatic " + how
              + ";"
            )
        );
        probes.execute();
        probes.write();

        // Half of the excess pressure is shown
        const scalarList line(lastLine(how, "porePressureProbes"));
        EXPECT_NEAR(line[3], (p - line[2])/2, 1e-2) << how;
        EXPECT_NEAR(line[1], line[2] + line[3], 1e-2) << how;
        return line[2];
    };
    EXPECT_NEAR(hydrostatic("layer")/p, 1, 1e-6);
    EXPECT_NEAR(p/hydrostatic("normal"), std::cos(slope), 1e-6);
    EXPECT_NEAR(p/hydrostatic("vertical"), sqr(std::cos(slope)), 1e-6);
}


TEST_F(tank, aPressureWrittenBetweenTwoLooksIsOfItsOwnTime)
{
    functionObjects::porePressureProbes probes
    (
        "probes", box_.time(), dict("probes ((0.45 0.45 0)); patch zMin;")
    );
    probes.execute();

    ++box_.time();
    p_.boundaryFieldRef() *= 0.5;
    probes.write();

    const scalarList line(lastLine("probes", "porePressureProbes"));
    ASSERT_EQ(line.size(), 7);
    EXPECT_NEAR(line[0], box_.time().value(), 1e-12);
    EXPECT_NEAR(line[1], 4905/2.0, 1e-3);
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


TEST_F(tank, waterThatComesToGrainsThatWereAloneIsThatOfTheStart)
{
    const volScalarField water(alpha_);
    alpha_ = dimensionedScalar(dimless, Zero);
    {
        functionObjects::massBalance alone("balance", box_.time(), dict(""));
        ++box_.time();
        alone.execute();
        alone.write();
    }

    alpha_ = water;
    functionObjects::massBalance balance("balance", box_.time(), dict(""));
    ++box_.time();
    balance.execute();
    balance.write();
    EXPECT_NEAR(lastLine("balance", "massBalance")[3], 0, 1e-14);
}


TEST_F(tank, aStepThatTheWaterBalanceMissesIsAnError)
{
    functionObjects::massBalance balance("balance", box_.time(), dict(""));
    ++box_.time();
    balance.execute();
    ++box_.time();
    ++box_.time();
    const std::string message = refusal([&]() { balance.execute(); });
    expectHolds(message, "was not executed in 1 steps");
    expectHolds(message, "executeControl timeStep with executeInterval 1");
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
