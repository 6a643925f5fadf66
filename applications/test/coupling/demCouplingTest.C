// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of an exchange, with LIGGGHTS, and its place in time.

#include "demCoupling.H"
#include "grainSnapshot.H"
#include "granularProperties.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include "OSspecific.H"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

//- DEM step [s], and the interval of 50 of them
constexpr scalar step = 2e-5;
constexpr scalar interval = 50*step;


//- Four grains of 20 mm in a box of 1 m full of water at rest
class boxOfWater
{
    testMesh box_;

    void write(const fileName& name, const std::string& text) const
    {
        mkDir((box_.folder()/name).path());
        std::ofstream(box_.folder()/name) << text;
    }

public:

    //- The case, with an entry more in its dictionary
    explicit boxOfWater(const std::string& more = "")
    {
        const std::string all = " all property/global ";
        placeGrains(0.5);
        write
        (
            "constant/grains/physics",
            "neighbor 0.002 bin\nneigh_modify delay 0\n"
            "fix E" + all + "youngsModulus peratomtype 1e7\n"
            "fix nu" + all + "poissonsRatio peratomtype 0.3\n"
            "fix e" + all + "coefficientRestitution peratomtypepair 1 0.4\n"
            "fix mu" + all + "coefficientFriction peratomtypepair 1 0.7\n"
            "pair_style gran model hertz tangential history\n"
            "pair_coeff * *\ntimestep 2e-5\nfix integrate all nve/sphere\n"
        );
        write
        (
            "constant/granularProperties",
            "FoamFile { version 2.0; format ascii; class dictionary;"
            " object granularProperties; }\n"
            "granularPhase LIGGGHTS; LIGGGHTS { walls { patches (\".*\");"
            " type 1; } } exchange { interval 50; }\n" + more
        );
    }

    //- The initial script: the box up to a height [m], and what is in it
    void writeInitial(const scalar top, const std::string& grains) const
    {
        std::ostringstream os;
        os  << "units si\natom_style granular\nnewton off\n"
            << "communicate single vel yes\n"
            << "region box block 0 1 0 1 0 " << top
            << " units box\ncreate_box 1 box\n" << grains;
        write("constant/grains/initial", os.str());
    }

    //- The grains at a height [m], which may be above the box; of a diameter [m] and
    //  density [kg/m3]
    void placeGrains
    (
        const scalar z,
        const scalar diameter = 0.02,
        const scalar density = 2500
    ) const
    {
        std::ostringstream os;
        for (const char* x : {"0.3", "0.4", "0.5", "0.6"})
        {
            os << "create_atoms 1 single " << x << " 0.5 " << z << " units box\n";
        }
        os  << "set type 1 diameter " << diameter << " density " << density << "\n";
        writeInitial(max(z + 0.1, scalar(1)), os.str());
    }

    //- Let a grain of 20 mm and of a density [kg/m3] come in, in the first step
    void insertGrain(const scalar density) const
    {
        std::ostringstream os;
        os  << "fix light all particletemplate/sphere 15485863 atom_type 1 density"
            << " constant " << density << " radius constant 0.01\n"
            << "fix sizes all particledistribution/discrete 32452843 1 light 1.0\n"
            << "region above block 0.4 0.6 0.4 0.6 0.6 0.9 units box\n"
            << "fix insertion all insert/pack seed 32452867 distributiontemplate"
            << " sizes insert_every once overlapcheck yes all_in yes"
            << " particles_in_region 1 region above\n";
        addPhysics(os.str());
    }

    //- The physics script, with a line more
    void addPhysics(const std::string& line) const
    {
        std::ofstream
        (
            box_.folder()/"constant/grains/physics", std::ios::app
        )   << line << "\n";
    }

    testMesh& box()
    {
        return box_;
    }

    fluidFields water()
    {
        const label n = box_.mesh().nCells();
        return fluidFields
        {
            scalarField(n, 1000),
            scalarField(n, 1e-3),
            scalarField(n, 1),
            vectorField(n, Zero),
            vectorField(n, Zero),
            vectorField(n, Zero),
            vectorField()
        };
    }
};


const vector g(0, 0, -9.81);


//- Of grains of a density in water, with the mass that they carry along [m/s2]
scalar riseOf(const scalar density)
{
    return (1000 - density)/(density + 0.5*1000)*mag(g);
}


const std::string carryingWater
(
    "interphaseForces { drag { model none; } virtualMass { model constant; } }"
);


//- One exchange of grains with water that stays at rest
void exchangeOnce(demCoupling& grains, boxOfWater& w)
{
    const fluidFields water(w.water());
    const fvMesh& mesh = w.box().mesh();
    const surfaceScalarField none
    (
        IOobject("none", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure/dimLength*dimArea, Zero)
    );

    grains.moveGrains([&]{ return w.water(); });
    grains.locateGrains();
    grains.findVoidFraction();
    grains.prepareForces(water);
    grains.addFluidStep(water.U, water.rho, none, water.U, vectorField(), interval);
    grains.setParticleForces(water.U);
}

} // End anonymous namespace


