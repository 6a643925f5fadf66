// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict.

#include "stages.H"
#include "HashSet.H"

#include <algorithm>

const Foam::Enum<Foam::misfit::verdictKind> Foam::misfit::verdictNames
({
    {verdictKind::none, "none"},
    {verdictKind::sensor, "sensor"},
    {verdictKind::registration, "registration"},
    {verdictKind::named, "named"},
    {verdictKind::set, "set"},
    {verdictKind::unknown, "unknown"}
});


namespace
{

using namespace Foam;
using namespace Foam::misfit;

bool isSame(const std::vector<int>& a, const std::vector<int>& b)
{
    return
        a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
}


//- Without those that add to another
std::vector<hypothesisFit> simplest(const std::vector<hypothesisFit>& list)
{
    std::vector<hypothesisFit> kept;
    for (const hypothesisFit& w : list)
    {
        bool adds = false;
        for (const hypothesisFit& other : list)
        {
            adds = adds || w.what.extends(other.what);
        }
        if (!adds)
        {
            kept.push_back(w);
        }
    }
    return kept;
}


//- True if all are faults of the channel of the best, or its exchange
bool blameTheSame(const std::vector<hypothesisFit>& near, const hypothesis& best)
{
    for (const hypothesisFit& w : near)
    {
        const bool same =
            w.what.fault && best.fault
         && w.what.fault->blamesSame(*best.fault);
        if (!same)
        {
            return false;
        }
    }
    return true;
}


//- The simplest of these are the answer: one that adds to another of the set explains
//  nothing more
decision setOf(const std::vector<hypothesisFit>& all)
{
    decision d;
    d.kind = verdictKind::set;
    d.alternatives = simplest(all);
    return d;
}


decision channelOf(const sensorFault& fault)
{
    decision d;
    d.kind =
        fault.isRegistration()
      ? verdictKind::registration : verdictKind::sensor;
    d.names = wordList(1, word(fault.channel));
    if (fault.kind == faultKind::swapped)
    {
        d.names.append(fault.partner);
    }
    return d;
}


decision nameOf(const wordList& mechanisms)
{
    decision d;
    d.kind = verdictKind::named;
    d.names = mechanisms;
    return d;
}


//- Chooses the verdict among the rivals
decision judge
(
    const study& s,
    const std::vector<hypothesisFit>& near,
    const hypothesis& best
)
{
    for (const hypothesisFit& w : near)
    {
        if (w.what.isOnlyUnknown())
        {
            decision d;
            d.kind = verdictKind::unknown;
            return d;
        }
    }
    if (blameTheSame(near, best))
    {
        return channelOf(*best.fault);
    }
    const std::vector<int> core(commonMechanisms(near));
    return
        core.size() && isSame(best.mechanisms, core)
      ? nameOf(s.namesOf(core)) : setOf(near);
}


//- The simplest of these, and what wins without a channel
std::vector<hypothesisFit> withWinners
(
    const std::vector<hypothesisFit>& list,
    const std::vector<winner>& winners
)
{
    std::vector<hypothesisFit> near(simplest(list));
    for (const winner& without : winners)
    {
        // What all data support does not give way to what wins on fewer
        const hypothesis& h = without.explanation.what;
        bool another = !isAmong(near, without.explanation);
        for (const hypothesisFit& n : near)
        {
            another = another && !n.what.extends(h) && !h.extends(n.what);
        }
        if (another)
        {
            near.push_back(without.explanation);
        }
    }
    return near;
}


//- Only what does not depend on one channel
decision weaken
(
    const study& s,
    const std::vector<hypothesisFit>& near,
    const stageResults& e,
    const verdictKind kind
)
{
    const std::vector<winner>& winners = e.tests.winners;
    if (kind != verdictKind::named)
    {
        return setOf(withWinners(near, winners));
    }
    const std::vector<hypothesisFit> best(1, e.best());
    std::vector<hypothesisFit> all(best);
    for (const winner& without : winners)
    {
        all.push_back(without.explanation);
    }

    // What wins without a channel, too, has some of it: that much is sure
    const std::vector<int> sure(commonMechanisms(all));
    decision d(sure.size() ? nameOf(s.namesOf(sure)) : setOf(withWinners(best, winners)));
    d.partly = sure.size();
    d.weakened = sure.empty();
    return d;
}


//- False if what was held out does not agree with nothing being wrong
bool confirmsNone(const gateTests& tests)
{
    for (const heldOut& h : tests.held)
    {
        if (h.use == purpose::validation && h.squareBefore >= h.limitOfNothing)
        {
            return false;
        }
    }

    // Where the fitted channels agree, an experiment in which the solver fails
    // confirms nothing
    return
        tests.gates.passed(gateKind::detection)
     || tests.gates.passed(gateKind::computed);
}


//- The verdict and its names
decision choose
(
    const study& s,
    const std::vector<hypothesisFit>& rivals,
    const stageResults& e
)
{
    const gateList& gates = e.tests.gates;
    decision d;
    if (gates.passed(gateKind::detection) && gates.passed(gateKind::evidence))
    {
        d = judge(s, rivals, e.best().what);
        if (!gates.allowAnswer())
        {
            d.kind = verdictKind::unknown;
        }
        else if
        (
            d.kind != verdictKind::unknown && !gates.passed(gateKind::stability)
        )
        {
            d = weaken(s, rivals, e, d.kind);
        }
    }
    if (d.kind == verdictKind::none && !confirmsNone(e.tests))
    {
        d.kind = verdictKind::unknown;
    }
    if (d.kind == verdictKind::unknown)
    {
        d.names.clear();
        d.alternatives.clear();
    }
    return d;
}


//- Of the mechanisms that are named
List<fittedStrength> strengthsOf
(
    const study& s,
    const hypothesisFit& best,
    const decision& d
)
{
    List<fittedStrength> all;
    for (label i = 0; i < count(best.what.mechanisms); ++i)
    {
        const label k = s.bounds.nParameters + i;
        const word& name = s.names[best.what.mechanisms[i]];
        if (!d.partly || d.names.found(name))
        {
            all.append
            ({
                name, best.fit.x[k], best.fit.deviation(k),
                best.fit.pinned[k]
            });
        }
    }
    return all;
}


//- The best fit with nothing on but what is named
runState namedState(const study& s, const hypothesisFit& best, const wordList& names)
{
    runState named(s.state(s.calibration.model(best.what).expand(best.fit.x)));
    for (const word& name : named.strengths.toc())
    {
        if (!names.found(name))
        {
            named.strengths.erase(name);
        }
    }
    return named;
}


//- What measurement would settle a set
advice adviceOn(const study& s, const stageResults& e, const decision& d)
{
    advice a;
    if (d.kind == verdictKind::set && d.weakened)
    {
        a.what = advice::kind::check;
    }
    else if (d.kind == verdictKind::set)
    {
        a = measurementBetween(s, e.explained, d.alternatives);
    }
    return a;
}


//- Where the answer acts; else where recording and simulation part
std::vector<place> locate(const study& s, const stageResults& e, const decision& d)
{
    std::vector<place> named;
    if (d.strengths.size() && !e.best().what.unknown)
    {
        named = locateNamed(s, e, d);
    }
    return named.size() ? named : e.detection.located;
}

//- Standard deviation of the fitted samples with the answer, without what something
//  unknown beside it may do
vec deviationWith(const study& s, const stageResults& e, const decision& d)
{
    const hypothesisFit& best = e.best();
    if (!d.blamesChannel())
    {
        return e.detection.sigma;
    }
    mat known = best.covariance;
    if (best.what.unknown)
    {
        known -= s.calibration.score().unknownShape(best.amplitude, best.length);
    }
    // Rounding may leave less than nothing
    return known.diagonal().cwiseMax(0).cwiseSqrt();
}

} // End anonymous namespace


Foam::misfit::decision
Foam::misfit::decide(const study& s, const stageResults& e)
{
    Info<< "Verdict" << endl;
    const std::vector<hypothesisFit> rivals(e.explained.rivals(s.set));
    decision d(choose(s, rivals, e));
    d.rivals = rivals;

    const bool changed =
        d.kind != verdictKind::none && d.kind != verdictKind::unknown;
    d.before = e.explained.baseline().fit.f;
    d.after = changed ? e.best().fit.f : d.before;
    d.sigma = deviationWith(s, e, d);
    if (changed)
    {
        d.strengths = strengthsOf(s, e.best(), d);
    }
    if (d.kind == verdictKind::named)
    {
        d.state = namedState(s, e.best(), d.names);
    }
    d.measure = adviceOn(s, e, d);
    d.located = locate(s, e, d);
    d.grounds = groundsOf(s.set, e, d);
    d.confidence = confidenceIn(s.set, e, d);
    return d;
}
