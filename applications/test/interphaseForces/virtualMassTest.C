// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests of the virtual mass laws.

#include "forceModels.H"
#include "forceLaws.H"
#include "testMesh.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

scalar coefficient(const std::string& text, const scalar voidFraction)
{
    grainState state = inWater();
    state.voidFraction = voidFraction;
    testMesh box;
    return
        forceModels(box.mesh(), entries("virtualMass {" + text + "}"))
       .virtualMassCoefficient(state);
}

} // End anonymous namespace


TEST(virtualMass, everyLawIsThereUnderItsName)
{
    for (const std::string name : {"constant", "Zuber"})
    {
        EXPECT_EQ
        (
            law<virtualMassModel>("model " + name + ";")->type(), name
        );
    }
    EXPECT_FALSE(law<virtualMassModel>("model none;").valid());
}


TEST(virtualMass, wrongInputListsWhatIsValid)
{
    expectError<virtualMassModel>("model half;", {"half", "constant", "Zuber"});
    expectError<virtualMassModel>("", {"model", "missing", "none"});
    expectError<virtualMassModel>
    (
        "model constant; coeficient 0.4;", {"coeficient", "coefficient"}
    );
    expectError<virtualMassModel>
    (
        "model constant; coefficient -1;", {"-1", "negative"}
    );
}


TEST(virtualMass, isHalfForASingleSphere)
{
    EXPECT_EQ(coefficient("model constant;", 1), 0.5);
    EXPECT_EQ(coefficient("model Zuber;", 1), 0.5);
}


TEST(virtualMass, growsFromTheCoefficientThatIsGiven)
{
    EXPECT_EQ(coefficient("model Zuber; coefficient 0.4;", 1), 0.4);
    EXPECT_DOUBLE_EQ
    (
        coefficient("model Zuber; coefficient 0.4;", 0.5),
        0.8*coefficient("model Zuber;", 0.5)
    );
}


TEST(virtualMass, constantTakesItsCoefficientAtAnyVoidFraction)
{
    EXPECT_EQ(coefficient("model constant; coefficient 0.7;", 0.4), 0.7);
}


TEST(virtualMass, ZuberGrowsWithTheSolidFraction)
{
    for (const scalar s : {0.1, 0.3, 0.6})
    {
        EXPECT_NEAR
        (
            coefficient("model Zuber;", 1 - s), 0.5*(1 + 2*s)/(1 - s), 1e-14
        );
    }
}


TEST(virtualMass, strengthZeroIsNothingAndBetweenIsInProportion)
{
    EXPECT_EQ(coefficient("model Zuber; strength 0;", 0.5), 0);
    EXPECT_NEAR(coefficient("model Zuber; strength 0.3;", 0.5), 0.6, 1e-14);
    EXPECT_EQ(coefficient("model none;", 0.5), 0);
}


TEST(virtualMass, ofStrengthZeroNeedsNoAccelerationOfTheFluid)
{
    testMesh box;
    const auto carries = [&](const std::string& text)
    {
        const forceModels laws(box.mesh(), entries("virtualMass {" + text + "}"));
        return laws.carriesFluid();
    };

    EXPECT_TRUE(carries("model Zuber;"));
    EXPECT_FALSE(carries("model Zuber; strength 0;"));
}
