// SPDX-License-Identifier: GPL-3.0-or-later
// One side of the proof, and the file of its ensemble.

#include "concealedSide.H"
#include "caseChange.H"
#include "diagnosis.H"
#include "keptRuns.H"
#include "textFile.H"

#include "serialTool.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Time between two values of an ensemble [s]
const scalar step = 0.02;

//- The same of a truth, which all readings of a case are made of
const scalar fineStep = 0.01;

//- Without the entries "outside" and "recordings", which only the making knows
dictionary readDictionary(const fileName& file, wordList& outside, label& nRecordings)
{
    checkThere(file, "start in the folder of a slice, or name it with -case");
    IFstream is(file);
    dictionary dict(is);
    dict.readIfPresent("outside", outside);
    dict.readIfPresent("recordings", nRecordings);
    if (nRecordings < 1)
    {
        FatalIOErrorInFunction(dict)
            << "recordings is " << nRecordings
            << ": experiment A is recorded once or more often. Set 1 or more, or leave it"
            << " out" << exit(FatalIOError);
    }
    dict.remove("outside");
    dict.remove("recordings");
    return dict;
}

} // End anonymous namespace


Foam::List<Foam::misfit::runState> Foam::misfit::concealedSide::ensembleStates
(
    const settings& set,
    const label replicate
)
{
    predictedSampler simulation(bare_, solver_);
    const List<plannedStage> stages(plan(simulation, set));
    List<runState> states;
    for (const word& e : bare_.experiments())
    {
        for (runState s : stages[1].states)
        {
            if (s.replicate == 0)
            {
                s.experiment = e;
                s.replicate = replicate;
                states.append(s);
            }
        }
    }
    wordList deciding(bare_.experiments(purpose::calibration));
    deciding.append(bare_.experiments(purpose::validation));
    for (const word& e : deciding)
    {
        for (runState s : stages[0].states)
        {
            if (!s.isBase() || (s.replicate && !replicate))
            {
                s.experiment = e;
                states.append(s);
            }
        }
    }
    return states;
}


Foam::misfit::concealedSide::concealedSide
(
    const fileName& slice,
    const fileName& ensembles,
    const word& side,
    const bool useSolver,
    const label most
)
:
    dict_(readDictionary(slice/"sides"/side + "Dict", outside_, nRecordings_)),
    bare_(dict_, slice),
    solver_(bare_, slice, dict_),
    useSolver_(useSolver)
{
    // What the solver shall compute needs no ensemble. The library's has the states
    // that every diagnosis begins with; the truth's are drawn, never those of one
    const settings set(readSettings(dict_));
    const fileName file(ensembles/side + ".txt");
    if (useSolver && (side == "truth" || !isFile(file, false)))
    {
        return;
    }
    states_ = ensembleStates(set, replicate(side));
    stringList names;
    for (const runState& s : states_)
    {
        names.append(describe(s));
    }
    const keptRuns kept{file, solver_.digest(states_), bare_, states_, names, step};
    const List<prediction> all(kept.predictions(solver_, most, batch()));
    if (all.size() < states_.size())
    {
        return;
    }
    emulator_.reset
    (
        new emulatedPredictor
        (
            set.parameters, set.candidates, states_, all, set.chaotic
        )
    );
}


bool Foam::misfit::concealedSide::hasReplicates() const
{
    const List<caseChange> changes(readChanges(dict_, "replicateChanges"));
    return std::any_of
    (
        changes.begin(),
        changes.end(),
        [](const caseChange& c) { return !c.isFixed(); }
    );
}


Foam::List<Foam::misfit::prediction>
Foam::misfit::concealedSide::predict(const List<runState>& states)
{
    if (!useSolver_)
    {
        return emulator_->predict(states);
    }
    List<prediction> all(states.size());
    List<runState> rest;
    labelList places;
    forAll(states, i)
    {
        const prediction* known = emulator_ ? emulator_->find(states[i]) : nullptr;
        if (known && known->ok())
        {
            all[i] = *known;
        }
        else
        {
            rest.append(states[i]);
            places.append(i);
        }
    }
    const List<prediction> run(solver_.predict(rest));
    forAll(run, i)
    {
        all[places[i]] = run[i];
    }
    return all;
}


Foam::List<Foam::misfit::prediction> Foam::misfit::concealedSide::predict
(
    const List<runState>& states,
    const fileName& kept
)
{
    stringList names;
    for (const runState& s : states)
    {
        names.append(solver_.digest({s}));
    }
    const keptRuns runs{kept, "runs of concealed cases", bare_, states, names, fineStep};
    return runs.predictions(solver_, labelMax, batch());
}


Foam::scalar Foam::misfit::concealedSide::difference(const label run)
{
    const runState& state = states_[run];
    const prediction now(keptRuns::reduced(solver_.predict({state})[0], step));
    const prediction* then = emulator_ ? emulator_->find(state) : nullptr;
    if (!now.ok() || !then || !then->ok())
    {
        return GREAT;
    }
    scalar largest = 0;
    forAll(now.channels, i)
    {
        const series& s = now.channels[i];
        forAll(s.x, k)
        {
            const scalar off = mag(s.y[k] - then->channels[i](s.x[k]));
            largest = max(largest, off/bare_.channels()[i].samples.uncertainty);
        }
    }
    return largest;
}


Foam::fileName Foam::misfit::concealedSide::repeatName
(
    const word& channel,
    const label repeat
)
{
    return channel + ".repeat" + Foam::name(repeat) + ".csv";
}


Foam::misfit::recordings
Foam::misfit::concealedSide::recorded(const fileName& folder) const
{
    IFstream is(folder/"level");
    const scalar level = readScalar(is);
    dictionary all(dict_);
    dictionary& channels = all.subDict("channels");
    for (const word& name : channels.toc())
    {
        dictionary& c = channels.subDict(name);
        c.set("file", fileName(folder/name + ".csv"));
        fileNameList repeats;
        while (isFile(folder/repeatName(name, repeats.size() + 1), false))
        {
            repeats.append(folder/repeatName(name, repeats.size() + 1));
        }
        c.set("repeats", repeats);
        c.set("uncertainty", level*c.get<scalar>("uncertainty"));
    }
    return recordings(all, folder);
}


Foam::misfit::settings
Foam::misfit::concealedSide::known(settings set, const fileName& folder)
{
    const fileName file(folder/"measured");
    const char* const dictionaryName = "libraryDict";
    const json measured(isFile(file, false) ? readJson(file) : json::object());
    for (parameter& p : set.parameters)
    {
        if (p.isMeasured != measured.contains(p.name))
        {
            FatalErrorInFunction
                << "The parameter " << p.name << " is measured in "
                << (p.isMeasured ? dictionaryName : file.c_str()) << ", not in "
                << (p.isMeasured ? file.c_str() : dictionaryName)
                << ": give both dictionaries of the slice the same parameters, and make"
                << " the cases again"
                << exit(FatalError);
        }
        if (p.isMeasured)
        {
            p.measured = measured[p.name];
        }
    }
    return set;
}


Foam::misfit::json Foam::misfit::readJson(const fileName& file)
{
    checkThere(file, "-make writes a key, -diagnose the verdict and proof of each case");
    const json all(json::parse(contentOf(file), nullptr, false));
    if (all.is_discarded())
    {
        FatalErrorInFunction
            << file << " is not whole: remove it and have it written again"
            << exit(FatalError);
    }
    return all;
}
