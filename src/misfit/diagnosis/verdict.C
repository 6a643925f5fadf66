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
std::vector<scored> simplest(const std::vector<scored>& list)
{
    std::vector<scored> kept;
    for (const scored& w : list)
    {
        bool adds = false;
        for (const scored& other : list)
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
bool blameTheSame(const std::vector<scored>& near, const hypothesis& best)
{
    for (const scored& w : near)
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


//- The simplest of these are the answer
void callSet(const std::vector<scored>& all, finding& f)
{
    // One that adds to another of the set says nothing more
    f.names.clear();
    f.alternatives = simplest(all);
    f.verdict = verdictKind::set;
}


//- Chooses the verdict among the rivals
void judge(const study& s, const std::vector<scored>& near, finding& f)
{
    for (const scored& w : near)
    {
        if (w.what.isOnlyUnknown())
        {
            f.verdict = verdictKind::unknown;
            return;
        }
    }
    const hypothesis& best = f.best().what;
    if (blameTheSame(near, best))
    {
        f.verdict =
            best.fault->isRegistration()
          ? verdictKind::registration : verdictKind::sensor;
        f.names = wordList(1, word(best.fault->channel));
        if (best.fault->kind == faultKind::swapped)
        {
            f.names.append(best.fault->partner);
        }
        return;
    }
    const std::vector<int> core(commonMechanisms(near));
    if (core.size() && isSame(best.mechanisms, core))
    {
        f.names = s.namesOf(core);
        f.verdict = verdictKind::named;
        return;
    }
    callSet(near, f);
}


//- Only what does not hang on one channel
void weaken(const study& s, std::vector<scored> near, finding& f)
{
    if (f.verdict == verdictKind::named)
    {
        near = std::vector<scored>(1, f.best());
        std::vector<scored> all(near);
        for (const winner& without : f.winners)
        {
            all.push_back(without.what);
        }

        // What wins without a channel, too, has some of it: that much is sure
        const std::vector<int> sure(commonMechanisms(all));
        if (sure.size())
        {
            f.names = s.namesOf(sure);
            f.partly = true;
            return;
        }
        f.weakened = true;
    }
    near = simplest(near);
    for (const winner& without : f.winners)
    {
        // What all data support does not give way to what wins on fewer
        const hypothesis& h = without.what.what;
        bool another = !isAmong(near, without.what);
        for (const scored& n : near)
        {
            another = another && !n.what.extends(h) && !h.extends(n.what);
        }
        if (another)
        {
            near.push_back(without.what);
        }
    }
    callSet(near, f);
}


//- False if what was held out does not agree with nothing being wrong
bool confirmsNone(const finding& f)
{
    for (const heldOut& h : f.held)
    {
        if (h.use == purpose::validation && h.squareBefore >= h.limitOfNothing)
        {
            return false;
        }
    }

    // Where the fitted channels agree, an experiment in which the solver fails
    // confirms nothing
    return
        f.gates.passed(gateKind::detection)
     || f.gates.passed(gateKind::computed);
}


//- Sets verdict and names
void choose(const study& s, finding& f)
{
    const gateList& gates = f.gates;
    if (gates.passed(gateKind::detection) && gates.passed(gateKind::evidence))
    {
        judge(s, f.rivals, f);
        if (!gates.allowAnswer())
        {
            f.verdict = verdictKind::unknown;
        }
        else if
        (
            f.verdict != verdictKind::unknown
         && !gates.passed(gateKind::stability)
        )
        {
            weaken(s, f.rivals, f);
        }
    }
    if (f.verdict == verdictKind::none && !confirmsNone(f))
    {
        f.verdict = verdictKind::unknown;
    }
    if (f.verdict == verdictKind::unknown)
    {
        f.names.clear();
        f.alternatives.clear();
    }
}


//- Of the mechanisms that are named
void setStrengths(const study& s, finding& f)
{
    const scored& best = f.best();
    for (label i = 0; i < count(best.what.mechanisms); ++i)
    {
        const label k = s.bounds.nParameters + i;
        const word& name = s.names[best.what.mechanisms[i]];
        if (!f.partly || f.names.found(name))
        {
            f.strengths.append
            ({
                name, best.best.x[k], best.best.deviation(k),
                best.best.pinned[k]
            });
        }
    }
}


//- The best fit with nothing on but what is named
runState namedState(const study& s, const finding& f)
{
    const scored& best = f.best();
    runState named(s.state(s.calibration.model(best.what).expand(best.best.x)));
    for (const word& name : named.strengths.toc())
    {
        if (!f.names.found(name))
        {
            named.strengths.erase(name);
        }
    }
    return named;
}


} // End anonymous namespace


void Foam::misfit::decide(const study& s, finding& f)
{
    Info<< "Verdict" << endl;
    const settings& set = s.set;
    statistics::setProbabilities(f.explained.all(), set.temperature);
    f.rivals = f.explained.rivals(set);
    choose(s, f);

    const bool changed =
        f.verdict != verdictKind::none && f.verdict != verdictKind::unknown;
    f.before = f.explained.baseline().best.f;
    f.after = changed ? f.best().best.f : f.before;
    if (changed)
    {
        setStrengths(s, f);
    }
    if (f.verdict == verdictKind::named)
    {
        f.answer.append(namedState(s, f));
    }
    if (f.verdict == verdictKind::set && f.weakened)
    {
        f.measure.what = advice::kind::check;
    }
    else if (f.verdict == verdictKind::set)
    {
        f.measure = measurementBetween(s, f);
    }
    if (f.strengths.size() && !f.best().what.unknown)
    {
        const std::vector<place> named(locateNamed(s, f));
        f.located = named.size() ? named : f.located;
    }
    setConfidence(set, f);
}
