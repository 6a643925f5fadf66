// SPDX-License-Identifier: GPL-3.0-or-later
// What no candidate explains is fitted by a free correction, and that correction by
// dimensionless numbers.

#include "stages.H"
#include "correctionStudy.H"
#include "designs.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Runs the base, each element, and the parameters again, which are there. False if the
//  base fails
bool computeSensitivities(correctionStudy& c)
{
    std::vector<vec> design(1, c.atBase);
    for (const auto& more : {elementDesign(c.s, c.atBase), parameterDesign(c.s.bounds)})
    {
        design.insert(design.end(), more.begin(), more.end());
    }
    const List<samples> results(c.s.addRuns(design));
    forAll(c.elements(), i)
    {
        if (!results[i + 1].ok())
        {
            c.result.failed.append(c.elements()[i].name);
        }
    }
    c.computed = results.first();
    c.result.failure = c.computed.failure;
    c.s.build();
    return c.computed.ok();
}


//- Some elements are free
hypothesisFit fitFree(const correctionStudy& c, const labelList& some)
{
    const label n = c.elements().size();
    const label k = some.size();
    mat combination = mat::Zero(n, k);
    forAll(some, i)
    {
        combination(some[i], i) = 1;
    }

    // Twice the logarithm of the number of ways to choose these
    const scalar number =
        2*(std::lgamma(n + 1.) - std::lgamma(k + 1.) - std::lgamma(n - k + 1.));
    return c.fit(combination, number);
}


//- The best with one more element that is free, which is appended to them
hypothesisFit withOneMore(const correctionStudy& c, labelList& free)
{
    hypothesisFit best;
    labelList chosen(free);
    forAll(c.elements(), i)
    {
        if (free.found(i) || c.result.failed.found(c.elements()[i].name))
        {
            continue;
        }
        labelList more(free);
        more.append(i);
        const hypothesisFit one(fitFree(c, more));
        if (one.score < best.score)
        {
            best = one;
            chosen = more;
        }
    }
    free = chosen;
    return best;
}


//- Elements taken up one after the other
evaluation fitFreely(correctionStudy& c)
{
    const settings& set = c.s.set;
    labelList free;
    evaluation r;
    r.best = fitFree(c, free);
    const scalar none = r.best.score;

    // The first one must be evidence, the others more than luck
    while (free.size() < set.correctionMost)
    {
        const scalar bound =
            free.empty() ? none - set.evidence : r.best.score - set.gap;
        labelList more(free);
        const hypothesisFit next(withOneMore(c, more));
        if (next.score > bound)
        {
            break;
        }
        r.best = next;
        free = more;
    }
    c.result.gain = none - r.best.score;
    if (free.size())
    {
        r = c.compute(r.best);
    }
    forAll(free, i)
    {
        const label k = c.s.bounds.nParameters + i;
        c.result.elements.append
        ({
            c.elements()[free[i]], r.best.fit.x[k], r.best.fit.deviation(k)
        });
    }
    return r;
}


//- Another experiment, before and after; true if the solver runs and matches it with the
//  correction
bool holdsIn
(
    correctionStudy& c,
    const observation& other,
    const evaluation& r,
    const covariance& known
)
{
    // A push that follows the flow is another one where the flow is another
    const dimensionlessLaw* law =
        c.result.explained ? &c.result.laws.first().law : nullptr;
    runState state(c.s.state(other.experiment, c.atBase));
    state.noting = law && law->family == elementFamily::push;
    const samples before(c.s.means(List<runState>(1, state)).first());
    if (!before.ok())
    {
        return false;
    }
    vec x = r.variables;
    if (state.noting)
    {
        const mat there(combinationOf(*law, c.elements(), before.water));
        x.tail(c.elements().size()) = there*r.best.fit.x.tail(there.cols());
    }
    state = c.s.state(other.experiment, x);
    const samples after(c.s.means(List<runState>(1, state)).first());
    const settings& set = c.s.set;
    if (!after.ok())
    {
        return false;
    }
    const auto held
    (
        compare(heldOut::part::experiment, other, before, after, known, set)
    );
    if (!held)
    {
        return false;
    }
    c.result.held.append(*held);
    return
        held->squareAfter
     <= max(confirmingSquare(*held, set), held->limitOfMatch);
}


