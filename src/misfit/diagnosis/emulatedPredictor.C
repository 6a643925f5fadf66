// SPDX-License-Identifier: GPL-3.0-or-later
// Predictions from a training ensemble of runs, without the solver.

#include "emulatedPredictor.H"
#include "IndirectList.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Each channel of a run at so many places as even grids
List<series> gridsOf(const prediction& run)
{
    List<series> grids(run.channels.size());
    forAll(grids, c)
    {
        const series& s = run.channels[c];
        scalarList x(s.x.size() ? 120 : 0);
        forAll(x, k)
        {
            x[k] = s.x.first() + k*(s.x.last() - s.x.first())/(x.size() - 1);
        }
        grids[c] = series(x, x);
    }
    return grids;
}


//- All channels of a run on these grids
vec onGrids(const List<series>& grids, const prediction& run)
{
    scalarList all;
    forAll(grids, c)
    {
        for (const scalar x : grids[c].x)
        {
            all.append(run.channels[c](x));
        }
    }
    return Eigen::Map<const vec>(all.cdata(), all.size());
}

//- Mean variance between runs, a column for each, of the channel that each row is of
vec spread(const List<series>& grids, const mat& runs)
{
    const mat apart = statistics::deviations(runs);
    vec variance(runs.rows());
    label first = 0;
    for (const series& s : grids)
    {
        const label n = s.x.size();
        const scalar sum = apart.middleRows(first, n).squaredNorm();
        variance.segment(first, n).setConstant(sum/max(n*runs.cols(), label(1)));
        first += n;
    }
    return variance;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::misfit::emulatedPredictor::isVariant(const label run) const
{
    const runState& s = states_[run];
    return !s.isBase() || s.replicate != states_.first().replicate;
}


bool Foam::misfit::emulatedPredictor::isVariantOf
(
    const label run,
    const runState& s
) const
{
    const runState& r = states_[run];
    const bool otherResolution = !r.isBase();
    const bool otherReplicate = r.replicate != states_.first().replicate;
    return runs_[run].ok() && otherResolution != otherReplicate
     && r.experiment == s.experiment
     && (!otherResolution || r.resolution == s.resolution)
     && (!otherReplicate || r.replicate == s.replicate);
}


Foam::labelList
Foam::misfit::emulatedPredictor::surfaceRuns(const word& experiment) const
{
    labelList some;
    forAll(states_, i)
    {
        if (states_[i].experiment == experiment && runs_[i].ok() && !isVariant(i))
        {
            some.append(i);
        }
    }
    return some;
}


Foam::wordList
Foam::misfit::emulatedPredictor::failingCandidates(const word& experiment) const
{
    wordList failing;
    for (const candidate& c : candidates_)
    {
        label failed = 0;
        label ran = 0;
        forAll(states_, i)
        {
            const bool on =
                states_[i].experiment == experiment
             && states_[i].strengths.lookup(c.name, 0) > 0;
            ran += on && runs_[i].ok();
            failed += on && !runs_[i].ok();
        }
        if (failed && !ran)
        {
            failing.append(c.name);
        }
    }
    return failing;
}


Foam::misfit::emulatedPredictor::emulator
Foam::misfit::emulatedPredictor::build(const word& experiment) const
{
    const labelList some(surfaceRuns(experiment));
    emulator e;
    e.grids = some.size() ? gridsOf(runs_[some.first()]) : List<series>();
    const label n = parameters_.size() + candidates_.size();
    mat x(n, some.size());
    mat y;
    forAll(some, i)
    {
        const vec samples(onGrids(e.grids, runs_[some[i]]));
        x.col(i) = variables(states_[some[i]]);
        y.conservativeResize(samples.size(), some.size());
        y.col(i) = samples;
    }

    vec centre = variables(runState());
    vec width(n);
    forAll(parameters_, i)
    {
        width[i] = parameters_[i].deviation;
    }
    forAll(candidates_, i)
    {
        width[parameters_.size() + i] = candidates_[i].strong;
    }
    const vec chance = chaotic_ ? spread(e.grids, y) : vec();
    e.surface.reset
    (
        new statistics::responseSurface(x, y, centre, width, std::vector<bool>(), chance)
    );
    return e;
}


Foam::misfit::prediction
Foam::misfit::emulatedPredictor::emulated(const runState& s) const
{
    prediction p;
    const auto position = emulators_.find(s.experiment);
    if (position == emulators_.end())
    {
        p.failure = "the training ensemble has no experiment " + s.experiment;
        return p;
    }
    for (const word& name : failing_.lookup(s.experiment, wordList()))
    {
        if (s.strengths.lookup(name, 0) > 0)
        {
            p.failure = "each run of the training ensemble with " + name + " failed";
            return p;
        }
    }
    const emulator& e = position->second;
    vec y = (*e.surface)(variables(s));

    // Of a replicate and of a resolution each the mean over its runs
    mat replicate;
    mat resolution;
    forAll(states_, i)
    {
        if (isVariantOf(i, s))
        {
            statistics::appendColumn
            (
                states_[i].isBase() ? replicate : resolution,
                onGrids(e.grids, runs_[i]) - (*e.surface)(variables(states_[i]))
            );
        }
    }
    for (const mat* changes : {&replicate, &resolution})
    {
        if (changes->cols())
        {
            y += changes->rowwise().mean();
        }
    }

    p.channels = e.grids;
    const scalar* next = y.data();
    for (series& c : p.channels)
    {
        std::copy_n(next, c.y.size(), c.y.begin());
        next += c.y.size();
    }
    return p;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::emulatedPredictor::emulatedPredictor
(
    const List<parameter>& parameters,
    const List<candidate>& candidates,
    const List<runState>& states,
    const List<prediction>& runs,
    const bool chaotic
)
:
    parameters_(parameters),
    candidates_(candidates),
    states_(states),
    runs_(runs),
    chaotic_(chaotic)
{
    forAll(states, i)
    {
        // That another replicate or resolution failed must not stay unsaid
        if (runs[i].ok() || isVariant(i))
        {
            known_.insert(describe(states[i]), i);
        }
        const word& experiment = states[i].experiment;
        if (runs[i].ok() && !emulators_.count(experiment))
        {
            emulators_.emplace(experiment, build(experiment));
            failing_.insert(experiment, failingCandidates(experiment));
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::misfit::prediction>
Foam::misfit::emulatedPredictor::predict(const List<runState>& states)
{
    List<prediction> all(states.size());
    forAll(states, i)
    {
        const prediction* known = find(states[i]);
        all[i] = known ? *known : emulated(states[i]);
    }
    return all;
}


const Foam::misfit::prediction*
Foam::misfit::emulatedPredictor::find(const runState& s) const
{
    const auto known = known_.cfind(describe(s));
    return known.found() ? &runs_[known.val()] : nullptr;
}


Foam::List<Foam::misfit::runState>
Foam::misfit::emulatedPredictor::trainingEnsemble(const word& experiment) const
{
    return List<runState>(UIndirectList<runState>(states_, surfaceRuns(experiment)));
}
