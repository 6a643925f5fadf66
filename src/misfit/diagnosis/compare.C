// SPDX-License-Identifier: GPL-3.0-or-later
// What these channels can tell apart, and what measurement would settle the
// rest.

#include "diagnosis.H"
#include "StringStream.H"

#include <cmath>

void Foam::misfit::diagnosis::compare(const weighed& base)
{
    const label n = mechanisms_.size();
    const hypothesisModel model(fit_->surface(), bounds_, base.what);
    const vec at = model.expand(base.best.x);
    const whitener white
    (
        withFitted
        (
            base.covariance, model.slopes(base.best.x), model.deviation()
        )
    );

    mat effects(fit_->size(), n);
    for (label i = 0; i < n; ++i)
    {
        const candidate& c = settings_.candidates[mechanisms_[i]];
        found_.candidates.append(c.name);
        vec with = at;
        with[bounds_.nParameters + mechanisms_[i]] = c.strong;
        effects.col(i) =
            white(vec(fit_->surface()(with) - fit_->surface()(at)));
    }

    // What is left of one when the other, at any strength, imitates it
    found_.apart.resize(n, n);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const vec a = effects.col(i);
            const vec b = effects.col(j);
            const scalar share =
                i == j ? 0 : max(a.dot(b), 0.0)/max(b.squaredNorm(), VSMALL);
            found_.apart(i, j) = (a - share*b).norm();
        }
    }
}


void Foam::misfit::diagnosis::advise(const List<weighed>& rivals)
{
    List<computed> two;
    for (const weighed& w : rivals)
    {
        if (two.size() < 2 && !w.what.isNone() && !w.what.isOnlyUnknown())
        {
            two.append(lookUp(w));
        }
    }
    if (two.size() < 2)
    {
        return;
    }

    for (const computed& c : two)
    {
        if (!c.given.possible.size() && sampler_.data().first().possible.size())
        {
            found_.advice =
                "Which measurement would settle it was not weighed, since "
              + c.explanation + " was not run in the solver (refit in decision)";
            return;
        }
    }

    const vec& a = two[0].given.possible;
    const vec& b = two[1].given.possible;
    const stacked& possible = sampler_.data().first().possible;
    scalar most = 0;
    OStringStream os;
    os.precision(3);
    for (const segment& s : possible.segments)
    {
        if (a.size() != possible.size() || b.size() != a.size())
        {
            break;
        }
        label i = 0;
        const scalar d =
            vec(s.of(a) - s.of(b)).cwiseAbs().maxCoeff(&i)/s.uncertainty;
        if (d > most)
        {
            most = d;
            os.reset();
            os << "Measure " << s.name.c_str() << ": at " << s.x[i]
                << (s.overTime ? " s" : " m") << ", "
                << two[0].explanation.c_str() << " and "
                << two[1].explanation.c_str() << " differ there by " << d
                << " times its uncertainty";
        }
    }
    if (most > 2)
    {
        found_.advice = os.str();
        return;
    }
    found_.advice =
        "The channels that are there, also the possible ones that the"
        " dictionary names, do not tell " + two[0].explanation + " from "
      + two[1].explanation + ". Measure another quantity or nearer to"
        " where they act; name it in channels without a file, and it is weighed"
        " here";
}


void Foam::misfit::diagnosis::adviseToCheck()
{
    string channels;
    for (const Tuple2<word, weighed>& w : winners_)
    {
        channels += (channels.empty() ? "" : " and ") + w.first();
    }
    found_.advice =
        "The answer hangs on " + channels
      + ": check what was recorded there, or measure it a second time";
}
