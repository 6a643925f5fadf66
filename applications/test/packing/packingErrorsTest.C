// SPDX-License-Identifier: GPL-3.0-or-later
// Packings: what is wrong with their entries, or cannot be reached, is named.

#include "packingModel.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- The message of the error that making such a packing ends with
std::string complaint
(
    const std::string& entries,
    const vector& g = vector(0, 0, -9.81)
)
{
    try
    {
        IStringStream is(entries + " density 2650;");
        packingModel::New(dictionary(is), g)->make("/tmp");
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "";
}


::testing::AssertionResult contains(const std::string& text, const char* words)
{
    return text.find(words) != std::string::npos
      ? ::testing::AssertionSuccess()
      : ::testing::AssertionFailure() << '"' << text << "\" lacks " << words;
}


//- Making such a packing ends with an error that has these words
void expectComplaint(const std::string& entries, const char* words)
{
    EXPECT_TRUE(contains(complaint(entries), words));
}


//- Entries of a dense packing in a box, without its grains
const std::string box = "type dense; box (0 0 0) (0.3 0.3 0.3); ";

const std::string grain = "diameter 0.03; ";

} // End anonymous namespace


TEST(packing, anErrorListsTheTypes)
{
    expectComplaint("type heap; " + grain, "dense");
    expectComplaint("type heap; " + grain, "settled");
}


TEST(packing, anErrorNamesTheWrongAmount)
{
    expectComplaint(box + grain + "solidFraction 0.7;", "out of range");
    expectComplaint(box + "diameter 0.4; solidFraction 0.5;", "too small");
    expectComplaint
    (
        box + grain + "solidFraction 0.5; mass 90; fluidDensity 1000;", "contradict"
    );
    expectComplaint
    (
        "type dense; box (0 0 0) (300 300 300); diameter 0.003; solidFraction 0.5;",
        "in metres"
    );
    expectComplaint(box + grain, "Too little");
    expectComplaint(box + "diameters ((0.03 0.5) (0.02 0.4)); ", "sum to 1");
}


TEST(packing, anErrorNamesTheWrongKeyword)
{
    expectComplaint
    (
        box + grain + "solidFraction 0.5; periodc (y);", "Unknown keyword periodc"
    );
    expectComplaint(box + grain + "solidFraction 0.5; periodic (w);", "x, y and z");

    const std::string settled
    (
        "type settled; box (0 0 0) (0.6 0.1 0.05); diameter 0.01; "
    );
    const std::string contact
    (
        "youngsModulus 5e6; poissonsRatio 0.3; restitution 0.4; friction 0.7; "
    );
    expectComplaint
    (
        settled + "soldFraction 0.5; contact { " + contact + "rollingFriction 0.1; }",
        "Unknown keyword soldFraction"
    );
    expectComplaint
    (
        settled + "contact { " + contact + "rolingFriction 0.1; }",
        "Unknown keyword rolingFriction"
    );
}


TEST(packing, namesTheLargestSolidFractionWhereWallsAreTooNear)
{
    const std::string text = complaint
    (
        "type dense; box (0 0 0) (0.05 0.05 0.5); diameter 0.03;"
        " solidFraction 0.6;"
    );
    EXPECT_TRUE(contains(text, "largest one reached"));
}


TEST(packing, aBedNeedsGravityTowardsItsFloor)
{
    EXPECT_TRUE
    (
        contains
        (
            complaint
            (
                "type settled; box (0 0 0) (0.6 0.1 0.05); diameter 0.01;"
                " contact { youngsModulus 5e6; poissonsRatio 0.3;"
                " restitution 0.4; friction 0.7; rollingFriction 0.1; }",
                vector(Zero)
            ),
            "constant/g"
        )
    );
}
