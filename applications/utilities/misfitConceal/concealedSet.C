// SPDX-License-Identifier: GPL-3.0-or-later
// Cases whose cause is concealed: what making, diagnosing and scoring share.

#include "concealedSet.H"
#include "diagnosis.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

dictionary readDictionary(const fileName& file)
{
    IFstream is(file);
    return dictionary(is);
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
        data_[0].use = purpose::fit;
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


//- The random states of a bank in all experiments, and other resolutions in the
//  first
List<runState> bankStates
(
    const settings& set,
    const wordList& experiments,
    const label packing
)
{
    nothingRecorded none;
    const auto stages(diagnosis(none, set).plan());
    List<runState> states;
    for (const word& e : experiments)
    {
        for (runState s : stages[1].second())
        {
            if (s.packing == 0)
            {
                s.experiment = e;
                s.packing = packing;
                states.append(s);
            }
        }
    }
    for (const runState& s : stages[0].second())
    {
        if (s.resolution != "base")
        {
            states.append(s);
        }
    }
    return states;
}

} // End anonymous namespace


Foam::misfit::concealedSide::concealedSide
(
    const fileName& slice,
    const word& dictName,
    const label packing,
    const bool useSolver
)
:
    dict_(readDictionary(slice/"sides"/dictName)),
    bare_(dict_, slice),
    solver_(bare_, slice, dict_),
    useSolver_(useSolver)
{
    const settings set(readSettings(dict_));
    List<runState> states(bankStates(set, bare_.experiments(), packing));
    const List<prediction> runs(solver_.predict(states));
    for (runState& s : states)
    {
        s.packing = 0;
    }
    bank_.reset
    (
        new emulatedPredictor(set.parameters, set.candidates, states, runs)
    );
}


Foam::misfit::predictor& Foam::misfit::concealedSide::predict()
{
    if (useSolver_)
    {
        return solver_;
    }
    return *bank_;
}


Foam::dictionary Foam::misfit::withFiles
(
    const dictionary& dict,
    const fileName& folder,
    const scalar level
)
{
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
    std::sort(all.begin(), all.end());
    return all;
}
