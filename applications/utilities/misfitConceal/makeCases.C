// SPDX-License-Identifier: GPL-3.0-or-later
// Makes cases whose cause is concealed, and the key to them.

#include "caseDrawing.H"
#include "shortNumber.H"
#include "textFile.H"

#include "OSspecific.H"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Time between two readings [s]
const scalar step = 0.005;

//- The replicates of a case's repeats are so many apart, and there are no more cases
const label mostCases = 10000;


//- What a channel would record of a true series, every 5 ms and without noise
series recorded
(
    const json& key,
    const series& truth,
    const word& channel
)
{
    series s;
    const std::string how(key["faulty"] == channel ? key["fault"] : json(""));
    const scalar size = key["faultSize"];
    const scalar end = truth.x.last();
    const auto extremes = std::minmax_element(truth.y.cbegin(), truth.y.cend());
    const scalar range = *extremes.second - *extremes.first;
    const scalar late = key["startOff"].get<scalar>() + (how == "clock" ? size : 0);
    scalar reading = truth(0);
    for (label i = 2; i*step < end - 0.02; ++i)
    {
        const scalar t = i*step;
        const scalar y = truth(max(t - late, 0.0));
        if (how == "lag")
        {
            reading += (y - reading)*(1 - std::exp(-step/size));
        }
        s.y.append
        (
            how == "gain" ? y*(1 + size)
          : how == "zero" ? y + size*range
          : how == "drift" ? y + size*range*t/end
          : how == "lag" ? reading : y
        );
        s.x.append(t);
    }
    return s;
}


std::string csv(const series& s, const word& quantity, const bool overTime)
{
    std::ostringstream os;
    os << (overTime ? "t_s," : "x_m,")
        << (quantity == "pressure" ? "p_Pa" : quantity == "velocity" ? "u_m/s" : "h_m")
        << '\n';
    forAll(s.x, i)
    {
        os << s.x[i] << ',' << s.y[i] << '\n';
    }
    return os.str();
}


//- What is concealed changes in the channels of experiment A: a series for each
json effect
(
    const recordings& all,
    const json& key,
    const prediction& with,
    const prediction& without
)
{
    json changes = json::object();
    json sound(key);
    sound["faulty"] = "";
    forAll(all.channels(), i)
    {
        const word& name = all.channels()[i].name;
        if (all.channels()[i].experiment == "A")
        {
            series s(recorded(key, with.channels[i], name));
            const series b(recorded(sound, without.channels[i], name));
            forAll(s.y, k)
            {
                s.y[k] -= b.y[k];
            }
            changes[name] = {{"t", s.x}, {"change", s.y}};
        }
    }
    return changes;
}


//- The states that a case needs: all experiments, A without what is concealed, and both
//  of A repeated
List<runState> statesOf
(
    const json& key,
    const wordList& experiments,
    const label replicate,
    const label nRecordings
)
{
    runState bare;
    bare.replicate = replicate;
    for (const auto& [name, value] : key["parameters"].items())
    {
        bare.parameters.insert(name, value);
    }
    runState state(bare);
    for (const json& m : key["mechanisms"])
    {
        state.strengths.insert(m["name"].get<std::string>(), m["strength"]);
    }
    List<runState> states(experiments.size(), state);
    forAll(states, i)
    {
        states[i].experiment = experiments[i];
    }
    states.append(bare);
    for (label repeat = 1; repeat < nRecordings; ++repeat)
    {
        for (const runState& s : {states[experiments.find("A")], bare})
        {
            states.append(s);
            states.last().replicate += mostCases*repeat;
        }
    }
    return states;
}


//- Fatal if a key has cases that are none of these
void checkMade(const json& cases, const fileName& keyFile, const labelRange& these)
{
    for (const json& c : cases)
    {
        const label number = std::stoi(c["case"].get<std::string>());
        if (!these(number - 1))
        {
            FatalErrorInFunction
                << "The key " << keyFile << " has case " << number
                << ", which is none of " << these.min() + 1 << " to " << these.max() + 1
                << ". Give another -folder and -key, or remove it and its cases"
                << exit(FatalError);
        }
    }
}


//- A case and where its runs stand, in the order of statesOf
struct caseToMake
{
    string name;

    json key;

    List<prediction> runs;

    //- Number of experiment A
    label fitted;

    label nExperiments;

    //- A run of an experiment, or A once more
    const prediction& with(const label experiment, const label repeat) const
    {
        return runs[repeat ? nExperiments + 2*repeat - 1 : experiment];
    }

