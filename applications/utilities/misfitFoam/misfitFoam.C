// SPDX-License-Identifier: GPL-3.0-or-later
// Reports where a case and recordings differ, and which physics is missing.

#include "designReport.H"
#include "diagnosis.H"
#include "emulatedPredictor.H"
#include "refit.H"
#include "report.H"
#include "solverPredictor.H"

#include "argList.H"
#include "IOdictionary.H"
#include "Time.H"
#include "projectVersion.H"
#include "serialTool.H"

#include <cmath>

namespace Foam::misfit
{

//- List the runs and what they will cost
void printPlan
(
    sampler& simulation,
    solverPredictor& solver,
    const recordings& recorded,
    const settings& set
)
{
    label n = 0;
    for (const plannedStage& stage : plan(simulation, set))
    {
        const List<runState> runs(runsOf(recorded, stage.states));
        solver.print(stage.name, runs);
        n += runs.size();
    }
    const label parts = recorded.experiments(purpose::calibration).size();
    const labelRange refits(refitRuns(set));
    Info<< "Refit of the best explanations: " << parts*refits.min() << " to "
        << parts*refits.max() << " runs at states that the sensitivities will show; none"
        << " where no misfit is detected" << nl
        << "Gates: up to "
        << (2 + set.parameters.size())*set.commonRandomNumbers + set.replicates
         + set.resolutionReplicates*set.resolutions.size()
        << " runs of each validation or test experiment" << nl;
    if (set.correction.size())
    {
        Info<< "Free correction: at most " << 4*set.passes*set.commonRandomNumbers*parts
            << " runs, and 2 of each held-out experiment; none where there is"
            << " an answer" << nl;
    }
    Info<< nl
        << n << " runs are known beforehand; a state that two stages share is"
        << " run once" << endl;
}


//- The runs of the experiment that is fitted that are known beforehand
List<runState> trainingRuns(sampler& simulation, settings set)
{
    set.correction.clear();
    const word fitted(simulation.data().first().experiment);
    List<runState> states;
    for (const plannedStage& stage : plan(simulation, set))
    {
        for (const runState& s : stage.states)
        {
            if (s.experiment == fitted)
            {
                states.append(s);
            }
        }
    }
    return states;
}


//- The states of the surfaces of an emulator, which have all experiments that are fitted
List<runState> ensembleOf(const emulatedPredictor& emulator, const recordings& recorded)
{
    const word fitted(recorded.calibrated());
    List<runState> states(emulator.trainingEnsemble(recorded.parts(fitted).first()));
    for (runState& s : states)
    {
        s.experiment = fitted;
    }
    return states;
}


//- Which mechanisms the experiment of a case could distinguish
void designOf
(
    const IOdictionary& dict,
    const settings& set,
    const fileName& caseFolder,
    const bool onlyPlan
)
{
    recordings recorded(dict, caseFolder);
    recorded.plan();
    const designSettings design(readDesign(dict, recorded));
    checkStrengths(dict, design, set);
    solverPredictor solver(recorded, caseFolder, dict);
    predictedSampler bySolver(recorded, solver);
    const List<runState> states(runsOf(recorded, trainingRuns(bySolver, set)));
    solver.print("Training runs", states);
    if (onlyPlan)
    {
        return;
    }

    emulatedPredictor emulator
    (
        set.parameters, set.candidates, states, solver.predict(states), set.chaotic
    );
    predictedSampler simulation(recorded, emulator, ensembleOf(emulator, recorded));
    Info<< "Diagnoses of simulated recordings" << endl;
    const experimentDesign d(designExperiment(simulation, set, design, solver.jobs()));
    const fileName folder(caseFolder/"misfit");
    writeDesign(d, folder, caseFolder.path().name()/caseFolder.name());
    Info<< nl << designTable(d).c_str() << nl
        << "To read: " << (folder/"design.html").c_str() << nl
        << "The record: " << (folder/"design.json").c_str() << endl;
}


//- What makes an answer less sure than it looks
void warnOf(const settings& set)
{
    if (set.resolutions.empty())
    {
        WarningInFunction
            << "resolution is empty: what the mesh and the step change may be taken"
            << " for missing physics. Name a finer mesh there at least" << endl;
    }
    if (set.replicates > 1 && set.replicates < 10)
    {
        WarningInFunction
            << "replicates is " << set.replicates << ": the spread of them is known"
            << " to about " << label(100/std::sqrt(2*(set.replicates - 1.0)))
            << " % only, and intervals are too narrow. 20 are advised" << endl;
    }
}


//- Remove what an earlier call answered, so that it is not there while this one is not
//  finished; the corrected case is kept beside
void putAnswerAside(const fileName& folder)
{
    rm(folder/"verdict.json");
    rm(folder/"report.html");
    const fileName corrected(folder/correctedCase);
    if (isDir(corrected))
    {
        if (isDir(corrected + ".before"))
        {
            rmDir(corrected + ".before");
        }
        mv(corrected, corrected + ".before");
    }
}


//- Diagnose a case and write the answer into its folder misfit, or list the runs only
void diagnosisOf
(
    const IOdictionary& dict,
    const fileName& caseFolder,
    const bool onlyPlan
)
{
    const fileName folder(caseFolder/"misfit");
    if (!onlyPlan)
    {
        putAnswerAside(folder);
    }

    const settings set(readSettings(dict));
    warnOf(set);
    const recordings recorded(dict, caseFolder);
    recorded.checkEnough(dict, set.parameters.size() + 2);

    solverPredictor solver(recorded, caseFolder, dict);
    predictedSampler simulation(recorded, solver);
    if (onlyPlan)
    {
        printPlan(simulation, solver, recorded, set);
        return;
    }

    const finding result(diagnose(simulation, set));
    const string title(caseFolder.path().name()/caseFolder.name());
    writeReport(result, folder, originOf(title, recorded, set.candidates));
    Info<< nl << summaryOf(result, folder).c_str() << endl;
    if (result.verdict.state)
    {
        const runState corrected(runsOf(recorded, {*result.verdict.state}).first());
        solver.makeCase(corrected, folder/correctedCase);
    }
}

} // End namespace Foam::misfit


int main(int argc, char* argv[])
{
    using namespace Foam;
    using namespace Foam::misfit;

    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Compare a case with recordings and report which physics is missing."
        " See README.md beside the source."
    );
    argList::noParallel();
    argList::addOption("dict", "file", "Instead of system/misfitDict");
    argList::addBoolOption("dry-run", "List the runs and their cost only");
    argList::addBoolOption
    (
        "design",
        "Without recordings: which mechanisms the experiment could distinguish"
    );

    startSerialTool();
    const argList args(argc, argv);
    checkThere
    (
        args.path()/"system"/"controlDict",
        "start misfitFoam in the folder of a case, or name it with -case"
    );
    Time runTime(Time::controlDictName, args);

    // A dictionary that is not there, or cannot be read, takes no answer away
    const word dictName("misfitDict");
    #include "setSystemRunTimeDictionaryIO.H"
    checkThere
    (
        dictIO.objectPath(),
        "it has the recordings and what may be missing; keywords: README.md of misfitFoam"
    );
    const IOdictionary dict(dictIO);

    const bool onlyPlan = args.found("dry-run");
    if (args.found("design"))
    {
        const settings set(readSettings(dict));
        warnOf(set);
        designOf(dict, set, runTime.path(), onlyPlan);
    }
    else
    {
        diagnosisOf(dict, runTime.path(), onlyPlan);
    }
    return 0;
}
