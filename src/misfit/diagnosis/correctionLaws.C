// SPDX-License-Identifier: GPL-3.0-or-later
// All elements of a free correction following dimensionless numbers.

#include "correctionFitter.H"

#include <algorithm>
#include <cmath>

void Foam::misfit::correctionFitter::addLaw
(
    const dimensionlessLaw& law,
    const correctionFit& f,
    const scalar lead
)
{
    const label k = law.functions.size();
    vec deviations(k);
    for (label j = 0; j < k; ++j)
    {
        deviations[j] =
            f.explained.best.deviation(s_.bounds().nParameters + j);
    }
    found_.laws.append({law, f.explained.best.x.tail(k), deviations, lead});
}


void Foam::misfit::correctionFitter::judge
(
    const correctionFit& free,
    const List<dimensionlessLaw>& laws,
    const List<correctionFit>& fits,
    const labelList& order
)
{
    const settings& set = s_.set();
    const dimensionlessLaw& best = laws[order[0]];
    const correctionFit& first = fits[order[0]];
    const scalar needed = free.free.size() ? set.gap : set.evidence;
    const bool enough =
        first.variables.size() && first.failure.empty()
     && free.explained.score - first.explained.score >= needed;
    found_.explained = enough;
    for (const label i : order)
    {
        const scalar score = fits[i].explained.score;
        const scalar lead = free.explained.score - score;
        addLaw(laws[i], fits[i], lead);

        // One that has the best in it, or is a part of it, is no rival, unless
        // it is better and the solver fails with it
        const bool fails = fits[i].failure.size();
        const bool nested =
            best.contains(laws[i]) || laws[i].contains(best);
        const scalar limit = nested ? (fails ? 0 : -GREAT) : set.gap;
        if (score < first.explained.score + limit)
        {
            found_.explained = false;
            if
            (
                fails && found_.lawThatFails < 0
             && (enough || lead >= needed)
            )
            {
                found_.lawThatFails = found_.laws.size() - 1;
            }
        }
    }
}


Foam::List<Foam::misfit::dimensionlessLaw> Foam::misfit::correctionFitter::laws()
{
    HashTable<conditions> met;
    for (const correctionElement& e : elements())
    {
        if (e.family == "push")
        {
            runState state(s_.state(atBase_));
            state.noting = true;
            met = s_.run(List<runState>(1, state)).first().met;
            break;
        }
    }
    List<dimensionlessLaw> all;
    for (const word family : {"drag", "push"})
    {
        all.append(lawsOf(family, elements(), met));
    }
    return all;
}


Foam::misfit::correctionFit Foam::misfit::correctionFitter::follow
(
    const correctionFit& free,
    const List<dimensionlessLaw>& laws
)
{
    const scalar number = 2*std::log(scalar(laws.size()));
    List<correctionFit> fits;
    labelList order(identity(laws.size()));
    for (const dimensionlessLaw& l : laws)
    {
        fits.append(score(l.combination, number));
    }
    const auto sort = [&]()
    {
        std::stable_sort
        (
            order.begin(),
            order.end(),
            [&](const label a, const label b)
            {
                const bool ran = fits[a].failure.empty();
                return
                    ran == fits[b].failure.empty()
                  ? fits[a].explained.score < fits[b].explained.score : ran;
            }
        );
    };
    sort();

    // In the solver, too, until the best of those that run was computed
    for (label n = 0; n < s_.set().refit; ++n)
    {
        correctionFit& first = fits[order[0]];
        const scalar limit = free.explained.score + s_.set().gap;
        if (first.variables.size() || first.explained.score > limit)
        {
            break;
        }
        compute(first);
        sort();
    }
    judge(free, laws, fits, order);
    return fits[order[0]];
}
