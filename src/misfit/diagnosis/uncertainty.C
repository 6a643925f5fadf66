// SPDX-License-Identifier: GPL-3.0-or-later
// How far simulation and recording may differ with nothing wrong.

#include "stages.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

void checkBases(study& s)
{
    const List<samples> given(s.run(bases(s)));
    if (!given.first().ok())
    {
        FatalErrorInFunction
            << "The base case did not run: " << given.first().failure.c_str()
            << nl << "Mend the case first; nothing was diagnosed. If the case"
            << " is sound, delete its folder in misfit/runs to have it run again"
            << exit(FatalError);
    }
    for (label i = 1; i < given.size(); ++i)
    {
        if (!given[i].ok())
        {
            WarningInFunction
                << "The base of the experiment "
                << s.experiments[i].experiment << " did not run: "
                << given[i].failure.c_str() << nl
                << "It will confirm nothing until that is mended" << endl;
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
    if (run >= s.set.replicates)
    {
        const word& name = state.resolution;
        FatalErrorInFunction
            << "The run with other " << name << " failed: "
            << why.c_str() << nl << "Without it what numerics"
            << " change would be taken for physics. Mend resolution/" << name
            << " in system/misfitDict, or take it out. Finished runs are"
            << " kept" << exit(FatalError);
    }
    if (run < s.set.commonRandomNumbers)
    {
        FatalErrorInFunction
            << "Replicate " << run << ", one of the "
            << s.set.commonRandomNumbers << " with common random numbers"
            << " that every state is computed with, failed: "
            << why.c_str() << nl << "Mend 'replicateChanges'"
            << " in system/misfitDict, or ask for fewer with 'commonRandomNumbers'."
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
            << " ran, so nothing is known of the spread between them: mend"
            << " 'replicateChanges' in system/misfitDict. Finished runs are kept"
            << exit(FatalError);
    }
}


//- Stop where another resolution changes nothing
void checkChanges
(
    const word& resolution,
    const vec& calibration,
    const vec& validation
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

} // End anonymous namespace


Foam::List<Foam::misfit::runState> Foam::misfit::bases(const study& s)
{
    List<runState> states;
    for (const observed& o : s.experiments)
    {
        states.append(s.state(o.experiment, s.bounds.mean));
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
        states.append(s.state(experiment, s.bounds.mean));
        states.last().replicate = replicate;
    }
    for (const word& name : s.set.resolutions)
    {
        states.append(s.state(experiment, s.bounds.mean));
        states.last().resolution = name;
    }
    return states;
}


void Foam::misfit::addUncertainty(study& s)
{
    Info<< "Uncertainty" << endl;
    const settings& set = s.set;
    const List<runState> states(uncertaintyRuns(s, s.data().experiment));
    checkBases(s);
    const List<samples> given(s.run(states));
    mat calibration(s.calibration.size(), 0);
    mat validation(s.validation.size(), 0);
    forAll(given, i)
    {
        if (!given[i].ok())
        {
            checkFailure(s, i, states[i], given[i].failure);
        }
        else if (i < set.replicates)
        {
            appendColumn(calibration, given[i].calibration);
            appendColumn(validation, given[i].validation);
        }
        else
        {
            const vec ofCalibration =
                given[i].calibration - given.first().calibration;
            const vec ofValidation =
                given[i].validation - given.first().validation;
            checkChanges(states[i].resolution, ofCalibration, ofValidation);
            s.calibration.addDifference(states[i].resolution, ofCalibration);
            s.validation.addDifference(states[i].resolution, ofValidation);
        }
    }
    checkSpread(set.replicates, calibration.cols());
    checkReplicates(calibration, validation);
    s.calibration.addRepeats(calibration, set.commonRandomNumbers);
    s.validation.addRepeats(validation, set.commonRandomNumbers);
}
