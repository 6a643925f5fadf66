// SPDX-License-Identifier: GPL-3.0-or-later
// Function objects at barriers: load on walls, run-up, leap over a crest, landing.

#include "overflow.H"
#include "tank.H"
#include "wallLoad.H"

#include "unitConversion.H"

using namespace Foam;

namespace
{

//- The tank with a velocity of air and water
class barrier
:
    public tank
{
protected:

    volVectorField U_;

    barrier()
    :
        U_
        (
            IOobject("U", box_.time().timeName(), box_.mesh()),
            box_.mesh(),
            dimensionedVector(dimVelocity, Zero),
            "zeroGradient"
        )
    {
        OFstream(box_.folder()/"constant"/"transportProperties")()
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object transportProperties; }\n"
            << "phases (water air); water { nu 1e-6; rho 1000; }"
            << " air { nu 1.5e-5; rho 1; }\n";
        box_.time().setDeltaT(0.01, false);
    }

    //- Set a value on all cells and faces
    template<class Type>
    static void fill
    (
        GeometricField<Type, fvPatchField, volMesh>& f,
        const Type& value
    )
    {
        f.primitiveFieldRef() = value;
        for (auto& patch : f.boundaryFieldRef())
        {
            patch == Field<Type>(patch.size(), value);
        }
    }

    //- These grains of 20 mm and 0.5 kg alone, nowhere in contact
    void putGrains(const pointField& at, const vectorField& velocity)
    {
        grainSnapshot& g = grains_.grains;
        g = grainSnapshot(at.size());
        grains_.radii = scalarField(at.size(), 0.01);
        g.d = 0.02;
        g.mass = 0.5;
        g.type = 1;
        g.position = at;
        g.U = velocity;
    }

    scalar volume() const
    {
        return constant::mathematical::pi*pow3(0.02)/6;
    }
};

} // End anonymous namespace


TEST_F(barrier, theLoadOnAWallIsThatOfLiquidAndGrains)
{
    functionObjects::wallLoad load("load", box_.time(), dict("patches (zMin);"));
    ++box_.time();
    load.execute();
    load.write();

    // Out of the mesh, against z; about the origin
    const scalarList line(lastLine("load", "wallLoad"));
    ASSERT_EQ(line.size(), 22);
    EXPECT_NEAR(line[1], 4905, 1e-2);
    EXPECT_NEAR(line[4], -4905, 1e-2);
    EXPECT_NEAR(line[5], -4905*0.5, 1e-2);
    EXPECT_NEAR(line[6], 4905*0.5, 1e-2);

    // A hundred grains with 2 N each around (0.5 0.5)
    EXPECT_NEAR(line[8], 200, 1e-3);
    EXPECT_NEAR(line[12], -200*0.5, 1e-3);
    EXPECT_NEAR(line[13], 200*0.5, 1e-3);
    EXPECT_NEAR(line[15], 5105, 1e-2);
}


TEST_F(barrier, frictionActsWhereAGrainTouchesAFlatWall)
{
    putGrains(pointField(1, point(0.3, 0.4, 0.01)), vectorField(1, Zero));
    grains_.grains.wallForce.set("zMin", vectorField(1, vector(-3, 0, 2)));
    fill(p_, scalar(0));

    functionObjects::wallLoad load("load", box_.time(), dict("patches (zMin);"));
    ++box_.time();
    load.execute();

    // (0.3 0.4 0) x (3 0 -2)
    const scalarList line(lastLine("load", "wallLoad"));
    ASSERT_EQ(line.size(), 22);
    EXPECT_NEAR(line[9], 3, 1e-6);
    EXPECT_NEAR(line[12], -0.8, 1e-6);
    EXPECT_NEAR(line[13], 0.6, 1e-6);
    EXPECT_NEAR(line[14], -1.2, 1e-6);
}


