// SPDX-License-Identifier: GPL-3.0-or-later
// On a surge in closed form: what no candidate explains is found by a free
// correction, in its place or by its dimensionless number, and noise is not.

#include "correctedWorld.H"
#include "diagnosis.H"
#include "testNumber.H"
#include "designs.H"
#include "stages.H"
#include "words.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- More drag by constant + slope ln(Re/100)
HashTable<scalar> dragLaw(const scalar constant, const scalar slope)
{
    HashTable<scalar> values;
    for (const correctionElement& e : elements())
    {
        if (e.family == elementFamily::drag)
        {
            values.insert(e.name, constant + slope*std::log(e.Reynolds/100));
        }
    }
    return values;
}


//- With a library that lacks the cause
settings poorSettings()
{
    settings s;
    s.parameters =
    {
        {"release", {}, 0, 0.1, -0.4, 0.4}, {"friction", {}, 0, 0.1, -0.4, 0.4}
    };
    for (const label m : {0, 3})
    {
        const word name(world::mechanism(m));
        s.candidates.append({name, name, {}, 0.5, 1, 1, GREAT, {}});
    }
    s.correction = elements();
    s.clockUncertainty = 0.005;
    s.draws = 500;
    return s;
}


finding diagnosed(correctedWorld& w, const settings& set = poorSettings())
{
    const finding f(diagnose(w, set));
    std::printf("%s: %s\n", verdictNames[f.verdict.kind].c_str(), describe(f).c_str());
    for (const fittedLaw& l : f.correction.laws)
    {
        std::printf("  %6.1f %s\n", l.lead, describe(l).c_str());
    }
    return f;
}

} // End anonymous namespace


TEST(misfitUnknown, aPushFollowsNumbersOfTheWaterThatTheCaseHas)
{
    List<correctionElement> one(1, elements().first());
    ASSERT_EQ(one[0].family, elementFamily::push);
    HashTable<conditions> met;
    met.insert(one[0].name, {-2, 0.1, 0.6, 1200, 0.05, 3});

    // Weight 3600 N/m3; Fr2 = 4/0.3; Fr2/Re = 0.05 x 2/(3 x 0.01)
    const scalarList expected
    ({
        -3600, -3600*4/0.3, -3600*0.05*2/0.03, -3600*0.4
    });
    dimensionlessLaw law;
    law.family = elementFamily::push;
    law.functions = identity(4);
    const mat computed(combinationOf(law, one, met));
    forAll(expected, i)
    {
        EXPECT_NEAR(computed(0, i)/expected[i], 1, 1e-12) << i;
    }

    // What is not known has no laws
    met.set(one[0].name, {-2, 0.1, 0.6});
    EXPECT_TRUE(lawsOf(elementFamily::push, one, met).empty());
}


TEST(misfitUnknown, theErrorOfTheMeshInAnotherExperimentCountsThere)
{
    settings set(poorSettings());
    set.resolutions = wordList({"finer"});
    std::vector<vec> sigma;
    for (const scalar share : {0.0, 0.1})
    {
        HashTable<scalar> push;
        push.insert("push2_2", -45);
        correctedWorld w(push, push, 500);
        w.changeWhereFiner(share);
        const finding f(diagnosed(w, set));
        for (const heldOut& h : f.correction.held)
        {
            if (h.experiment == "B")
            {
                sigma.push_back(h.sigma);
            }
        }
    }
    ASSERT_EQ(sigma.size(), 2);
    EXPECT_GT((sigma[1] - sigma[0]).maxCoeff(), 0.5*sigma[0].maxCoeff());
}


TEST(misfitUnknown, aPushThatNoCandidateIsIsFoundInItsPlace)
{
    for (const label seed : {500, 501, 502})
    {
        HashTable<scalar> truth;
        truth.insert("push2_2", -45);
        correctedWorld w(truth, HashTable<scalar>(), seed);
        const finding f(diagnosed(w));

        EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
        ASSERT_FALSE(f.correction.elements.empty());
        const freeElement& first = f.correction.elements.first();
        EXPECT_EQ(first.element.name, "push2_2");
        EXPECT_NEAR(first.value, -45, 10);
        const string words(describe(first.element, first.value));
        EXPECT_NE(words.find("against (1 0 0) at 1.5 m"), std::string::npos);
        EXPECT_NE(describe(f).find(words), std::string::npos);

        // On the gauge that was not used; in B there is no such push
        ASSERT_EQ(f.correction.held.size(), 2);
        testNumber("held-out misfit gone", removed(f.correction.held[0]));
        EXPECT_GT(removed(f.correction.held[0]), 0.7);
        EXPECT_FALSE(f.correction.transfers);
        EXPECT_FALSE(f.correction.named);
    }
}


TEST(misfitUnknown, whereTheSolverFailsWithTheFittedPushThatOfTheSurfaceIsReported)
{
    HashTable<scalar> truth;
    truth.insert("push2_2", -45);
    correctedWorld w(truth, HashTable<scalar>(), 500);
    w.failWhereFitted();
    const finding f(diagnosed(w));
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_FALSE(f.correction.named);
    ASSERT_FALSE(f.correction.elements.empty());
    EXPECT_EQ(f.correction.elements.first().element.name, "push2_2");
    EXPECT_NEAR(f.correction.elements.first().value, -45, 10);

    ASSERT_FALSE(f.correction.held.empty());
    EXPECT_GT(removed(f.correction.held[0]), 0.7);
    EXPECT_NE
    (
        describe(f).find("The solver fails with it: these numbers are of the"),
        std::string::npos
    ) << describe(f);
}


