// SPDX-License-Identifier: GPL-3.0-or-later
// S9: the verdict.

#include "diagnosis.H"
#include "HashSet.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

bool isFault(const weighed& w)
{
    return w.what.fault != nullptr;
}


bool isSame(const List<label>& a, const List<label>& b)
{
    return labelHashSet(a) == labelHashSet(b);
}


//- The mechanisms that all have on
List<label> common(const List<weighed>& list)
{
    List<label> core(list.first().what.mechanisms);
    for (const weighed& w : list)
    {
        List<label> both;
        for (const label m : core)
        {
            if (w.what.mechanisms.found(m))
            {
                both.append(m);
            }
        }
        core = both;
    }
    return core;
}


//- Without those that add to another
List<weighed> simplest(const List<weighed>& list)
{
    List<weighed> kept;
    for (const weighed& w : list)
    {
        bool adds = false;
        for (const weighed& other : list)
        {
            adds = adds || w.what.extends(other.what);
        }
        if (!adds)
        {
            kept.append(w);
        }
    }
    return kept;
}

} // End anonymous namespace


void Foam::misfit::diagnosis::putFirst(const string& explanation)
{
    const wordList names(mechanismNames());
    forAll(found_.explanations, i)
    {
        if (told(found_.explanations[i].what, names) == explanation)
        {
            std::swap(found_.explanations[i], found_.explanations[0]);
            return;
        }
    }
}


void Foam::misfit::diagnosis::prefer()
{
    // Held-out data are judged by the solver, not by the surface; what the solver
    // makes worse gives way to the next
    HashSet<string, string::hash> tried;
    for (label n = 0; n < settings_.refit + 2; ++n)
    {
        preferAmongRivals();
        const bool asked =
            found_.detection.p >= settings_.significance
         || findComputed(best())
         || !tried.insert(told(best().what, mechanismNames()));
        if (asked)
        {
            return;
        }
        found_.explanations[0] = refitted(best());
    }
    preferAmongRivals();
}


void Foam::misfit::diagnosis::preferAmongRivals()
{
    sortByScore(found_.explanations);

    // What all rivals have on is the answer, if that alone is one of them
    const wordList names(mechanismNames());
    const List<weighed> near(rivals());
    const List<label> core(common(near));
    for (const weighed& w : near)
    {
        if (core.size() && w.what.mechanisms.size() == core.size())
        {
            putFirst(told(w.what, names));
            break;
        }
    }

    // If it leaves more than chance, it is a part of what is missing
    const bool whole =
        best().what.mechanisms.size() && !best().what.unknown;
    if (whole && look(*fit_, best()).p < settings_.adequacy)
    {
        hypothesis part(best().what);
        part.unknown = true;
        putFirst(told(part, names));
    }
}


void Foam::misfit::diagnosis::judge(List<weighed>& near)
{
    label faults = 0;
    for (const weighed& w : near)
    {
        faults += isFault(w);
        if (w.what.isOnlyUnknown())
        {
            found_.verdict = "unknown";
            return;
        }
    }
    bool oneChannel = faults == near.size();
    for (const weighed& w : near)
    {
        oneChannel =
            oneChannel
         && w.what.fault->channel() == best().what.fault->channel();
    }
    if (oneChannel)
    {
        found_.verdict =
            best().what.fault->isRegistration()
          ? "registration" : "sensor";
        found_.names.append(best().what.fault->channel());
        return;
    }

    const List<label> core(common(near));
    if (core.size() && isSame(best().what.mechanisms, core))
    {
        found_.names = namesOf(core);
        found_.verdict = "named";
        return;
    }

    callSet(near);
}


void Foam::misfit::diagnosis::callSet(List<weighed>& all)
{
    // One that adds to another of the set says nothing more
    all = simplest(all);
    found_.verdict = "set";
    found_.names.clear();
    for (const weighed& w : all)
    {
        // As where one is named, names are of mechanisms and faults
        found_.names.append(word(told(w.what.known(), mechanismNames()), false));
    }
    set_ = all;
}


