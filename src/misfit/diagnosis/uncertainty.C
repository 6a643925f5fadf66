// SPDX-License-Identifier: GPL-3.0-or-later
// How far simulation and recording may differ with nothing wrong.

#include "stages.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

void checkBases(study& s)
{
    const List<samples> results(s.run(bases(s)));
    if (!results.first().ok())
    {
        FatalErrorInFunction
            << "The base case did not run: " << results.first().failure.c_str()
            << nl << "Correct the case first; nothing was diagnosed. If the case"
            << " is sound, delete its folder in misfit/runs to have it run again"
            << exit(FatalError);
    }
    for (label i = 1; i < results.size(); ++i)
    {
        if (!results[i].ok())
        {
            WarningInFunction
                << "The base of the experiment "
                << s.experiments[i].experiment << " did not run: "
                << results[i].failure.c_str() << nl
                << "It confirms nothing until that is corrected" << endl;
        }
    }
}


//- Notes a run that failed, or stops where nothing goes on without it
void checkFailure
(
    study& s,
    const label run,
    const runState& state,
    const string& why
)
{
    if (run < s.set.commonRandomNumbers)
    {
        FatalErrorInFunction
            << "Replicate " << run << ", one of the "
            << s.set.commonRandomNumbers << " with common random numbers"
            << " that every state is computed with, failed: "
            << why.c_str() << nl << "Correct 'replicateChanges'"
            << " in system/misfitDict, or request fewer with 'commonRandomNumbers'."
            << " Finished runs are kept" << exit(FatalError);
    }
    s.leaveOut(state, why);
}


//- Stop where too few replicates ran to know their spread
void checkSpread(const label replicates, const label ran)
{
    if (replicates > 1 && ran < 2)
    {
        FatalErrorInFunction
            << "Of " << replicates << " replicates only " << ran
            << " ran, so the spread between them is unknown. Correct"
            << " 'replicateChanges' in system/misfitDict. Finished runs are kept"
            << exit(FatalError);
    }
}


//- Stop where no run with another resolution ended
void checkAny
(
    const word& resolution,
    const List<runState>& states,
    const List<samples>& results,
    const mat& changes
)
{
    if (changes.cols())
    {
        return;
    }
    string why;
    forAll(states, i)
    {
        if (states[i].resolution == resolution && why.empty())
        {
            why = results[i].failure;
        }
    }
    FatalErrorInFunction
        << "The run with other " << resolution << " failed: " << why.c_str() << nl
        << "Without it, numerical effects would be taken for physics. Correct"
        << " resolution/" << resolution << " in system/misfitDict, or remove it."
        << " Finished runs are kept"
        << exit(FatalError);
}


//- Stop where another resolution changes nothing
void checkChanges
(
    const word& resolution,
    const mat& calibration,
    const mat& validation
)
{
    if (calibration.isZero(0) && validation.isZero(0))
    {
        FatalErrorInFunction
            << "The run with other " << resolution << " gives the same numbers in"
            << " all channels, so what numerics change would be taken for physics."
            << nl << "    Does resolution/" << resolution << " in system/misfitDict"
            << " set the case's own values? Finished runs are kept"
            << exit(FatalError);
    }
}


//- Stop where two replicates, a column each, are the same
void checkReplicates
(
    const mat& calibration,
    const mat& validation
)
{
    for (label i = 0; i < calibration.cols(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if
            (
                calibration.col(i) == calibration.col(j)
             && validation.col(i) == validation.col(j)
            )
            {
                FatalErrorInFunction
                    << "Two replicates give the same numbers in all channels, so"
                    << " the spread between replicates comes out too small."
                    << nl << "    Does 'replicateChanges' in system/misfitDict"
                    << " set the case's own value once more?"
                    << " 'offset 1;' in it makes the second replicate 2."
                    << exit(FatalError);
            }
        }
    }
}


//- Samples of these runs for a use, of those with a resolution or "base": a column for
//  each that did not fail
mat samplesOf
(
    const word& resolution,
    const List<runState>& states,
    const List<samples>& results,
    const purpose use
)
{
    mat all;
    forAll(states, i)
    {
        if (states[i].resolution == resolution && results[i].ok())
        {
            appendColumn(all, results[i].of(use));
        }
    }
    return all;
}


