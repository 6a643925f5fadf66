// SPDX-License-Identifier: GPL-3.0-or-later
// The scores of verdicts on concealed cases.

#include "scores.H"
#include "report.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using json = nlohmann::json;

using nameList = std::vector<std::string>;

bool contains(const nameList& all, const std::string& one)
{
    return std::find(all.begin(), all.end(), one) != all.end();
}


//- The mechanisms of one of a set, or the fault of a sensor as it is worded
nameList partsOf(std::string one)
{
    nameList parts;
    const std::string between(" and ");
    for (size_t at = one.find(between); at != one.npos; at = one.find(between))
    {
        parts.push_back(one.substr(0, at));
        one.erase(0, at + between.size());
    }
    parts.push_back(one);
    return parts;
}


//- Share of the misfit at held-out data that is gone [%]; adds none where there was
//  no misfit to speak of
void addGone(scalarList& values, const json& held, const std::string& what)
{
    for (const json& h : held)
    {
        const scalar before = h["meanSquareBefore"];
        const scalar after = h["meanSquareAfter"];
        if (h["what"] == what && before > 2)
        {
            values.append(100*(before - after)/(before - 1));
        }
    }
}


std::string row
(
    const std::string& what,
    const interval& i,
    const std::string& goal
)
{
    return what + ','
      + (
            i.n
          ? shortNumber(i.value) + ',' + shortNumber(i.low) + ','
              + shortNumber(i.high)
          : std::string(",,")
        )
      + ',' + std::to_string(i.n) + ',' + goal + ',' + against(i, goal) + '\n';
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * openedCase * * * * * * * * * * * * * * * * * //

std::vector<std::string> Foam::misfit::openedCase::truth() const
{
    nameList all;
    for (const json& m : key["mechanisms"])
    {
        all.push_back(m["name"]);
    }
    std::sort(all.begin(), all.end());
    return all;
}


std::vector<std::string> Foam::misfit::openedCase::names() const
{
    std::vector<std::string> all(verdict["names"]);
    std::sort(all.begin(), all.end());
    return all;
}


bool Foam::misfit::openedCase::nothingWrong() const
{
    bool right = named();
    const auto real = truth();
    for (const std::string& name : names())
    {
        right = right && contains(real, name);
    }
    return right;
}


bool Foam::misfit::openedCase::isRight() const
{
    nameList all(truth());
    const std::string faulty = key["faulty"];
    if (said() == "set")
    {
        for (const std::string& one : names())
        {
            const nameList parts(partsOf(one));
            const bool ofChannel =
                faulty.size() && one.find("of " + faulty) != one.npos;
            const bool isThere = std::all_of
            (
                parts.begin(), parts.end(),
                [&all](const std::string& part) { return contains(all, part); }
            );
            if (ofChannel || isThere)
            {
                return true;
            }
        }
        return false;
    }
    return
        said() == "none" ? kind() == "null"
      : said() == "unknown" ? kind() == "outside"
      : blamesChannel() ? faulty.size() && names() == nameList({faulty})
      : nothingWrong();
}


bool Foam::misfit::openedCase::blamesPhysics() const
{
    bool aFault = false;
    for (const std::string& name : names())
    {
        const std::string channel = key["faulty"];
        aFault = aFault || name.find(channel) != std::string::npos;
    }
    return named() || (said() == "set" && !aFault);
}


Foam::scalar Foam::misfit::openedCase::overlap() const
{
    scalar both = 0;
    scalar lengths = 0;
    for (const window& a : effect.places)
    {
        const segment& s = data->segments[a.segment];
        const scalar from = s.x[a.begin] - 0.5*s.span;
        const scalar to = s.x[a.end - 1] + 0.5*s.span;
        lengths += to - from;
        for (const json& b : verdict["located"])
        {
            if (b["channel"] == s.name)
            {
                both += max
                (
                    min(to, b["to"].get<scalar>())
                  - max(from, b["from"].get<scalar>()),
                    0.0
                );
            }
        }
    }
    if (effect.places.empty())
    {
        return -1;
    }
    for (const json& b : verdict["located"])
    {
        lengths += b["to"].get<scalar>() - b["from"].get<scalar>();
    }
    return 2*both/lengths;
}


Foam::scalar Foam::misfit::openedCase::onset() const
{
    scalar real = GREAT;
    scalar found = GREAT;
    scalar end = 0;
    for (const window& a : effect.places)
    {
        const segment& s = data->segments[a.segment];
        real = min(real, s.x[a.begin] - 0.5*s.span);
        end = max(end, s.x[s.size - 1]);
    }
    for (const json& b : verdict["located"])
    {
        found = min(found, b["from"].get<scalar>());
    }
    return
        effect.places.empty() ? -1
      : found == GREAT ? end : mag(found - real);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::scores::addRemoved(const openedCase& c)
{
    addGone(probes_.values, c.verdict["heldOut"], "test channels");
    addGone(experiment_.values, c.verdict["heldOut"], "experiment C");
    const json& rival = c.proof["gaussianProcess"];
    addGone(probesRival_.values, rival, "test channels");
    addGone(experimentRival_.values, rival, "experiment C");
}


void Foam::misfit::scores::addPhysics(const openedCase& c)
{
    const bool strong = c.effect.SNR >= detectableFrom;
    const bool all = c.named() && c.names() == c.truth();
    if (c.kind() == "single")
    {
        if (strong)
        {
            single_.count(all);
            singleOrSet_.count
            (
                all
             || (c.said() == "set" && contains(c.names(), c.truth().front()))
            );
        }
        if (c.effect.noiseSNR >= detectableFrom)
        {
            singleNoise_.count(all);
        }
    }
    else if (strong)
    {
        pair_.count(all);
        if (c.named())
        {
            pairPart_.count(c.nothingWrong());
        }
    }
    if (strong && c.overlap() >= 0)
    {
        const segment& s = c.data->segments.front();
        places_.values.append(c.overlap());
        onset_.values.append(100*c.onset()/(s.duration() + s.span));
    }
    if (all && c.namedSize > 0)
    {
        size_.values.append(100*mag(c.namedSize/c.effect.noiseSNR - 1));
    }
    if (c.named())
    {
        addRemoved(c);
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::misfit::scores::add(const openedCase& c)
{
    const bool strong = c.effect.SNR >= detectableFrom;
    const bool right = c.isRight();
    if (c.kind() == "null")
    {
        falseAlarm_.count(!right);
    }
    else if (c.kind() == "single" || c.kind() == "pair")
    {
        blamedSensor_.count(c.blamesChannel());
        addPhysics(c);
    }
    else if (c.kind() == "outside")
    {
        blamedSensor_.count(c.blamesChannel());
        wrong_.count(c.named());
        if (strong)
        {
            unknown_.count(right);
        }
    }
    else
    {
        blamed_.count(c.blamesPhysics());
        if (strong)
        {
            sensor_.count(right && c.blamesChannel());
        }
    }
    if (c.named())
    {
        precision_.count(right);
    }
    reliability_.add(c.verdict["confidence"], right);
}


std::string Foam::misfit::scores::rows() const
{
    std::string text("score,value,low,high,cases,goal,says\n");
    for (const share* s :
        {
            &falseAlarm_, &single_, &singleNoise_, &singleOrSet_, &pair_,
            &pairPart_, &precision_, &unknown_, &wrong_, &blamedSensor_,
            &blamed_, &sensor_
        })
    {
        interval i(ofShare(s->hits, s->n));
        for (scalar* x : {&i.value, &i.low, &i.high})
        {
            *x *= 100;
        }
        text += row(s->what, i, s->goal);
    }
    for (const list* l :
        {
            &places_, &onset_, &size_, &probes_, &probesRival_, &experiment_,
            &experimentRival_
        })
    {
        text += row(l->what, ofMedian(l->values), l->goal);
    }
    return text + row("Brier score of the confidence", reliability_.brier(), "");
}
