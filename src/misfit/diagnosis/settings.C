// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a diagnosis, from system/misfitDict.

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


//- Keywords by the names that they had
HashTable<word> formerKeywords()
{
    return HashTable<word>
    ({
        {"packing", "replicateChanges"}, {"packings", "replicates"},
        {"common", "commonRandomNumbers"}, {"bank", "trainingEnsemble"},
        {"trigger", "clockUncertainty"}
    });
}


void checkSizes(const dictionary& dict, const settings& s)
{
    const label terms = 1 + 2*(s.parameters.size() + s.candidates.size());
    if (s.trainingEnsemble && s.trainingEnsemble < terms)
    {
        FatalIOErrorInFunction(dict)
            << "trainingEnsemble is " << s.trainingEnsemble << ": one for "
            << s.parameters.size() << " parameters and " << s.candidates.size()
            << " candidates needs " << terms << " runs, better twice as many"
            << exit(FatalIOError);
    }
    const bool repeats = s.replicates >= 1 && s.commonRandomNumbers >= 1;
    if (!repeats || s.draws < 100)
    {
        FatalIOErrorInFunction(dict)
            << "replicates and commonRandomNumbers must be 1 or more, draws 100 or"
            << " more" << exit(FatalIOError);
    }
    if (s.chaotic && s.replicates < 3)
    {
        FatalIOErrorInFunction(dict)
            << "chaotic needs replicates, which show how much chance changes: give"
            << " replicateChanges, and 3 replicates or more, better 12"
            << exit(FatalIOError);
    }
    const bool many = s.resolutionReplicates > (s.chaotic ? s.replicates : 1);
    if (s.resolutionReplicates < 1 || many)
    {
        FatalIOErrorInFunction(dict)
            << "resolutionReplicates is " << s.resolutionReplicates << ": give 1 to the"
            << " number of replicates, " << s.replicates << "; without 'chaotic yes' give"
            << " 1, since the run with another mesh then is compared with the one of the"
            << " same replicate" << exit(FatalIOError);
    }
}

//- Warns where the chance between runs stays unknown, or a number of them does nothing
void warnOfReplicates(const dictionary& dict, const settings& s)
{
    const bool canRepeat = dict.found("replicateChanges");
    if (canRepeat && s.replicates == 1)
    {
        WarningInFunction
            << "replicates is 1: the case runs once, so nothing is known of the spread"
            << " between replicates, and what chance changes may be taken for missing"
            << " physics. 20 are advised; a case without chance needs no replicateChanges"
            << endl;
    }
    if (!canRepeat && dict.getOrDefault<label>("replicates", 1) > 1)
    {
        WarningInFunction
            << "replicates is " << dict.get<label>("replicates") << ", but nothing"
            << " differs between them, so the case runs once: give"
            << " replicateChanges, or take replicates out" << endl;
    }
}

} // End anonymous namespace


Foam::misfit::settings Foam::misfit::readSettings(const dictionary& dict)
{
    keywords::checkRenamed(dict, formerKeywords());
    keywords::check
    (
        dict,
        {
            "FoamFile", "commands", "files", "ranks", "jobs", "timeLimit",
            "experiments", "channels", "heldOut", "samples", "parameters",
            "candidates", "replicateChanges", "replicates", "commonRandomNumbers",
            "resolution", "resolutionReplicates", "trainingEnsemble", "chaotic",
            "clockUncertainty", "faults", "decision", "draws", "seed", "shared",
            "correction", "design"
        }
    );

    settings s(keywords::sub(dict, "decision"));
    s.parameters = readParameters(keywords::sub(dict, "parameters"));
    s.candidates = readCandidates(keywords::sub(dict, "candidates"));
    s.correction = correction(dict).elements();
    s.correctionMost =
        keywords::sub(dict, "correction").getOrDefault<label>
        (
            "most", s.correctionMost
        );
    s.replicates =
        dict.found("replicateChanges")
      ? dict.getOrDefault<label>("replicates", 20) : 1;
    s.commonRandomNumbers =
        min(dict.getOrDefault<label>("commonRandomNumbers", 3), s.replicates);
    s.resolutions = keywords::sub(dict, "resolution").sortedToc();
    dict.readIfPresent("resolutionReplicates", s.resolutionReplicates);
    dict.readIfPresent("trainingEnsemble", s.trainingEnsemble);
    dict.readIfPresent("chaotic", s.chaotic);
    dict.readIfPresent("clockUncertainty", s.clockUncertainty);
    s.draws = dict.getOrDefault<label>("draws", s.draws);
    s.seed = dict.getOrDefault<label>("seed", s.seed);

    s.faults = readFaults(dict);
    checkSizes(dict, s);
    warnOfReplicates(dict, s);
    return s;
}


Foam::misfit::vec Foam::misfit::variablesOf
(
    const List<parameter>& parameters,
    const wordList& names,
    const runState& s
)
{
    const label nP = parameters.size();
    vec x = vec::Zero(nP + names.size());
    forAll(parameters, i)
    {
        x[i] = s.parameters.lookup(parameters[i].name, parameters[i].mean);
    }
    forAll(names, i)
    {
        x[nP + i] = s.strengths.lookup(names[i], 0);
    }
    return x;
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
