// SPDX-License-Identifier: GPL-3.0-or-later
// A concealed case once its key is open.

#include "openedCase.H"
#include "diagnosis.H"
#include "record.H"

#include "OSspecific.H"

#include <algorithm>
#include <map>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using nameList = std::vector<std::string>;

//- What the channels see of an effect, with all that is uncertain; for cases with one
//  level of noise
struct detectability
{
    recordings recorded;

    predictedSampler simulation;

    const settings set;

    const visibility visible;

    const stacked& data;


    //- From the recordings of any of these cases: their times and repeats count. Where
    //  the parameters are in one of them changes little
    detectability(concealedSide& library, const fileName& caseFolder)
    :
        recorded(library.recorded(caseFolder)),
        simulation(recorded, library, library.trainingEnsemble()),
        set(readSettings(library.dict())),
        visible(misfit::visible(simulation, set)),
        data(simulation.data().first().calibration)
    {}


    //- Where and when what calibration leaves of an effect is beyond so many standard
    //  deviations of all that is uncertain as a diagnosis takes
    std::vector<window> places(const vec& effect) const
    {
        // The parameters take up what they can within their priors
        const vec left = visible.all*visible.calibrated.ldlt().solve(effect);
        return statistics::stretches(data, left, visible.all, set.beyond);
    }
};


nameList sorted(nameList all)
{
    std::sort(all.begin(), all.end());
    return all;
}


scalarList listOf(const json& numbers)
{
    scalarList list(numbers.size());
    std::copy(numbers.begin(), numbers.end(), list.begin());
    return list;
}


vec vecOf(const scalarList& list)
{
    return Eigen::Map<const vec>(list.cdata(), list.size());
}


//- The samples of an effect that a key has as series
vec sampled(const json& effect, const detectability& detect)
{
    vec all(detect.data.size());
    for (const segment& s : detect.data.segments)
    {
        const json& entry = effect.at(s.name);
        const series change(listOf(entry["t"]), listOf(entry["change"]));
        for (const channel& c : detect.recorded.channels())
        {
            if (c.name == s.name)
            {
                s.of(all) = vecOf(c.sampled(change));
            }
        }
    }
    return all;
}


//- The verdict in a folder
json verdictIn(const fileName& folder)
{
    const json verdict(readJson(folder/"verdict.json"));
    if (verdict.value("schema", 0) != recordSchema)
    {
        FatalErrorInFunction
            << folder/"verdict.json" << " is of another version: remove the file and"
            << " diagnose this case again with -diagnose" << exit(FatalError);
    }
    return verdict;
}


//- The explanations of a set
std::vector<alternative> alternativesOf(const json& verdict)
{
    const auto nameIn = [](const json& fault, const char* key)
    {
        return
            fault.is_null() || fault[key].is_null()
          ? std::string() : fault[key].get<std::string>();
    };
    std::vector<alternative> all;
    for (const json& one : verdict["alternatives"])
    {
        const json& fault = one["fault"];
        all.push_back
        ({
            one["mechanisms"], nameIn(fault, "channel"), nameIn(fault, "partner")
        });
    }
    return all;
}


//- One of a set is at least part of the cause
bool setIsRight(const openedCase& c)
{
    const auto isInTruth = [&](const std::string& mechanism)
    {
        return statistics::contains(c.truth, mechanism);
    };
    const auto isPart = [&](const alternative& a)
    {
        return
            a.channel.size()
          ? a.channel == c.faulty
          : a.mechanisms.size()
         && std::all_of(a.mechanisms.begin(), a.mechanisms.end(), isInTruth);
    };
    return std::any_of(c.alternatives.begin(), c.alternatives.end(), isPart);
}


bool isRight(const openedCase& c)
{
    return
        c.outcome == verdictKind::set ? setIsRight(c)
      : c.outcome == verdictKind::none ? c.kind == "null"
      : c.outcome == verdictKind::unknown ? c.kind == "outside"
      : c.blamesChannel() ? c.faulty.size() && c.names == nameList({c.faulty})
      : c.nothingWrong;
}


