// SPDX-License-Identifier: GPL-3.0-or-later
// What these channels can distinguish, and which measurement would settle the rest.

#include "stages.H"

Foam::misfit::separation Foam::misfit::separate
(
    const study& s,
    const std::vector<int>& mechanisms,
    const hypothesisFit& base
)
{
    const sampledModel& calibration = s.calibration;
    const hypothesisModel model(calibration.model(base.what));
    const vec at = model.expand(base.fit.x);
    const whitener white
    (
        statistics::withFitted
        (
            base.covariance, model.slopes(base.fit.x), model.deviation()
        )
    );

    const label n = mechanisms.size();
    mat effects(calibration.size(), n);
    for (label i = 0; i < n; ++i)
    {
        vec with = at;
        with[s.bounds.nParameters + mechanisms[i]] =
            s.set.candidates[mechanisms[i]].strong;
        effects.col(i) =
            white(vec(calibration.surface()(with) - calibration.surface()(at)));
    }

    // What is left of one when the other, at any strength, imitates it
    separation apart{s.namesOf(mechanisms), mat(n, n)};
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const vec a = effects.col(i);
            const vec b = effects.col(j);
            const scalar share =
                i == j ? 0 : max(a.dot(b), 0.0)/max(b.squaredNorm(), VSMALL);
            apart.distances(i, j) = (a - share*b).norm();
        }
    }
    return apart;
}


Foam::misfit::advice Foam::misfit::measurementBetween
(
    const study& s,
    const explanations& explained,
    const std::vector<hypothesisFit>& alternatives
)
{
    advice result;
    std::vector<evaluation> two;
    for (const hypothesisFit& w : alternatives)
    {
        if (two.size() < 2 && !w.what.isNone() && !w.what.isOnlyUnknown())
        {
            two.push_back(explained.lookUp(s, w));
        }
    }
    if (two.size() < 2)
    {
        return result;
    }
    const stacked& possible = s.data().possible;
    for (const evaluation& c : two)
    {
        if (!c.computed.possible.size() && possible.size())
        {
            result.what = advice::kind::notRun;
            result.two = {c.best.what};
            return result;
        }
    }

    result.what = advice::kind::elsewhere;
    result.two = {two[0].best.what, two[1].best.what};
    const vec& a = two[0].computed.possible;
    const vec& b = two[1].computed.possible;
    if (a.size() != possible.size() || b.size() != a.size())
    {
        return result;
    }
    for (const segment& channel : possible.segments)
    {
        label i = 0;
        const scalar times =
            vec(channel.of(a) - channel.of(b)).cwiseAbs().maxCoeff(&i)
           /channel.uncertainty;
        if (times > result.times)
        {
            result.times = times;
            result.channel = channel;
            result.at = channel.x[i];
        }
    }
    if (result.times > s.set.separation)
    {
        result.what = advice::kind::measure;
    }
    return result;
}
