// SPDX-License-Identifier: GPL-3.0-or-later
// Scores verdicts against the key.

#include "concealedSet.H"
#include "report.H"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using json = nlohmann::json;

json readJson(const fileName& file)
{
    std::ifstream is(file);
    if (!is)
    {
        FatalErrorInFunction << "There is no " << file << exit(FatalError);
    }
    return json::parse(is);
}


//- A share, how often it was and of how many
struct share
{
    std::string what;

    std::string goal;

    label hits = 0;

    label n = 0;

    void count(const bool hit)
    {
        hits += hit;
        ++n;
    }

    //- Wilson's interval (1927, J. Am. Stat. Assoc. 22:209)
    std::string row() const
    {
        if (!n)
        {
            return what + ",,,,0," + goal + '\n';
        }
        const scalar z = 1.96;
        const scalar p = scalar(hits)/n;
        const scalar middle = (p + z*z/(2*n))/(1 + z*z/n);
        const scalar half =
            z*std::sqrt(p*(1 - p)/n + z*z/(4.0*n*n))/(1 + z*z/n);
        return
            what + ',' + shortNumber(100*p) + ','
          + shortNumber(100*max(middle - half, 0.0)) + ','
          + shortNumber(100*min(middle + half, 1.0)) + ','
          + std::to_string(n) + ',' + goal + '\n';
    }
};


std::string median(const std::string& what, scalarList v, const std::string& goal)
{
    std::sort(v.begin(), v.end());
    const label n = v.size();
    return
        n
      ? what + ',' + shortNumber(v[n/2]) + ',' + shortNumber(v[n/4]) + ','
          + shortNumber(v[(3*n)/4]) + ',' + std::to_string(n) + ',' + goal + '\n'
      : what + ",,,,0," + goal + '\n';
}


std::vector<std::string> sorted(std::vector<std::string> v)
{
    std::sort(v.begin(), v.end());
    return v;
}


//- Names of the mechanisms that a case really has
std::vector<std::string> truth(const json& key)
{
    std::vector<std::string> names;
    for (const json& m : key["mechanisms"])
    {
        names.push_back(m["name"]);
    }
    return sorted(names);
}


//- Length that two lists of stretches of the same channels share, over the mean
//  of their lengths
scalar overlap(const json& key, const json& verdict)
{
    scalar both = 0;
    scalar all = 0;
    const scalar dt = 0.01;
    for (const char* channel : {"P1", "E1", "L1", "L2"})
    {
        const auto inside = [&](const json& list, const scalar t)
        {
            for (const json& w : list)
            {
                if (w["channel"] == channel && t >= w["from"] && t <= w["to"])
                {
                    return true;
                }
            }
            return false;
        };
        for (scalar t = 0; t < 1.2; t += dt)
        {
            const bool a = inside(key["effect"]["places"], t);
            const bool b = inside(verdict["located"], t);
            both += a && b;
            all += 0.5*(a + b);
        }
    }
    return all > 0 ? both/all : 1;
}


//- Share of the misfit at held-out data that is gone
scalarList removed(const json& verdict, const std::string& what)
{
    scalarList list;
    for (const json& h : verdict["heldOut"])
    {
        const scalar before = h["meanSquareBefore"];
        const scalar after = h["meanSquareAfter"];
        if (h["what"] == what && before > 2)
        {
            list.append(100*(before - after)/(before - 1));
        }
    }
    return list;
}


struct scores
{
    share falseAlarm{"nulls with another verdict than none [%]", "<= 5"};
    share single{"single: right name where SNR >= 20 [%]", ">= 90"};
    share singleOrSet{"single: right name or in the set [%]", ""};
    share pair{"pair: both named [%]", ""};
    share pairPart{"pair: nothing named that is not there [%]", ""};
    share precision{"a name that is given is right [%]", ">= 98"};
    share unknown{"outside the library: unknown where SNR >= 20 [%]", ">= 80"};
    share wrong{"outside the library: wrongly named [%]", "<= 10"};
    share blamed{"sensor fault blamed on physics [%]", "<= 5"};
    share sensor{"sensor fault found in its channel where SNR >= 20 [%]", ""};
    scalarList places;
    scalarList probes;
    scalarList experiment;
    scalar brier = 0;
    label n = 0;

