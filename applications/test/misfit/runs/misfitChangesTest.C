// SPDX-License-Identifier: GPL-3.0-or-later
// misfitFoam changes in a case what the dictionary requests, and nothing else.

#include "caseChange.H"
#include "fakeCase.H"

#include "IFstream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

caseChange change(const std::string& text)
{
    IStringStream is(text);
    return caseChange(dictionary(is));
}

} // End anonymous namespace


TEST(misfitChanges, anEntryIsChangedAndIncludesStay)
{
    const fakeCase c;
    change("file \"system/controlDict\"; entry endTime; scale 2; offset 1;")
        .apply(c.folder(), 3);
    const std::string text(contentOf(c.folder()/"system/controlDict"));
    expectHolds(text, "#include");
    expectHolds(text, "\"more\"");

    IFstream is(c.folder()/"system/controlDict");
    const dictionary dict(is);
    EXPECT_EQ(dict.get<scalar>("endTime"), 7);
    EXPECT_EQ(dict.get<scalar>("deltaT"), 1);
}


TEST(misfitChanges, allKindsOfEntriesStayBesideOneThatIsChanged)
{
    const std::string kept[] =
    {
        "endTime #eval{ 2*$start + pow(3, 2) };",
        "both #eval{ $start > 1 ? (1 + 2) : 3 } #eval { 4 };",
        "quoted #eval{ strlen(\"a } b\") };",
        "spread #eval\n{\n    // of the year }\n    1 /* } */ + 1\n};",
        "verbatim #eval #{ 1 + 2 #};",
        "inside ( 0 #eval{ 1 + 1 } 0 );",
        "inline ${{ 3*$start }};",
        "coded #codeStream { code #{ os << 1; if (true) { os << 2; } #}; };"
    };
    std::string text
    (
        "FoamFile { version 2.0; format ascii; class dictionary; object d; }\n"
        "#include \"more\"\n"
        "start 2;\n"
        "sum #calc \"$start + 1\";\n"
        "of $start; deep ${start}; above $:start;\n"
        "nu nu [0 2 -1 0 0 0 0] 1e-06;\n"
        "places ((0 0 1) (1 2 3));\n"
        "more { \"(U|p).*\" { tolerance 1e-07; } $copied; }\n"
        "type \"a // b { c\"; // of { a comment\n"
        "level 0.3;\n"
    );
    for (const std::string& one : kept)
    {
        text += one + '\n';
    }
    const fakeCase c;
    c.write("system/all", text);
    change("file \"system/all\"; entry level;").apply(c.folder(), 0.5);
    const std::string after(contentOf(c.folder()/"system/all"));
    for (const std::string& one : kept)
    {
        const size_t at = one.find_first_of("#$(");
        expectHolds
        (
            after, one.substr(at, one.size() - at - 1 - (one[at] == '(' ? 1 : 0))
        );
    }
    for
    (
        const char* words :
        {
            "#include", "\"$start + 1\"", "$start;", "${start};", "$:start;",
            "[ 0 2 -1 0 0 0 0 ] 1e-06", "\"(U|p).*\"", "$copied", "\"a // b { c\""
        }
    )
    {
        expectHolds(after, words);
    }
    expectLacks(after, "misfitFunction");
    expectHolds(after, "0.5;");

    // Once more, and one of them
    change("file \"system/all\"; entry level;").apply(c.folder(), 0.6);
    change("file \"system/all\"; entry endTime;").apply(c.folder(), 3);
    const std::string last(contentOf(c.folder()/"system/all"));
    expectLacks(last, "pow(3, 2)");
    expectHolds(last, "#eval{ $start > 1 ? (1 + 2) : 3 } #eval { 4 };");
    expectHolds(last, "0.6;");
}


TEST(misfitChanges, whatIsComputedInBracesIsComputedAfterAChange)
{
    const fakeCase c;
    c.write
    (
        "system/all", "level 2; twice #eval{ 2*$level }; list (1 #eval{ $level + 1 });\n"
    );
    change("file \"system/all\"; entry level;").apply(c.folder(), 5);
    IFstream is(c.folder()/"system/all");
    const dictionary dict(is);
    EXPECT_EQ(dict.get<scalar>("twice"), 10);
    EXPECT_EQ(dict.get<scalarList>("list"), scalarList({1, 6}));
}


TEST(misfitChanges, aVariableOfAScriptIsChanged)
{
    const fakeCase c;
    change("file \"constant/script\"; variable mu;").apply(c.folder(), 0.25);
    EXPECT_EQ
    (
        contentOf(c.folder()/"constant/script"),
        "variable mu equal 0.25\nfix 1 mu ${mu}\n"
    );
}


TEST(misfitChanges, whatIsNotThereCannotBeChanged)
{
    const fakeCase c;
    const auto output = [&c](const std::string& text)
    {
        return refusal([&](){ change(text).apply(c.folder(), 1); });
    };
    expectHolds(output("file \"constant/model\"; entry \"a/slop\";"), "add true");
    expectHolds(output("file \"constant/none\"; entry x;"), "has no file");
    expectHolds(output("file \"constant/script\"; variable nu;"), "0 lines");
}
