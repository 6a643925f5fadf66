// SPDX-License-Identifier: GPL-3.0-or-later
// The statistics of misfitFoam where runs differ by chance: chaos counts once for the
// recording, and not as squares of the surface or as an error of the mesh.

#include "misfitWorld.H"
#include "heldOutChance.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- What chance adds to a run, of that standard deviation in each sample
vec chanced(const label n, const scalar deviation, std::mt19937& generator)
{
    std::normal_distribution<scalar> normal;
    return vec::NullaryExpr(n, [&](Eigen::Index) { return deviation*normal(generator); });
}


//- Runs at random states and replicates, linear in the variables but for chance. Three
//  gauges; what another mesh changes is added to chance in samples 8 to 15 of the second
struct chaoticRuns
{
    static constexpr label n = 24;

    static constexpr scalar deviation = 200;

    //- Runs with another mesh
    label finerRuns = 1;

    world w = world(n);

    std::mt19937 generator = std::mt19937(11);

    mat slopes;

    explicit chaoticRuns()
    :
        slopes(n*4, w.bounds.mean.size())
    {
        w.bounds.width = vec::Ones(w.bounds.mean.size());
        for (label k = 0; k < slopes.cols(); ++k)
        {
            slopes.col(k) = chanced(slopes.rows(), 300, generator);
        }
    }

    vec run(const vec& x)
    {
        return slopes*x + chanced(slopes.rows(), deviation, generator);
    }

    statistics::sampledModel model(const bool chaotic, const scalar ofMesh)
    {
        statistics::sampledModel m(w.data, w.bounds, 0, 0.2, chaotic);
        std::uniform_real_distribution<scalar> any;
        const label nX = slopes.cols();
        for (label r = 0; r < 40; ++r)
        {
            const vec x =
                vec::NullaryExpr(nX, [&](Eigen::Index) { return any(generator); });
            m.addRun(x, run(x));
        }
        const vec none = vec::Zero(nX);
        mat repeats(slopes.rows(), 0);
        for (label r = 0; r < 12; ++r)
        {
            statistics::appendColumn(repeats, run(none));
        }
        m.addRepeats(repeats, 1);
        mat changes(slopes.rows(), 0);
        for (label r = 0; r < finerRuns; ++r)
        {
            vec one = run(none) - repeats.col(r);
            one.segment(n + 8, 8).array() += ofMesh;
            statistics::appendColumn(changes, one);
        }
        m.addResolution("mesh", changes);
        m.build();
        return m;
    }
};


//- Root mean square over so many samples of what a source adds
scalar sizeOf
(
    const statistics::sampledModel& m,
    const std::string& source,
    const label first,
    const label size
)
{
    for (const uncertaintySource& s : m.uncertainty().sources(m.data().y))
    {
        if (s.first == source)
        {
            return s.second.segment(first, size).norm()/std::sqrt(scalar(size));
        }
    }
    return 0;
}

} // End anonymous namespace


TEST(misfitChaos, isCountedOnceForTheRecordingAndByItsLeverageForTheSurface)
{
    chaoticRuns runs;
    const statistics::sampledModel m(runs.model(true, 0));
    const scalar leverage = m.surface().leverage().mean();
    EXPECT_NEAR(leverage, 8.0/40, 1e-9);
    const label all = 4*runs.n;
    const scalar expected = runs.deviation*std::sqrt(1 + leverage);
    EXPECT_NEAR(sizeOf(m, "chaos", 0, all), expected, 0.06*expected);

    // Without the setting it is in three parts, twice as wide together
    const statistics::sampledModel parts(chaoticRuns().model(false, 0));
    EXPECT_GT
    (
        std::hypot
        (
            sizeOf(parts, "replicates", 0, all),
            sizeOf(parts, "between the runs", 0, all),
            sizeOf(parts, "mesh", 0, all)
        ),
        2*expected
    );
}


TEST(misfitChaos, isNoErrorOfTheMesh)
{
    const label all = 4*chaoticRuns::n;
    EXPECT_LT
    (
        sizeOf(chaoticRuns().model(true, 0), "mesh", 0, all),
        0.5*sizeOf(chaoticRuns().model(false, 0), "mesh", 0, all)
    );

    // What another mesh changes beyond it counts, there and with its place
    const statistics::sampledModel m(chaoticRuns().model(true, 1500));
    EXPECT_GT(sizeOf(m, "mesh", chaoticRuns::n + 8, 8), 2000);
    EXPECT_LT(sizeOf(m, "mesh", 2*chaoticRuns::n, 2*chaoticRuns::n), 500);
}


