// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnoses of the surge in closed form, for the tests of verdicts and gates.

#include "worldDiagnosis.H"

#include <gtest/gtest.h>

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
        "lag", "gain", "zero", "drift", "clock",
        "clogged", "swapped", "misplaced", "units",
        "dead", "saturated"
    };
    s.trigger = 0.005;
    s.draws = 500;
    return s;
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
    diagnosis d(s, set);
    return d();
}


void Foam::misfit::show(const finding& f)
{
    std::printf("%s: %s\n", f.verdict.c_str(), f.told.c_str());
    for (const gate& g : f.gates)
    {
        std::printf
        (
            "  %-10s %-7s %s (%s)\n", g.name.c_str(),
            g.applies ? g.passed ? "passed" : "failed" : "-",
            g.value.c_str(), g.bound.c_str()
        );
    }
}


bool Foam::misfit::passes(const finding& f, const word& name)
{
    for (const gate& g : f.gates)
    {
        if (g.name == name && g.applies && !g.passed)
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
    EXPECT_EQ(f.verdict, verdict);
    wordList found(f.names);
    std::sort(found.begin(), found.end());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(found, names);
}
