// SPDX-License-Identifier: GPL-3.0-or-later
// What a case will not write for its channels is reported before any run.

#include "fakeCase.H"
#include "numberTable.H"
#include "testMesh.H"

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- The output before any run of the fake case, with these entries in a channel and
//  these function objects in controlDict
std::string outputBefore
(
    const fakeCase& c,
    const std::string& channel,
    const std::string& functions
)
{
    c.write
    (
        "system/controlDict",
        "#include \"more\"\nendTime 2; writeControl adjustableRunTime;"
        " writeInterval 0.2; functions\n{\n#include \"tables\"\n}\n"
    );
    c.write("system/tables", functions);
    return outputDuring
    (
        [&]()
        {
            fakePredictor p(c, dictWith(c, "length;", "length; " + channel));
            p.predict.print("planned", {withSlope(2)});
        }
    );
}

} // End anonymous namespace


TEST(misfitTables, aFunctionObjectThatIsNotThereIsReported)
{
    const fakeCase c;
    const std::string output(outputBefore(c, "", "outs { type x; } moved { type y; }"));
    expectHolds(output, "channel y");
    expectHolds(output, "function object out writes");
    expectHolds(output, "none of that name: outs moved");
    EXPECT_EQ(c.count(), 0);

    expectLacks(outputBefore(c, "", "out { type x; }"), "function object");

    // The solver writes the table by itself
    expectLacks(outputBefore(c, "", ""), "function object");
}


TEST(misfitTables, aTimeAtWhichNothingIsWrittenIsReported)
{
    const fakeCase c;
    c.write("r.csv", "x_m,y_m\n0,0\n1,2\n2,4\n");
    const std::string writes("out { type x; writeControl writeTime; }");
    const std::string output(outputBefore(c, "at 0.25;", writes));
    expectHolds(output, "channel y is at 0.25 s");
    expectHolds(output, "writes every 0.2 s: the nearest is 0.2 s");
    expectLacks(outputBefore(c, "at 0.6;", writes), "the nearest");
    expectLacks(outputBefore(c, "at 0.25;", "out { type x; }"), "the nearest");
    expectHolds
    (
        outputBefore
        (
            c, "at 0.25;",
            "out { type x; writeControl adjustableRunTime; writeInterval 0.1; }"
        ),
        "every 0.1 s"
    );
    expectHolds(outputBefore(c, "at 3;", writes), "endTime of the experiment A is 2 s");
    EXPECT_EQ(c.count(), 0);
}


TEST(misfitTables, rowsOfALaterStartReplaceThoseBefore)
{
    const fakeCase c;
    const std::string out("postProcessing/out/");
    for (const char* start : {"0", "1"})
    {
        mkDir(c.folder()/out/start);
    }
    c.write(out + "0/out.dat", "# Time y\n0 1\n1 1\n1.2 1\n2 1\n");
    c.write(out + "1/out.dat", "# Time y\n1.5 2\n2 2\n3 2\n");

    // A second start at 1 s, as OpenFOAM names its file
    c.write(out + "1/out_1.dat", "# Time y\n1.5 3\n2 3\n");

    // A start at the end writes no row
    mkDir(c.folder()/out/"2");
    c.write(out + "2/out.dat", "# Time y\n");
    const numberTable t(writtenTable(c.folder(), "out", "out.dat"));
    EXPECT_EQ(t.column(0), scalarList({0, 1, 1.5, 2}));
    EXPECT_EQ(t.column(1), scalarList({1, 1, 3, 3}));
}


TEST(misfitTables, aHeightThatIsMoreThanTheMeshIsRefused)
{
    testMesh m;
    const auto profile = [&m](const std::string& height)
    {
        IStringStream is
        (
            "quantity length; uncertainty 1; at 0; simulated { type profile;"
            " function cells; height " + height + "; }"
        );
        const channel c("S1", dictionary(is), purpose::calibration, "", 40);
        return refusal([&](){ checkPlaces(m.mesh(), {observer(c)}, "A"); });
    };
    EXPECT_EQ(profile("1"), "nothing");
    expectHolds
    (
        profile("400"), "S1 has the height 400 m, more than the diagonal of the mesh"
    );
}


TEST(misfitTables, aNameWithoutItsQuotesIsNotTakenForANumber)
{
    const auto column = [](const string& entry)
    {
        return columnIn(dictionary(IStringStream(entry)()), "column", "2");
    };
    EXPECT_EQ(column("column 3;"), "3");
    EXPECT_EQ(column("column \"1:zz\";"), "1:zz");
    EXPECT_EQ(column("file f;"), "2");
    expectHolds(refusal([&]() { column("column 1:zz;"); }), "needs quotes");
}