void Foam::misfit::diagnosis::weaken(List<weighed>& near)
{
    if (found_.verdict == "named")
    {
        near = List<weighed>(1, best());
        List<weighed> all(near);
        for (const Tuple2<word, weighed>& without : winners_)
        {
            all.append(without.second());
        }

        // What wins without a channel, too, has some of it: that much is sure
        const List<label> sure(common(all));
        if (sure.size())
        {
            found_.names = namesOf(sure);
            partly_ = true;
            return;
        }
        weakened_ = true;
    }
    near = simplest(near);
    for (const Tuple2<word, weighed>& without : winners_)
    {
        const weighed& w = without.second();
        // What all data support does not give way to what wins on fewer
        bool another = !isAmong(near, w);
        for (const weighed& n : near)
        {
            another =
                another && !n.what.extends(w.what) && !w.what.extends(n.what);
        }
        if (another)
        {
            near.append(w);
        }
    }
    callSet(near);
}


bool Foam::misfit::diagnosis::answers() const
{
    return
        passed("computed") && passed("adequacy") && passed("heldOut")
     && passed("harm") && passed("transfer") && passed("alone")
     && passed("placebo");
}


bool Foam::misfit::diagnosis::confirmsNone() const
{
    for (const heldOut& h : found_.held)
    {
        if (h.use == purpose::gate && h.squareBefore >= limitOfNothing(h))
        {
            return false;
        }
    }

    // Where the fitted channels agree, an experiment in which the solver fails
    // confirms nothing
    return passed("detection") || passed("computed");
}


Foam::wordList Foam::misfit::diagnosis::failedGates() const
{
    wordList failed;
    for (const gate& g : found_.gates)
    {
        // No misfit beyond chance is no failure
        if
        (
            g.applies && !g.passed && g.name != "detection"
         && !failed.found(g.name)
        )
        {
            failed.append(g.name);
        }
    }
    return failed;
}


bool Foam::misfit::diagnosis::wasTried() const
{
    for (const gate& g : found_.gates)
    {
        if ((g.name == "heldOut" || g.name == "transfer") && g.applies)
        {
            return true;
        }
    }
    return false;
}


bool Foam::misfit::diagnosis::isUnproved() const
{
    return
        found_.verdict == "unknown" && passed("evidence") && answers()
     && !best().what.isOnlyUnknown();
}


void Foam::misfit::diagnosis::decide()
{
    setProbabilities(found_.explanations, settings_.temperature);
    setPosterior();
    const List<weighed> near(choose());

    const bool changed = found_.verdict != "none" && found_.verdict != "unknown";
    found_.before = baseline().best.f;
    found_.after = changed ? best().best.f : found_.before;
    if (changed)
    {
        setStrengths();
    }
    if (found_.verdict == "named")
    {
        found_.answer.append(namedState());
    }
    if (found_.verdict == "set")
    {
        weakened_ ? adviseToCheck() : advise(near);
    }
    if (found_.strengths.size() && !best().what.unknown)
    {
        locateNamed();
    }
    confide();
    describe();
}


Foam::List<Foam::misfit::weighed> Foam::misfit::diagnosis::choose()
{
    found_.verdict = "none";
    List<weighed> near;
    if (passed("detection") && passed("evidence"))
    {
        near = rivals();
        judge(near);
        if (!answers())
        {
            found_.verdict = "unknown";
        }
        else if (found_.verdict != "unknown" && !passed("stability"))
        {
            weaken(near);
        }
    }
    if (found_.verdict == "none" && !confirmsNone())
    {
        found_.verdict = "unknown";
    }
    if (found_.verdict == "unknown")
    {
        found_.names.clear();
    }
    return near;
}


void Foam::misfit::diagnosis::setStrengths()
{
    const fitted& with = best().best;
    forAll(best().what.mechanisms, i)
    {
        const label k = bounds_.nParameters + i;
        const word name(mechanismNames()[best().what.mechanisms[i]]);
        if (!partly_ || found_.names.found(name))
        {
            found_.strengths.append
            ({
                name, with.x[k], with.deviation(k), with.pinned[k]
            });
        }
    }
}


Foam::misfit::runState Foam::misfit::diagnosis::namedState() const
{
    const hypothesisModel model(fit_->surface(), bounds_, best().what);
    runState named(state(model.expand(best().best.x)));
    for (const word& name : named.strengths.toc())
    {
        if (!found_.names.found(name))
        {
            named.strengths.erase(name);
        }
    }
    return named;
}


bool Foam::misfit::diagnosis::isAmong
(
    const List<weighed>& list,
    const weighed& w
) const
{
    const wordList names(mechanismNames());
    const string name(told(w.what, names));
    return std::any_of
    (
        list.begin(),
        list.end(),
        [&](const weighed& other) { return told(other.what, names) == name; }
    );
}