TEST_F(barrier, aLoadHasItsOwnSamplingRatePeakAndImpulse)
{
    functionObjects::wallLoad load
    (
        "load", box_.time(), dict("patches (zMin); samplingRate 50;")
    );

    // Looked at each 10 ms, sampled each 20 ms: p of 100 k Pa at step k
    for (label k = 1; k <= 10; ++k)
    {
        ++box_.time();
        fill(p_, scalar(k == 7 ? 5000 : 100*k));
        load.execute();
    }
    load.write();

    // The first look, then those at even steps
    const List<scalarList> rows(table("load", "wallLoad"));
    ASSERT_EQ(rows.size(), 6);
    EXPECT_NEAR(rows[0][0], 0.01, 1e-9);
    EXPECT_NEAR(rows[1][0], 0.02, 1e-9);
    EXPECT_NEAR(rows[5][0], 0.10, 1e-9);

    // The peak at step 7 lies between two samples
    const scalarList sum(lastLine("load", "summary"));
    ASSERT_EQ(sum.size(), 13);
    EXPECT_NEAR(sum[1], 1000, 1e-6);
    EXPECT_NEAR(sum[2], 0.1, 1e-9);
    EXPECT_NEAR(sum[3], 0.5*(100 + 200)*0.01 + 0.5*(200 + 1000)*0.08, 1e-6);
    EXPECT_NEAR(sum[7], 200*0.09, 1e-6);
    EXPECT_NEAR(sum[9], 1200, 1e-6);
    EXPECT_NEAR(sum[12], sum[4] + 200, 1e-6);
}


TEST_F(barrier, theDistributionOfALoadHasAllSamplesInOrder)
{
    functionObjects::wallLoad load("load", box_.time(), dict("patches (zMin);"));
    for (const scalar p : {30.0, 10.0, 20.0, 40.0})
    {
        ++box_.time();
        fill(p_, p);
        load.execute();
    }
    box_.time().writeOnce();
    ++box_.time();
    fill(p_, scalar(50));
    load.execute();
    load.write();

    std::ifstream is
    (
        box_.folder()/"postProcessing"/"load"/box_.time().timeName()
       /"distribution.dat"
    );
    DynamicList<scalar> shares;
    DynamicList<scalar> forces;
    for (std::string line; std::getline(is, line);)
    {
        scalar share, liquid;
        if (line[0] != '#' && std::istringstream(line) >> share >> liquid)
        {
            shares.append(share);
            forces.append(liquid);
        }
    }

    ASSERT_EQ(forces.size(), 5);
    forAll(forces, i)
    {
        EXPECT_NEAR(shares[i], 0.2*(i + 1), 1e-6);
        EXPECT_NEAR(forces[i], 10.0*(i + 1), 1e-5);
    }
}


TEST_F(barrier, aLoadOnWallsToAllSidesNeedsADirection)
{
    EXPECT_THROW
    (
        functionObjects::wallLoad
        (
            "load", box_.time(), dict("patches (\"z.*\");")
        ),
        Foam::IOerror
    );

    functionObjects::wallLoad load
    (
        "both", box_.time(), dict("patches (\"z.*\"); direction (0 0 -2);")
    );
    ++box_.time();
    load.execute();
    const scalarList line(lastLine("both", "wallLoad"));
    ASSERT_EQ(line.size(), 22);
    EXPECT_NEAR(line[1], 0, 1e-2);
    EXPECT_NEAR(line[8], 200, 1e-3);
}


