// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the key and scores the verdicts.

#include "concealedSet.H"
#include "report.H"
#include "textFile.H"
#include "scores.H"

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


std::string joined(const std::vector<std::string>& list)
{
    std::string text;
    for (const std::string& s : list)
    {
        text += (text.empty() ? "" : "+") + s;
    }
    return text;
}


//- A line of cases.csv
std::string row(const openedCase& c)
{
    // No table of confidences is for a verdict without grounds: its cells are empty
    std::string grounds;
    for (const word& name : groundNames)
    {
        const json& from = c.verdict["confidenceFrom"];
        grounds +=
            ',' + (from.is_null() ? std::string() : shortNumber(from[name]));
    }
    const std::string faulty = c.key["faulty"];
    const std::string fault = c.key["fault"];
    return
        c.key["case"].get<std::string>() + ',' + c.kind() + ','
      + joined(c.truth()) + (faulty.empty() ? "" : fault + ' ' + faulty) + ','
      + shortNumber(c.effect.noiseSNR) + ',' + shortNumber(c.effect.SNR) + ','
      + c.said() + ',' + joined(c.names()) + ','
      + shortNumber(c.verdict["confidence"]) + ','
      + (c.overlap() < 0 ? "" : shortNumber(c.overlap())) + ','
      + (c.isRight() ? '1' : '0') + grounds + '\n';
}

} // End anonymous namespace


void Foam::misfit::scoreCases
(
    concealedSide& library,
    const fileName& folder,
    const fileName& keyFile
)
{
    scores all;
    std::map<std::string, std::unique_ptr<detectability>> byNoise;
    std::string table
    (
        "case,kind,truth,snrNoise,snr,verdict,names,confidence,overlap,right"
    );
    for (const word& name : groundNames)
    {
        table += ',' + name;
    }
    table += '\n';
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
        all.add(c);
        table += row(c);
    }
    if (open)
    {
        Info<< open << " cases have no verdict yet" << endl;
    }
    writeWhole(folder/"cases.csv", table);
    writeWhole(folder/"score.csv", all.rows());
    writeWhole(folder/"reliability.csv", all.confidence().rows());
    Info<< all.rows().c_str() << endl;
}
