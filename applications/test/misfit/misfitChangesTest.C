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
