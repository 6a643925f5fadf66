// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnoses concealed cases, without a look at the key.

#include "concealedSet.H"
#include "diagnosis.H"
#include "gaussianProcess.H"
#include "record.H"
#include "report.H"
#include "textFile.H"
#include "words.H"

#include "IFstream.H"
#include "OSspecific.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The second rival: the calibrated base, and what a Gaussian process has learnt
//  from what it leaves at the fitted channels
json rival(const finding& f, const scalar clockUncertainty)
{
    if (f.held.empty())
    {
        return json::array();
    }
    const statistics::gaussianProcess learnt
    (
        f.data,
        f.data.y - f.before,
        covariance(f.data, clockUncertainty).at(f.before)
    );
    return each(f.held, [&](const heldOut& h) -> json
    {
        const whitener white(covariance(h.data, clockUncertainty).at(h.before));
        const vec left = h.data.y - h.before;
        const scalar n = h.data.size();
        return
        {
            {"what", describe(h)},
            {"meanSquareBefore", white(left).squaredNorm()/n},
            {"meanSquareAfter", white(vec(left - learnt(h.data))).squaredNorm()/n}
        };
    });
}


//- The first of the explanations as a state, with or without its mechanisms
runState stateOf(const finding& f, const settings& set, const bool with)
{
    const scored& best = f.best();
    wordList names;
    for (const int m : best.what.mechanisms)
    {
        names.append(set.candidates[m].name);
    }
    return stateOf(set, "A", with ? names : wordList(), best.best.x);
}


//- What the named mechanisms change at the fitted channels
json effect(const finding& f, const settings& set, sampler& ask)
{
    if (f.verdict != verdictKind::named)
    {
        return json::array();
    }
    const List<samples> two(ask({stateOf(f, set, true), stateOf(f, set, false)}));
    return
        two[0].ok() && two[1].ok()
      ? json(vec(two[0].calibration - two[1].calibration)) : json::array();
}

} // End anonymous namespace


void Foam::misfit::diagnoseCases(concealedSide& library, const fileName& folder)
{
    const settings set(readSettings(library.dict()));
    const fileNameList cases(caseFolders(folder));
    label n = 0;
    for (const fileName& c : cases)
    {
        Info<< ++n << " of " << cases.size() << ": " << c.name() << endl;
        if (isFile(c/"verdict.json", false))
        {
            continue;
        }
        const recordings recorded(withFiles(library.dict(), c), c);
        predictedSampler ask(recorded, library, library.trainingEnsemble("A"));
        const finding found(diagnose(ask, set));
        const json proof =
        {
            {"gaussianProcess", rival(found, set.clockUncertainty)},
            {"effect", effect(found, set, ask)}
        };
        writeWhole(c/"proof.json", proof.dump(1) + '\n');
        writeWhole(c/"verdict.json", verdictJson(found, c.name()));
        Info<< "    " << verdictNames[found.verdict] << ": "
            << describe(found).c_str() << endl;
    }
}
