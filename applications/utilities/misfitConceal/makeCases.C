// SPDX-License-Identifier: GPL-3.0-or-later
// Makes cases whose cause is concealed, and the key to them.

#include "concealedSide.H"
#include "report.H"
#include "textFile.H"

#include "OSspecific.H"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Time between two readings [s]
const scalar step = 0.005;

//- Draws cases as the key has them: kind (null, single, pair, outside, sensor), noise
//  (over what the channels state), mechanisms (name and strength of each), parameters,
//  startOff (common shift of time [s]), faulty (a channel), fault, and faultSize (a
//  share, or [s] of a lag and a clock)
class drawing
{
    std::mt19937 generator_;

    std::uniform_real_distribution<scalar> any_;

    std::normal_distribution<scalar> normal_;

    List<parameter> parameters_;

    //- Between which of their strengths each is drawn
    HashTable<candidate> candidates_;

    wordList library_;

    //- Those that the library does not have
    wordList outside_;

    //- Those of A that are fitted: one of them may be faulty
    wordList channels_;


    scalar uniform(const scalar from, const scalar to)
    {
        return from + (to - from)*any_(generator_);
    }


    label pick(const label n)
    {
        return min(label(n*any_(generator_)), n - 1);
    }


public:

    drawing(const concealedSide& truth, const label seed)
    :
        generator_(seed),
        parameters_(readParameters(truth.dict().subDict("parameters"))),
        outside_(truth.outside())
    {
        for (const channel& c : truth.bare().channels())
        {
            if (c.experiment == "A" && c.use == purpose::calibration)
            {
                channels_.append(c.name);
            }
        }
        for (const candidate& c : readCandidates(truth.dict().subDict("candidates")))
        {
            candidates_.insert(c.name, c);
            if (!outside_.found(c.name))
            {
                library_.append(c.name);
            }
        }
        if (library_.size() < 2 || outside_.empty() || channels_.empty())
        {
            FatalIOErrorInFunction(truth.dict())
                << "The truth needs two candidates of the library, one that the entry"
                << " outside names, and a channel to fit" << exit(FatalIOError);
        }
    }


    //- In the shares 30 % nulls, 25 % singles, 12 % pairs, 15 % outside the
    //  library, 18 % faults
    json draw()
    {
        const scalar lot = any_(generator_);
        nlohmann::json parameters = nlohmann::json::object();
        for (const parameter& p : parameters_)
        {
            // As far as an ensemble reaches
            const scalar z = min(max(normal_(generator_), -2.0), 2.0);
            const scalar x = p.mean + p.deviation*z;
            parameters[p.name] = min(max(x, p.lower), p.upper);
        }
        const scalar jitter = 0.005*normal_(generator_);
        const word kind
        (
            lot < 0.3 ? "null" : lot < 0.55 ? "single" : lot < 0.67 ? "pair"
          : lot < 0.82 ? "outside" : "sensor"
        );
        json key =
        {
            {"kind", kind}, {"noise", pick(2) ? 2.0 : 1.0},
            {"mechanisms", json::array()}, {"parameters", parameters},
            {"startOff", jitter}, {"faulty", ""}, {"fault", ""}, {"faultSize", 0.0}
        };
        if (kind == "sensor")
        {
            key["faulty"] = channels_[pick(channels_.size())];
            const word fault(wordList({"gain", "zero", "lag", "drift", "clock"})[pick(5)]);
            const scalar side = pick(2) ? 1 : -1;
            key["fault"] = fault;
            key["faultSize"] =
                fault == "gain" ? side*uniform(0.1, 0.3)
              : fault == "lag" ? uniform(0.03, 0.12)
              : fault == "clock" ? side*uniform(0.03, 0.1)
              : side*uniform(0.05, 0.2);
        }
        wordList names;
        if (kind != "null" && kind != "sensor")
        {
            const wordList& from = kind == "outside" ? outside_ : library_;
            const label n = from.size();
            const label i = pick(n);
            names.append(from[i]);
            if (kind == "pair")
            {
                names.append(from[(i + 1 + pick(n - 1)) % n]);
            }
        }
        for (const word& name : names)
        {
            const candidate& c = candidates_[name];
            key["mechanisms"].push_back
            (
                {{"name", name}, {"strength", uniform(c.weak, c.strong)}}
            );
        }
        return key;
    }


