// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of a free correction are taken up and run in the solver.

#include "correctionFitter.H"
#include "designs.H"
#include "refit.H"

#include <cmath>

namespace
{

using namespace Foam;

//- Twice the logarithm of the number of ways to choose some of all
scalar choices(const label all, const label some)
{
    return
        2*(std::lgamma(all + 1.) - std::lgamma(some + 1.)
      - std::lgamma(all - some + 1.));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::misfit::correctionFit Foam::misfit::correctionFitter::score
(
    const mat& combination,
    const scalar number
) const
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


Foam::misfit::mat Foam::misfit::correctionFitter::freeing
(
    const labelList& some
) const
{
    mat m = mat::Zero(elements().size(), some.size());
    forAll(some, i)
    {
        m(some[i], i) = 1;
    }
    return m;
}


Foam::misfit::correctionFit Foam::misfit::correctionFitter::withOneMore
(
    const correctionFit& f
) const
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


void Foam::misfit::correctionFitter::compute(correctionFit& f)
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


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::correctionFitter::correctionFitter
(
    const study& s,
    const models& m,
    const scored& base
)
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


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool Foam::misfit::correctionFitter::computeSensitivities()
{
    std::vector<vec> design(1, atBase_);
    forAll(elements(), i)
    {
        design.push_back(atBase_);
        design.back()[s_.bounds().nParameters + i] = elements()[i].size;
    }
    for (const vec& x : parameterDesign(s_.bounds()))
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


Foam::misfit::correctionFit Foam::misfit::correctionFitter::freely()
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
