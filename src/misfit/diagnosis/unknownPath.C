// SPDX-License-Identifier: GPL-3.0-or-later
// S8: what no candidate explains is fitted by a free correction, and that
// correction by dimensionless numbers.

#include "unknownPath.H"
#include "settle.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Twice the logarithm of the number of ways to choose some of all
scalar choices(const label all, const label some)
{
    return
        2*(std::lgamma(all + 1.) - std::lgamma(some + 1.)
      - std::lgamma(all - some + 1.));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::unknownPath::setBounds
(
    const variableBounds& old,
    const vec& width
)
{
    const label nP = old.nParameters;
    const label n = nP + nElements();
    bounds_.nParameters = nP;
    for (vec* v :
        {
            &bounds_.mean, &bounds_.deviation, &bounds_.lower, &bounds_.upper,
            &width_
        })
    {
        *v = vec::Zero(n);
    }
    bounds_.mean.head(nP) = old.mean.head(nP);
    bounds_.deviation.head(nP) = old.deviation.head(nP);
    bounds_.lower.head(nP) = old.lower.head(nP);
    bounds_.upper.head(nP) = old.upper.head(nP);
    width_.head(nP) = width.head(nP);
    forAll(settings_.correction, i)
    {
        const scalar size = settings_.correction[i].size;
        width_[nP + i] = bounds_.deviation[nP + i] = size;
        bounds_.lower[nP + i] = -4*size;
        bounds_.upper[nP + i] = 4*size;
    }
}


Foam::misfit::runState Foam::misfit::unknownPath::state
(
    const vec& variables
) const
{
    wordList names;
    for (const correctionElement& e : settings_.correction)
    {
        names.append(e.name);
    }
    return stateOf(settings_, data().experiment, names, variables);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::unknownPath::means(const List<vec>& variables)
{
    List<runState> states;
    for (const vec& x : variables)
    {
        states.append(state(x));
    }
    found_.nRuns += states.size()*settings_.common;

    return sampler_.means(states, settings_.common);
}


void Foam::misfit::unknownPath::signatures(const List<vec>& parameterDesign)
{
    List<vec> design(1, base_);
    for (label i = 0; i < nElements(); ++i)
    {
        design.append(base_);
        design.last()[bounds_.nParameters + i] = settings_.correction[i].size;
    }
    for (const vec& x : parameterDesign)
    {
        design.append(vec::Zero(base_.size()));
        design.last().head(bounds_.nParameters) =
            x.head(bounds_.nParameters);
    }

    const List<samples> given(means(design));
    forAll(given, i)
    {
        if (given[i].ok())
        {
            fit_->addRun(design[i], given[i].fit);
            gate_->addRun(design[i], given[i].gate);
        }
        else if (i > 0 && i <= nElements())
        {
            found_.failed.append(settings_.correction[i - 1].name);
        }
    }
    atBase_ = given.first();
    fit_->build(width_);
    gate_->build(width_);
}


Foam::misfit::unknownPath::fit Foam::misfit::unknownPath::weigh
(
    const sampledModel& m,
    const mat& combination,
    const scalar number
) const
{
    fit f;
    f.combination = combination;
    f.number = number;
    f.best =
        misfit::fit
        (
            combinedModel(m.surface(), bounds_, combination), m.data().y, white_
        );
    setScore(f);
    return f;
}


void Foam::misfit::unknownPath::setScore(fit& f) const
{
    f.score =
        f.best.objective + f.number
      + f.combination.cols()*std::log(max(white_.effectiveSize(), 8.0));
}


Foam::misfit::mat
Foam::misfit::unknownPath::freeing(const labelList& elements) const
{
    mat m = mat::Zero(nElements(), elements.size());
    forAll(elements, i)
    {
        m(elements[i], i) = 1;
    }
    return m;
}


Foam::misfit::unknownPath::fit Foam::misfit::unknownPath::freely() const
{
    fit best(weigh(*fit_, freeing(labelList()), 0));
    const scalar none = best.score;

    // The first one must be evidence, the others more than luck
    while (best.free.size() < settings_.correctionMost)
    {
        const scalar wanted =
            best.free.empty()
          ? none - settings_.evidence : best.score - settings_.gap;
        fit next;
        for (label i = 0; i < nElements(); ++i)
        {
            const bool may =
                !best.free.found(i)
             && !found_.failed.found(settings_.correction[i].name);
            if (may)
            {
                labelList free(best.free);
                free.append(i);
                fit one
                (
                    weigh
                    (
                        *fit_, freeing(free), choices(nElements(), free.size())
                    )
                );
                one.free = free;
                if (one.score < next.score)
                {
                    next = one;
                }
            }
        }
        if (next.score > wanted)
        {
            break;
        }
        best = next;
    }
    return best;
}


Foam::misfit::unknownPath::fit
Foam::misfit::unknownPath::refitted(const fit& f)
{
    const auto local(fit_->copy());
    const auto model = [&](const fit& now)
    {
        return combinedModel(local->surface(), bounds_, now.combination);
    };
    refitting<fit> with;
    with.expand = [&](const fit& now)
    {
        return model(now).expand(now.best.x);
    };
    with.compute = [&](const vec& x)
    {
        return means(List<vec>(1, x)).first();
    };
    with.passThrough = [&](const vec& x, const samples& given)
    {
        local->passThrough(x, given.fit);
    };
    with.stay = [&](fit now)
    {
        now.best = unfitted(model(now), local->data().y, white_, now.best.x);
        setScore(now);
        return now;
    };
    with.fit = [&](const fit& now)
    {
        fit next(weigh(*local, now.combination, now.number));
        next.free = now.free;
        return next;
    };

    const settled<fit> s(settle(f, settings_.passes, width_, with));
    fit now(s.best);
    now.given = s.given;
    now.variables = s.variables;
    now.failure = s.failure;
    if (s.failure.size())
    {
        now.variables = with.expand(now);
        now.given.fit = now.best.f;
        now.given.gate =
            gate_->size() ? gate_->surface()(now.variables) : vec();
    }
    return now;
}


void Foam::misfit::unknownPath::addLaw
(
    const dimensionlessLaw& law,
    const fit& fitted,
    const scalar lead
)
{
    const label k = law.functions.size();
    vec deviations(k);
    for (label j = 0; j < k; ++j)
    {
        deviations[j] = fitted.best.deviation(bounds_.nParameters + j);
    }
    found_.laws.append
    ({
        law.family, law.groups, law.told(fitted.best.x.tail(k), deviations), lead
    });
}


Foam::misfit::unknownPath::fit Foam::misfit::unknownPath::explain
(
    const fit& free,
    const List<dimensionlessLaw>& laws
)
{
    const scalar number = 2*std::log(scalar(laws.size()));
    List<fit> fits;
    labelList order(identity(laws.size()));
    for (const dimensionlessLaw& l : laws)
    {
        fits.append(weigh(*fit_, l.combination, number));
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
                  ? fits[a].score < fits[b].score : ran;
            }
        );
    };
    sort();

    // In the solver, too, until the best of those that run was computed
    for (label n = 0; n < 3; ++n)
    {
        fit& first = fits[order[0]];
        if (first.variables.size() || first.score > free.score + settings_.gap)
        {
            break;
        }
        first = refitted(first);
        sort();
    }

    best_ = order[0];
    judgeLaws(free, laws, fits, order);
    return fits[best_];
}


