// SPDX-License-Identifier: GPL-3.0-or-later
// S6: the best explanations, computed in the solver and fitted again.

#include "diagnosis.H"
#include "settle.H"
#include "HashSet.H"

Foam::misfit::weighed Foam::misfit::diagnosis::refitted(const weighed& w)
{
    const auto local(fit_->copy());
    const auto weigh = [&]()
    {
        return local->weigh(settings_.formulaTolerance);
    };
    refitting<weighed> with;
    with.expand = [&](const weighed& now)
    {
        return
            hypothesisModel(local->surface(), bounds_, now.what).expand(now.best.x);
    };
    with.compute = [&](const vec& x)
    {
        return means(List<vec>(1, x)).first();
    };
    with.passThrough = [&](const vec& x, const samples& given)
    {
        local->passThrough(x, given.fit);
    };
    with.stay = [&](const weighed& now)
    {
        return weigh().where(now);
    };
    with.fit = [&](const weighed& now)
    {
        return weigh().thoroughly(now);
    };

    const settled<weighed> s(settle(w, settings_.passes, width_, with));
    forget(w);
    if (s.failure.empty())
    {
        computed_.append({told(w.what, mechanismNames()), s.variables, s.given});
    }
    return s.best;
}


void Foam::misfit::diagnosis::forget(const weighed& w)
{
    const string name(told(w.what, mechanismNames()));
    List<computed> others;
    for (const computed& c : computed_)
    {
        if (c.explanation != name)
        {
            others.append(c);
        }
    }
    computed_.transfer(others);
}


void Foam::misfit::diagnosis::refit()
{
    if (found_.detection.p >= settings_.significance)
    {
        return;
    }
    Info<< "S6 refit" << endl;
    List<weighed>& all = found_.explanations;

    // The first run of each, side by side; the passes find them done
    List<vec> first;
    forAll(all, i)
    {
        if (i < settings_.refit || all[i].what.isNone())
        {
            const hypothesisModel model(fit_->surface(), bounds_, all[i].what);
            first.append(model.expand(all[i].best.x));
        }
    }
    means(first);

    // The base too; then the best, until the best of all was computed
    HashSet<string, string::hash> done;
    for (weighed& w : all)
    {
        if (w.what.isNone())
        {
            w = refitted(w);
            done.insert(told(w.what, mechanismNames()));
        }
    }
    for (label n = 0; n < settings_.refit + 2; ++n)
    {
        sortByScore(all);
        label i = 0;
        while
        (
            i < min(settings_.refit, all.size())
         && done.found(told(all[i].what, mechanismNames()))
        )
        {
            ++i;
        }
        if (i == min(settings_.refit, all.size()))
        {
            break;
        }
        done.insert(told(all[i].what, mechanismNames()));
        all[i] = refitted(all[i]);
    }
    sortByScore(all);
}


const Foam::misfit::diagnosis::computed*
Foam::misfit::diagnosis::findComputed(const weighed& w) const
{
    const string name(told(w.what, mechanismNames()));
    for (const computed& c : computed_)
    {
        if (c.explanation == name)
        {
            return &c;
        }
    }
    return nullptr;
}


Foam::misfit::diagnosis::computed
Foam::misfit::diagnosis::lookUp(const weighed& w) const
{
    if (const computed* found = findComputed(w))
    {
        return *found;
    }

    const hypothesisModel model(fit_->surface(), bounds_, w.what);
    computed c;
    c.explanation = told(w.what, mechanismNames());
    c.variables = model.expand(w.best.x);
    c.given.fit = w.best.f;
    if (gate_->size())
    {
        c.given.gate = gate_->surface()(c.variables);
    }
    return c;
}


const Foam::misfit::weighed& Foam::misfit::diagnosis::baseline() const
{
    for (const weighed& w : found_.explanations)
    {
        if (w.what.isNone())
        {
            return w;
        }
    }
    return found_.explanations.last();
}


Foam::scalar Foam::misfit::diagnosis::lowestScore() const
{
    scalar lowest = GREAT;
    for (const weighed& w : found_.explanations)
    {
        lowest = min(lowest, w.score);
    }
    return lowest;
}


Foam::List<Foam::misfit::weighed> Foam::misfit::diagnosis::rivals() const
{
    const scalar lowest = lowestScore();
    hypothesis leader;
    for (const weighed& w : found_.explanations)
    {
        if (w.score == lowest)
        {
            leader = w.what;
        }
    }
    List<weighed> near;
    for (const weighed& w : found_.explanations)
    {
        // Another formula of the first is easily taken for a second mechanism
        const bool isPart =
            leader.mechanisms.size() > 1 && w.what.mechanisms.size()
         && leader.contains(w.what);
        if (w.score < lowest + (isPart ? settings_.pairGap : settings_.gap))
        {
            near.append(w);
        }
    }
    return near;
}
