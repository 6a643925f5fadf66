// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: Koch & Hill and Beetstra against results that neither was made
// from, as the whole force over Stokes's at the superficial velocity.

#include "forceLaws.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

//- Tenneti, Garg & Subramaniam (2011), immersed-boundary computations of flow
//  through fixed random arrays of spheres; solid fraction s, Re superficial
scalar Tenneti(const scalar s, const scalar Re)
{
    const scalar e = 1 - s;

    return
        (1 + 0.15*std::pow(Re, 0.687))/pow3(e)
      + 5.81*s/pow3(e) + 0.48*std::cbrt(s)/pow4(e)
      + pow3(s)*Re*(0.95 + 0.61*pow3(s)/sqr(e));
}


scalar force(const dragModel& drag, const scalar s, const scalar Re)
{
    grainState state = inWater();
    state.voidFraction = 1 - s;
    return wholeForceOverStokes(drag, atReynolds(state, Re/(1 - s)));
}


//- Expects both laws within a fraction of Tenneti's correlation
void expectTenneti(std::initializer_list<scalar> Res, const scalar fraction)
{
    for (const std::string name : {"KochHill", "Beetstra"})
    {
        const auto drag = law<dragModel>("model " + name + ";");

        for (const scalar s : {0.1, 0.2, 0.3, 0.4, 0.5})
        {
            for (const scalar Re : Res)
            {
                EXPECT_NEAR(force(drag(), s, Re)/Tenneti(s, Re), 1, fraction)
                    << name << " solid fraction " << s << " Re " << Re;
            }
        }
    }
}

} // End anonymous namespace


TEST(dragComparison, latticeAndImmersedBoundaryAgreeAtRest)
{
    expectTenneti({1e-6}, 0.15);
}


TEST(dragComparison, latticeAndImmersedBoundaryAgreeAtModerateReynolds)
{
    expectTenneti({1, 10}, 0.15);
    expectTenneti({100}, 0.30);
}


TEST(dragComparison, KochHillAndBeetstraAgreeAtRest)
{
    const auto KochHill = law<dragModel>("model KochHill;");
    const auto Beetstra = law<dragModel>("model Beetstra;");

    for (scalar s = 0.02; s < 0.641; s += 0.02)
    {
        EXPECT_NEAR
        (
            force(KochHill(), s, 0)/force(Beetstra(), s, 0), 1, 0.08
        ) << s;
    }
}


TEST(dragComparison, dilutePackingsFollowTheExactSeries)
{
    // Random fixed arrays: Howells (1974), Hinch (1977), Kim & Russel (1985)
    for (const std::string name : {"KochHill", "Beetstra"})
    {
        const auto drag = law<dragModel>("model " + name + ";");

        for (const scalar s : {0.001, 0.01, 0.02})
        {
            const scalar exact =
                1 + 3*std::sqrt(s/2) + 135.0/64*s*std::log(s) + 16.456*s;

            EXPECT_NEAR(force(drag(), s, 0)/exact, 1, 0.05) << name << s;
        }
    }
}


TEST(dragComparison, theDensestPackingIsTheExactOne)
{
    // Zick & Homsy (1982): 435 for touching spheres, face-centred cubic
    const scalar s = std::sqrt(2.0)*M_PI/6;

    for (const std::string name : {"KochHill", "Beetstra"})
    {
        EXPECT_NEAR
        (
            force(law<dragModel>("model " + name + ";")(), s, 0)/435, 1, 0.05
        ) << name;
    }
}


TEST(dragComparison, BeetstraIsTheSameInItsOtherPublishedForm)
{
    // Per volume of the mixture, A mu s^2/(e d^2) + B mu s Re/(e d^2), as the
    // same authors write it for two-fluid models, 0.31 standing for 0.30975
    const auto drag = law<dragModel>("model Beetstra;");

    for (const scalar s : {0.1, 0.3, 0.6})
    {
        for (const scalar Re : {0.1, 30.0, 1000.0})
        {
            const scalar e = 1 - s;
            const scalar A = 180 + 18*pow4(e)/s*(1 + 1.5*std::sqrt(s));
            const scalar B =
                0.31*(1/e + 3*e*s + 8.4*std::pow(Re, -0.343))
               /(1 + std::pow(10.0, 3*s)*std::pow(Re, 2*e - 2.5));

            grainState state = atReynolds(inWater(), Re/e);
            state.voidFraction = e;
            const scalar beta =
                state.mu/(e*sqr(state.d))*(A*sqr(s) + B*s*Re);

            EXPECT_NEAR(drag->K(state)*s/volume(state)/beta, 1, 1e-3)
                << s << ' ' << Re;
        }
    }
}


TEST(dragComparison, BeetstraGivesGrainsOfAMixtureTheirShareBySurface)
{
    // At the same slip, in the same mixture
    const auto drag = law<dragModel>("model Beetstra;");
    grainState state = inWater();
    state.voidFraction = 0.45;
    state.slip = vector(0.02, 0, 0);
    state.dSauter = 1.5e-3;
    const scalar small = drag->K(state);
    state.d = 3e-3;

    EXPECT_NEAR(drag->K(state)/small, 9, 1e-12);
}


TEST(dragComparison, BeetstraKeepsThePressureDropOfTheSauterMean)
{
    // Slow flow through a mixture of 1 and 3 mm grains, half of each by volume
    const auto drag = law<dragModel>("model Beetstra;");
    const scalar sizes[] = {1e-3, 3e-3};

    grainState state = inWater();
    state.voidFraction = 0.45;
    state.dSauter = 1/(0.5/sizes[0] + 0.5/sizes[1]);
    state.slip = vector(0.02, 0, 0);

    scalar mixture = 0;
    for (const scalar d : sizes)
    {
        state.d = d;
        mixture += 0.5*drag->K(state)/volume(state);
    }

    state.d = state.dSauter;
    EXPECT_NEAR(mixture*volume(state)/drag->K(state), 1, 1e-12);
}