void Foam::misfit::unknownPath::judgeLaws
(
    const fit& free,
    const List<dimensionlessLaw>& laws,
    const List<fit>& fits,
    const labelList& order
)
{
    const dimensionlessLaw& best = laws[best_];
    const fit& first = fits[best_];
    const scalar needed = free.free.size() ? settings_.gap : settings_.evidence;
    const bool enough =
        first.variables.size() && first.failure.empty()
     && free.score - first.score >= needed;
    found_.explained = enough;
    for (const label i : order)
    {
        const scalar lead = free.score - fits[i].score;
        addLaw(laws[i], fits[i], lead);

        // One that has the best in it, or is a part of it, is no rival, unless it is
        // better and the solver fails with it
        const bool fails = fits[i].failure.size();
        const bool nested = best.contains(laws[i]) || laws[i].contains(best);
        const scalar limit = nested ? (fails ? 0 : -GREAT) : settings_.gap;
        if (fits[i].score < first.score + limit)
        {
            found_.explained = false;
            if (fails && lawThatFails_.empty() && (enough || lead >= needed))
            {
                lawThatFails_ = found_.laws.last().words;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::unknownPath::unknownPath
(
    sampler& s,
    const settings& set,
    const variableBounds& old,
    const vec& width,
    const sampledModel& fit,
    const sampledModel& gate,
    const weighed& base,
    const std::map<word, covariance>& elsewhere
)
:
    sampler_(s),
    settings_(set),
    elsewhere_(elsewhere),
    covariance_(base.covariance),
    white_(covariance_)
{
    setBounds(old, width);
    base_ = vec::Zero(bounds_.mean.size());
    base_.head(old.nParameters) = base.best.x.head(old.nParameters);
    fit_ = fit.withVariables(bounds_);
    gate_ = gate.withVariables(bounds_);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

const Foam::misfit::correctionFound&
Foam::misfit::unknownPath::operator()(const List<vec>& parameterDesign)
{
    Info<< "S8 free correction" << endl;
    found_.asked = true;
    signatures(parameterDesign);
    if (!atBase_.ok())
    {
        found_.told = "The free correction could not be fitted: "
          + atBase_.failure + '.';
        return found_;
    }

    fit free(freely());
    found_.gain =
        weigh(*fit_, freeing(labelList()), 0).score - free.score;
    if (free.free.size())
    {
        free = refitted(free);
    }
    tellParts(free);

    bool pushes = false;
    for (const correctionElement& e : settings_.correction)
    {
        pushes = pushes || e.family == "push";
    }
    if (pushes)
    {
        runState s(state(base_));
        s.noting = true;
        met_ = sampler_(List<runState>(1, s)).first().met;
        ++found_.nRuns;
    }

    List<dimensionlessLaw> laws;
    for (const word family : {"drag", "push"})
    {
        laws.append
        (
            groupFunctions(family, settings_.correction, met_).laws()
        );
    }

    fit best(free);
    if (laws.size())
    {
        const fit law(explain(free, laws));
        best = found_.explained ? law : free;
    }
    if (free.free.size() || found_.explained)
    {
        found_.after = best.best.f;
        found_.left = left(best);
        holdOut(best, found_.explained ? &laws[best_] : nullptr);
    }
    describe(best);
    return found_;
}
