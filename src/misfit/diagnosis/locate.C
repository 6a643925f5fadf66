// SPDX-License-Identifier: GPL-3.0-or-later
// Where and when recording and simulation part, and what could be seen at all.

#include "diagnosis.H"

void Foam::misfit::diagnosis::locate
(
    const vec& misfit,
    const mat& covariance
)
{
    List<window> clear;
    if (found_.detection.p < settings_.significance)
    {
        clear = stretches(fit_->data(), misfit, covariance, settings_.beyond);
        if (clear.empty())
        {
            // Chance says no, yet no sample is far off: the strongest window
            clear = found_.detection.windows;
            clear.setSize(min(clear.size(), 1));
        }
    }
    setLocated(clear, misfit);
}


void Foam::misfit::diagnosis::locateNamed()
{
    // Half of what is left counts, too: nature's formula may be another one
    const vec explained =
        0.5*(found_.after - found_.before)
      + 0.5*(fit_->data().y - found_.before);
    const List<window> clear
    (
        stretches
        (
            fit_->data(),
            explained,
            baseline().covariance,
            settings_.beyond
        )
    );
    if (clear.size())
    {
        setLocated(clear, explained);
    }
}


void Foam::misfit::diagnosis::setLocated
(
    const List<window>& places,
    const vec& misfit
)
{
    found_.located.clear();
    for (const window& w : places)
    {
        found_.located.append(told(w, fit_->data(), misfit));
    }
    found_.detection.windows = places;
}


Foam::misfit::mat
Foam::misfit::diagnosis::shapes(const weighed& base) const
{
    mat all(fit_->size(), 0);
    const auto add = [&all](const vec& change)
    {
        if (change.norm() > SMALL)
        {
            appendColumn(all, change);
        }
    };

    const hypothesisModel model(fit_->surface(), bounds_, base.what);
    const vec at = model.expand(base.best.x);
    forAll(settings_.candidates, i)
    {
        // A weak effect may look otherwise than a strong one, as one that delays
        for
        (
            const scalar strength :
            {settings_.candidates[i].weak, settings_.candidates[i].strong}
        )
        {
            vec with = at;
            with[bounds_.nParameters + i] = strength;
            add(fit_->surface()(with) - fit_->surface()(at));
        }
    }

    for (const auto& fault : possibleFaults(fit_->data(), settings_.faults))
    {
        if (fault->size() == 1)
        {
            add((*fault)(base.best.f, fault->slight()) - base.best.f);
        }
    }
    return all;
}


Foam::misfit::visibility Foam::misfit::diagnosis::visible()
{
    uncertainty();
    calibrationRuns();
    visibility v;
    v.sensors = covariance(fit_->data(), 0).at(fit_->data().y);
    v.all = fit_->uncertainty().at(fit_->surface()(bounds_.mean));
    v.calibrated = withFitted
    (
        v.all,
        fit_->surface().slopes(bounds_.mean).leftCols(bounds_.nParameters),
        bounds_.deviation.head(bounds_.nParameters)
    );
    return v;
}