//- Sets how well it was located
void compare
(
    openedCase& c,
    const std::vector<window>& places,
    const stacked& data
)
{
    scalar both = 0;
    scalar lengths = 0;
    scalar real = GREAT;
    scalar last = 0;
    for (const window& a : places)
    {
        const segment& s = data.segments[a.segment];
        const scalar begin = s.x[a.begin] - 0.5*s.span;
        const scalar end = s.x[a.end - 1] + 0.5*s.span;
        lengths += end - begin;
        real = min(real, begin);
        last = max(last, s.x[s.size - 1]);
        for (const json& b : c.verdict["located"])
        {
            if (b["channel"] == s.name)
            {
                const scalar from = max(begin, b["from"].get<scalar>());
                both += max(min(end, b["to"].get<scalar>()) - from, 0.0);
            }
        }
    }
    scalar onset = GREAT;
    for (const json& b : c.verdict["located"])
    {
        onset = min(onset, b["from"].get<scalar>());
        lengths += b["to"].get<scalar>() - b["from"].get<scalar>();
    }
    const segment& s = data.segments.front();
    c.overlap = 2*both/lengths;
    c.onset = 100*(onset == GREAT ? last : mag(onset - real))/(s.duration() + s.span);
}


openedCase opened
(
    const json& key,
    const fileName& folder,
    const detectability& detect
)
{
    openedCase c;
    c.key = key;
    c.verdict = verdictIn(folder);
    c.proof = readJson(folder/"proof.json");
    c.kind = key["kind"];
    c.outcome = verdictNames[word(c.verdict["verdict"].get<std::string>())];
    c.faulty = key["faulty"];
    for (const json& m : key["mechanisms"])
    {
        c.truth.push_back(m["name"]);
    }
    c.truth = sorted(c.truth);
    c.names = sorted(c.verdict["names"]);
    c.alternatives = alternativesOf(c.verdict);
    c.confidence = c.verdict["confidence"];
    c.nothingWrong =
        c.outcome == verdictKind::named
     && std::includes
        (
            c.truth.begin(), c.truth.end(), c.names.begin(), c.names.end()
        );
    c.right = isRight(c);

    mat effects(detect.data.size(), 0);
    for (const json& effect : key.at("effects"))
    {
        appendColumn(effects, sampled(effect, detect));
    }
    const whitener sensors(detect.visible.sensors);
    c.noiseSNR = sensors.normInCommon(effects);
    c.SNR = whitener(detect.visible.calibrated).normInCommon(effects);
    const json& named = c.proof["effect"];
    const scalar size = named.empty() ? 0 : sensors(vecOf(listOf(named))).norm();
    if (size > 0 && c.noiseSNR > 0)
    {
        c.sizeOff = 100*mag(size/c.noiseSNR - 1);
    }
    const std::vector<window> places(detect.places(effects.rowwise().mean()));
    if (places.size())
    {
        compare(c, places, detect.data);
    }
    return c;
}

} // End anonymous namespace


std::vector<Foam::misfit::openedCase> Foam::misfit::openCases
(
    concealedSide& library,
    const fileName& folder,
    const fileName& keyFile
)
{
    const json all(readJson(keyFile));
    std::vector<openedCase> cases;
    std::map<std::string, detectability> byNoise;
    for (const json& key : all.at("cases"))
    {
        const fileName here(folder/key["case"].get<std::string>());
        if (isFile(here/"verdict.json", false))
        {
            const auto detect =
                byNoise.try_emplace(key["noise"].dump(), library, here).first;
            cases.push_back(opened(key, here, detect->second));
        }
    }
    if (cases.size() < all["cases"].size())
    {
        Info<< all["cases"].size() - cases.size() << " cases have no verdict yet"
            << endl;
    }
    return cases;
}
