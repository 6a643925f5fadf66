// SPDX-License-Identifier: GPL-3.0-or-later
// Void fraction from grains: conservation, adjointness, over-full cells.

#include "grainsInBox.H"
#include "terminalOutput.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::grainsInBox;

namespace
{

//- |sum V spread(a) u - sum a gather(u)| over the sum of magnitudes
scalar adjointError
(
    const fvMesh& mesh,
    const grainExchange& exchange,
    const solidFractionField& p
)
{
    scalarField a(exchange.grains().size());
    forAll(a, i)
    {
        a[i] = std::sin(1 + 7.0*exchange.grains()[i].id);
    }

    scalarField u(mesh.nCells());
    forAll(u, cell)
    {
        u[cell] = std::cos(mesh.C()[cell] & vector(13, 29, 17));
    }

    const scalarField cells(mesh.V().field()*p.mapping().spread(a)*u);
    const scalarField grains(a*p.mapping().gather(u));

    return mag(gSum(cells) - gSum(grains))/(gSum(mag(cells)) + VSMALL);
}


//- Both, with grains that reach into walls and over periodic sides
void expectConserved(const testBox& b, const word& model, const bool skewed)
{
    testMesh test(b);
    if (skewed)
    {
        skew(test.mesh());
    }

    pointField places(randomPoints(300));
    if (skewed)
    {
        for (point& p : places)
        {
            p.x() += 0.4*p.z();
        }
    }

    standingGrains phase(test.mesh());
    place(phase, places, radius);
    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    for (const word smoothing : {"none", "diffusion"})
    {
        solidFractionField p(exchange, settings(model, smoothing));
        p.update();

        const scalar lost = lostVolume(test.mesh(), p, places.size());
        const scalar error = adjointError(test.mesh(), exchange, p);

        testNumber
        (
            (model + ", " + smoothing + ": relative loss of volume").c_str(),
            lost
        );
        testNumber
        (
            (model + ", " + smoothing + ": relative error of the adjoint")
           .c_str(),
            error
        );
        EXPECT_LT(lost, 1e-13);
        EXPECT_LT(error, 1e-12);
    }
}


//- Solid fraction of all cells on every rank, x fastest
scalarField global(const fvMesh& mesh, const scalarField& cells)
{
    scalarField all(512, Zero);

    forAll(cells, cell)
    {
        const point at(8*mesh.C()[cell]);
        all[label(at.x()) + 8*label(at.y()) + 64*label(at.z())] = cells[cell];
    }

    reduce(all, sumOp<scalarField>());
    return all;
}


//- Grains in a cluster that is shifted by whole cells along x: so is the solid
//  fraction, whatever ranks the cluster lies on
void expectShifted(const word& model)
{
    testMesh test(periodicBox());
    const pointField cluster
    (
        randomPoints(40, point(0.05, 0.1, 0.9), point(0.3, 0.4, 1.1))
    );
    scalarField first;
    scalar most = 0;

    for (label shift = 0; shift < 8; ++shift)
    {
        standingGrains phase(test.mesh());
        place(phase, pointField(cluster + vector(shift/8.0, 0, 0)), radius);
        grainExchange exchange(test.mesh());
        exchange.locate(phase);

        solidFractionField p(exchange, settings(model, "diffusion"));
        p.update();
        const scalarField all(global(test.mesh(), p.solidFraction()));

        if (shift == 0)
        {
            first = all;
        }

        forAll(all, i)
        {
            const label from = i - i % 8 + (i % 8 + 8 - shift) % 8;
            most = max(most, mag(all[i] - first[from]));
        }
    }

    testNumber((model + ": largest difference").c_str(), most);
    EXPECT_GT(max(first), 0.01);
    EXPECT_LT(most, 1e-13);
}


//- Sixty grains in one place: what does not fit is spread, none is lost
void expectSpread()
{
    testMesh test(box());
    standingGrains phase(test.mesh());
    place
    (
        phase,
        randomPoints(60, point(0.4, 0.02, 0.4), point(0.6, 0.1, 0.6)),
        radius
    );
    grainExchange exchange(test.mesh());
    exchange.locate(phase);

    dictionary dict(settings("satellitePoints", "none"));
    // All of it at most, in however many rounds
    dict.add("largestSpread", scalar(1));
    solidFractionField p(exchange, dict);
    p.update();

    const scalar lost = lostVolume(test.mesh(), p, 60);
    const scalar most = gMax(p.solidFraction());

    testNumber("spread volume over grain volume", p.excess().movedVolume()/volumeOf(60));
    testNumber("relative loss of volume", lost);
    testNumber("largest solid fraction", most);

    EXPECT_GT(p.excess().movedVolume(), 0.1*volumeOf(60));
    EXPECT_LT(lost, 1e-13);
    EXPECT_LT(most, 0.7 + 1e-8);
    EXPECT_GE(gMin(p.solidFraction()), 0);

    // What acts on it where it went is what grains get
    scalarField u(test.mesh().nCells());
    forAll(u, cell)
    {
        u[cell] = std::cos(test.mesh().C()[cell] & vector(13, 29, 17));
    }
    const grainMeshMapping& mapping = p.mapping();
    const auto onGrains = [&](const scalarField& cells)
    {
        return gSum(scalarField(mapping.volumes()*mapping.gather(cells)));
    };
    const scalar onCells
    (
        gSum(scalarField(test.mesh().V().field()*p.solidFraction()*u))
    );

    EXPECT_GT(mag(onGrains(u) - onCells), 0.01*mag(onCells));
    EXPECT_NEAR(onGrains(p.excess().seenFromCells(u))/onCells, 1, 1e-12);
}

//- A grain in the middle of a cell beside empty ones
struct loneGrain
{
    testMesh test;
    standingGrains phase;
    grainExchange exchange;