TEST(demCoupling, hasNoGrainsWithoutTheirDictionary)
{
    testMesh box;
    const demCoupling grains(box.mesh(), hydrostatics(g));

    EXPECT_FALSE(grains.hasGrains());
    EXPECT_FALSE(grains.due());
}


TEST(granularProperties, warnsOfDragThatIsSmoothedForMaterialPoints)
{
    const std::string points
    (
        "#remove (LIGGGHTS granularPhase)\ngranularPhase materialPoints;\n"
        "materialPoints { cellSize 0.1; bodies { sand { law linearElastic;"
        " density 1500; E 1e6; nu 0.2; region { box ((0.2 0.2 0.2) (0.4 0.4 0.4)); }"
        " } } }\n"
    );
    const auto output = [&](const std::string& smoothing, const std::string& drag)
    {
        boxOfWater w
        (
            points + "voidFraction { smoothing { " + smoothing + " } }\n"
            "interphaseForces { drag { model " + drag + "; } }"
        );
        return outputDuring([&]{ demCoupling(w.box().mesh(), hydrostatics(g)); });
    };
    const std::string remedy("Write  drag off;");

    expectHolds(output("", "Beetstra"), remedy);
    expectHolds(output("width 2;", "Beetstra"), remedy);
    expectLacks(output("drag off;", "Beetstra"), remedy);
    expectLacks(output("drag on;", "Beetstra"), remedy);
    expectLacks(output("model none;", "Beetstra"), remedy);
    expectLacks(output("", "none"), remedy);

    boxOfWater byDefault(points);
    expectHolds
    (
        outputDuring([&]{ demCoupling(byDefault.box().mesh(), hydrostatics(g)); }), remedy
    );

    boxOfWater ofGrains("interphaseForces { drag { model Beetstra; } }");
    expectLacks
    (
        outputDuring([&]{ demCoupling(ofGrains.box().mesh(), hydrostatics(g)); }), remedy
    );
}


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
    for (const vector& force : grains->snapshot()->contactForce)
    {
        EXPECT_LT(mag(force), 1e-9*weight);
    }
}


TEST(demCoupling, grainsThatAllStartOutsideAreAnErrorAlsoWhereTheyMayLeave)
{
    boxOfWater w("LIGGGHTS { walls { patches (zMin); } outflow (zMax); }");
    w.placeGrains(5);
    EXPECT_THROW(demCoupling(w.box().mesh(), hydrostatics(g)), Foam::error);
    EXPECT_THROW(demCoupling(w.box().mesh(), g), Foam::error);
}


TEST(demCoupling, grainsAloneTellTheirNumberAtEachTimeWritten)
{
    boxOfWater w;
    const demCoupling grains(w.box().mesh(), g);
    const std::string output(outputDuring([&]{ grains.report(); }));

    EXPECT_NE(output.find("Grains: 4 = 4 located + 0 outside"), std::string::npos)
        << output;
    EXPECT_EQ(output.find("Exchange"), std::string::npos) << output;
}


TEST(demCoupling, refusesFormerAndUnknownKeysOfItsDictionary)
{
    const auto error = [](const std::string& entry)
    {
        boxOfWater w(entry);
        return refusal
        (
            [&]{ demCoupling(w.box().mesh(), hydrostatics(g)); }
        );
    };

    EXPECT_NE
    (
        error("porosity { model caps; }").find("Write voidFraction"),
        std::string::npos
    );
    EXPECT_NE(error("poresity { }").find("Valid keywords"), std::string::npos);
    EXPECT_NE
    (
        error("exchange { interval 0; }").find("1 or more"), std::string::npos
    );
}


TEST(demCoupling, refusesADEMStepThatChangesMeanwhile)
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


TEST(demCoupling, takesAWholeNumberOfFluidStepsInAnInterval)
{
    boxOfWater w;
    const demCoupling grains(w.box().mesh(), hydrostatics(g));

    EXPECT_TRUE(grains.due());
    EXPECT_NEAR(grains.stepInInterval(1), interval, 1e-12*interval);
    EXPECT_NEAR(grains.stepInInterval(interval), interval, 1e-12*interval);
    EXPECT_NEAR(grains.stepInInterval(0.3*interval), interval/4, 1e-12*interval);
}


