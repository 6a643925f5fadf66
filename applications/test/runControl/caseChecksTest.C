// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: what stops a run before or while it goes.

#include "caseChecks.H"
#include "stopSignal.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>

using namespace Foam;


TEST(caseChecks, namesTheFieldAndTheCellOfANumberThatIsNone)
{
    testMesh box;
    volScalarField T
    (
        IOobject("T", box.time().timeName(), box.mesh()),
        box.mesh(),
        dimensionedScalar("T", dimTemperature, 300)
    );
    EXPECT_EQ(refusal([&]() { checkFinite(T); }), "nothing");

    T.primitiveFieldRef()[5] = std::numeric_limits<scalar>::quiet_NaN();
    const std::string words(refusal([&]() { checkFinite(T); }));
    expectHolds(words, "has 1 values");
    expectHolds(words, "in cell 5 at");
}


TEST(stopSignal, isRequestedOnceASignalHasCome)
{
    const stopSignal signal;
    EXPECT_FALSE(signal.requested());
    std::raise(SIGUSR1);
    EXPECT_TRUE(signal.requested());
    EXPECT_FALSE(stopSignal().requested());

    for (const int number : {SIGUSR1, SIGTERM, SIGINT})
    {
        std::signal(number, SIG_DFL);
    }
}