    //- White noise and a part that remembers 20 ms, with that deviation
    void addNoise(series& s, const scalar deviation)
    {
        scalar slow = normal_(generator_);
        const scalar keep = std::exp(-step/0.02);
        for (scalar& y : s.y)
        {
            slow = keep*slow + Foam::sqrt(1 - keep*keep)*normal_(generator_);
            y +=
                deviation
               *(Foam::sqrt(0.8)*normal_(generator_) + Foam::sqrt(0.2)*slow);
        }
    }
};


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
    scalar shown = truth(0);
    for (label i = 2; i*step < end - 0.02; ++i)
    {
        const scalar t = i*step;
        const scalar y = truth(max(t - late, 0.0));
        if (how == "lag")
        {
            shown += (y - shown)*(1 - std::exp(-step/size));
        }
        s.y.append
        (
            how == "gain" ? y*(1 + size)
          : how == "zero" ? y + size*range
          : how == "drift" ? y + size*range*t/end
          : how == "lag" ? shown : y
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


//- The states that a case needs: all experiments, and A without what is concealed
List<runState> statesOf
(
    const json& key,
    const wordList& experiments,
    const label replicate
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
    return states;
}

} // End anonymous namespace


void Foam::misfit::makeCases
(
    concealedSide& truth,
    const fileName& folder,
    const fileName& keyFile,
    const label n,
    const fileName& kept
)
{
    json key(readJson(keyFile));
    if (!key["cases"].empty())
    {
        Info<< key["cases"].size() << " cases are made already" << endl;
        return;
    }
    const recordings& all = truth.bare();
    drawing lots(truth, key["seed"]);
    std::vector<json> cases(n);
    List<runState> states;
    const label own = truth.hasReplicates();
    for (label i = 0; i < n; ++i)
    {
        cases[i] = lots.draw();
        const label replicate = concealedSide::replicate("truth") + own*i;
        states.append(statesOf(cases[i], all.experiments(), replicate));
    }
    const List<prediction> given
    (
        kept.empty() ? truth.predict(states) : truth.predict(states, kept)
    );
    const label each = all.experiments().size() + 1;

    for (label i = 0; i < n; ++i)
    {
        std::string number(std::to_string(i + 1));
        number.insert(0, 4 - min(label(number.size()), label(4)), '0');
        const UList<prediction> mine(SubList<prediction>(given, each, i*each));
        const auto failed =
            std::find_if_not(mine.begin(), mine.end(), std::mem_fn(&prediction::ok));
        if (failed != mine.end())
        {
            Info<< "    No case " << number << ": a run of its truth failed: "
                << failed->failure.c_str() << endl;
            continue;
        }

        const fileName target(folder/number);
        mkDir(target);
        const scalar level = cases[i]["noise"];
        forAll(all.channels(), k)
        {
            const channel& ch = all.channels()[k];
            const label e = all.experiments().find(ch.experiment);
            series s(recorded(cases[i], mine[e].channels[k], ch.name));
            lots.addNoise(s, level*ch.samples.uncertainty);
            writeWhole(target/ch.name + ".csv", csv(s, ch.samples.quantity, ch.overTime()));
        }
        writeWhole(target/"level", shortNumber(level) + '\n');

        json k = {{"case", number}};
        k.update(cases[i]);
        k["effect"] =
            effect(all, cases[i], mine[all.experiments().find("A")], mine[each - 1]);
        key["cases"].push_back(k);
    }
    writeWhole(keyFile, key.dump() + '\n');
}