    loneGrain()
    :
        test(box()),
        phase(test.mesh()),
        exchange(test.mesh())
    {
        place(phase, pointField(1, vector::uniform(0.0625)), radius);
        exchange.locate(phase);
    }

    //- What is printed, or ends it, where the least void fraction leaves no room for a
    //  share of its volume, at two updates
    std::string outputOf(const scalar share, const scalar largest = -1)
    {
        dictionary dict(settings("centroid", "none"));
        dict.add("minimum", 1 - 512*volumeOf(1)*(1 - share));
        if (largest >= 0)
        {
            dict.add("largestSpread", largest);
        }

        std::string error;
        const std::string output = outputDuring([&]()
        {
            error = refusal([&]
            {
                solidFractionField p(exchange, dict);
                p.update();
                p.update();
            });
        });
        return output + error;
    }
};

} // End anonymous namespace


TEST(voidFraction, warnsFromOnePerCentThatIsSpreadAndStopsAboveAQuarter)
{
    loneGrain grain;

    expectLacks(grain.outputOf(0.009), "Warning");
    expectHolds(grain.outputOf(0.009), "0.9 %");

    const std::string warning(grain.outputOf(0.011));
    expectHolds(warning, "Warning");
    expectHolds(warning, "1.1 % of the solid volume is spread");
    expectHolds(warning, "The fullest cell is at (0.0625 0.0625 0.0625) m");
    expectHolds(warning, "larger cells");
    expectHolds(warning, "stops at 25 %");

    // Once, until it is twice as much
    const auto first = warning.find("of the solid volume");
    EXPECT_EQ(warning.find("of the solid volume", first + 1), std::string::npos);

    expectLacks(grain.outputOf(0.24), "To go on, raise");
    const std::string error(grain.outputOf(0.26));
    expectHolds(error, "26 % of the solid volume is spread");
    expectHolds(error, "The fullest cell is at (0.0625 0.0625 0.0625) m");
    expectHolds(error, "raise voidFraction/largestSpread above 0.25");

    expectLacks(grain.outputOf(0.26, 0.3), "To go on, raise");
    expectHolds(grain.outputOf(0.001, 0), "largestSpread is 0");
}


TEST(voidFraction, keepsVolumeAndIsItsOwnAdjoint)
{
    for (const word model : {"centroid", "satellitePoints", "sphereCaps"})
    {
        expectConserved(box(), model, false);
        expectConserved(periodicBox(), model, false);
    }
}


TEST(voidFraction, keepsVolumeInASkewedAndGradedMesh)
{
    testBox b(box());
    b.patches.fill("wall");

    for (const word model : {"centroid", "satellitePoints", "sphereCaps"})
    {
        expectConserved(b, model, true);
    }
}


TEST(voidFraction, spreadsWhatDoesNotFitAndLosesNothing)
{
    expectSpread();
}


TEST(voidFraction, shiftsWithTheGrains)
{
    expectShifted("satellitePoints");
    expectShifted("sphereCaps");
}


TEST(voidFraction, refusesAnUnknownModelWithTheChoices)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());

    try
    {
        solidFractionField p(exchange, settings("halved", "none"));
        FAIL() << "no error";
    }
    catch (const Foam::error& e)
    {
        EXPECT_NE(e.message().find("satellitePoints"), std::string::npos);
    }
}


TEST(voidFraction, anEnlargementIsForCapsAloneAndNotBelowOne)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());

    const auto output = [&](const word& model, const scalar enlargement)
    {
        dictionary dict(settings(model, "none"));
        dict.add("enlargement", enlargement);
        return refusal([&]{ solidFractionField p(exchange, dict); });
    };

    EXPECT_EQ(output("sphereCaps", 1.9), "nothing");
    EXPECT_NE(output("sphereCaps", 0.9).find("is 0.9"), std::string::npos);
    EXPECT_NE(output("centroid", 1.9).find("enlargement"), std::string::npos);
}


TEST(voidFraction, keysOfSmoothingMayStayWhereThereIsNone)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());
    dictionary dict(settings("centroid", "none"));
    dictionary& smoothing = dict.subDict("smoothing");
    smoothing.add("drag", "off");
    smoothing.add("diameter", 0.01);

    EXPECT_EQ(refusal([&]{ solidFractionField p(exchange, dict); }), "nothing");
}


TEST(voidFraction, formerNamesOfModelsAreErrorsThatNameThePresentOnes)
{
    testMesh test(box());
    grainExchange exchange(test.mesh());
    const HashTable<word> present
    ({
        {"caps", "sphereCaps"},
        {"divided", "satellitePoints"},
        {"centre", "centroid"}
    });

    forAllConstIters(present, model)
    {
        EXPECT_NE
        (
            refusal
            (
                [&]{ solidFractionField p(exchange, settings(model.key(), "none")); }
            ).find("Write " + model.val()),
            std::string::npos
        );
    }
}


TEST(ParallelVoidFraction, keepsVolumeAndIsItsOwnAdjoint)
{
    for (const word model : {"centroid", "satellitePoints", "sphereCaps"})
    {
        expectConserved(box(), model, false);
        expectConserved(periodicBox(), model, false);
    }
}


TEST(ParallelVoidFraction, spreadsWhatDoesNotFitAndLosesNothing)
{
    expectSpread();
}


TEST(ParallelVoidFraction, isTheSameWhereverTheRanksMeet)
{
    expectShifted("satellitePoints");
    expectShifted("sphereCaps");
}