//- What a resolution changes in them, a column for each replicate that ran with and
//  without it
mat changesBy
(
    const word& resolution,
    const List<runState>& states,
    const List<samples>& results,
    const purpose use
)
{
    mat all;
    forAll(states, i)
    {
        // The replicates without it are the first runs, in their order
        const samples& base = results[states[i].replicate];
        if (states[i].resolution == resolution && results[i].ok() && base.ok())
        {
            appendColumn(all, results[i].of(use) - base.of(use));
        }
    }
    return all;
}

} // End anonymous namespace


Foam::List<Foam::misfit::runState> Foam::misfit::bases(const study& s)
{
    List<runState> states;
    for (const observation& o : s.experiments)
    {
        states.append(s.state(o.experiment, s.bounds.centre));
    }
    return states;
}


Foam::List<Foam::misfit::runState> Foam::misfit::uncertaintyRuns
(
    const study& s,
    const word& experiment
)
{
    List<runState> states;
    for (label replicate = 0; replicate < s.set.replicates; ++replicate)
    {
        states.append(s.state(experiment, s.bounds.centre));
        states.last().replicate = replicate;
    }
    for (const word& name : s.set.resolutions)
    {
        for (label replicate = 0; replicate < s.set.resolutionReplicates; ++replicate)
        {
            states.append(s.state(experiment, s.bounds.centre));
            states.last().resolution = name;
            states.last().replicate = replicate;
        }
    }
    return states;
}


void Foam::misfit::addUncertainty(study& s)
{
    Info<< "Uncertainty" << endl;
    const settings& set = s.set;
    const List<runState> states(uncertaintyRuns(s, s.data().experiment));
    checkBases(s);
    const List<samples> results(s.run(states));
    forAll(results, i)
    {
        if (!results[i].ok())
        {
            checkFailure(s, i, states[i], results[i].failure);
        }
    }
    const purpose fitted = purpose::calibration;
    const purpose held = purpose::validation;
    const mat repeats(samplesOf("base", states, results, fitted));
    checkSpread(set.replicates, repeats.cols());
    for (const word& name : set.resolutions)
    {
        const mat changes(changesBy(name, states, results, fitted));
        const mat heldChanges(changesBy(name, states, results, held));
        checkAny(name, states, results, changes);
        if (!s.simulation.isSelection())
        {
            checkChanges(name, changes, heldChanges);
            checkReplicates
            (
                samplesOf(name, states, results, fitted),
                samplesOf(name, states, results, held)
            );
        }
        s.calibration.addResolution(name, changes);
        s.validation.addResolution(name, heldChanges);
    }
    const mat heldRepeats(samplesOf("base", states, results, held));
    if (!s.simulation.isSelection())
    {
        checkReplicates(repeats, heldRepeats);
    }
    s.calibration.addRepeats(repeats, set.commonRandomNumbers);
    s.validation.addRepeats(heldRepeats, set.commonRandomNumbers);
}


bool Foam::misfit::addNumerics
(
    study& s,
    const observation& other,
    covariance& known
)
{
    const label replicates = s.set.replicates;
    const List<runState> states(uncertaintyRuns(s, other.experiment));
    const List<samples> results(s.run(states));
    bool confirms = results.first().ok();
    forAll(results, i)
    {
        if (!results[i].ok())
        {
            s.leaveOut(states[i], results[i].failure);
        }
    }
    const mat repeats(samplesOf("base", states, results, other.use));
    for (const word& name : s.set.resolutions)
    {
        const mat changes(changesBy(name, states, results, other.use));
        confirms = confirms && changes.cols();
        if (changes.cols())
        {
            known.addResolution
            (
                name, changes, repeats, s.set.chaotic && repeats.cols() > 1
            );
        }
    }
    known.addRepeats(repeats, s.set.commonRandomNumbers);
    return confirms && (replicates < 2 || repeats.cols() > 1);
}
