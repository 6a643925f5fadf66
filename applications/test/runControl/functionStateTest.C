// SPDX-License-Identifier: GPL-3.0-or-later
// What function objects keep for a run that goes on is written with all digits.

#include "functionState.H"
#include "testMesh.H"

#include "IFstream.H"
#include "IOdictionary.H"
#include "OSspecific.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

fileName stateFile(const testMesh& box)
{
    return box.folder()/"0"/"uniform"/"functionObjectProperties";
}

} // End anonymous namespace


TEST(functionState, isWrittenWithAllDigitsAndTheStreamsKeepTheirs)
{
    testMesh box;
    const scalar sum = 1000.0/3;
    IOdictionary state
    (
        IOobject
        (
            "functionObjectProperties",
            box.time().timeName(),
            "uniform",
            box.time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    );
    state.add("sum", sum);
    const unsigned int digits = IOstream::defaultPrecision();
    EXPECT_TRUE(writeFunctionState(box.time()));
    EXPECT_EQ(IOstream::defaultPrecision(), digits);
    EXPECT_LT(digits, 16);

    ASSERT_TRUE(isFile(stateFile(box)));
    const dictionary written(IFstream(stateFile(box))());
    EXPECT_NEAR(written.get<scalar>("sum"), sum, 1e-12);
}


TEST(functionState, thatIsNotThereIsNoFailure)
{
    testMesh box;
    EXPECT_TRUE(writeFunctionState(box.time()));
    EXPECT_FALSE(isFile(stateFile(box)));
}
