// SPDX-License-Identifier: GPL-3.0-or-later
// Predictions from a training ensemble of runs, without the solver.

#include "emulatedPredictor.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::misfit::vec
Foam::misfit::emulatedPredictor::variables(const runState& s) const
{
    const label nP = parameters_.size();
    vec x = vec::Zero(nP + candidates_.size());
    forAll(parameters_, i)
    {
        x[i] = s.parameters.lookup(parameters_[i].name, parameters_[i].mean);
    }
    forAll(candidates_, i)
    {
        x[nP + i] = s.strengths.lookup(candidates_[i].name, 0);
    }
    return x;
}


bool Foam::misfit::emulatedPredictor::isVariant(const label run) const
{
    const runState& s = states_[run];
    return s.resolution != "base" || s.replicate != states_.first().replicate;
}


bool Foam::misfit::emulatedPredictor::makesSurface
(
    const label run,
    const word& experiment
) const
{
    return
        states_[run].experiment == experiment && runs_[run].ok()
     && !isVariant(run);
}


bool Foam::misfit::emulatedPredictor::isVariantOf
(
    const label run,
    const runState& s
) const
{
    const runState& r = states_[run];
    return runs_[run].ok() && isVariant(run)
     && r.experiment == s.experiment
     && (r.resolution == "base" || r.resolution == s.resolution)
     && (r.replicate == states_.first().replicate || r.replicate == s.replicate);
}


Foam::misfit::vec Foam::misfit::emulatedPredictor::onGrids
(
    const emulator& e,
    const prediction& p
) const
{
    scalarList all;
    forAll(e.grids, c)
    {
        for (const scalar x : e.grids[c])
        {
            all.append(p.channels[c](x));
        }
    }
    return Eigen::Map<const vec>(all.cdata(), all.size());
}


Foam::autoPtr<Foam::misfit::emulatedPredictor::emulator>
Foam::misfit::emulatedPredictor::build(const word& experiment) const
{
    autoPtr<emulator> e(new emulator);
    mat x(parameters_.size() + candidates_.size(), 0);
    mat y;
    forAll(states_, i)
    {
        if (!makesSurface(i, experiment))
        {
            continue;
        }
        const label n = x.cols();
        if (!n)
        {
            for (const series& s : runs_[i].channels)
            {
                scalarList grid(s.x.size() ? 120 : 0);
                forAll(grid, k)
                {
                    grid[k] =
                        s.x.first()
                      + k*(s.x.last() - s.x.first())/(grid.size() - 1);
                }
                e->grids.append(grid);
            }
        }
        const vec samples(onGrids(e(), runs_[i]));
        x.conservativeResize(Eigen::NoChange, n + 1);
        y.conservativeResize(samples.size(), n + 1);
        x.col(n) = variables(states_[i]);
        y.col(n) = samples;
    }

    vec centre = vec::Zero(x.rows());
    vec width = vec::Ones(x.rows());
    forAll(parameters_, i)
    {
        centre[i] = parameters_[i].mean;
        width[i] = parameters_[i].deviation;
    }
    forAll(candidates_, i)
    {
        width[parameters_.size() + i] = candidates_[i].strong;
    }
    e->surface.reset(new statistics::responseSurface(x, y, centre, width));
    return e;
}


Foam::misfit::prediction
Foam::misfit::emulatedPredictor::emulated(const runState& s) const
{
    prediction p;
    if (!emulators_.found(s.experiment))
    {
        p.failure = "the training ensemble has no experiment " + s.experiment;
        return p;
    }
    const emulator& e = *emulators_[s.experiment];
    vec y = (*e.surface)(variables(s));

    forAll(states_, i)
    {
        if (isVariantOf(i, s))
        {
            y += onGrids(e, runs_[i]) - (*e.surface)(variables(states_[i]));
        }
    }

    label first = 0;
    for (const scalarList& grid : e.grids)
    {
        series c;
        c.x = grid;
        c.y.setSize(grid.size());
        forAll(grid, k)
        {
            c.y[k] = y[first + k];
        }
        first += grid.size();
        p.channels.append(c);
    }
    return p;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::emulatedPredictor::emulatedPredictor
(
    const List<parameter>& parameters,
    const List<candidate>& candidates,
    const List<runState>& states,
    const List<prediction>& runs
)
:
    parameters_(parameters),
    candidates_(candidates),
    states_(states),
    runs_(runs)
{
    forAll(states, i)
    {
        // That another replicate or resolution failed must not stay unsaid
        if (runs[i].ok() || isVariant(i))
        {
            known_.insert(describe(states[i]), i);
        }
        if (runs[i].ok())
        {
            if (!emulators_.found(states[i].experiment))
            {
                emulators_.set
                (
                    states[i].experiment,
                    build(states[i].experiment).ptr()
                );
            }
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
        const auto known = known_.cfind(describe(states[i]));
        all[i] = known.found() ? runs_[known.val()] : emulated(states[i]);
    }
    return all;
}


Foam::List<Foam::misfit::runState>
Foam::misfit::emulatedPredictor::trainingEnsemble(const word& experiment) const
{
    List<runState> some;
    forAll(states_, i)
    {
        if (makesSurface(i, experiment))
        {
            some.append(states_[i]);
        }
    }
    return some;
}
