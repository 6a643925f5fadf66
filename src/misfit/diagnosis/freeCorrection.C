// SPDX-License-Identifier: GPL-3.0-or-later
// What no candidate explains is fitted by a free correction, and that correction by
// dimensionless numbers.

#include "freeCorrection.H"
#include "correctionFitter.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- A law of dimensionless numbers is a name, as sure as its lead up to a limit: no
//  case of the table of confidences has one
void nameLaw(const settings& set, finding& f)
{
    const fittedLaw& l = f.correction.laws.first();
    word name(l.law.family);
    for (const word& group : l.law.groups)
    {
        name += ':' + group;
    }
    f.verdict = verdictKind::named;
    f.names = wordList(1, name);
    f.confidence = min
    (
        1/(1 + std::exp(-0.5*l.lead/set.temperature)), set.largestUncalibrated
    );
    f.grounds.resize(0);
}

} // End anonymous namespace


Foam::misfit::correctionFound Foam::misfit::fitCorrection
(
    const study& s,
    const models& m,
    const scored& base,
    const std::map<word, covariance>& known,
    label& runs
)
{
    Info<< "Free correction" << endl;
    correctionFitter fitter(s, m, base);
    const correctionFound& found = fitter.found();
    if (fitter.computeSensitivities())
    {
        const correctionFit free(fitter.freely());
        const List<dimensionlessLaw> laws(fitter.laws());
        correctionFit best(free);
        if (laws.size())
        {
            const correctionFit law(fitter.follow(free, laws));
            best = found.explained ? law : free;
        }
        if (free.free.size() || found.explained)
        {
            fitter.test(best, known);
        }
        fitter.finish(best);
    }
    runs += fitter.nRuns();
    return found;
}


void Foam::misfit::correct
(
    const study& s,
    const models& m,
    const std::map<word, covariance>& known,
    finding& f
)
{
    // Where the fitted channels agree there is nothing to fit it to
    const bool asked =
        f.verdict == verdictKind::unknown && s.set().correction.size()
     && f.gates.passed(gateKind::detection);
    if (!asked)
    {
        return;
    }
    f.correction =
        fitCorrection(s, m, f.explained.baseline(), known, f.nRuns);
    const correctionFound& found = f.correction;
    if (found.after.size())
    {
        f.after = found.after;
        f.held = found.held;
    }
    if (found.named)
    {
        nameLaw(s.set(), f);
    }
}


Foam::List<Foam::misfit::runState>
Foam::misfit::correctionRuns(const study& s)
{
    List<runState> states;
    for (const correctionElement& e : s.set().correction)
    {
        for (label i = 0; i < s.set().commonRandomNumbers; ++i)
        {
            states.append(s.state(s.bounds().mean));
            states.last().replicate = i;
            states.last().strengths.insert(e.name, e.size);
        }
    }
    states.append(s.state(s.bounds().mean));
    states.last().noting = true;
    return states;
}
