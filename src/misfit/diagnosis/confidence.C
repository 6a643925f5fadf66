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
bool hasOneOfSet(const finding& f, const scored& w)
{
    return
        isAmong(f.alternatives, w)
     || std::any_of
        (
            f.alternatives.begin(),
            f.alternatives.end(),
            [&](const scored& one)
            {
                return
                    one.what.fault ? w.what.extends(one.what)
                  : w.what.contains(one.what);
            }
        );
}


//- It has all on that is named, whatever else
bool hasAllThatIsNamed(const finding& f, const hypothesis& h)
{
    label n = 0;
    for (const int m : h.mechanisms)
    {
        n += f.names.found(f.library[m]);
    }
    return n && n == f.names.size();
}


//- True if an explanation says what the verdict says
bool agrees(const finding& f, const scored& w)
{
    switch (f.verdict)
    {
        case verdictKind::none:
            return w.what.isNone();
        case verdictKind::sensor:
        case verdictKind::registration:
            return
                w.what.fault
             && w.what.fault->blamesSame(*f.best().what.fault);
        case verdictKind::unknown:
            return w.what.isOnlyUnknown();
        case verdictKind::set:
            return hasOneOfSet(f, w);
        default:
            return hasAllThatIsNamed(f, w.what);
    }
}


//- Small differences count as they are, large ones by their order
scalar ofOrder(const scalar x)
{
    return x < 0 ? -std::log1p(-x) : std::log1p(x);
}


//- By how much the score of those that agree is ahead of that of all others
scalar lead(const finding& f)
{
    scalar own = GREAT;
    scalar others = GREAT;
    for (const scored& w : f.explained.all())
    {
        scalar& least = agrees(f, w) ? own : others;
        least = min(least, w.score);
    }
    return own == GREAT || others == GREAT ? 0 : others - own;
}


//- Fraction of the tested gates that passed [-]
scalar shareOfGates(const finding& f)
{
    label nTried = 0;
    label passed = 0;
    for (const gate& g : f.gates)
    {
        if (g.applies && g.kind != gateKind::detection)
        {
            ++nTried;
            passed += g.passed;
        }
    }
    return nTried ? scalar(passed)/nTried : 1;
}


groundValues groundsOf(const settings& set, const finding& f)
{
    groundValues g(groundNames.size());
    g <<
        ofOrder(lead(f)),
        f.detection.p,
        ofOrder(std::sqrt(max(f.detection.sum - f.data.size(), 0.0))),
        shareOfGates(f),
        isConfirmed(f.held, set),
        f.verdict != verdictKind::none && f.hasMore();
    return g;
}


//- Share of the probability that those that agree have
scalar shareOfThoseThatAgree(const finding& f)
{
    scalar sum = 0;
    for (const scored& w : f.explained.all())
    {
        sum += agrees(f, w) ? w.probability : 0;
    }
    return sum;
}

} // End anonymous namespace


void Foam::misfit::setConfidence(const settings& set, finding& f)
{
    f.grounds = groundsOf(set, f);
    f.confidence = set.confidence(verdictNames[f.verdict], f.grounds);

    // The cases of the table had all their runs
    if (f.failing.size() || f.failedRuns.size())
    {
        f.confidence = min(f.confidence, shareOfThoseThatAgree(f));
    }
}
