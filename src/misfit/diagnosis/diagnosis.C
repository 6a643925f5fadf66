// SPDX-License-Identifier: GPL-3.0-or-later
// A diagnosis: its stages, one after the other.

#include "diagnosis.H"
#include "designs.H"
#include "stages.H"

#include <stdexcept>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- The error of the clock is a shift in time
void warnOfClock(const study& s)
{
    for (const segment& channel : s.data().calibration.segments)
    {
        const bool moves = !channel.overTime && !channel.isNumber();
        if (moves && s.set.clockUncertainty > 0)
        {
            WarningInFunction
                << "clockUncertainty is not counted in " << channel.name.c_str()
                << ", which is no series over time: put what the clock's error"
                << " moves it by into its uncertainty" << endl;
        }
    }
}


//- The candidates that may be the cause: none where nothing is detected
screenedCandidates screenAll
(
    study& s,
    const hypothesisFit& base,
    const std::vector<int>& failing,
    const bool detected
)
{
    const screenedCandidates candidates(screen(s, base, failing));
    return
        detected
      ? addSensitivityRuns(s, base, candidates)
      : screenedCandidates{{}, candidates.dropped, candidates.failing};
}


finding runStages(sampler& simulation, const settings& set)
{
    study s(simulation, set);
    warnOfClock(s);
    addUncertainty(s);
    const std::vector<int> failing(addCalibrationRuns(s));
    const hypothesisFit base(s.calibration.score().base());
    const misfitDetection detection(detect(s, base));
    const bool detected = detection.calibrated.p < set.significance;
    const screenedCandidates candidates(screenAll(s, base, failing, detected));
    const explanations explained(rank(s, candidates.left, detected));
    const separation apart(separate(s, candidates.left, explained.baseline()));
    const gateTests tests(testGates(s, candidates.left, detection, explained));
    const stageResults e
    {
        s.names, detection, candidates, explained, apart, tests, s.failed
    };
    const decision verdict(decide(s, e));
    const correctionFit correction(correct(s, e, verdict));
    return
    {
        e, withCorrection(set, verdict, correction), correction,
        departuresOf(e, verdict.before, set), s.nRuns + correction.nRuns
    };
}


//- The states at these variables, with each of the replicates with common random numbers
List<runState> replicated(const study& s, const std::vector<vec>& design)
{
    List<runState> states;
    for (const vec& x : design)
    {
        for (label i = 0; i < s.set.commonRandomNumbers; ++i)
        {
            states.append(s.state(x));
            states.last().replicate = i;
        }
    }
    return states;
}

} // End anonymous namespace


Foam::misfit::finding
Foam::misfit::diagnose(sampler& simulation, const settings& set)
{
    try
    {
        return runStages(simulation, set);
    }
    catch (const std::domain_error& e)
    {
        FatalErrorInFunction
            << e.what() << nl
            << "    Check the uncertainties and the bounds in system/misfitDict"
            << exit(FatalError);
        throw;
    }
}


Foam::misfit::visibility
Foam::misfit::visible(sampler& simulation, const settings& set)
{
    study s(simulation, set);
    addUncertainty(s);
    addCalibrationRuns(s);

    const vec& mean = s.bounds.mean;
    const label nP = s.bounds.nParameters;
    visibility v;
    v.sensors = covariance(s.calibration.data(), 0).at(s.calibration.data().y);
    v.all = s.calibration.uncertainty().at(s.calibration.surface()(mean));
    v.calibrated = statistics::withFitted
    (
        v.all,
        s.calibration.surface().slopes(mean).leftCols(nP),
        s.bounds.deviation.head(nP)
    );
    return v;
}


Foam::List<Foam::misfit::plannedStage>
Foam::misfit::plan(sampler& simulation, const settings& set)
{
    const study s(simulation, set);
    const List<runState> all(bases(s));
    List<runState> first(uncertaintyRuns(s, s.data().experiment));
    first.append(List<runState>(SubList<runState>(all, all.size() - 1, 1)));

    List<plannedStage> stages;
    stages.append({"Uncertainty", first});
    if (set.trainingEnsemble)
    {
        stages.append
        ({
            "Calibration and sensitivities, a training ensemble of random runs",
            replicated
            (
                s, ensembleDesign(s.bounds, set.trainingEnsemble, set.seed)
            )
        });
    }
    else
    {
        const std::vector<int> every(statistics::inOrder(set.candidates.size()));
        stages.append({"Calibration", replicated(s, parameterDesign(s.bounds))});
        stages.append
        ({
            "Sensitivities of the mechanisms (around the calibrated state, not the"
            " one shown)",
            replicated(s, s.sensitivityDesign(s.bounds.centre, every))
        });
    }
    if (set.correction.size())
    {
        const study c(s.ofCorrection());
        List<runState> states(replicated(c, elementDesign(c, c.bounds.centre)));
        states.append(c.state(c.bounds.centre));
        states.last().noting = true;
        stages.append
        ({
            "Free correction, only where the verdict would be unknown (around the"
            " calibrated state, not the one shown)",
            states
        });
    }
    return stages;
}
