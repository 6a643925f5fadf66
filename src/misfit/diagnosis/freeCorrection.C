// SPDX-License-Identifier: GPL-3.0-or-later
// What no candidate explains is fitted by a free correction, and that correction by
// dimensionless numbers.

#include "freeCorrection.H"
#include "designs.H"
#include "detect.H"
#include "refit.H"

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


//- A combination of elements, fitted, and what the solver gave for it
struct correctionFit
{
    scored explained;

    //- Elements that are free; those of a law are not
    labelList free;

    //- What the solver gave, or the surface says
    samples given;

    //- Empty if it was not computed
    vec variables;

    //- Why the solver failed as it was fitted, or empty
    string failure;
};


class correctionFitter
{
    //- Whose strengths are the elements
    study s_;

    models m_;

    const scored base_;

    //- The covariance of the base is that of all
    const whitener white_;

    //- The calibrated base
    vec atBase_;

    samples given_;

    correctionFound found_;


    const List<correctionElement>& elements() const
    {
        return s_.set().correction;
    }


    //- number: the part of the score that counts the choices
    correctionFit score(const mat& combination, const scalar number) const
    {
        correctionFit f;
        f.explained.what.combination = combination;
        f.explained.number = number;
        f.explained.covariance = base_.covariance;
        f.explained =
            m_.calibration->score(s_.set().modelDiscrepancy).again
            (
                f.explained, white_
            );
        return f;
    }


    //- Frees some elements
    mat freeing(const labelList& some) const
    {
        mat m = mat::Zero(elements().size(), some.size());
        forAll(some, i)
        {
            m(some[i], i) = 1;
        }
        return m;
    }


    //- The best with one more element that is free
    correctionFit withOneMore(const correctionFit& f) const
    {
        correctionFit best;
        forAll(elements(), i)
        {
            if (f.free.found(i) || found_.failed.found(elements()[i].name))
            {
                continue;
            }
            labelList free(f.free);
            free.append(i);
            correctionFit one
            (
                score(freeing(free), choices(elements().size(), free.size()))
            );
            one.free = free;
            if (one.explained.score < best.explained.score)
            {
                best = one;
            }
        }
        return best;
    }


    //- Computed in the solver and fitted again, until it stays
    void compute(correctionFit& f)
    {
        const refitted r(refit(s_, *m_.calibration, f.explained, &white_));
        f.explained = r.best;
        f.given = r.given;
        f.variables = r.variables;
        f.failure = r.failure;
        if (r.failure.size())
        {
            f.variables =
                m_.calibration->model(f.explained.what).expand(f.explained.best.x);
            f.given.calibration = f.explained.best.f;
            f.given.validation =
                m_.validation->size() ? m_.validation->surface()(f.variables) : vec();
        }
    }


    void addLaw
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


    //- Notes the laws in that order, and whether the first explains it: it leads, and no
    //  rival is as good
    void judge
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


    //- What was fitted, in an experiment where the law met that water
    runState inExperiment
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


    //- Another experiment, before and after; true if the solver runs and matches it
    //  with the correction
    bool holdsIn
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
        const samples after
        (
            s_.means
            (
                List<runState>
                (
                    1,
                    inExperiment
                    (
                        other.experiment, f, follows ? law : nullptr, before
                    )
                )
            ).first()
        );
        const bool validates = other.use == purpose::validation;
        const stacked& recorded = validates ? other.validation : other.test;
        if (!after.ok() || !recorded.size())
        {
            return false;
        }
        found_.held.append
        (
            compared
            (
                heldOut::part::experiment, other.experiment, other.use, recorded,
                validates ? before.validation : before.test,
                validates ? after.validation : after.test, known, s_.set().adequacy
            )
        );
        const heldOut& h = found_.held.last();
        return h.squareAfter < max(0.5*(h.squareBefore + 1), matchLimit(h));
    }