TEST_F(barrier, grainsLeapOverTheCrestAndLand)
{
    fill(alpha_, scalar(0));
    putGrains
    (
        pointField
        ({
            point(0.5, 0.5, 0.62), point(0.5, 0.5, 0.4), point(0.8, 0.5, 0.25)
        }),
        vectorField({vector(3, 0, 4), vector(1, 0, 0), vector(2, 0, -3)})
    );

    functionObjects::overflow flow
    (
        "flow",
        box_.time(),
        dict
        (
            "crest (0.5 0 0.5); range (0.4 0.6); layer 0.1; threshold 1e-5;"
            " landing 0.25;"
        )
    );
    ++box_.time();
    flow.execute();
    flow.write();

    const scalarList line(lastLine("flow", "overflow"));
    ASSERT_EQ(line.size(), 13);
    EXPECT_NEAR(line[4], volume()*3/0.1, 1e-4*volume()*3/0.1);
    EXPECT_EQ(line[5], 0);
    EXPECT_NEAR(line[6], 5, 1e-5);
    EXPECT_NEAR(line[7], radToDeg(std::atan2(4.0, 3.0)), 1e-4);

    // 4 t - 4.905 t2 = -0.25
    const scalar t = (4 + std::sqrt(16 + 2*9.81*0.25))/9.81;
    EXPECT_NEAR(line[8], 0.5 + 3*t, 1e-4);

    EXPECT_NEAR(line[9], 0.5*3/0.1, 1e-4);
    EXPECT_NEAR(line[10], 0.8, 1e-5);
    EXPECT_NEAR(line[11], 2, 1e-5);
    EXPECT_NEAR(line[12], 3, 1e-5);

    // The highest of those in the range is in the layer from 0.6 to 0.7
    EXPECT_GT(line[1], 0.6);
    EXPECT_LE(line[1], 0.7);
    EXPECT_EQ(line[2], 0);
}


TEST_F(barrier, liquidOverACrestHasItsFluxAndRunUp)
{
    putGrains(pointField(), vectorField());
    U_.primitiveFieldRef() = vector(2, 0, 0);
    fill(alpha_, scalar(0));
    forAll(alpha_, i)
    {
        alpha_[i] = box_.mesh().C()[i].z() < 0.75 ? 1 : 0;
    }

    functionObjects::overflow flow
    (
        "flow",
        box_.time(),
        dict("crest (0.5 0 0.5); range (0.2 0.6); layer 0.125; landing 0.1;")
    );
    for (label i = 0; i < 3; ++i)
    {
        ++box_.time();
        flow.execute();
    }
    flow.write();

    // Void fraction 0.8, 1 m wide, 0.25 m deep over the crest
    const scalarList line(lastLine("flow", "overflow"));
    EXPECT_NEAR(line[5], 0.8*2*0.25, 1e-6);
    EXPECT_NEAR(line[6], 2, 1e-6);
    EXPECT_NEAR(line[7], 0, 1e-6);
    EXPECT_NEAR(line[2], 0.75, 1e-6);
    EXPECT_NEAR(line[3], 0.75, 1e-6);

    const scalarList sum(lastLine("flow", "summary"));
    EXPECT_NEAR(sum[3], 1000*0.8*2*0.25*0.02, 1e-4);
    EXPECT_NEAR(sum[4], 2, 1e-6);
}


TEST_F(barrier, aLandingAboveTheCrestIsAnError)
{
    EXPECT_THROW
    (
        functionObjects::overflow
        (
            "flow",
            box_.time(),
            dict("crest (0.5 0 0.5); range (0.4 0.6); landing 0.6;")
        ),
        Foam::IOerror
    );
}


namespace
{

class ParallelBarrier
:
    public barrier
{};

} // End anonymous namespace


// A rank without water must not wait for another that reads its density
TEST_F(ParallelBarrier, waterOnOneRankAloneGoesOverTheCrest)
{
    putGrains(pointField(), vectorField());
    U_.primitiveFieldRef() = vector(2, 0, 0);
    forAll(alpha_, i)
    {
        const scalar x = box_.mesh().C()[i].x();
        alpha_[i] = x > 0.5 && x < 0.75 ? 1 : 0;
    }

    functionObjects::overflow flow
    (
        "flow",
        box_.time(),
        dictionary
        (
            IStringStream
            (
                "crest (0.6 0 0.5); range (0.5 0.75); layer 0.1; log no;"
            )()
        )
    );
    ++box_.time();
    flow.execute();
    flow.write();

    if (Pstream::master())
    {
        // Void fraction 0.8, 1 m wide, 0.5 m deep
        const scalarList line(lastLine("flow", "overflow"));
        EXPECT_NEAR(line[5], 0.8*2*0.5, 1e-6);
    }
}
