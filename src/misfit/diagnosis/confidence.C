// SPDX-License-Identifier: GPL-3.0-or-later
// How sure the verdict is: what speaks for it, and how often such verdicts were right.

#include "stages.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- True if it is one of the set, or has all mechanisms of one
bool hasOneOf(const std::vector<hypothesisFit>& alternatives, const hypothesisFit& w)
{
    return
        isAmong(alternatives, w)
     || std::any_of
        (
            alternatives.begin(),
            alternatives.end(),
            [&](const hypothesisFit& one)
            {
                return
                    one.what.fault ? w.what.extends(one.what)
                  : w.what.contains(one.what);
            }
        );
}


//- It has all on that is named, whatever else
bool hasAll
(
    const wordList& names,
    const wordList& library,
    const hypothesis& h
)
{
    label n = 0;
    for (const int m : h.mechanisms)
    {
        n += names.found(library[m]);
    }
    return n && n == names.size();
}


//- True if an explanation names what the verdict names
bool agrees(const stageResults& e, const decision& d, const hypothesisFit& w)
{
    switch (d.kind)
    {
        case verdictKind::none:
            return w.what.isNone();
        case verdictKind::sensor:
        case verdictKind::registration:
            return
                w.what.fault
             && w.what.fault->blamesSame(*e.best().what.fault);
        case verdictKind::unknown:
            return w.what.isOnlyUnknown();
        case verdictKind::set:
            return hasOneOf(d.alternatives, w);
        default:
            return hasAll(d.names, e.library, w.what);
    }
}


//- Small differences count as they are, large ones by their order
scalar ofOrder(const scalar x)
{
    return x < 0 ? -std::log1p(-x) : std::log1p(x);
}


//- By how much the score of those that agree is ahead of that of all others
scalar lead(const stageResults& e, const decision& d)
{
    scalar own = GREAT;
    scalar others = GREAT;
    for (const hypothesisFit& w : e.explained.all())
    {
        scalar& least = agrees(e, d, w) ? own : others;
        least = min(least, w.score);
    }
    return own == GREAT || others == GREAT ? 0 : others - own;
}


//- Fraction of the tested gates that passed [-]
scalar shareOfGates(const gateList& gates)
{
    label nAttempts = 0;
    label passed = 0;
    for (const gate& g : gates)
    {
        if (g.applies && g.kind != gateKind::detection)
        {
            ++nAttempts;
            passed += g.passed;
        }
    }
    return nAttempts ? scalar(passed)/nAttempts : 1;
}


//- Share of the probability that those that agree have
scalar shareOfThoseThatAgree(const stageResults& e, const decision& d)
{
    scalar sum = 0;
    for (const hypothesisFit& w : e.explained.all())
    {
        sum += agrees(e, d, w) ? w.probability : 0;
    }
    return sum;
}

} // End anonymous namespace


Foam::misfit::groundValues Foam::misfit::groundsOf
(
    const rules& limits,
    const stageResults& e,
    const decision& d
)
{
    const misfitDetection& misfit = e.detection;
    const bool hasMore = d.partly || e.best().what.unknown;
    groundValues g(groundNames.size());
    g <<
        ofOrder(lead(e, d)),
        misfit.calibrated.p,
        ofOrder(std::sqrt(max(misfit.calibrated.sum - misfit.data.size(), 0.0))),
        shareOfGates(e.tests.gates),
        isConfirmed(e.tests.held, limits),
        d.kind != verdictKind::none && hasMore;
    return g;
}


Foam::scalar Foam::misfit::confidenceIn
(
    const rules& limits,
    const stageResults& e,
    const decision& d
)
{
    const scalar confidence = limits.confidence(d.kind, d.grounds);

    // The cases of the table had all their runs
    const bool failed = e.candidates.failing.size() || e.failedRuns.size();
    return failed ? min(confidence, shareOfThoseThatAgree(e, d)) : confidence;
}
