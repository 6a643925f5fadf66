// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnoses concealed cases, without reading the key.

#include "concealedSide.H"
#include "diagnosis.H"
#include "gaussianProcess.H"
#include "record.H"
#include "report.H"
#include "textFile.H"
#include "words.H"

#include "OSspecific.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The second rival: the calibrated base, and what a Gaussian process has learnt
//  from what it leaves at the fitted channels
json rival(const finding& f, const scalar clockUncertainty)
{
    if (f.held().empty())
    {
        return json::array();
    }
    const statistics::gaussianProcess learnt
    (
        f.detection.data,
        f.detection.data.y - f.verdict.before,
        covariance(f.detection.data, clockUncertainty).at(f.verdict.before)
    );
    return each(f.held(), [&](const heldOut& h) -> json
    {
        const whitener white(h.covariance);
        const vec left = h.data.y - h.before;
        const scalar n = h.data.size();
        json match(heldOutData(h));
        match["meanSquareBefore"] = white(left).squaredNorm()/n;
        match["meanSquareAfter"] = white(vec(left - learnt(h.data))).squaredNorm()/n;
        return match;
    });
}


//- What the named mechanisms change at the fitted channels
json effect(const finding& f, const settings& set, sampler& simulation)
{
    if (f.verdict.kind != verdictKind::named)
    {
        return json::array();
    }
    wordList names;
    for (const int m : f.best().what.mechanisms)
    {
        names.append(set.candidates[m].name);
    }
    const vec& x = f.best().fit.x;
    const List<samples> two
    (
        simulation({stateOf(set, "A", names, x), stateOf(set, "A", wordList(), x)})
    );
    return
        two[0].ok() && two[1].ok()
      ? json(vec(two[0].calibration - two[1].calibration)) : json::array();
}


//- Folders of cases, in their order; fatal if there are none
fileNameList caseFolders(const fileName& folder)
{
    fileNameList all;
    for (const fileName& d : readDir(folder, fileName::DIRECTORY))
    {
        if (isFile(folder/d/"level"))
        {
            all.append(folder/d);
        }
    }
    if (all.empty())
    {
        FatalErrorInFunction
            << "There are no cases in " << folder << ": make some with -make, or give"
            << " another -folder" << exit(FatalError);
    }
    std::sort(all.begin(), all.end());
    return all;
}

} // End anonymous namespace


void Foam::misfit::diagnoseCases(concealedSide& library, const fileName& folder)
{
    const settings common(readSettings(library.dict()));
    const fileNameList cases(caseFolders(folder));
    label n = 0;
    for (const fileName& c : cases)
    {
        Info<< ++n << " of " << cases.size() << ": " << c.name() << endl;
        if (isFile(c/"verdict.json", false))
        {
            continue;
        }
        const recordings recorded(library.recorded(c));
        const settings set(concealedSide::known(common, c));
        predictedSampler simulation(recorded, library, library.trainingEnsemble());
        const finding result(diagnose(simulation, set));
        const json proof =
        {
            {"gaussianProcess", rival(result, set.clockUncertainty)},
            {"effect", effect(result, set, simulation)}
        };
        writeWhole(c/"proof.json", proof.dump(1) + '\n');
        writeWhole(c/"verdict.json", verdictJson(result, c.name()));
        Info<< "    " << verdictNames[result.verdict.kind] << ": "
            << describe(result).c_str() << endl;
    }
}
