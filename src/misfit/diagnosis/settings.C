// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that a diagnosis decides by.

#include "settings.H"
#include "keywords.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

std::vector<faultKind> readFaults(const dictionary& dict)
{
    wordList valid;
    for (const std::string& name : statistics::faultNames())
    {
        valid.append(name);
    }
    std::vector<faultKind> kinds;
    for (const word& name : dict.getOrDefault("faults", valid))
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "The fault " << name << " is not known. Valid faults:"
                << keywords::listed(valid).c_str() << exit(FatalIOError);
        }
        kinds.push_back(statistics::faultNamed(name));
    }
    return kinds;
}


void readDecision(const dictionary& dict, settings& s)
{
    const dictionary decision
    (
        keywords::sub
        (
            dict,
            "decision",
            wordList
            ({
                "significance", "adequacy", "evidence", "gap", "pairGap",
                "formulaTolerance", "refit", "passes", "pairs", "temperature",
                "ceiling"
            })
        )
    );
    decision.readIfPresent("significance", s.significance);
    decision.readIfPresent("adequacy", s.adequacy);
    decision.readIfPresent("evidence", s.evidence);
    decision.readIfPresent("gap", s.gap);
    decision.readIfPresent("pairGap", s.pairGap);
    decision.readIfPresent("formulaTolerance", s.formulaTolerance);
    decision.readIfPresent("refit", s.refit);
    decision.readIfPresent("passes", s.passes);
    decision.readIfPresent("pairs", s.pairs);
    decision.readIfPresent("temperature", s.temperature);
    decision.readIfPresent("ceiling", s.ceiling);

    const bool isShare =
        s.significance > 0 && s.significance < 1
     && s.adequacy > 0 && s.adequacy < 1 && s.ceiling > 0 && s.ceiling <= 1;
    if (!isShare || s.refit < 1 || s.passes < 1)
    {
        FatalIOErrorInFunction(decision)
            << "significance, adequacy and ceiling are shares between 0 and 1,"
            << " refit and passes 1 or more" << exit(FatalIOError);
    }
}


void checkSizes(const dictionary& dict, const settings& s)
{
    const label terms = 1 + 2*(s.parameters.size() + s.candidates.size());
    if (s.bank && s.bank < terms)
    {
        FatalIOErrorInFunction(dict)
            << "bank is " << s.bank << ": a bank for " << s.parameters.size()
            << " parameters and " << s.candidates.size() << " candidates needs "
            << terms << " runs, better twice as many" << exit(FatalIOError);
    }
    if (s.packings < 1 || s.common < 1 || s.draws < 100 || s.temperature <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "packings and common must be 1 or more, draws 100 or more, the"
            << " temperature above zero" << exit(FatalIOError);
    }
}

} // End anonymous namespace


Foam::misfit::settings Foam::misfit::readSettings(const dictionary& dict)
{
    keywords::check
    (
        dict,
        {
            "FoamFile", "commands", "files", "ranks", "jobs", "timeLimit",
            "experiments", "channels", "heldOut", "samples", "parameters",
            "candidates", "packing", "packings", "common", "resolution",
            "bank", "trigger", "faults", "decision", "draws", "seed", "shared",
            "correction"
        }
    );

    settings s;
    s.parameters = readParameters(keywords::sub(dict, "parameters"));
    s.candidates = readCandidates(keywords::sub(dict, "candidates"));
    s.correction = correction(dict).elements();
    s.correctionMost =
        keywords::sub(dict, "correction").getOrDefault<label>
        (
            "most", s.correctionMost
        );
    s.packings =
        dict.found("packing") ? dict.getOrDefault<label>("packings", 20) : 1;
    s.common = min(dict.getOrDefault<label>("common", 3), s.packings);
    s.resolutions = keywords::sub(dict, "resolution").sortedToc();
    s.bank = dict.getOrDefault<label>("bank", s.bank);
    s.trigger = dict.getOrDefault<scalar>("trigger", s.trigger);
    s.draws = dict.getOrDefault<label>("draws", s.draws);
    s.seed = dict.getOrDefault<label>("seed", s.seed);

    s.faults = readFaults(dict);
    readDecision(dict, s);
    checkSizes(dict, s);
    return s;
}


Foam::misfit::runState Foam::misfit::stateOf
(
    const settings& set,
    const word& experiment,
    const wordList& names,
    const vec& variables
)
{
    runState s;
    s.experiment = experiment;
    const label nParameters = set.parameters.size();
    for (label i = 0; i < nParameters; ++i)
    {
        s.parameters.insert(set.parameters[i].name, variables[i]);
    }
    forAll(names, i)
    {
        const scalar strength = variables[nParameters + i];
        if (strength != 0)
        {
            s.strengths.insert(names[i], strength);
        }
    }
    return s;
}