    //- A without what is concealed
    const prediction& without(const label repeat) const
    {
        return runs[nExperiments + 2*repeat];
    }

    //- Why there is no case; nothing where all runs went well
    string failure() const
    {
        const auto failed =
            std::find_if_not(runs.begin(), runs.end(), std::mem_fn(&prediction::ok));
        return failed == runs.end() ? string() : failed->failure;
    }
};


//- Four digits at least
string nameOf(const label number)
{
    std::string name(std::to_string(number));
    name.insert(0, 4 - min(label(name.size()), label(4)), '0');
    return name;
}


//- These cases and their runs, or what is kept of them; those before are drawn as well,
//  so that each is the same whatever others are made
List<caseToMake> withRuns
(
    concealedSide& truth,
    caseDrawing& lots,
    const labelRange& these,
    const fileName& kept
)
{
    const wordList& experiments = truth.bare().experiments();
    const label times = truth.nRecordings();
    const label own = truth.hasReplicates();
    List<caseToMake> cases(these.size());
    List<runState> states;
    for (label i = 0; i <= these.max(); ++i)
    {
        const json key(lots.draw());
        if (these(i))
        {
            cases[i - these.start()] =
                {nameOf(i + 1), key, {}, experiments.find("A"), experiments.size()};
            const label replicate = concealedSide::replicate("truth") + own*i;
            states.append(statesOf(key, experiments, replicate, times));
        }
    }
    const List<prediction> results
    (
        kept.empty() ? truth.predict(states) : truth.predict(states, kept)
    );
    const label each = states.size()/cases.size();
    forAll(cases, i)
    {
        cases[i].runs = SubList<prediction>(results, each, i*each);
    }
    return cases;
}


//- Writes the recordings of a case, with their noise
void writeRecordings
(
    const caseToMake& one,
    const recordings& all,
    const label times,
    caseDrawing& lots,
    const fileName& folder
)
{
    mkDir(folder);
    const scalar level = one.key["noise"];
    forAll(all.channels(), k)
    {
        const channel& ch = all.channels()[k];
        const label e = all.experiments().find(ch.experiment);
        for (label repeat = 0; repeat < (e == one.fitted ? times : 1); ++repeat)
        {
            series s(recorded(one.key, one.with(e, repeat).channels[k], ch.name));
            lots.addNoise(s, level*ch.samples.uncertainty, step);
            const fileName name
            (
                repeat ? concealedSide::repeatName(ch.name, repeat) : ch.name + ".csv"
            );
            writeWhole(folder/name, csv(s, ch.samples.quantity, ch.overTime()));
        }
    }
    writeWhole(folder/"level", shortNumber(level) + '\n');
}


//- What the key holds of a case
json keyOf(const caseToMake& one, const recordings& all, const label times)
{
    json k = {{"case", one.name}};
    k.update(one.key);
    k["effects"] = json::array();
    for (label repeat = 0; repeat < times; ++repeat)
    {
        k["effects"].push_back
        (
            effect(all, one.key, one.with(one.fitted, repeat), one.without(repeat))
        );
    }
    return k;
}

} // End anonymous namespace


void Foam::misfit::makeCases
(
    concealedSide& truth,
    const fileName& folder,
    const fileName& keyFile,
    const labelRange& these,
    const fileName& kept
)
{
    json key(readJson(keyFile));
    if (!key["cases"].empty())
    {
        checkMade(key["cases"], keyFile, these);
        Info<< key["cases"].size() << " cases are made already" << endl;
        return;
    }
    if (these.max() >= mostCases)
    {
        FatalErrorInFunction
            << these.max() + 1 << " cases are too many: at most " << mostCases
            << " have grains of their own. Make no more than these with -make, others"
            << " in another folder" << exit(FatalError);
    }
    const recordings& all = truth.bare();
    const label times = truth.nRecordings();
    caseDrawing lots(truth, key["seed"]);
    label counted = these.start();
    for (const caseToMake& one : withRuns(truth, lots, these, kept))
    {
        ++counted;
        if (one.failure().size())
        {
            Info<< "    No case " << one.name << ": a run of its truth failed: "
                << one.failure().c_str() << endl;
            continue;
        }
        writeRecordings(one, all, times, lots, folder/one.name);
        const json measured(lots.measured(one.key["parameters"], counted));
        if (!measured.empty())
        {
            writeWhole(folder/one.name/"measured", measured.dump(1) + '\n');
        }
        key["cases"].push_back(keyOf(one, all, times));
    }
    writeWhole(keyFile, key.dump() + '\n');
}