TEST(misfitChaos, hidesWhatAnotherMeshChangesFromOneRunButNotFromSix)
{
    // What it changes is as large as chance is in one run; with the parametric part,
    // which is twice as large, sqrt(5) of that is to be found
    const auto error = [](const label finerRuns)
    {
        scalar square = 0;
        for (label seed = 1; seed <= 40; ++seed)
        {
            chaoticRuns runs;
            runs.generator.seed(seed);
            runs.finerRuns = finerRuns;
            const scalar whole = std::sqrt(5.0)*runs.deviation;
            const scalar found =
                sizeOf(runs.model(true, runs.deviation), "mesh", runs.n + 8, 8);
            square += sqr(found/whole - 1)/40;
        }
        return std::sqrt(square);
    };
    EXPECT_LT(error(6), 0.5*error(1));
}


namespace
{

//- Of so many worlds that many in which held-out channels contradict a mechanism by more
//  than chance does (0.05): they do not feel it, but for so many times what the runs,
//  with its effect of a size on all of them, lead to expect
label contradicted(const scalar shown, const scalar effect, const label worlds)
{
    label n = 0;
    for (label seed = 1; seed <= worlds; ++seed)
    {
        chaoticRuns runs;
        runs.generator.seed(seed);
        const statistics::sampledModel fitted(runs.model(true, 0));
        const label k = world::nParameters + 3;
        runs.slopes.setZero();
        runs.slopes.col(k).setConstant(effect);
        statistics::sampledModel heldOut(runs.model(true, 0));

        hypothesisFit best;
        best.what.mechanisms = {3};
        best.fit.x = vec::Zero(world::nParameters + 1);
        best.fit.x[world::nParameters] = 1;
        best.covariance = fitted.uncertainty().at(fitted.data().y);

        const vec without = vec::Zero(runs.w.bounds.mean.size());
        vec with = without;
        with[k] = 1;
        const statistics::responseSurface& surface = heldOut.surface();
        const vec base =
            vec::Constant(heldOut.size(), shown*effect)
          + chanced(heldOut.size(), runs.deviation, runs.generator);
        heldOut.record(base);
        n += statistics::chanceOfDegradation
        (
            fitted, heldOut, best, surface(without), surface(with),
            surface.chanceShared(with, without)
        ) < 0.05;
    }
    return n;
}

} // End anonymous namespace


TEST(misfitChaos, makesNoRightExplanationDegradeHeldOutChannels)
{
    // What is predicted there is chance in the runs alone
    EXPECT_LT(contradicted(0, 0, 60), 8);
}


TEST(misfitChaos, savesNoExplanationThatHeldOutChannelsContradict)
{
    // The opposite of what is predicted, half as wide as chance in each sample
    EXPECT_GT(contradicted(-1, 0.5*chaoticRuns::deviation, 60), 55);
}


TEST(misfitChaos, isSharedByAValueAndADifferenceAsInManyEnsembles)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<scalar> any;
    const mat x = mat::NullaryExpr(3, 20, [&](Eigen::Index) { return any(generator); });
    const vec zero(vec::Zero(3));
    const vec one(vec::Ones(3));
    const vec at = (vec(3) << 1, 0.2, 0).finished();
    const vec other = (vec(3) << 0, 0.6, 0).finished();

    // Each sample is an ensemble of its own; with their variance it keeps to linear terms
    constexpr label ensembles = 20000;
    const mat y = chanced(ensembles*20, 1, generator).reshaped(ensembles, 20);
    const statistics::responseSurface surface
    (
        x, y, zero, one, std::vector<bool>(), vec::Ones(ensembles)
    );
    const vec value = surface(at);
    const scalar shared = value.dot(value - surface(other))/ensembles;
    EXPECT_NEAR(surface.chanceShared(at, other)/shared, 1, 0.05);
}


TEST(misfitChaos, theSurfaceHasSquaresOnlyWhereTheyPredict)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<scalar> any(-1, 1);
    mat x(4, 30);
    mat y(5, 30);
    for (label r = 0; r < 30; ++r)
    {
        x.col(r) = vec::NullaryExpr(4, [&](Eigen::Index) { return any(generator); });
        y.col(r) = x(0, r)*vec::Ones(5) + chanced(5, 1, generator);
    }
    const vec zero(vec::Zero(4));
    const vec one(vec::Ones(4));
    const vec chance(vec::Ones(5));
    const std::vector<bool> anyMix;
    EXPECT_EQ(statistics::responseSurface(x, y, zero, one, anyMix, chance).nTerms(), 5);
    EXPECT_GT(statistics::responseSurface(x, y, zero, one).nTerms(), 9);

    for (label r = 0; r < 30; ++r)
    {
        y.col(r).array() += 20*Foam::sqr(x(1, r));
    }
    EXPECT_GT(statistics::responseSurface(x, y, zero, one, anyMix, chance).nTerms(), 9);
}
