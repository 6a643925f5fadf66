// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the key and scores the verdicts.

#include "openedCase.H"
#include "shortNumber.H"
#include "textFile.H"
#include "words.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- A line of cases.csv
std::string row(const openedCase& c)
{
    // No table of confidences is for a verdict without grounds: its cells are empty
    const json& from = c.verdict["confidenceFrom"];
    const std::string grounds(joined(groundNames, ",", [&](const word& name)
    {
        return from.is_null() ? std::string() : shortNumber(from[name]);
    }));
    const std::string fault = c.key["fault"];
    return
        c.key["case"].get<std::string>() + ',' + c.kind + ',' + joined(c.truth, "+")
      + (c.faulty.empty() ? "" : fault + ' ' + c.faulty) + ','
      + shortNumber(c.noiseSNR) + ',' + shortNumber(c.SNR) + ','
      + verdictNames[c.outcome] + ',' + joined(c.names, "+") + ','
      + shortNumber(c.confidence) + ','
      + (c.overlap ? shortNumber(*c.overlap) : "") + ',' + (c.right ? '1' : '0')
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
    const std::vector<openedCase> cases(openCases(library, folder, keyFile));
    const std::string scores(scoresOf(cases));
    writeWhole
    (
        folder/"cases.csv",
        "case,kind,truth,snrNoise,snr,verdict,names,confidence,overlap,right,"
      + joined(groundNames, ",") + '\n'
      + joined(cases, "", row)
    );
    writeWhole(folder/"score.csv", scores);
    writeWhole(folder/"reliability.csv", reliabilityOf(cases));
    Info<< scores.c_str() << endl;
}
