// SPDX-License-Identifier: GPL-3.0-or-later
// The free correction as entries of a case, and what is read back.

#include "correction.H"
#include "recordedFiles.H"

#include "IStringStream.H"
#include "dictionary.H"
#include "IFstream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

dictionary entries(const string& text)
{
    return dictionary(IStringStream(text)());
}


//- A case with a drag law and nothing else
struct emptyCase
:
    recorded::files
{
    emptyCase()
    {
        mkDir(folder()/"constant");
        mkDir(folder()/"system");
        write
        (
            "constant/granularProperties",
            "interphaseForces { drag { model Gidaspow; } }\n"
        );
    }

    dictionary read(const fileName& file) const
    {
        return dictionary(IFstream(folder()/file)());
    }

    void apply(const List<caseChange>& changes) const
    {
        for (const caseChange& c : changes)
        {
            c.apply(folder(), 0);
        }
    }
};


const string pushes("push { stations (1 2 4); times (0.5 1); size 50; }");

const string drags
(
    "drag { voidFraction (0.5 0.8); Reynolds (1 10 100); size 0.3; }"
);


std::string errorOf(const string& text)
{
    return refusal([&]() { correction(entries("correction { " + text + " }")); });
}

} // End anonymous namespace


TEST(misfitCorrection, thatIsNotRequestedHasNoElementsAndChangesNothing)
{
    const correction none(entries("ranks 1;"));
    EXPECT_TRUE(none.elements().empty());
    EXPECT_TRUE(none.changes({}, true, "/nowhere").empty());
}


TEST(misfitCorrection, elementsReachToTheirNeighbours)
{
    const correction c(entries("correction { " + pushes + drags + " }"));
    ASSERT_EQ(c.elements().size(), 12);
    const correctionElement& e = c.elements()[3];
    EXPECT_EQ(e.name, "push2_2");
    EXPECT_EQ(e.place, 2);
    EXPECT_EQ(e.reach, Pair<scalar>(1, 2));
    EXPECT_EQ(e.lasting, Pair<scalar>(0.5, 0.5));
    EXPECT_EQ(c.elements()[4].reach, Pair<scalar>(2, 2));
    EXPECT_EQ(c.elements().last().name, "drag2_3");
}


TEST(misfitCorrection, isWrittenIntoACaseAsEntriesThatMayBeNew)
{
    emptyCase at;
    const correction c(entries("correction { " + pushes + drags + " }"));
    HashTable<scalar> strengths;
    strengths.insert("push1_2", -35);
    strengths.insert("drag2_1", 0.25);
    at.apply(c.changes(strengths, false, at.folder()));

    const dictionary options(at.read("constant/fvOptions"));
    EXPECT_FALSE(options.found("push1_1"));
    const dictionary& push = options.subDict("push1_2");
    EXPECT_EQ(push.get<word>("type"), "localisedMomentumSource");
    EXPECT_EQ(push.get<scalar>("force"), -35);
    EXPECT_EQ(push.get<scalar>("time"), 1);
    EXPECT_EQ(push.get<Pair<scalar>>("reach"), Pair<scalar>(1, 1));

    const dictionary drag
    (
        at.read("constant/granularProperties").subDict("interphaseForces")
       .subDict("drag")
    );
    EXPECT_EQ(drag.get<word>("model"), "Gidaspow");
    const List<scalarList> table
    (
        drag.subDict("correction").get<List<scalarList>>("logarithm")
    );
    EXPECT_EQ(table[0], scalarList(3, scalar(0)));
    EXPECT_EQ(table[1][0], 0.25);
}


TEST(misfitCorrection, joinsTheOptionsThatACaseHas)
{
    emptyCase at;
    at.write("system/fvOptions", "walls { width 1; }\n");
    const correction c(entries("correction { " + pushes + " }"));
    at.apply(c.changes({}, true, at.folder()));

    const dictionary options(at.read("system/fvOptions"));
    EXPECT_TRUE(options.found("walls"));
    EXPECT_EQ(options.size(), 7);
    EXPECT_EQ(options.subDict("push3_2").get<scalar>("force"), 0);
    EXPECT_FALSE(isFile(at.folder()/"constant/fvOptions"));
}


TEST(misfitCorrection, readsWhatWaterWasMet)
{
    emptyCase at;
    mkDir(at.folder()/"postProcessing/push1_1/0");
    at.write
    (
        "postProcessing/push1_1/0/localisedMomentumSource.dat",
        "# Time share U depth voidFraction rho nu g\n"
        "0.1 0 9 9 0.9 1100 9 9.81\n0.2 1 2 0.1 0.6 1100 1e-3 9.81\n"
        "0.4 0.5 4 0.3 0.6 1100 3e-3 9.81\n0.5 0 9 9 0.9 1100 9 9.81\n"
    );

    const HashTable<conditions> met
    (
        correction(entries("correction { " + pushes + " }")).waterIn(at.folder())
    );
    ASSERT_EQ(met.size(), 1);
    EXPECT_NEAR(met["push1_1"].velocity, 3, 1e-12);
    EXPECT_NEAR(met["push1_1"].depth, 0.2, 1e-12);
    EXPECT_NEAR(met["push1_1"].voidFraction, 0.6, 1e-12);
    EXPECT_NEAR(met["push1_1"].density, 1100, 1e-9);
    EXPECT_NEAR(met["push1_1"].viscosity, 2e-3, 1e-12);
    EXPECT_NEAR(met["push1_1"].gravity, 9.81, 1e-12);
}


TEST(misfitCorrection, badInputIsReportedWithWhatToDo)
{
    expectHolds
    (
        errorOf("push { stations (2 1); times (1 2); size 1; }"),
        "stations 2(2 1) of the correction must rise"
    );
    expectHolds(errorOf("push { stations (1); times (1 2); size 1; }"), "reach");
    for
    (
        const char* low :
        {
            "push { stations (1 2); times (1 2); size 0; }",
            "drag { voidFraction (0 1); Reynolds (1); size 1; }"
        }
    )
    {
        expectHolds(errorOf(low), "must be above zero");
    }
    expectHolds(errorOf("pull { }"), "pull");
}
