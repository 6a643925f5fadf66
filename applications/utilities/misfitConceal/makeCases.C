// SPDX-License-Identifier: GPL-3.0-or-later
// Makes cases whose cause is concealed, and the key to them.

#include "concealedCase.H"
#include "concealedSet.H"
#include "record.H"
#include "report.H"
#include "textFile.H"

#include "OSspecific.H"

#include <algorithm>
#include <fstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
void writeCsv(const fileName& file, const series& s, const word& quantity)
{
    std::ofstream os(file);
    os << "t_s,"
        << (quantity == "pressure" ? "p_Pa" : quantity == "velocity" ? "u_m/s" : "h_m")
        << '\n';
    forAll(s.x, i)
    {
        os << s.x[i] << ',' << s.y[i] << '\n';
    }
}


//- What is concealed changes in the channels of experiment A: a series for each
json effect
(
    const recordings& all,
    const concealedCase& c,
    const prediction& with,
    const prediction& without
)
{
    json changes = json::object();
    concealedCase sound(c);
    sound.faulty = "";
    forAll(all.channels(), i)
    {
        const channel& ch = all.channels()[i];
        if (ch.experiment == "A")
        {
            series s(c.recorded(with.channels[i], ch.name));
            const series b(sound.recorded(without.channels[i], ch.name));
            forAll(s.y, k)
            {
                s.y[k] -= b.y[k];
            }
            changes[ch.name] = {{"t", s.x}, {"change", s.y}};
        }
    }
    return changes;
}


json keyOf(const concealedCase& c, const word& name)
{
    json parameters = json::object();
    for (const word& p : c.state.parameters.sortedToc())
    {
        parameters[p] = c.state.parameters[p];
    }
    const auto mechanism = [&c](const word& m) -> json
    {
        return {{"name", m}, {"strength", c.state.strengths[m]}};
    };
    return
    {
        {"case", name}, {"kind", c.kind}, {"noise", c.level},
        {"mechanisms", each(c.mechanisms, mechanism)}, {"parameters", parameters},
        {"startOff", c.jitter}, {"faulty", c.faulty}, {"fault", c.fault},
        {"faultSize", c.faultSize}
    };
}


//- The states that a case needs: all experiments, and A without what is concealed
List<runState> statesOf
(
    const concealedCase& c,
    const wordList& experiments,
    const label replicate
)
{
    List<runState> states;
    for (const word& e : experiments)
    {
        states.append(c.state);
        states.last().experiment = e;
    }
    states.append(c.state);
    states.last().strengths.clear();
    for (runState& s : states)
    {
        s.replicate = replicate;
    }
    return states;
}


//- The channels of A that are fitted: one of them may be faulty
wordList fittedChannels(const recordings& all)
{
    wordList names;
    for (const channel& c : all.channels())
    {
        if (c.experiment == "A" && c.use == purpose::calibration)
        {
            names.append(c.name);
        }
    }
    return names;
}

} // End anonymous namespace


void Foam::misfit::beginKey
(
    const fileName& keyFile,
    const label seed,
    const bool mustBeThatSeed
)
{
    if (!isFile(keyFile, false))
    {
        const json key = {{"seed", seed}, {"cases", json::array()}};
        writeWhole(keyFile, key.dump(1) + '\n');
        return;
    }
    if (mustBeThatSeed && json::parse(contentOf(keyFile))["seed"] != seed)
    {
        FatalErrorInFunction
            << "The key " << keyFile << " has another seed than " << seed
            << ". Leave -seed out to go on with it, or remove it and its cases"
            << exit(FatalError);
    }
}


void Foam::misfit::makeCases
(
    concealedSide& truth,
    const fileName& folder,
    const fileName& keyFile,
    const label n
)
{
    json key(json::parse(contentOf(keyFile)));
    if (!key["cases"].empty())
    {
        Info<< key["cases"].size() << " cases are made already" << endl;
        return;
    }
    const recordings& all = truth.bare();
    drawing lots(truth.dict(), truth.outside(), fittedChannels(all), key["seed"]);
    List<concealedCase> cases(n);
    List<runState> states;
    const label own = truth.hasReplicates();
    forAll(cases, i)
    {
        cases[i] = lots.draw();
        const label replicate = concealedSide::replicate("truth") + own*i;
        states.append(statesOf(cases[i], all.experiments(), replicate));
    }
    const List<prediction> given(truth.predict(states));
    const label each = all.experiments().size() + 1;

    forAll(cases, i)
    {
        std::string number(std::to_string(i + 1));
        number.insert(0, 4 - min(label(number.size()), label(4)), '0');
        const UList<prediction> mine(SubList<prediction>(given, each, i*each));
        const auto failed = std::find_if
        (
            mine.begin(), mine.end(), [](const prediction& p) { return !p.ok(); }
        );
        if (failed != mine.end())
        {
            Info<< "    No case " << number << ": a run of its truth failed: "
                << failed->failure.c_str() << endl;
            continue;
        }

        const fileName target(folder/number);
        mkDir(target);
        forAll(all.channels(), k)
        {
            const channel& ch = all.channels()[k];
            const label e = all.experiments().find(ch.experiment);
            series s(cases[i].recorded(mine[e].channels[k], ch.name));
            lots.addNoise(s, cases[i].level*ch.samples.uncertainty);
            writeCsv(target/ch.name + ".csv", s, ch.samples.quantity);
        }
        writeWhole(target/"level", shortNumber(cases[i].level) + '\n');

        json k(keyOf(cases[i], number));
        k["effect"] =
            effect(all, cases[i], mine[all.experiments().find("A")], mine[each - 1]);
        key["cases"].push_back(k);
    }
    writeWhole(keyFile, key.dump() + '\n');
}
