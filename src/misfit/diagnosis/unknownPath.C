// SPDX-License-Identifier: GPL-3.0-or-later
// S8: what no candidate explains is fitted by a free correction, and that
// correction by dimensionless numbers.

#include "unknownPath.H"

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
    const vec& variables,
    const label packing
) const
{
    runState s;
    s.experiment = data().experiment;
    s.packing = packing;
    forAll(settings_.parameters, i)
    {
        s.parameters.insert(settings_.parameters[i].name, variables[i]);
    }
    forAll(settings_.correction, i)
    {
        const scalar value = variables[bounds_.nParameters + i];
        if (value != 0)
        {
            s.strengths.insert(settings_.correction[i].name, value);
        }
    }
    return s;
}


Foam::List<Foam::misfit::samples>
Foam::misfit::unknownPath::means(const List<vec>& variables)
{
    List<runState> states;
    for (const vec& x : variables)
    {
        for (label packing = 0; packing < settings_.common; ++packing)
        {
            states.append(state(x, packing));
        }
    }
    found_.nRuns += states.size();
    const List<samples> all(sampler_(states));

    List<samples> mean(variables.size());
    forAll(mean, i)
    {
        for (label packing = 0; packing < settings_.common; ++packing)
        {
            mean[i].add(all[i*settings_.common + packing]);
        }
        mean[i].divide(settings_.common);
    }
    return mean;
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
    f.score =
        f.best.objective + number
      + combination.cols()*std::log(max(white_.effectiveSize(), 8.0));
    return f;
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
    fit now(f);
    const auto local(fit_->copy());
    for (label pass = 0; pass < settings_.passes; ++pass)
    {
        const vec x =
            combinedModel(local->surface(), bounds_, now.combination).expand
            (
                now.best.x
            );
        const samples given(means(List<vec>(1, x)).first());
        if (!given.ok())
        {
            Info<< "    not refitted: " << given.failure.c_str() << endl;
            break;
        }
        local->passThrough(x, given.fit);
        const labelList free(now.free);
        now = weigh(*local, now.combination, now.number);
        now.free = free;
        now.given = given;
        now.variables = x;

        const vec moved =
            combinedModel(local->surface(), bounds_, now.combination).expand
            (
                now.best.x
            ) - x;
        if (moved.cwiseQuotient(width_).cwiseAbs().maxCoeff() < 0.05)
        {
            break;
        }
    }
    if (!now.variables.size())
    {
        now.variables =
            combinedModel(local->surface(), bounds_, now.combination).expand
            (
                now.best.x
            );
        now.given.fit = now.best.f;
        now.given.gate =
            gate_->size() ? gate_->surface()(now.variables) : vec();
    }
    return now;
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
        std::sort
        (
            order.begin(),
            order.end(),
            [&](const label a, const label b)
            {
                return fits[a].score < fits[b].score;
            }
        );
    };
    sort();

    // In the solver, too, until the best of all was computed
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

    const dimensionlessLaw& best = laws[order[0]];
    const fit& first = fits[order[0]];
    found_.explained =
        free.score - first.score
     >= (free.free.size() ? settings_.gap : settings_.evidence);
    for (const label i : order)
    {
        const label k = laws[i].functions.size();
        const label nP = bounds_.nParameters;
        vec deviations(k);
        for (label j = 0; j < k; ++j)
        {
            deviations[j] = fits[i].best.deviation(nP + j);
        }
        found_.laws.append
        ({
            laws[i].family,
            laws[i].groups,
            laws[i].told(fits[i].best.x.tail(k), deviations),
            free.score - fits[i].score
        });
        const bool rival =
            !best.contains(laws[i]) && !laws[i].contains(best);
        if (rival && fits[i].score < first.score + settings_.gap)
        {
            found_.explained = false;
        }
    }
    best_ = order[0];
    return first;
}


void Foam::misfit::unknownPath::tellParts(const fit& f)
{
    forAll(f.free, i)
    {
        const correctionElement& e = settings_.correction[f.free[i]];
        const label k = bounds_.nParameters + i;
        const scalar value = f.best.x[k];
        found_.parts.append
        ({
            e.name, misfit::told(e, value), value, f.best.deviation(k)
        });
    }
}