    void add(const json& key, const json& v);

    std::string rows() const;
};


void scores::add(const json& key, const json& v)
{
    const std::string kind = key["kind"];
    const std::string verdict = v["verdict"];
    const bool strong = key["effect"]["snr"] >= 20;
    const auto names = sorted(v["names"].get<std::vector<std::string>>());
    const auto real = truth(key);
    const bool named = verdict == "named";
    const bool all = named && names == real;
    bool part = named;
    for (const std::string& name : names)
    {
        part = part && std::find(real.begin(), real.end(), name) != real.end();
    }
    bool right = false;

    if (kind == "null")
    {
        right = verdict == "none";
        falseAlarm.count(!right);
    }
    else if (kind == "single" || kind == "pair")
    {
        right = all || (kind == "pair" && part);
        if (kind == "single" && strong)
        {
            single.count(all);
            const bool inSet =
                verdict == "set"
             && std::find(names.begin(), names.end(), real[0]) != names.end();
            singleOrSet.count(all || inSet);
        }
        else if (kind == "pair" && strong)
        {
            pair.count(all);
            pairPart.count(!named || part);
        }
        if (strong)
        {
            places.append(overlap(key, v));
        }
        if (named)
        {
            probes.append(removed(v, "scored channels"));
            experiment.append(removed(v, "experiment C"));
        }
    }
    else if (kind == "outside")
    {
        right = verdict == "unknown";
        if (strong)
        {
            unknown.count(right);
        }
        wrong.count(named);
    }
    else
    {
        const std::string faulty = key["faulty"];
        right =
            (verdict == "sensor" || verdict == "registration")
         && names == std::vector<std::string>{faulty};
        blamed.count(named);
        if (strong)
        {
            sensor.count(right);
        }
    }
    if (named)
    {
        precision.count(part);
    }
    brier += sqr(v["confidence"].get<scalar>() - right);
    ++n;
}


std::string scores::rows() const
{
    std::string text;
    for (const share* s :
        {
            &falseAlarm, &single, &singleOrSet, &pair, &pairPart, &precision,
            &unknown, &wrong, &blamed, &sensor
        })
    {
        text += s->row();
    }
    text += median("where: overlap F1 (median and quartiles)", places, ">= 0.85");
    text += median("misfit removed at scored channels [%]", probes, ">= 70");
    text += median("misfit removed in experiment C [%]", experiment, ">= 50");
    text +=
        "Brier score of the confidence," + shortNumber(brier/max(n, 1))
      + ",,," + std::to_string(n) + ",\n";
    return text;
}

} // End anonymous namespace


void Foam::misfit::scoreCases
(
    const fileName& folder,
    const fileName& keyFile
)
{
    scores all;
    std::ofstream table(folder/"cases.csv");
    table << "case,kind,truth,snr,verdict,names,confidence\n";
    for (const json& key : readJson(keyFile))
    {
        const std::string name = key["case"];
        const json v(readJson(folder/name/"verdict.json"));
        all.add(key, v);

        const auto joined = [](const std::vector<std::string>& list)
        {
            std::string text;
            for (const std::string& s : list)
            {
                text += (text.empty() ? "" : "+") + s;
            }
            return text;
        };
        const std::string faulty = key["faulty"];
        const std::string fault = key["fault"];
        table
            << name << ',' << key["kind"].get<std::string>() << ','
            << joined(truth(key)) << (faulty.empty() ? "" : fault + " " + faulty)
            << ',' << shortNumber(key["effect"]["snr"]) << ','
            << v["verdict"].get<std::string>() << ','
            << joined(v["names"].get<std::vector<std::string>>()) << ','
            << shortNumber(v["confidence"]) << '\n';
    }
    const std::string text
    (
        "score,value,low,high,cases,goal\n" + all.rows()
    );
    writeWhole(folder/"score.csv", text);
    Info<< text.c_str() << endl;
}