TEST(demCoupling, goesEvenlyToTheVoidFractionThatTheGrainsLeave)
{
    boxOfWater w;
    const fvMesh& mesh = w.box().mesh();
    demCoupling grains(mesh, hydrostatics(g));
    const fluidFields water(w.water());
    volScalarField voidFraction
    (
        IOobject("voidFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    );
    const scalarField before(1 - grains.solidFraction());
    grains.start(water);

    grains.moveGrains();
    grains.locateGrains();
    grains.findVoidFraction();
    grains.prepareForces(water);

    EXPECT_FALSE(grains.due());
    const scalarField after(1 - grains.solidFraction());
    EXPECT_GT(max(mag(after - before)), 1e-12);

    // Times the interval, whatever the fluid's step
    const auto change = [&](const scalar dt)
    {
        return scalarField
        (
            interval*grains.voidFractionRate(voidFraction, dt)().field()
        );
    };
    voidFraction.primitiveFieldRef() = before;
    EXPECT_LT(max(mag(change(interval) - (after - before))), 1e-15);
    EXPECT_LT(max(mag(change(interval/2) - (after - before)/2)), 1e-15);
    voidFraction.primitiveFieldRef() = after;
    EXPECT_LT(max(mag(change(interval))), 1e-15);
}


TEST(demCoupling, givesGrainsTheOppositeOfWhatTheFluidGets)
{
    boxOfWater w;
    const fvMesh& mesh = w.box().mesh();
    demCoupling grains(mesh, hydrostatics(g));
    const fluidFields water(w.water());
    grains.start(water);

    grains.moveGrains();
    grains.locateGrains();
    grains.findVoidFraction();
    grains.prepareForces(water);

    const surfaceScalarField none
    (
        IOobject("none", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure/dimLength*dimArea, Zero)
    );
    grains.addFluidStep
    (
        water.U, water.rho, none, water.U, vectorField(), interval
    );
    EXPECT_TRUE(grains.due());
    grains.setParticleForces(water.U);

    EXPECT_LT(grains.forces().residual(), 1e-12);
    EXPECT_EQ(grains.forces().force().size(), 4);
}


TEST(demCoupling, grainsCarryWaterAlongFromTheFirstIntervalOn)
{
    for (const scalar density : {5.0, 100.0, 2500.0})
    {
        boxOfWater w(carryingWater);
        w.placeGrains(0.5, 0.02, density);
        demCoupling grains(w.box().mesh(), hydrostatics(g));
        grains.start(w.water());
        grains.moveGrains();

        const auto& phase =
            w.box().mesh().lookupObject<granularPhase>(granularPhase::typeName);
        const scalar speed = riseOf(density)*interval;
        EXPECT_NEAR(phase.velocity()[0].z(), speed, 1e-9*mag(speed)) << density;
    }
}


TEST(demCoupling, aGrainThatComesInFeelsTheWaterAtOnce)
{
    for (const scalar density : {5.0, 100.0, 2500.0})
    {
        boxOfWater w(carryingWater);
        w.insertGrain(density);
        demCoupling grains(w.box().mesh(), hydrostatics(g));
        grains.start(w.water());
        grains.moveGrains([&]{ return w.water(); });

        const auto& phase =
            w.box().mesh().lookupObject<granularPhase>(granularPhase::typeName);
        ASSERT_EQ(phase.size(), 5);
        const label last = findMax(phase.id());

        // It comes in during the first of the 50 steps
        const scalar speed = riseOf(density)*interval;
        EXPECT_NEAR(phase.velocity()[last].z(), speed, 0.03*mag(speed)) << density;
    }
}


TEST(demCoupling, goesOnWithoutGrainsAndTakesThoseThatComeIn)
{
    for (const bool enters : {false, true})
    {
        boxOfWater w;
        w.writeInitial(1, "");
        if (enters)
        {
            w.insertGrain(2500);
        }
        demCoupling grains(w.box().mesh(), hydrostatics(g));
        grains.start(w.water());
        exchangeOnce(grains, w);
        EXPECT_TRUE(grains.write());
        exchangeOnce(grains, w);

        EXPECT_EQ(grains.forces().force().size(), enters ? 1 : 0);
        EXPECT_TRUE(std::isfinite(grains.forces().residual()));
    }
}


TEST(demCoupling, warnsOfLoneSlowGrainsThatDragTheirCellAlong)
{
    const auto output = [](const scalar mu, const std::string& smoothing)
    {
        boxOfWater w("voidFraction { smoothing { " + smoothing + " } }");
        demCoupling grains(w.box().mesh(), hydrostatics(g));
        fluidFields fluid(w.water());
        fluid.mu = mu;
        return outputDuring([&]{ grains.start(fluid); });
    };

    // 1.59 d over a cell of 0.25 m, and the bell of 60 mm
    expectHolds(output(100, ""), "move up to 9.2");
    expectLacks(output(100, "width 60;"), "too fast");
    expectLacks(output(1e-3, ""), "too fast");
}


// A box of 1 m with bins of 0.1 mm
TEST(demCoupling, binsAreAsManyAsTheGrainsWhateverTheirBox)
{
    boxOfWater w;
    w.placeGrains(0.5, 1e-4);
    w.addPhysics("neighbor 1e-4 bin\ntimestep 1e-7");
    demCoupling grains(w.box().mesh(), hydrostatics(g));
    grains.start(w.water());
    exchangeOnce(grains, w);
    EXPECT_TRUE(grains.write());
}


TEST(demCoupling, farTooManyBinsOfLiggghtsAreAnErrorBeforeTheyTakeTheMemory)
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