Foam::scalar Foam::misfit::unknownPath::left(const fit& f) const
{
    const combinedModel model(fit_->surface(), bounds_, f.combination);
    const mat slopes = model.slopes(f.best.x);
    const vec fromMean = f.best.x - model.mean();
    const whitener white
    (
        withFitted(covariance_, slopes, model.deviation())
    );
    const scan look(fit_->data(), white, settings_.draws, settings_.seed);
    return look
    (
        fit_->data().y - f.best.f + slopes*fromMean, settings_.significance
    ).p;
}


void Foam::misfit::unknownPath::holdOut
(
    const fit& f,
    const dimensionlessLaw* law
)
{
    const auto add = [&]
    (
        const string& what,
        const purpose use,
        const stacked& data,
        const vec& before,
        const vec& after,
        const covariance& known
    )
    {
        const label n = data.size();
        if (n && before.size() == n && after.size() == n)
        {
            found_.held.append
            (
                compared(what, use, data, before, after, known.at(after))
            );
        }
    };

    if (gate_->size())
    {
        add
        (
            "held-out channels", purpose::gate, gate_->data(), atBase_.gate,
            f.given.gate, gate_->uncertainty()
        );
    }
    add
    (
        "scored channels", purpose::score, data().score, atBase_.score,
        f.given.score, covariance(data().score, settings_.trigger)
    );

    // A push that follows the flow is another one where the flow is another
    const label nP = bounds_.nParameters;
    found_.transfers = false;
    for (label i = 1; i < sampler_.data().size(); ++i)
    {
        const observed& other = sampler_.data()[i];
        const bool gates = other.use == purpose::gate;
        const stacked& recorded = gates ? other.gate : other.score;
        runState s(state(base_));
        s.experiment = other.experiment;
        s.noting = law && law->family == "push";
        const samples before(sampler_(List<runState>(1, s)).first());

        vec x = f.variables;
        if (s.noting)
        {
            const groupFunctions there
            (
                law->family, settings_.correction, before.met
            );
            x.tail(nElements()) =
                there.combination(*law)*f.best.x.tail(f.combination.cols());
        }
        x.head(nP) = f.variables.head(nP);
        s = state(x);
        s.experiment = other.experiment;
        const samples after(sampler_(List<runState>(1, s)).first());
        found_.nRuns += 2;

        if (before.ok() && after.ok())
        {
            add
            (
                "experiment " + other.experiment, other.use, recorded,
                gates ? before.gate : before.score,
                gates ? after.gate : after.score,
                covariance(recorded, settings_.trigger)
            );
            if (gates)
            {
                const heldOut& h = found_.held.last();
                found_.transfers =
                    h.squareAfter < max(0.5*(h.squareBefore + 1), 1.5);
            }
        }
    }
}


void Foam::misfit::unknownPath::describe()
{
    string gone;
    string worse;
    bool holds = true;
    for (const heldOut& h : found_.held)
    {
        if (h.squareAfter > h.squareBefore)
        {
            worse += (worse.empty() ? "" : " and ") + h.what;
            holds = holds && h.use != purpose::gate;
        }
        else
        {
            gone +=
                (gone.empty() ? "" : ", ")
              + Foam::name(std::round(100*removed(h))) + " % at " + h.what;
        }
    }

    found_.named =
        found_.explained && found_.transfers && holds
     && found_.left >= settings_.adequacy;
    if (found_.parts.empty() && !found_.explained)
    {
        found_.told =
            "No push and no factor on the drag of the free correction explains"
            " it either.";
        return;
    }
    if (found_.explained)
    {
        found_.told = "It acts like " + found_.laws.first().words;
    }
    else
    {
        found_.told = "It acts like ";
        forAll(found_.parts, i)
        {
            found_.told += (i ? ", and " : "") + found_.parts[i].words;
        }
    }
    found_.told +=
        found_.held.empty()
      ? string(". There are no held-out data to try that on.")
      : gone.empty() ? string(".")
      : ". Of the misfit, this takes away " + gone + '.';
    if (!worse.empty())
    {
        found_.told += " It does not hold at " + worse + '.';
    }
    if (!found_.named)
    {
        found_.told +=
            !found_.explained
          ? " No law in one or two dimensionless numbers says as much."
          : !found_.transfers
          ? " This law is not named, since no other experiment confirms it."
          : !holds
          ? " This law is not named, since held-out channels are matched worse."
          : " This law is not named, since it leaves too much.";
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
    const weighed& base
)
:
    sampler_(s),
    settings_(set),
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
    describe();
    return found_;
}
