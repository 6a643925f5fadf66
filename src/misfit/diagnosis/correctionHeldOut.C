// SPDX-License-Identifier: GPL-3.0-or-later
// What a free correction leaves, and whether it holds where it was not fitted.

#include "correctionFitter.H"
#include "detect.H"

Foam::misfit::runState Foam::misfit::correctionFitter::inExperiment
(
    const word& experiment,
    const correctionFit& f,
    const dimensionlessLaw* followed,
    const samples& before
) const
{
    vec x = f.variables;
    if (followed)
    {
        const mat there(combinationOf(*followed, elements(), before.met));
        x.tail(elements().size()) =
            there*f.explained.best.x.tail(there.cols());
    }
    return s_.state(experiment, x);
}


bool Foam::misfit::correctionFitter::holdsIn
(
    const observed& other,
    const correctionFit& f,
    const dimensionlessLaw* law,
    const covariance& known
)
{
    // A push that follows the flow is another one where the flow is another
    const bool follows = law && law->family == "push";
    runState base(s_.state(other.experiment, atBase_));
    base.noting = follows;
    const samples before(s_.means(List<runState>(1, base)).first());
    if (!before.ok())
    {
        return false;
    }
    const runState with
    (
        inExperiment(other.experiment, f, follows ? law : nullptr, before)
    );
    const samples after(s_.means(List<runState>(1, with)).first());
    if (!after.ok() || !other.of(other.use).size())
    {
        return false;
    }
    compare
    (
        heldOut::part::experiment, other, other.use, before, after, known,
        s_.set(), found_.held
    );
    const heldOut& h = found_.held.last();
    const scalar left =
        1 + s_.set().leftIfConfirmed*(h.squareBefore - 1);
    return h.squareAfter < max(left, h.limitOfMatch);
}


void Foam::misfit::correctionFitter::test
(
    const correctionFit& f,
    const std::map<word, covariance>& known
)
{
    const dimensionlessLaw* law =
        found_.explained ? &found_.laws.first().law : nullptr;
    const settings& set = s_.set();
    found_.after = f.explained.best.f;
    found_.left = scanResidual(s_, *m_.calibration, f.explained).p;
    found_.isEnough = found_.left >= set.adequacy;
    compareHere
    (
        s_, given_, f.given, m_.validation->uncertainty(), found_.held
    );
    label asked = 0;
    label held = 0;
    for (label i = 1; i < s_.experiments().size(); ++i)
    {
        const observed& other = s_.experiments()[i];
        const bool holds =
            holdsIn(other, f, law, known.at(other.experiment));
        if (other.use == purpose::validation && other.validation.size())
        {
            ++asked;
            held += holds;
        }
    }
    found_.transfers = asked && held == asked;
}


void Foam::misfit::correctionFitter::finish(const correctionFit& best)
{
    found_.ofSurface = best.failure.size();
    for (const heldOut& h : found_.held)
    {
        const bool worse = h.squareAfter > h.squareBefore;
        found_.holds = found_.holds && !(worse && h.use == purpose::validation);
    }
    found_.named =
        found_.explained && found_.transfers && found_.holds
     && found_.isEnough;
}
