// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnoses of the surge in closed form, for the tests of verdicts and gates.

#include "worldDiagnosis.H"
#include "temporaryFolder.H"
#include "textFile.H"
#include "verdictKind.H"
#include "words.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- A confidence that depends on the lead alone, see leastOfAName
confidenceTable byTheLead()
{
    // Of the lead the ground is ln(1 + lead); at a lead below zero, less ln(1 - lead)
    std::string text;
    for (const word& verdict : verdictNames.sortedToc())
    {
        text += verdict + " { cases 1; right 1; constant 0;";
        for (const word& ground : groundNames)
        {
            text += ground + (ground == "lead" ? " (1 -99 99);" : " (0 0 0);");
        }
        text += " }\n";
    }
    const temporaryFolder scratch;
    const fileName file(fileName(scratch)/"confidence");
    writeWhole(file, text);
    return confidenceTable(file);
}

} // End anonymous namespace


Foam::misfit::settings Foam::misfit::worldSettings()
{
    settings s;
    s.parameters =
    {
        {"release", {}, 0, 0.1, -0.4, 0.4}, {"friction", {}, 0, 0.1, -0.4, 0.4}
    };
    for (label m = 0; m < world::nMechanisms; ++m)
    {
        const word name(world::mechanism(m));
        s.candidates.append({name, name, {}, 0.5, 1, 1, GREAT, {}});
    }
    s.faults =
    {
        faultKind::lag, faultKind::gain, faultKind::zero, faultKind::drift,
        faultKind::clock, faultKind::clogged, faultKind::swapped, faultKind::misplaced,
        faultKind::units, faultKind::dead, faultKind::saturated
    };
    s.clockUncertainty = 0.005;
    s.draws = 500;
    static const confidenceTable confidence(byTheLead());
    s.confidence = confidence;
    return s;
}


Foam::scalar Foam::misfit::leastOfAName()
{
    const scalar gap = worldSettings().gap;
    return (1 + gap)/(2 + gap);
}


Foam::misfit::vec Foam::misfit::truth(const label mechanism, const scalar strength)
{
    vec x = vec::Zero(world::nParameters + world::nMechanisms);
    x[0] = 0.06;
    x[1] = -0.08;
    if (mechanism >= 0)
    {
        x[world::nParameters + mechanism] = strength;
    }
    return x;
}


Foam::misfit::finding
Foam::misfit::diagnose(worldSampler& s, const settings& set)
{
    return diagnose(static_cast<sampler&>(s), set);
}


void Foam::misfit::show(const finding& f)
{
    std::printf("%s: %s\n", verdictNames[f.verdict.kind].c_str(), describe(f).c_str());
    for (const gate& g : f.tests.gates)
    {
        std::printf("  %s\n", gateWords(g, f).dump().c_str());
    }
}


bool Foam::misfit::passes(const finding& f, const word& name)
{
    for (const gate& g : f.tests.gates)
    {
        if (gateNames[g.kind] == name && g.fails())
        {
            return false;
        }
    }
    return true;
}


void Foam::misfit::expectFault
(
    const std::optional<sensorFault>& fault,
    const faultKind kind,
    const std::string& channel,
    const std::string& partner
)
{
    ASSERT_TRUE(fault.has_value());
    EXPECT_EQ(fault->kind, kind);
    EXPECT_EQ(fault->channel, channel);
    EXPECT_EQ(fault->partner, partner);
}


bool Foam::misfit::hasAll(const hypothesis& h, const std::vector<int>& mechanisms)
{
    for (const int m : mechanisms)
    {
        if (!statistics::contains(h.mechanisms, m))
        {
            return false;
        }
    }
    return true;
}


void Foam::misfit::expectAnswer
(
    const finding& f,
    const word& verdict,
    wordList names
)
{
    show(f);
    EXPECT_EQ(verdictNames[f.verdict.kind], verdict);
    wordList found(answerOf(f));
    std::sort(found.begin(), found.end());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(found, names);
}
