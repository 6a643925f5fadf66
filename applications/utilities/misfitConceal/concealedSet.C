// SPDX-License-Identifier: GPL-3.0-or-later
// Cases whose cause is concealed: what making, diagnosing and scoring share.

#include "concealedSet.H"
#include "ensembleFile.H"
#include "caseChange.H"
#include "diagnosis.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Without the entry "outside", which only the making knows
dictionary readDictionary(const fileName& file, wordList& outside)
{
    IFstream is(file);
    dictionary dict(is);
    dict.readIfPresent("outside", outside);
    dict.remove("outside");
    return dict;
}


//- A sampler that has channels but nothing recorded, to ask for a plan
class nothingRecorded
:
    public sampler
{
    List<observed> data_;

public:

    nothingRecorded()
    :
        data_(1)
    {
        data_[0].experiment = "A";
        data_[0].use = purpose::calibration;
    }

    List<samples> operator()(const List<runState>& states) override
    {
        return List<samples>(states.size());
    }

    const List<observed>& data() const override
    {
        return data_;
    }
};


//- The random states of an ensemble in all experiments, and in those that decide
//  other resolutions and, unless the side has one of its own, replicates
List<runState> ensembleStates
(
    const settings& set,
    const wordList& experiments,
    const wordList& deciding,
    const label replicate
)
{
    nothingRecorded none;
    const List<plannedStage> stages(plan(none, set));
    List<runState> states;
    for (const word& e : experiments)
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
    for (const word& e : deciding)
    {
        for (runState s : stages[0].states)
        {
            if (s.resolution != "base" || (s.replicate && !replicate))
            {
                s.experiment = e;
                states.append(s);
            }
        }
    }
    return states;
}

} // End anonymous namespace


Foam::List<Foam::misfit::prediction> Foam::misfit::concealedSide::runs
(
    const fileName& file,
    const List<runState>& states
)
{
    const string digest(solver_.digest(states));
    if (!isFile(file, false))
    {
        List<prediction> all(solver_.predict(states));
        for (prediction& p : all)
        {
            p = ensembleFile::reduced(p);
        }
        mkDir(file.path());
        ensembleFile::write(file, bare_, digest, states, all);
    }
    return ensembleFile::read(file, bare_, digest, states);
}


Foam::misfit::concealedSide::concealedSide
(
    const fileName& slice,
    const fileName& ensembles,
    const word& side,
    const bool useSolver
)
:
    dict_(readDictionary(slice/"sides"/side + "Dict", outside_)),
    bare_(dict_, slice),
    solver_(bare_, slice, dict_),
    useSolver_(useSolver)
{
    // What the solver shall compute needs no ensemble. The library's has the states
    // that every diagnosis begins with; the truth's are drawn, never those of one
    const settings set(readSettings(dict_));
    const bool isDrawn = side == "truth";
    if (useSolver && (isDrawn || !isFile(ensembles/side + ".txt", false)))
    {
        return;
    }
    wordList deciding(bare_.experiments(purpose::calibration));
    deciding.append(bare_.experiments(purpose::validation));
    states_ = ensembleStates(set, bare_.experiments(), deciding, replicate(side));
    const List<prediction> all(runs(ensembles/side + ".txt", states_));
    forAll(states_, i)
    {
        if (all[i].ok())
        {
            known_.insert(describe(states_[i]), all[i]);
        }
    }
    emulator_.reset
    (
        new emulatedPredictor(set.parameters, set.candidates, states_, all)
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
    forAll(states, i)
    {
        const auto known = known_.cfind(describe(states[i]));
        if (known.found())
        {
            all[i] = known.val();
        }
        else
        {
            rest.append(states[i]);
        }
    }
    const List<prediction> run(solver_.predict(rest));
    label next = 0;
    forAll(states, i)
    {
        if (!known_.found(describe(states[i])))
        {
            all[i] = run[next++];
        }
    }
    return all;
}


Foam::scalar Foam::misfit::concealedSide::difference(const label run)
{
    const prediction now
    (
        ensembleFile::reduced(solver_.predict(List<runState>(1, states_[run]))[0])
    );
    if (!now.ok() || !known_.found(describe(states_[run])))
    {
        return GREAT;
    }
    const prediction& then = known_[describe(states_[run])];
    scalar largest = 0;
    forAll(now.channels, i)
    {
        forAll(now.channels[i].x, k)
        {
            largest = max
            (
                largest,
                mag(now.channels[i].y[k] - then.channels[i](now.channels[i].x[k]))
               /bare_.channels()[i].samples.uncertainty
            );
        }
    }
    return largest;
}


Foam::dictionary Foam::misfit::withFiles
(
    const dictionary& dict,
    const fileName& folder
)
{
    IFstream is(folder/"level");
    const scalar level = readScalar(is);
    dictionary all(dict);
    dictionary& channels = all.subDict("channels");
    for (const word& name : channels.toc())
    {
        dictionary& c = channels.subDict(name);
        c.set("file", fileName(folder/name + ".csv"));
        c.set("uncertainty", level*c.get<scalar>("uncertainty"));
    }
    return all;
}


Foam::fileNameList Foam::misfit::caseFolders(const fileName& folder)
{
    fileNameList all;
    for (const fileName& d : readDir(folder, fileName::DIRECTORY))
    {
        if (isFile(folder/d/"level"))
        {
            all.append(folder/d);
        }
    }
    if (all.empty())
    {
        FatalErrorInFunction
            << "There are no cases in " << folder << ": make some with -make, or give"
            << " another -folder" << exit(FatalError);
    }
    std::sort(all.begin(), all.end());
    return all;
}
