// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: choosing drag laws by name, blending them, and the errors for wrong
// input.

#include "forceLaws.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

const char* const names[]
{
    "DiFelice", "Gidaspow", "Ergun", "KochHill", "Beetstra",
    "SchillerNaumann"
};


grainState someState()
{
    grainState state = atReynolds(inWater(), 37);
    state.voidFraction = 0.61;
    return state;
}

} // End anonymous namespace


TEST(dragSelection, everyLawIsThereUnderItsName)
{
    for (const std::string name : names)
    {
        EXPECT_EQ
        (
            law<dragModel>("model " + name + ";")->type(), name
        );
    }
    EXPECT_FALSE(law<dragModel>("model none;").valid());
}


TEST(dragSelection, anUnknownNameListsTheValidOnes)
{
    for (const std::string name : names)
    {
        expectError<dragModel>("model DiFelise;", {"DiFelise", name});
    }
    expectError<dragModel>("model DiFelise;", {"none"});
}


TEST(dragSelection, aMissingNameListsTheValidOnes)
{
    expectError<dragModel>("", {"model", "missing", "DiFelice", "KochHill"});
}


TEST(dragSelection, aMisspeltKeywordIsNotTakenForItsDefault)
{
    expectError<dragModel>
    (
        "model DiFelice; formulatoin asPrinted;",
        {"formulatoin", "formulation", "strength"}
    );
    expectError<dragModel>
    (
        "model KochHill; strenght 0.5;", {"strenght", "strength"}
    );
}


TEST(dragSelection, aWrongChoiceListsTheValidOnes)
{
    expectError<dragModel>
    (
        "model DiFelice; formulation B;", {"formulation", "modelA", "asPrinted"}
    );
    expectError<dragModel>
    (
        "model Gidaspow; transition soft;", {"transition", "sharp", "smooth"}
    );
}


TEST(dragSelection, strengthOutsideZeroToOneIsRefused)
{
    for (const std::string strength : {"-0.1", "1.1"})
    {
        expectError<dragModel>
        (
            "model KochHill; base DiFelice; strength " + strength + ";",
            {"strength", strength, "between 0"}
        );
    }
}


TEST(dragSelection, strengthBelowOneNeedsAValidBase)
{
    expectError<dragModel>
    (
        "model KochHill; strength 0.5;", {"base", "missing", "Gidaspow"}
    );
    expectError<dragModel>
    (
        "model KochHill; base Ergon;", {"Ergon", "Gidaspow"}
    );
}


TEST(dragSelection, strengthZeroIsTheBaseToTheLastBit)
{
    const auto base = law<dragModel>("model DiFelice;");
    const auto none = law<dragModel>
    (
        "model KochHill; base DiFelice; strength 0;"
    );

    EXPECT_EQ(none->K(someState()), base->K(someState()));
}


TEST(dragSelection, strengthOneIsTheModelToTheLastBit)
{
    const auto model = law<dragModel>("model KochHill;");
    const auto full = law<dragModel>
    (
        "model KochHill; base DiFelice; strength 1;"
    );

    EXPECT_EQ(full->K(someState()), model->K(someState()));
}


TEST(dragSelection, strengthBetweenBlendsLinearly)
{
    const scalar base = law<dragModel>("model DiFelice;")->K(someState());
    const scalar model = law<dragModel>("model KochHill;")->K(someState());

    for (const scalar s : {1e-12, 0.25, 0.5, 1 - 1e-12})
    {
        std::ostringstream text;
        text.precision(17);
        text << "model KochHill; base DiFelice; strength " << s << ";";

        EXPECT_DOUBLE_EQ
        (
            law<dragModel>(text.str())->K(someState()),
            (1 - s)*base + s*model
        );
    }
}


TEST(dragSelection, noneIsABaseAndAModel)
{
    const scalar model = law<dragModel>("model KochHill;")->K(someState());

    EXPECT_DOUBLE_EQ
    (
        law<dragModel>("model KochHill; base none; strength 0.3;")
            ->K(someState()),
        0.3*model
    );
    EXPECT_DOUBLE_EQ
    (
        law<dragModel>("model none; base KochHill; strength 0.3;")
            ->K(someState()),
        0.7*model
    );
    EXPECT_FALSE
    (
        law<dragModel>("model KochHill; base none; strength 0;").valid()
    );
}