//- What it leaves, and held-out channels and experiments
void test
(
    correctionStudy& c,
    const evaluation& r,
    const std::map<word, covariance>& known
)
{
    correctionFit& result = c.result;
    result.after = r.best.fit.f;
    result.left = scanResidual(c.s, r.best).p;
    result.isEnough = result.left >= c.s.set.adequacy;
    result.held =
        compareHere(c.s, c.computed, r.computed, c.s.validation.uncertainty());
    label nAttempts = 0;
    label held = 0;
    for (label i = 1; i < c.s.experiments.size(); ++i)
    {
        const observation& other = c.s.experiments[i];
        const bool holds = holdsIn(c, other, r, known.at(other.experiment));
        if (other.use == purpose::validation && other.validation.size())
        {
            ++nAttempts;
            held += holds;
        }
    }
    result.transfers = nAttempts && held == nAttempts;
    for (const heldOut& h : result.held)
    {
        const bool worse = h.squareAfter > h.squareBefore;
        result.holds = result.holds && !(worse && h.use == purpose::validation);
    }
}


word nameOf(const dimensionlessLaw& law)
{
    word name(familyNames[law.family]);
    for (const word& group : law.groups)
    {
        name += ':' + group;
    }
    return name;
}

} // End anonymous namespace


Foam::misfit::correctionStudy::correctionStudy
(
    const study& whole,
    const hypothesisFit& calibrated
)
:
    s(whole.ofCorrection()),
    base(calibrated),
    white(base.covariance),
    atBase(vec::Zero(s.bounds.mean.size()))
{
    const label nP = s.bounds.nParameters;
    atBase.head(nP) = base.fit.x.head(nP);
    result.isRequested = true;
}


Foam::misfit::hypothesisFit Foam::misfit::correctionStudy::fit
(
    const mat& combination,
    const scalar number
) const
{
    hypothesisFit w;
    w.what.combination = combination;
    w.number = number;
    w.covariance = base.covariance;
    return s.calibration.score().again(w, white);
}


Foam::misfit::evaluation
Foam::misfit::correctionStudy::compute(const hypothesisFit& start)
{
    evaluation r(refit(s, start, &white));
    if (r.failure.size())
    {
        const evaluation atBest(onSurface(s, r.best));
        r.variables = atBest.variables;
        r.computed = atBest.computed;
    }
    return r;
}


Foam::misfit::correctionFit Foam::misfit::fitCorrection
(
    const study& s,
    const hypothesisFit& base,
    const std::map<word, covariance>& known
)
{
    Info<< "Free correction" << endl;
    correctionStudy c(s, base);
    correctionFit& result = c.result;
    if (computeSensitivities(c))
    {
        const evaluation best(followLaws(c, fitFreely(c)));
        if (result.elements.size() || result.explained)
        {
            test(c, best, known);
        }
        result.ofSurface = best.failure.size();
        result.named =
            result.explained && result.transfers && result.holds && result.isEnough;
    }
    result.nRuns = c.s.nRuns;
    return result;
}


Foam::misfit::correctionFit Foam::misfit::correct
(
    const study& s,
    const stageResults& e,
    const decision& d
)
{
    // Where the fitted channels agree there is nothing to fit it to
    const bool tries =
        d.kind == verdictKind::unknown && s.set.correction.size()
     && e.tests.gates.passed(gateKind::detection);
    return
        tries
      ? fitCorrection(s, e.explained.baseline(), e.tests.uncertainty)
      : correctionFit();
}


Foam::misfit::decision Foam::misfit::withCorrection
(
    const rules& limits,
    const decision& before,
    const correctionFit& correction
)
{
    decision d(before);
    if (correction.after.size())
    {
        d.after = correction.after;
    }
    if (correction.named)
    {
        // A law of dimensionless numbers is a name, as sure as its lead up to a limit:
        // no case of the table of confidences has one
        const fittedLaw& l = correction.laws.first();
        d.kind = verdictKind::named;
        d.names = wordList(1, nameOf(l.law));
        d.grounds.resize(0);
        d.confidence = min
        (
            1/(1 + std::exp(-0.5*l.lead/limits.temperature)), limits.largestUncalibrated
        );
    }
    return d;
}


std::vector<Foam::misfit::vec>
Foam::misfit::elementDesign(const study& s, const vec& around)
{
    const List<correctionElement>& elements = s.set.correction;
    std::vector<vec> design(elements.size(), around);
    forAll(elements, i)
    {
        design[i][s.bounds.nParameters + i] = elements[i].size;
    }
    return design;
}
