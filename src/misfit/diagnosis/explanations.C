// SPDX-License-Identifier: GPL-3.0-or-later
// The explanations that were scored, and what the solver gave for them.

#include "explanations.H"

#include <algorithm>

const Foam::misfit::hypothesisFit& Foam::misfit::explanations::baseline() const
{
    for (const hypothesisFit& w : all_)
    {
        if (w.what.isNone())
        {
            return w;
        }
    }
    return all_.back();
}


Foam::scalar Foam::misfit::explanations::lowestScore() const
{
    scalar lowest = GREAT;
    for (const hypothesisFit& w : all_)
    {
        lowest = min(lowest, w.score);
    }
    return lowest;
}


void Foam::misfit::explanations::sort()
{
    statistics::sortByScore(all_);
}


std::vector<const Foam::misfit::hypothesisFit*>
Foam::misfit::explanations::byScore() const
{
    std::vector<const hypothesisFit*> list;
    for (const hypothesisFit& w : all_)
    {
        list.push_back(&w);
    }
    const auto isBetter = [](const hypothesisFit* a, const hypothesisFit* b)
    {
        return a->score < b->score;
    };
    std::stable_sort(list.begin(), list.end(), isBetter);
    return list;
}


void Foam::misfit::explanations::putFirst(const hypothesis& h)
{
    for (hypothesisFit& w : all_)
    {
        if (w.what == h)
        {
            std::swap(w, all_.front());
            return;
        }
    }
}


std::vector<Foam::misfit::hypothesisFit>
Foam::misfit::explanations::rivals(const settings& set) const
{
    const scalar lowest = lowestScore();
    hypothesis leader;
    for (const hypothesisFit& w : all_)
    {
        if (w.score == lowest)
        {
            leader = w.what;
        }
    }
    std::vector<hypothesisFit> near;
    for (const hypothesisFit& w : all_)
    {
        // Another formula of the first is easily taken for a second mechanism
        const bool isPart =
            leader.mechanisms.size() > 1 && w.what.mechanisms.size()
         && leader.contains(w.what);
        if (w.score < lowest + (isPart ? set.pairGap : set.gap))
        {
            near.push_back(w);
        }
    }
    return near;
}


const Foam::misfit::evaluation*
Foam::misfit::explanations::find(const hypothesis& h) const
{
    for (const evaluation& c : evaluations_)
    {
        if (c.best.what == h)
        {
            return &c;
        }
    }
    return nullptr;
}


Foam::misfit::evaluation Foam::misfit::explanations::lookUp
(
    const study& s,
    const hypothesisFit& w
) const
{
    if (const evaluation* known = find(w.what))
    {
        return *known;
    }
    return onSurface(s, w);
}


void Foam::misfit::explanations::note(const evaluation& c)
{
    evaluations_.erase
    (
        std::remove_if
        (
            evaluations_.begin(),
            evaluations_.end(),
            [&c](const evaluation& old) { return old.best.what == c.best.what; }
        ),
        evaluations_.end()
    );
    if (c.failure.empty())
    {
        evaluations_.push_back(c);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::misfit::evaluation
Foam::misfit::onSurface(const study& s, const hypothesisFit& w)
{
    evaluation c;
    c.best = w;
    c.variables = s.calibration.model(w.what).expand(w.fit.x);
    c.computed.calibration = w.fit.f;
    if (s.validation.size())
    {
        c.computed.validation = s.validation.surface()(c.variables);
    }
    return c;
}


std::vector<int> Foam::misfit::commonMechanisms(const std::vector<hypothesisFit>& list)
{
    std::vector<int> core(list.front().what.mechanisms);
    for (const hypothesisFit& w : list)
    {
        std::vector<int> both;
        for (const int m : core)
        {
            if (statistics::contains(w.what.mechanisms, m))
            {
                both.push_back(m);
            }
        }
        core = both;
    }
    return core;
}


bool Foam::misfit::isAmong
(
    const std::vector<hypothesisFit>& list,
    const hypothesisFit& w
)
{
    return std::any_of
    (
        list.begin(),
        list.end(),
        [&w](const hypothesisFit& other) { return other.what == w.what; }
    );
}