TEST(misfitUnknown, anotherDragLawIsRegressedOnTheReynoldsNumber)
{
    for (const label seed : {600, 601, 602})
    {
        const HashTable<scalar> truth(dragLaw(0, 0.2));
        correctedWorld w(truth, truth, seed);
        const finding f(diagnosed(w));

        EXPECT_EQ(f.verdict.kind, verdictKind::named);
        EXPECT_EQ(f.verdict.names, wordList({"drag:Re_p"}));
        EXPECT_TRUE(f.correction.transfers);
        ASSERT_FALSE(f.correction.laws.empty());
        EXPECT_NE
        (
            describe(f.correction.laws.first()).find("(Re_p/30)^(0."),
            std::string::npos
        ) << describe(f.correction.laws.first());
        for (const heldOut& h : f.correction.held)
        {
            testNumber("held-out misfit gone, drag law", removed(h));
            EXPECT_GT(removed(h), 0.7);
        }
    }
}


TEST(misfitUnknown, aLawIsNoSurerThanTheLimitOfWhatIsNotCalibrated)
{
    const HashTable<scalar> truth(dragLaw(0, 0.2));
    settings set(poorSettings());
    for (const scalar limit : {set.largestUncalibrated, 0.6})
    {
        set.largestUncalibrated = limit;
        correctedWorld w(truth, truth, 600);
        const finding f(diagnosed(w, set));
        ASSERT_EQ(f.verdict.kind, verdictKind::named);

        // Its lead alone would give more
        EXPECT_GT(f.correction.laws.first().lead, 6);
        EXPECT_EQ(f.verdict.confidence, limit);
    }
}


TEST(misfitUnknown, aLawWithWhichTheSolverFailsIsReportedAndNoOtherIsNamed)
{
    const HashTable<scalar> truth(dragLaw(0, 0.2));
    correctedWorld w(truth, truth, 600);
    w.failWhereFitted();
    const finding f(diagnosed(w));
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_FALSE(f.correction.explained);
    EXPECT_NE(describe(f).find("fails with one that may say as much"), std::string::npos)
        << describe(f);
    scalar lead = -GREAT;
    for (const fittedLaw& l : f.correction.laws)
    {
        EXPECT_GT(l.lead, -1e6) << describe(l);
        lead = max(lead, l.lead);
    }
    EXPECT_GT(lead, 0);
}


TEST(misfitUnknown, aPartOfALawWithWhichTheSolverFailsIsNotNamed)
{
    const HashTable<scalar> truth(dragLaw(0.5, 0.02));
    correctedWorld w(truth, truth, 600);
    w.failWhereDragVaries();
    const finding f(diagnosed(w));
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_NE(describe(f).find("(Re_p/30)^(0."), std::string::npos) << describe(f);
    EXPECT_NE(describe(f).find("fails with one that may say as much"), std::string::npos)
        << describe(f);

    // The part runs, and would be enough
    ASSERT_FALSE(f.correction.laws.empty());
    const fittedLaw& part = f.correction.laws.first();
    EXPECT_EQ(describe(part).find("Re_p"), std::string::npos) << describe(part);
    EXPECT_GT(part.lead, poorSettings().gap);
}


TEST(misfitUnknown, theSameLawInOneExperimentOnlyIsNotNamed)
{
    const HashTable<scalar> truth(dragLaw(0, 0.2));
    correctedWorld w(truth, HashTable<scalar>(), 610);
    const finding f(diagnosed(w));

    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
    EXPECT_FALSE(f.correction.transfers);
    EXPECT_NE(describe(f).find("no other experiment confirms"), std::string::npos);
}


TEST(misfitUnknown, aLawIsNotNamedWhereTheOtherExperimentGivesNoSamplesWithIt)
{
    const HashTable<scalar> truth(dragLaw(0, 0.2));
    correctedWorld w(truth, truth, 600);
    w.loseWhereFitted();
    const finding f(diagnosed(w));
    EXPECT_TRUE(f.correction.explained);
    EXPECT_FALSE(f.correction.transfers);
    EXPECT_EQ(f.verdict.kind, verdictKind::unknown);
}


TEST(misfitUnknown, whatIsLeftMayBeAsMuchAsTheLimitWhereverItIsEvaluated)
{
    settings set(poorSettings());
    set.leftIfConfirmed = 0;
    set.matchedChance = 0.9999;
    const auto elsewhere = [&set]()
    {
        correctedWorld w(dragLaw(0, 0.2), dragLaw(0, 0.1), 600);
        return diagnosed(w, set).correction;
    };
    const heldOut b(elsewhere().held.last());
    ASSERT_EQ(b.experiment, "B");
    ASSERT_GT(b.squareAfter, set.matchedSquare);

    set.matchedSquare = b.squareAfter;
    const correctionFit c(elsewhere());
    ASSERT_EQ(c.held.last().squareAfter, c.held.last().limitOfMatch);
    EXPECT_TRUE(c.transfers);

    set.leftIfConfirmed = 0.5;
    heldOut half(b);
    half.squareBefore = 3;
    half.squareAfter = 2;
    half.limitOfMatch = 1.5;
    EXPECT_TRUE(isConfirmed(List<heldOut>(1, half), set));
}


TEST(misfitUnknown, noiseAloneLeavesTheCorrectionZero)
{
    const settings set(poorSettings());
    for (label seed = 700; seed < 720; ++seed)
    {
        correctedWorld w({}, {}, seed);
        study explained(w, set);
        explained.addRuns(parameterDesign(explained.bounds));
        explained.build();
        const correctionFit c
        (
            fitCorrection(explained, explained.calibration.score().base(), {})
        );
        EXPECT_TRUE(c.elements.empty()) << describe(c);
        EXPECT_FALSE(c.explained) << describe(c);
        EXPECT_FALSE(c.after.size());
    }
}
