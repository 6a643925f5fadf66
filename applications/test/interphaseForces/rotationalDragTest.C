// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests of the rotational drag laws.

#include "forceModels.H"
#include "forceLaws.H"
#include "testMesh.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

//- A grain that spins with the Reynolds number rho d^2 |spin|/mu
grainState spinning(const scalar Re)
{
    grainState state = inWater();
    state.relativeSpin =
        vector(0, 0, -Re*state.mu/(state.rho*sqr(state.d)));
    return state;
}


//- Coefficient over that of slow spinning, pi mu d^3
scalar overLaminar(const std::string& text, const scalar Re)
{
    const grainState state = spinning(Re);
    testMesh box;
    return
        forceModels(box.mesh(), entries("rotationalDrag {" + text + "}"))
       .rotationalDragCoefficient(state)/(M_PI*state.mu*pow3(state.d));
}

} // End anonymous namespace


TEST(rotationalDrag, everyLawIsThereUnderItsName)
{
    EXPECT_EQ(law<rotationalDragModel>("model Dennis;")->type(), "Dennis");
    EXPECT_FALSE(law<rotationalDragModel>("model none;").valid());
}


TEST(rotationalDrag, wrongInputListsWhatIsValid)
{
    expectError<rotationalDragModel>("model Denis;", {"Denis", "Dennis"});
    expectError<rotationalDragModel>("", {"model", "missing", "none"});
    expectError<rotationalDragModel>("model Dennis; d 1;", {"strength"});
    expectScaledError<rotationalDragModel>
    (
        "model Dennis; strength -1;", {"between 0"}
    );
}


TEST(rotationalDrag, slowSpinFollowsRubinowAndKeller)
{
    EXPECT_NEAR(overLaminar("model Dennis;", 0), 1, 1e-14);
    EXPECT_NEAR(overLaminar("model Dennis;", 30), 1, 1e-14);
}


TEST(rotationalDrag, fastSpinFollowsDennis)
{
    // Torque over rho a^5 spin^2/2 is 6.45/sqrt(R) + 32.1/R, R = Re/4 with the
    // radius a; slow spin has 16 pi/R
    for (const scalar R : {20.0, 100.0, 1000.0})
    {
        EXPECT_NEAR
        (
            overLaminar("model Dennis;", 4*R),
            (6.45/std::sqrt(R) + 32.1/R)/(16*M_PI/R),
            1e-12
        ) << R;
    }
}


TEST(rotationalDrag, isContinuousBetweenSlowAndFast)
{
    scalar last = overLaminar("model Dennis;", 30);

    for (scalar Re = 30; Re < 34; Re += 0.01)
    {
        const scalar now = overLaminar("model Dennis;", Re);
        EXPECT_GE(now, last);
        EXPECT_LT(now - last, 1e-4);
        last = now;
    }
}


TEST(rotationalDrag, strengthZeroIsNothingAndBetweenIsInProportion)
{
    const scalar full = overLaminar("model Dennis;", 500);

    EXPECT_EQ(overLaminar("model Dennis; strength 0;", 500), 0);
    EXPECT_NEAR
    (
        overLaminar("model Dennis; strength 0.3;", 500), 0.3*full, 1e-14
    );
    EXPECT_EQ(overLaminar("model none;", 500), 0);
}
