// SPDX-License-Identifier: GPL-3.0-or-later
// All elements of a free correction following dimensionless numbers.

#include "correctionStudy.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- All laws that there may be, for the water that the pushes meet
List<dimensionlessLaw> possibleLaws(correctionStudy& c)
{
    HashTable<conditions> water;
    for (const correctionElement& e : c.elements())
    {
        if (e.family == elementFamily::push)
        {
            runState state(c.s.state(c.atBase));
            state.noting = true;
            water = c.s.run(List<runState>(1, state)).first().water;
            break;
        }
    }
    List<dimensionlessLaw> all(lawsOf(elementFamily::drag, c.elements(), water));
    all.append(lawsOf(elementFamily::push, c.elements(), water));
    return all;
}


//- Notes the laws in that order, and whether the first explains it: it leads, and no
//  rival is as good
void judge
(
    correctionStudy& c,
    const hypothesisFit& free,
    const List<dimensionlessLaw>& laws,
    const List<evaluation>& fits,
    const labelList& order
)
{
    const settings& set = c.s.set;
    correctionFit& result = c.result;
    const dimensionlessLaw& best = laws[order[0]];
    const evaluation& first = fits[order[0]];
    const scalar needed = result.elements.size() ? set.gap : set.evidence;
    const bool enough =
        first.variables.size() && first.failure.empty()
     && free.score - first.best.score >= needed;
    result.explained = enough;
    for (const label i : order)
    {
        const fitResult& f = fits[i].best.fit;
        const scalar score = fits[i].best.score;
        const scalar lead = free.score - score;
        const label k = laws[i].functions.size();
        vec deviations(k);
        for (label j = 0; j < k; ++j)
        {
            deviations[j] = f.deviation(c.s.bounds.nParameters + j);
        }
        result.laws.append({laws[i], f.x.tail(k), deviations, lead});

        // One that has the best in it, or is a part of it, is no rival, unless
        // it is better and the solver fails with it
        const bool fails = fits[i].failure.size();
        const bool nested = best.contains(laws[i]) || laws[i].contains(best);
        const scalar limit = nested ? (fails ? 0 : -GREAT) : set.gap;
        if (score < first.best.score + limit)
        {
            result.explained = false;
            if (fails && result.lawThatFails < 0 && (enough || lead >= needed))
            {
                result.lawThatFails = result.laws.size() - 1;
            }
        }
    }
}

} // End anonymous namespace


Foam::misfit::evaluation
Foam::misfit::followLaws(correctionStudy& c, const evaluation& free)
{
    const List<dimensionlessLaw> laws(possibleLaws(c));
    if (laws.empty())
    {
        return free;
    }
    List<evaluation> fits(laws.size());
    labelList order(identity(laws.size()));
    forAll(laws, i)
    {
        fits[i].best =
            c.fit(laws[i].combination, 2*std::log(scalar(laws.size())));
    }
    const auto rank = [&](const label i)
    {
        return std::make_pair(!fits[i].failure.empty(), fits[i].best.score);
    };
    const auto sort = [&]()
    {
        std::stable_sort
        (
            order.begin(),
            order.end(),
            [&](const label a, const label b) { return rank(a) < rank(b); }
        );
    };
    sort();

    // In the solver, too, until the best of those that run was computed
    for (label n = 0; n < c.s.set.refit; ++n)
    {
        evaluation& first = fits[order[0]];
        const scalar limit = free.best.score + c.s.set.gap;
        if (first.variables.size() || first.best.score > limit)
        {
            break;
        }
        first = c.compute(first.best);
        sort();
    }
    judge(c, free.best, laws, fits, order);
    return c.result.explained ? fits[order[0]] : free;
}
