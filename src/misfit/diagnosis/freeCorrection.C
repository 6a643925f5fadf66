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
    const List<samples> given(c.s.addRuns(design));
    forAll(c.elements(), i)
    {
        if (!given[i + 1].ok())
        {
            c.found.failed.append(c.elements()[i].name);
        }
    }
    c.given = given.first();
    c.found.failure = c.given.failure;
    c.s.build();
    return c.given.ok();
}


//- Some elements are free
scored fitFree(const correctionStudy& c, const labelList& some)
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
scored withOneMore(const correctionStudy& c, labelList& free)
{
    scored best;
    labelList chosen(free);
    forAll(c.elements(), i)
    {
        if (free.found(i) || c.found.failed.found(c.elements()[i].name))
        {
            continue;
        }
        labelList more(free);
        more.append(i);
        const scored one(fitFree(c, more));
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
        const scored next(withOneMore(c, more));
        if (next.score > bound)
        {
            break;
        }
        r.best = next;
        free = more;
    }
    c.found.gain = none - r.best.score;
    if (free.size())
    {
        r = c.compute(r.best);
    }
    forAll(free, i)
    {
        const label k = c.s.bounds.nParameters + i;
        c.found.elements.append
        ({
            c.elements()[free[i]], r.best.best.x[k], r.best.best.deviation(k)
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
        c.found.explained ? &c.found.laws.first().law : nullptr;
    runState state(c.s.state(other.experiment, c.atBase));
    state.noting = law && law->family == "push";
    const samples before(c.s.means(List<runState>(1, state)).first());
    if (!before.ok())
    {
        return false;
    }
    vec x = r.variables;
    if (state.noting)
    {
        const mat there(combinationOf(*law, c.elements(), before.water));
        x.tail(c.elements().size()) = there*r.best.best.x.tail(there.cols());
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
    c.found.held.append(*held);
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
    correctionFit& found = c.found;
    found.after = r.best.best.f;
    found.left = scanResidual(c.s, r.best).p;
    found.isEnough = found.left >= c.s.set.adequacy;
    found.held =
        compareHere(c.s, c.given, r.given, c.s.validation.uncertainty());
    label nTried = 0;
    label held = 0;
    for (label i = 1; i < c.s.experiments.size(); ++i)
    {
        const observation& other = c.s.experiments[i];
        const bool holds = holdsIn(c, other, r, known.at(other.experiment));
        if (other.use == purpose::validation && other.validation.size())
        {
            ++nTried;
            held += holds;
        }
    }
    found.transfers = nTried && held == nTried;
    for (const heldOut& h : found.held)
    {
        const bool worse = h.squareAfter > h.squareBefore;
        found.holds = found.holds && !(worse && h.use == purpose::validation);
    }
}


word nameOf(const dimensionlessLaw& law)
{
    word name(law.family);
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
    const scored& calibrated
)
:
    s(whole.ofCorrection()),
    base(calibrated),
    white(base.covariance),
    atBase(vec::Zero(s.bounds.mean.size()))
{
    const label nP = s.bounds.nParameters;
    atBase.head(nP) = base.best.x.head(nP);
    found.isTried = true;
}


Foam::misfit::scored Foam::misfit::correctionStudy::fit
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


Foam::misfit::evaluation
Foam::misfit::correctionStudy::compute(const scored& start)
{
    evaluation r(refit(s, start, &white));
    if (r.failure.size())
    {
        const evaluation atBest(onSurface(s, r.best));
        r.variables = atBest.variables;
        r.given = atBest.given;
    }
    return r;
}


Foam::misfit::correctionFit Foam::misfit::fitCorrection
(
    const study& s,
    const scored& base,
    const std::map<word, covariance>& known
)
{
    Info<< "Free correction" << endl;
    correctionStudy c(s, base);
    correctionFit& found = c.found;
    if (computeSensitivities(c))
    {
        const evaluation best(followLaws(c, fitFreely(c)));
        if (found.elements.size() || found.explained)
        {
            test(c, best, known);
        }
        found.ofSurface = best.failure.size();
        found.named =
            found.explained && found.transfers && found.holds && found.isEnough;
    }
    found.nRuns = c.s.nRuns;
    return found;
}


Foam::misfit::correctionFit Foam::misfit::correct
(
    const study& s,
    const evidence& e,
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