public:

    correctionFitter(const study& s, const models& m, const scored& base)
    :
        s_(s.ofCorrection()),
        m_(s_),
        base_(base),
        white_(base.covariance),
        atBase_(vec::Zero(s_.bounds().mean.size()))
    {
        const label nP = s_.bounds().nParameters;
        atBase_.head(nP) = base.best.x.head(nP);
        m_.calibration = m.calibration->withVariables(s_.bounds());
        m_.validation = m.validation->withVariables(s_.bounds());
        found_.asked = true;
    }


    const correctionFound& found() const
    {
        return found_;
    }


    label nRuns() const
    {
        return s_.nRuns();
    }


    //- Runs the base, each element, and the parameters again, which are there. False
    //  if the base fails
    bool computeSensitivities()
    {
        std::vector<vec> design(1, atBase_);
        forAll(elements(), i)
        {
            design.push_back(atBase_);
            design.back()[s_.bounds().nParameters + i] = elements()[i].size;
        }
        for (const vec& x : parameterDesign(s_))
        {
            design.push_back(x);
        }
        const List<samples> given(s_.means(design));
        forAll(given, i)
        {
            if (given[i].ok())
            {
                m_.addRun(design[i], given[i]);
            }
            else if (i > 0 && i <= elements().size())
            {
                found_.failed.append(elements()[i - 1].name);
            }
        }
        given_ = given.first();
        found_.failure = given_.failure;
        m_.build(s_);
        return given_.ok();
    }


    //- Elements taken up one after the other
    correctionFit freely()
    {
        correctionFit best(score(freeing(labelList()), 0));
        const scalar none = best.explained.score;

        // The first one must be evidence, the others more than luck
        while (best.free.size() < s_.set().correctionMost)
        {
            const scalar wanted =
                best.free.empty()
              ? none - s_.set().evidence
              : best.explained.score - s_.set().gap;
            const correctionFit next(withOneMore(best));
            if (next.explained.score > wanted)
            {
                break;
            }
            best = next;
        }
        found_.gain = none - best.explained.score;
        if (best.free.size())
        {
            compute(best);
        }
        forAll(best.free, i)
        {
            const label k = s_.bounds().nParameters + i;
            found_.elements.append
            ({
                elements()[best.free[i]], best.explained.best.x[k],
                best.explained.best.deviation(k)
            });
        }
        return best;
    }


    //- All laws that there may be, for the water that the pushes meet
    List<dimensionlessLaw> laws()
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


    //- Fits the laws; the best of those that say something by themselves
    correctionFit follow
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
        for (label n = 0; n < 3; ++n)
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


    //- What it leaves, and held-out channels and experiments; the law, where one
    //  explains it
    void test
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
        const word& here = s_.data().experiment;
        if (m_.validation->size())
        {
            found_.held.append
            (
                compared
                (
                    heldOut::part::validation, here, purpose::validation,
                    m_.validation->data(), given_.validation, f.given.validation,
                    m_.validation->uncertainty(),
                    set.adequacy
                )
            );
        }
        const stacked& testData = s_.data().test;
        found_.held.append
        (
            compared
            (
                heldOut::part::test, here, purpose::test, testData,
                given_.test, f.given.test, covariance(testData, set.clockUncertainty),
                set.adequacy
            )
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


    void finish(const correctionFit& best)
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
};


//- A law of dimensionless numbers is a name, as sure as its lead
void nameLaw(const settings& set, finding& f)
{
    const fittedLaw& l = f.correction.laws.first();
    word name(l.law.family);
    for (const word& group : l.law.groups)
    {
        name += ':' + group;
    }
    f.verdict = verdictKind::named;
    f.names = wordList(1, name);
    f.confidence =
        min(1/(1 + std::exp(-0.5*l.lead/set.temperature)), set.ceiling);
}

} // End anonymous namespace


Foam::misfit::correctionFound Foam::misfit::fitCorrection
(
    const study& s,
    const models& m,
    const scored& base,
    const std::map<word, covariance>& known,
    label& runs
)
{
    Info<< "Free correction" << endl;
    correctionFitter fitter(s, m, base);
    const correctionFound& found = fitter.found();
    if (fitter.computeSensitivities())
    {
        const correctionFit free(fitter.freely());
        const List<dimensionlessLaw> laws(fitter.laws());
        correctionFit best(free);
        if (laws.size())
        {
            const correctionFit law(fitter.follow(free, laws));
            best = found.explained ? law : free;
        }
        if (free.free.size() || found.explained)
        {
            fitter.test(best, known);
        }
        fitter.finish(best);
    }
    runs += fitter.nRuns();
    return found;
}


void Foam::misfit::correct
(
    const study& s,
    const models& m,
    const std::map<word, covariance>& known,
    finding& f
)
{
    // Where the fitted channels agree there is nothing to fit it to
    const bool asked =
        f.verdict == verdictKind::unknown && s.set().correction.size()
     && f.gates.passed(gateKind::detection);
    if (!asked)
    {
        return;
    }
    f.correction =
        fitCorrection(s, m, f.explained.baseline(), known, f.nRuns);
    const correctionFound& found = f.correction;
    if (found.after.size())
    {
        f.after = found.after;
        f.held = found.held;
    }
    if (found.named)
    {
        nameLaw(s.set(), f);
    }
}


Foam::List<Foam::misfit::runState>
Foam::misfit::correctionRuns(const study& s)
{
    List<runState> states;
    for (const correctionElement& e : s.set().correction)
    {
        for (label i = 0; i < s.set().commonRandomNumbers; ++i)
        {
            states.append(s.state(s.bounds().mean));
            states.last().replicate = i;
            states.last().strengths.insert(e.name, e.size);
        }
    }
    states.append(s.state(s.bounds().mean));
    states.last().noting = true;
    return states;
}
