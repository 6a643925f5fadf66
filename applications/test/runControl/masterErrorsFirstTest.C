// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of all ranks but the first wait before they are shown.

#include "masterErrorsFirst.H"

#include "Pstream.H"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <sstream>

using namespace Foam;

namespace
{

//- std::cerr goes into a string while it lives
class caughtErrors
{
    std::ostringstream text_;

    std::streambuf* const before_ = std::cerr.rdbuf(text_.rdbuf());

public:

    caughtErrors() = default;

    ~caughtErrors()
    {
        std::cerr.rdbuf(before_);
    }

    std::string text() const
    {
        return text_.str();
    }

    bool areDirect() const
    {
        return std::cerr.rdbuf() == text_.rdbuf();
    }
};


//- How long it takes to print an error [s]
double timeToPrint(const char* words)
{
    using clock = std::chrono::steady_clock;
    const clock::time_point start = clock::now();
    std::cerr << words << std::flush;
    return std::chrono::duration<double>(clock::now() - start).count();
}


//- What SIGTERM does here, for comparison
void leave(int)
{}

} // End anonymous namespace


TEST(masterErrorsFirst, theFirstRankIsNotHeldBack)
{
    const caughtErrors caught;
    {
        const masterErrorsFirst guard;
        EXPECT_TRUE(caught.areDirect());
        EXPECT_LT(timeToPrint("at once"), 1);
    }
    EXPECT_EQ(caught.text(), "at once");
}


TEST(ParallelMasterErrorsFirst, otherRanksWaitOnceAndShowAll)
{
    const auto handler = std::signal(SIGTERM, leave);
    const caughtErrors caught;
    {
        const masterErrorsFirst guard;
        EXPECT_EQ(caught.areDirect(), Pstream::master());
        const double first = timeToPrint("one, ");
        if (Pstream::master())
        {
            EXPECT_LT(first, 1);
        }
        else
        {
            EXPECT_GE(first, 2);
        }
        EXPECT_LT(timeToPrint("two"), 1);
    }
    EXPECT_TRUE(caught.areDirect());
    EXPECT_EQ(caught.text(), "one, two");
    EXPECT_EQ(std::signal(SIGTERM, handler), leave);
}
