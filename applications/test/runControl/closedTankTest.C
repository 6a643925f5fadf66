// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: the volume of the grains in a tank whose fluid has no way out.

#include "closedTank.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A box of 1 m3 with a pressure, closed unless a patch holds it
class tankOfWater
{
    testMesh box_;

public:

    volScalarField p;

    volScalarField voidFraction;

    explicit tankOfWater(const bool closed)
    :
        p
        (
            IOobject("p_rgh", box_.time().timeName(), box_.mesh()),
            box_.mesh(),
            dimensionedScalar("p", dimPressure, 0),
            wordList
            (
                box_.mesh().boundary().size(), closed ? "zeroGradient" : "fixedValue"
            )
        ),
        voidFraction
        (
            IOobject("voidFraction", box_.time().timeName(), box_.mesh()),
            box_.mesh(),
            dimensionedScalar("void", dimless, 0.6),
            "zeroGradient"
        )
    {}

    scalarField solids(const scalar fraction) const
    {
        return scalarField(p.mesh().nCells(), fraction);
    }

    //- The words of the error where the void fraction changes everywhere at a rate [1/s]
    std::string refusalOf(const scalar rate)
    {
        const volScalarField::Internal rates
        (
            IOobject("rate", p.time().timeName(), p.mesh()),
            p.mesh(),
            dimensionedScalar("rate", dimless/dimTime, rate)
        );
        return refusal([&]() { checkGrainVolume(p, rates, 0.01); });
    }
};

} // End anonymous namespace


TEST(closedTank, stopsWhereTheVolumeOfTheGrainsChangesAndStatesIt)
{
    tankOfWater closed(true);
    const std::string words(closed.refusalOf(-0.1));
    expectHolds(words, "changes by 0.001 m3");
    expectHolds(words, "the tank is closed");
    EXPECT_EQ(closed.refusalOf(1e-12), "nothing");
}


TEST(closedTank, letsTheVolumeChangeWhereAPatchHoldsThePressure)
{
    EXPECT_EQ(tankOfWater(false).refusalOf(-0.1), "nothing");
}


TEST(closedTank, scalesTheVoidFractionByWhatTheDigitsOfAFileLeaveOut)
{
    tankOfWater tank(true);
    scaleToGrainVolume(tank.p, tank.voidFraction, tank.solids(0.40001));
    EXPECT_NEAR(gMax(tank.voidFraction.primitiveField()), 0.59999, 1e-14);

    tankOfWater open(false);
    scaleToGrainVolume(open.p, open.voidFraction, open.solids(0.40001));
    EXPECT_EQ(gMax(open.voidFraction.primitiveField()), 0.6);
}


TEST(closedTank, refusesAVoidFractionOfOtherGrains)
{
    tankOfWater tank(true);
    const std::string words
    (
        refusal
        (
            [&]() { scaleToGrainVolume(tank.p, tank.voidFraction, tank.solids(0.5)); }
        )
    );
    expectHolds(words, "Go on from another time");
}
