// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects that sample the grains: front, bed, load, stress.

#include "bedErosion.H"
#include "collisionLoad.H"
#include "grainStress.H"
#include "surgeFront.H"
#include "tank.H"

#include "unitConversion.H"

#include <vector>

using namespace Foam;
using Foam::functionObjects::flumeFunctionObject;


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


TEST_F(tank, aFrontAlongGravityHasNoFroudeNumber)
{
    const string flume("stripWidth 0.1; headLength 0.3; grainThreshold 1e-4;");
    functionObjects::surgeFront across
    (
        "across", box_.time(), dict(flume + " normal (0 1 0);")
    );
    across.execute();
    across.write();

    const scalarList line(lastLine("across", "surgeFront"));
    ASSERT_EQ(line.size(), 12);
    EXPECT_GT(line[10], 0);
    EXPECT_EQ(line[11], 0);
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
        ASSERT_EQ(line.size(), 16);
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
    ASSERT_EQ(summary.size(), 10);
    EXPECT_NEAR(summary[1], V/2/0.5, 1e-8);
}


TEST_F(tank, theMeanVelocityOfTheWholeBedIsByMassAndOverNetErosionAlsoOfARunThatGoesOn)
{
    const string entries
    (
        "bedTypes (1); depthRange (0.2 0.4); rateRange (0.2 0.4);"
        " xStart 0; packing 0.5; planWidth 0.1; onset 1e-5;"
    );
    box_.time().setDeltaT(0.1, false);

    // Half of the grains weigh thrice as much as the others and move; from the second
    // look on the bed is eroded, without end
    forAll(grains_.grains.mass, i)
    {
        grains_.grains.mass[i] = i % 2 ? 1.5 : 0.5;
    }
    const auto sample =
        [&](functionObjects::bedErosion& bed, const scalar U, const scalar d3)
    {
        forAll(grains_.grains.U, i)
        {
            grains_.grains.U[i] = vector(i % 2 ? U : 0, 1, 0);
        }
        grains_.grains.d *= Foam::cbrt(d3);
        ++box_.time();
        bed.execute();
        bed.write();
    };

    {
        functionObjects::bedErosion bed("bed", box_.time(), dict(entries));
        sample(bed, 40, 1);
        EXPECT_NEAR(lastLine("bed", "bedErosion")[15], 30, 1e-6);
        sample(bed, 4, 0.8);
        sample(bed, 8, 0.8);
        ASSERT_EQ(lastLine("bed", "summary").size(), 10);
        EXPECT_NEAR(lastLine("bed", "summary")[9], 4.5, 1e-6);

        ASSERT_TRUE
        (
            compatibility::writeObject
            (
                box_.time().lookupObject<regIOobject>("bedSeries"),
                IOstream::ASCII,
                IOstream::UNCOMPRESSED
            )
        );
    }

    functionObjects::bedErosion again("bed", box_.time(), dict(entries));
    sample(again, 12, 0.8);
    EXPECT_NEAR(lastLine("bed", "summary_0")[9], 6, 1e-6);
}


TEST_F(tank, aBedBesideTheMeshIsAnError)
{
    placeLattice(50);
    for (point& p : grains_.grains.position)
    {
        p.x() += 1000;
    }
    EXPECT_THROW
    (
        functionObjects::bedErosion("bed", box_.time(), dict("bedTypes (1);"))
            .execute(),
        Foam::error
    );
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


TEST_F(tank, whatIsWrittenBetweenTwoLooksIsOfItsOwnTime)
{
    functionObjects::surgeFront front
    (
        "front", box_.time(), dict("stripWidth 0.1;")
    );
    functionObjects::collisionLoad load
    (
        "load", box_.time(), dict("types (1); range (0 2); window (0 9);")
    );
    functionObjects::bedErosion bed
    (
        "bed", box_.time(),
        dict
        (
            "bedTypes (1); depthRange (0.2 0.4); rateRange (0.2 0.4);"
            " xStart 0; packing 0.5;"
        )
    );
    const std::vector<flumeFunctionObject*> all{&front, &load, &bed};

    ++box_.time();
    for (auto* object : all)
    {
        object->execute();
    }

    // executeInterval leaves out the second step, writeInterval does not
    ++box_.time();
    grains_.grains.position *= 0.5;
    grains_.grains.contactForce *= 2;
    for (auto* object : all)
    {
        object->write();
    }

    const scalar V = 100*constant::mathematical::pi*pow3(0.02)/6;
    EXPECT_NEAR(lastLine("front", "surgeFront")[3], 0.475, 1e-6);
    EXPECT_NEAR(lastLine("load", "collisionLoad")[1], 10, 1e-6);
    EXPECT_NEAR(lastLine("bed", "bedErosion")[1], -V/0.5, 0.05*V/0.5);
}


TEST_F(tank, whatIsKeptForARestartIsGatheredWhereATimeIsWrittenNotAtEachLook)
{
    functionObjects::surgeFront front
    (
        "front", box_.time(), dict("stripWidth 0.1;")
    );
    const auto state = [&]()
    {
        OStringStream os;
        os << box_.time().lookupObject<IOdictionary>("functionObjectProperties");
        return os.str();
    };
    // No number of few digits
    box_.time().setDeltaT(1.0/3);
    const auto sample = [&]()
    {
        ++box_.time();
        front.execute();
        return box_.time().value();
    };

    scalarList times({sample(), sample()});
    const auto before = state().size();
    for (label n = 0; n < 50; ++n)
    {
        times.append(sample());
    }
    EXPECT_LE(state().size(), before + 20);

    // In a case that writes binary files too
    const auto& series = box_.time().lookupObject<regIOobject>("frontSeries");
    ASSERT_TRUE
    (
        compatibility::writeObject
        (
            series,
            IOstream::BINARY,
            IOstream::UNCOMPRESSED
        )
    );
    const IOdictionary kept
    (
        IOobject
        (
            "frontSeries",
            box_.time().timeName(),
            "uniform/functionObjects",
            box_.time(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    EXPECT_EQ(kept.subDict("position").get<scalarList>("times"), times);
    EXPECT_EQ(kept.subDict("depth").get<scalarList>("values").size(), 52);
}
