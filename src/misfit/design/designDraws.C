// SPDX-License-Identifier: GPL-3.0-or-later
// Draws of simulated recordings, each diagnosed as a real one.

#include "designDraws.H"
#include "diagnosis.H"
#include "parallelWork.H"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using nlohmann::json;

//- No words on the terminal while it exists
class silence
{
    const int before_ = messageStream::level;

public:

    silence()
    {
        messageStream::level = 0;
    }

    ~silence()
    {
        messageStream::level = before_;
    }
};


//- Candidates with which at least one run of the sensitivities ended
labelList runningCandidates(sampler& simulation, const settings& set)
{
    const study s(simulation, set);
    labelList some;
    forAll(set.candidates, m)
    {
        List<runState> states;
        for (const vec& x : s.sensitivityDesign(s.bounds.centre, {int(m)}))
        {
            states.append(s.state(x));
        }
        for (const runState& one : simulation.trainingEnsemble())
        {
            if (one.strengths.lookup(set.candidates[m].name, 0) > 0)
            {
                states.append(one);
            }
        }
        const List<samples> results(simulation(states));
        const auto isOk = [](const samples& one) { return one.ok(); };
        if (std::any_of(results.begin(), results.end(), isOk))
        {
            some.append(m);
        }
    }
    return some;
}


//- The member of a set: its mechanisms, or the channel that it blames
wordList namesOf(const hypothesis& h, const wordList& mechanisms)
{
    if (h.fault)
    {
        return wordList({h.fault->channel});
    }
    wordList names;
    for (const int m : h.mechanisms)
    {
        names.append(mechanisms[m]);
    }
    return names;
}


//- An answer in one line, for the process that counts
std::string asText(const designAnswer& answer)
{
    json members = json::array();
    for (const wordList& member : answer.members)
    {
        members.push_back(std::vector<std::string>(member.begin(), member.end()));
    }
    return json
    (
        {
            {"detected", answer.detected},
            {"verdict", int(answer.verdict)},
            {"confidence", answer.confidence},
            {"members", members}
        }
    ).dump();
}


designAnswer asAnswer(const std::string& text)
{
    const json record(json::parse(text));
    designAnswer answer;
    answer.detected = record["detected"].get<bool>();
    answer.verdict = verdictKind(record["verdict"].get<int>());
    answer.confidence = record["confidence"].get<double>();
    for (const json& member : record["members"])
    {
        wordList names;
        for (const json& name : member)
        {
            names.append(word(name.get<std::string>(), false));
        }
        answer.members.append(names);
    }
    return answer;
}

} // End anonymous namespace


Foam::wordList Foam::misfit::possibleChannels
(
    const allChannels& all,
    const wordList& recorded
)
{
    wordList names;
    forAll(all.uses(), i)
    {
        const word name(all.data().segments[i].name, false);
        if (!recorded.found(name) && all.uses()[i] != purpose::validation)
        {
            names.append(name);
        }
    }
    return names;
}


Foam::misfit::designAnswer Foam::misfit::designDraws::answer
(
    const simulatedRecordings& recordings,
    const simulatedCause& c,
    const wordList& channels,
    const label draw
) const
{
    const silence quiet;
    const scalar strength =
        c.mechanism < 0 ? 0 : c.strength*set_.candidates[c.mechanism].strong;
    channelSelection some
    (
        simulation_, recordings.all(), recordings(c.mechanism, strength, draw),
        channels, true
    );
    const finding f(diagnose(some, set_));

    designAnswer result;
    result.detected = f.tests.gates.passed(gateKind::detection);
    result.verdict = f.verdict.kind;
    result.confidence = f.verdict.confidence;
    if (result.verdict == verdictKind::set)
    {
        for (const hypothesisFit& w : f.verdict.alternatives)
        {
            result.members.append(namesOf(w.what, f.library));
        }
    }
    else if (f.verdict.names.size())
    {
        result.members.append(f.verdict.names);
    }
    return result;
}


void Foam::misfit::designDraws::count(designRow& row, const designAnswer& answer) const
{
    bool has = false;
    for (const wordList& member : answer.members)
    {
        if (row.mechanism.size() && member == wordList({row.mechanism}))
        {
            has = true;
        }
        else
        {
            ++row.others[std::vector<word>(member.begin(), member.end())];
        }
    }
    const verdictKind verdict = answer.verdict;
    const bool right = has && row.mechanism.size();
    const bool isNone = verdict == verdictKind::none;
    const bool isUnknown = verdict == verdictKind::unknown;
    const bool isNamed = verdict == verdictKind::named && right;
    const bool blames = !isNone && !isUnknown;
    ++row.draws;
    row.detected += answer.detected;
    row.named += isNamed;
    row.inSet += verdict == verdictKind::set && right;
    row.wrong += blames && !right;
    row.none += isNone;
    row.unknown += isUnknown;
    row.namedIn.push_back(isNamed);
    const bool isTrue = row.mechanism.empty() ? isNone : blames && right;
    row.confidences += answer.confidence;
    row.squares += sqr(answer.confidence - isTrue);
}


void Foam::misfit::designDraws::printProgress(const designRow& row)
{
    ++nDone_;
    const scalar left = timer_.elapsedTime()/nDone_*max(nRows_ - nDone_, label(0));
    Info<< "    " << nDone_ << " of " << nRows_ << ": "
        << (row.mechanism.empty() ? word("nothing") : row.mechanism) << ' '
        << row.strength << ", repeats " << row.repeats << ": named "
        << row.named << " of " << row.draws
        << "; about " << std::ceil(left/60) << " min left" << endl;
}


Foam::misfit::designDraws::designDraws
(
    sampler& simulation,
    const settings& set,
    const designSettings& design,
    const label jobs
)
:
    simulation_(simulation),
    set_(withoutCorrection(set)),
    design_(design),
    jobs_(jobs),
    running_(runningCandidates(simulation, set)),
    nRows_
    (
        design.repeats.size()*(1 + running_.size()*design.strengths.size())
      + running_.size()
       *possibleChannels
        (
            allChannels(simulation.data().first(), 1), design.channels
        ).size()
    )
{}


std::vector<Foam::misfit::simulatedCause> Foam::misfit::designDraws::causes() const
{
    std::vector<simulatedCause> all({{-1, 0}});
    for (const label m : running_)
    {
        for (const scalar strength : design_.strengths)
        {
            all.push_back({m, strength});
        }
    }
    return all;
}


Foam::misfit::designRow Foam::misfit::designDraws::row
(
    const simulatedRecordings& recordings,
    const simulatedCause& c,
    const wordList& channels,
    const label repeats
)
{
    designRow row;
    row.mechanism = c.mechanism < 0 ? word() : set_.candidates[c.mechanism].name;
    row.strength = c.strength;
    row.repeats = repeats;
    const auto work = [&](const label draw)
    {
        return asText(answer(recordings, c, channels, draw));
    };
    for (const std::string& one : inProcesses(design_.draws, jobs_, work))
    {
        count(row, asAnswer(one));
    }
    printProgress(row);
    return row;
}
