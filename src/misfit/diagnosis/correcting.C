// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of a free correction share.

#include "correcting.H"

Foam::misfit::correcting::correcting(const study& whole, const scored& calibrated)
:
    s(whole.ofCorrection()),
    base(calibrated),
    white(base.covariance),
    atBase(vec::Zero(s.bounds.mean.size()))
{
    const label nP = s.bounds.nParameters;
    atBase.head(nP) = base.best.x.head(nP);
    found.asked = true;
}


Foam::misfit::scored Foam::misfit::correcting::fit
(
    const mat& combination,
    const scalar number
) const
{
    scored w;
    w.what.combination = combination;
    w.number = number;
    w.covariance = base.covariance;
    return s.calibration.score().again(w, white);
}


Foam::misfit::computed
Foam::misfit::correcting::compute(const scored& start)
{
    computed r(refit(s, start, &white));
    if (r.failure.size())
    {
        const computed said(onSurface(s, r.best));
        r.variables = said.variables;
        r.given = said.given;
    }
    return r;
}
