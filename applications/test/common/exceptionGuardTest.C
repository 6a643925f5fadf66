// SPDX-License-Identifier: GPL-3.0-or-later
// A fatal error throws while a guard lives, and only then.

#include "exceptionGuard.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Errors as in a program, which end it; exceptions again after the test
class exceptionGuards
:
    public testing::TestWithParam<error*>
{
protected:

    error& fatal = *GetParam();

    void SetUp() override
    {
        fatal.throwExceptions(false);
    }

    void TearDown() override
    {
        fatal.throwExceptions(true);
    }
};

} // End anonymous namespace


TEST_P(exceptionGuards, throwWhileTheyLive)
{
    {
        const exceptionGuard guard(fatal);
        EXPECT_TRUE(fatal.throwing());
    }

    EXPECT_FALSE(fatal.throwing());
}


TEST_P(exceptionGuards, areGoneWhereTheErrorIsHandled)
{
    bool thrown = false;

    try
    {
        const exceptionGuard guard(fatal);
        fatal("test", __FILE__, __LINE__) << "a mistake" << exit(fatal);
    }
    catch (const error&)
    {
        thrown = true;
        EXPECT_FALSE(fatal.throwing());
    }

    EXPECT_TRUE(thrown);
    EXPECT_FALSE(fatal.throwing());
}


TEST_P(exceptionGuards, leaveErrorsThrowingThatThrewBefore)
{
    fatal.throwExceptions();
    {
        const exceptionGuard outer(fatal);
        const exceptionGuard inner(fatal);
    }

    EXPECT_TRUE(fatal.throwing());
}


INSTANTIATE_TEST_SUITE_P
(
    errors,
    exceptionGuards,
    testing::Values(static_cast<error*>(&FatalError), &FatalIOError)
);
