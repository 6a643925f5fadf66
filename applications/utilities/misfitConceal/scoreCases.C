// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the key and scores the verdicts.

#include "concealedSet.H"
#include "report.H"
#include "textFile.H"
#include "scores.H"
#include "words.H"

#include "OSspecific.H"

#include <fstream>
#include <map>

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


//- A line of cases.csv
std::string row(const openedCase& c)
{
    // No table of confidences is for a verdict without grounds: its cells are empty
    const json& from = c.verdict["confidenceFrom"];
    const std::string grounds(joined(groundNames, ",", [&](const word& name)
    {
        return from.is_null() ? std::string() : shortNumber(from[name]);
    }));
    const auto all = [](const std::vector<std::string>& names)
    {
        return joined(names, "+", [](const std::string& name) { return name; });
    };
    const std::string fault = c.key["fault"];
    const auto overlap = c.overlap();
    return
        c.key["case"].get<std::string>() + ',' + c.kind() + ',' + all(c.truth())
      + (c.faulty().empty() ? "" : fault + ' ' + c.faulty()) + ','
      + shortNumber(c.effect.noiseSNR) + ',' + shortNumber(c.effect.SNR) + ','
      + c.said() + ',' + all(c.names()) + ',' + shortNumber(c.confidence()) + ','
      + (overlap ? shortNumber(*overlap) : "") + ',' + (c.isRight() ? '1' : '0')
      + ',' + grounds + '\n';
}

} // End anonymous namespace


void Foam::misfit::scoreCases
(
    concealedSide& library,
    const fileName& folder,
    const fileName& keyFile
)
{
    std::vector<openedCase> cases;
    std::map<std::string, std::unique_ptr<detectability>> byNoise;
    std::string table
    (
        "case,kind,truth,snrNoise,snr,verdict,names,confidence,overlap,right,"
      + joined(groundNames, ",", [](const word& name) { return name; }) + '\n'
    );
    label open = 0;
    const json opened(readJson(keyFile));
    for (const json& key : opened.at("cases"))
    {
        const fileName here(folder/key["case"].get<std::string>());
        if (!isFile(here/"verdict.json", false))
        {
            ++open;
            continue;
        }
        std::unique_ptr<detectability>& detect = byNoise[key["noise"].dump()];
        if (!detect)
        {
            detect.reset(new detectability(library, here));
        }
        openedCase c;
        c.key = key;
        c.verdict = readJson(here/"verdict.json");
        c.proof = readJson(here/"proof.json");
        c.data = &detect->data();
        c.effect = (*detect)(detect->sampled(key["effect"]));
        if (c.proof["effect"].size())
        {
            const std::vector<scalar> change(c.proof["effect"]);
            c.namedSize = detect->noiseSNR
            (
                Eigen::Map<const vec>(change.data(), change.size())
            );
        }
        cases.push_back(c);
        table += row(c);
    }
    if (open)
    {
        Info<< open << " cases have no verdict yet" << endl;
    }
    const std::string scores(scoresOf(cases));
    writeWhole(folder/"cases.csv", table);
    writeWhole(folder/"score.csv", scores);
    writeWhole(folder/"reliability.csv", reliabilityOf(cases));
    Info<< scores.c_str() << endl;
}
