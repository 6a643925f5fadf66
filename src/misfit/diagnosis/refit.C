// SPDX-License-Identifier: GPL-3.0-or-later
// Explanations are scored on the response surface; the best are computed in the
// solver and fitted again.

#include "refit.H"
#include "stages.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Computes an explanation and notes what the solver gave
hypothesisFit recompute(study& s, explanations& e, const hypothesisFit& w)
{
    const evaluation c(refit(s, w));
    e.note(c);
    Info<< "    score " << w.score << ", computed " << c.best.score << endl;
    return c.best;
}


void preferAmongRivals(const study& s, explanations& e)
{
    e.sort();

    // What all rivals have on is the answer, if that alone is one of them
    const std::vector<hypothesisFit> near(e.rivals(s.set));
    const std::vector<int> core(commonMechanisms(near));
    for (const hypothesisFit& w : near)
    {
        if (core.size() && w.what.mechanisms.size() == core.size())
        {
            e.putFirst(w.what);
            break;
        }
    }

    // If it leaves more than chance, it is a part of what is missing
    const hypothesis what(e.best().what);
    const bool exchanged =
        what.fault && what.fault->kind == faultKind::swapped;
    const bool whole =
        (what.mechanisms.size() || exchanged) && !what.unknown;
    if (whole && scanResidual(s, e.best()).p < s.set.adequacy)
    {
        hypothesis part(what);
        part.unknown = true;
        e.putFirst(part);
    }
}


//- The score up to which an explanation may still win: the error of the surface grows
//  with the misfit, whose measure is the gain of the best
scalar limitOfRefit(const explanations& e, const rules& limits)
{
    const scalar lowest = e.lowestScore();
    const scalar gain = e.baseline().score - lowest;
    return lowest + max(limits.refitWithin, limits.refitWithinShare*gain);
}


//- The base and the best explanations, until the best of all was computed
void refitBest(study& s, explanations& e)
{
    Info<< "Refit of the best explanations" << endl;
    std::vector<hypothesisFit>& all = e.all();
    const label n = s.set.refit;

    // The first run of each, side by side; the passes find them done
    std::vector<vec> first;
    const scalar limit = limitOfRefit(e, s.set);
    for (label i = 0; i < count(all); ++i)
    {
        if ((i < n && all[i].score <= limit) || all[i].what.isNone())
        {
            first.push_back(s.calibration.model(all[i].what).expand(all[i].fit.x));
        }
    }
    s.means(first);

    // The base too; then the best, until the best of all was computed
    std::vector<hypothesis> done;
    for (hypothesisFit& w : all)
    {
        if (w.what.isNone())
        {
            w = recompute(s, e, w);
            done.push_back(w.what);
        }
    }
    const label most = min(n, label(all.size()));
    for (label k = 0; k < n + 2; ++k)
    {
        e.sort();
        label i = 0;
        while (i < most && statistics::contains(done, all[i].what))
        {
            ++i;
        }
        if (i == most || all[i].score > limitOfRefit(e, s.set))
        {
            break;
        }
        done.push_back(all[i].what);
        all[i] = recompute(s, e, all[i]);
    }
    e.sort();
}


//- Puts the simplest explanation that the rivals agree on first, as the solver
//  computes it: held-out data are judged by the solver, not by the surface; what the
//  solver makes worse gives way to the next
void prefer(study& s, explanations& e, const bool detected)
{
    std::vector<hypothesis> attempts;
    for (label n = 0; n < s.set.refit + 2; ++n)
    {
        preferAmongRivals(s, e);
        const hypothesis what(e.best().what);
        if (!detected || e.find(what) || statistics::contains(attempts, what))
        {
            return;
        }
        attempts.push_back(what);
        e.all().front() = recompute(s, e, e.best());
    }
    preferAmongRivals(s, e);
}

} // End anonymous namespace


Foam::misfit::evaluation Foam::misfit::refit
(
    const hypothesisFit& start,
    const rules& limits,
    const vec& width,
    const refitSteps& with
)
{
    evaluation r;
    r.best = start;
    hypothesisFit least(start);
    hypothesisFit onward(start);
    hypothesisFit next(start);
    scalar share = 1;
    for (label pass = 0; pass < limits.passes; ++pass)
    {
        const vec x = with.expand(next);
        const samples computed(with.compute(x));
        if (!computed.ok() && !pass)
        {
            Info<< "    not computed: " << computed.failure.c_str() << endl;
            r.failure = computed.failure;
            return r;
        }

        bool better = false;
        if (computed.ok())
        {
            with.passThrough(x, computed);
            const hypothesisFit here(with.stay(next));
            better = !pass || here.score < least.score;
            if (better)
            {
                least = here;
                r.variables = x;
                r.computed = computed;
            }
            else
            {
                with.passThrough(r.variables, r.computed);
            }
            onward = with.fit(least);
        }
        else
        {
            Info<< "    half as far, as there " << computed.failure.c_str() << endl;
        }
        share = better ? 1 : 0.5*share;

        const vec step = with.expand(onward) - with.expand(least);
        const bool stays =
            !step.size()
         || step.cwiseQuotient(width).cwiseAbs().maxCoeff() < limits.settled;
        if (stays)
        {
            r.best = onward;
            return r;
        }
        next = onward;
        next.fit.x = least.fit.x + share*(onward.fit.x - least.fit.x);
    }
    r.best = least;
    return r;
}


Foam::misfit::evaluation Foam::misfit::refit
(
    study& s,
    const hypothesisFit& start,
    const whitener* white
)
{
    sampledModel local(s.calibration);
    refitSteps with;
    with.expand = [&](const hypothesisFit& now)
    {
        return local.model(now.what).expand(now.fit.x);
    };
    with.compute = [&](const vec& x)
    {
        return s.means(std::vector<vec>(1, x)).first();
    };
    with.passThrough = [&](const vec& x, const samples& computed)
    {
        local.passThrough(x, computed.calibration);
    };
    with.stay = [&](const hypothesisFit& now)
    {
        const scoring score(local.score());
        return white ? score.where(now, *white) : score.where(now);
    };
    with.fit = [&](const hypothesisFit& now)
    {
        const scoring score(local.score());
        return white ? score.again(now, *white) : score.withOwnCovariance(now);
    };
    return refit(start, s.set, s.bounds.width, with);
}


Foam::labelRange Foam::misfit::refitRuns(const settings& set)
{
    // The base and one more, where the first run settles both. At most the base, n + 2 in
    // turn and n + 2 that are preferred, and n first runs of which nothing comes
    const label n = set.refit;
    const label least = (n > 1 ? 2 : 1)*set.commonRandomNumbers;
    const label most = ((2*n + 5)*set.passes + n)*set.commonRandomNumbers;
    return labelRange(least, most - least + 1);
}


Foam::misfit::explanations Foam::misfit::rank
(
    study& s,
    const std::vector<int>& mechanisms,
    const bool detected
)
{
    Info<< "Sensors and mechanisms" << endl;
    explanations all
    (
        s.calibration.score().all
        (
            mechanisms,
            possibleFaults(s.calibration.data(), s.set.faults),
            s.set.pairs
        )
    );
    if (detected)
    {
        refitBest(s, all);
    }
    prefer(s, all, detected);
    if (!detected)
    {
        // Where the fitted channels agree, others may part all the same
        all.putFirst(hypothesis(all.baseline().what));
    }
    statistics::setProbabilities(all.all(), s.set.temperature);
    return all;
}