TEST(dragSelection, theBaseTakesItsOwnSettings)
{
    const auto asPrinted = law<dragModel>
    (
        "model DiFelice; formulation asPrinted;"
    );
    const auto blend = law<dragModel>
    (
        "model DiFelice; base DiFelice; strength 0;"
        "baseSettings { formulation asPrinted; }"
    );

    EXPECT_EQ(blend->K(someState()), asPrinted->K(someState()));
    EXPECT_NE
    (
        blend->K(someState()),
        law<dragModel>("model DiFelice;")->K(someState())
    );
}


TEST(dragSelection, baseSettingsWithoutABaseAreRefused)
{
    expectError<dragModel>
    (
        "model KochHill; baseSettings { formulation asPrinted; }",
        {"base", "missing"}
    );
}


TEST(dragSelection, theBaseSettingsHoldOnlyTheBasesOwn)
{
    expectError<dragModel>
    (
        "model KochHill; base DiFelice; strength 0.5;"
        "baseSettings { strength 0.5; }",
        {"Unknown keyword strength", "baseSettings", "formulation"}
    );
}


TEST(dragCorrection, isLinearInVoidFractionAndLogReynoldsBetweenNodes)
{
    const auto plain = law<dragModel>("model Gidaspow;");
    const auto corrected = law<dragModel>
    (
        "model Gidaspow; correction { voidFraction (0.4 0.8);"
        " Reynolds (1 100); logarithm ((0.1 0.3) (0.5 -0.1)); }"
    );
    const auto factor = [&](const scalar e, const scalar Re)
    {
        grainState state = atReynolds(inWater(), Re);
        state.voidFraction = e;
        return std::log(corrected->K(state)/plain->K(state));
    };

    EXPECT_NEAR(factor(0.4, 1), 0.1, 1e-12);
    EXPECT_NEAR(factor(0.8, 100), -0.1, 1e-12);
    EXPECT_NEAR(factor(0.4, 10), 0.2, 1e-12);
    EXPECT_NEAR(factor(0.5, 10), 0.2, 1e-12);
    EXPECT_NEAR(factor(0.7, 100), 0, 1e-12);

    // Beyond the nodes as at the last one, also at rest
    EXPECT_NEAR(factor(0.3, 1e4), 0.3, 1e-12);
    EXPECT_NEAR(factor(0.9, 0), 0.5, 1e-12);
}


TEST(dragCorrection, ofOneNodeIsAPlainFactor)
{
    EXPECT_NEAR
    (
        law<dragModel>
        (
            "model Ergun; correction { voidFraction (1); Reynolds (1);"
            " logarithm ((0.5)); strength -2; }"
        )->K(someState())
       /law<dragModel>("model Ergun;")->K(someState()),
        std::exp(-1.0),
        1e-12
    );
}


TEST(dragCorrection, ofStrengthZeroIsTheLawToTheLastBit)
{
    EXPECT_EQ
    (
        law<dragModel>
        (
            "model DiFelice; correction { voidFraction (1); Reynolds (1);"
            " logarithm ((0.5)); strength 0; }"
        )->K(someState()),
        law<dragModel>("model DiFelice;")->K(someState())
    );
}


TEST(dragCorrection, holdsForTheDiametersItNames)
{
    const scalar alone = law<dragModel>("model DiFelice;")->K(someState());
    const auto factor = [&](const scalar smallest, const scalar largest)
    {
        const std::string range(std::to_string(smallest) + ' ' + std::to_string(largest));
        return
            law<dragModel>
            (
                "model DiFelice; correction { voidFraction (1); Reynolds (1);"
                " logarithm ((0.5)); diameters (" + range + "); }"
            )->K(someState())/alone;
    };
    const scalar d = someState().d;
    EXPECT_EQ(factor(2*d, 3*d), 1);
    EXPECT_EQ(factor(0, 0.5*d), 1);
    EXPECT_NEAR(factor(0.5*d, 2*d), std::exp(0.5), 1e-12);
    expectError<dragModel>
    (
        "model DiFelice; correction { voidFraction (1); Reynolds (1);"
        " logarithm ((0.5)); diameters (2 1); }",
        {"the smallest comes first"}
    );
}


TEST(dragCorrection, aTableThatDoesNotFitItsNodesIsRefused)
{
    for (const char* table :
        {
            "voidFraction (0.4 0.8); Reynolds (1); logarithm ((0.1));",
            "voidFraction (0.8 0.4); Reynolds (1); logarithm ((0.1) (0));",
            "voidFraction (0.8); Reynolds (0); logarithm ((0.1));"
        })
    {
        expectError<dragModel>
        (
            "model DiFelice; correction { " + std::string(table) + " }",
            {"Nodes must rise", "a row for each void fraction"}
        );
    }
}
