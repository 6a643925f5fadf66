// SPDX-License-Identifier: GPL-3.0-or-later
// Says where a case and recordings part, and which physics is missing.

#include "diagnosis.H"
#include "report.H"
#include "solverPredictor.H"
#include "words.H"

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
    sampler& ask,
    solverPredictor& solver,
    const recordings& recorded,
    const settings& set
)
{
    label n = 0;
    for (const plannedStage& stage : plan(ask, set))
    {
        const List<runState> runs(runsOf(recorded, stage.states));
        solver.print(stage.name, runs);
        n += runs.size();
    }
    const label refits =
        (set.refit + 3)*set.commonRandomNumbers
       *recorded.experiments(purpose::calibration).size();
    Info<< "Refit of the best explanations: " << refits << " to " << refits*set.passes
        << " runs at states that the sensitivities will show" << nl
        << "Gates: " << 2*set.commonRandomNumbers
        << " runs of each test experiment, up to "
        << (2 + set.parameters.size())*set.commonRandomNumbers + set.replicates
         + set.resolutionReplicates*set.resolutions.size()
        << " of each validation experiment" << nl;
    if (set.correction.size())
    {
        Info<< "Free correction: at most " << 4*set.passes*refits/(set.refit + 3)
            << " runs, and 2 of each held-out experiment; none where there is"
            << " an answer" << nl;
    }
    Info<< nl
        << n << " runs are known beforehand; a state that two stages share is"
        << " run once" << endl;
}


void printFinding(const finding& f, const fileName& folder)
{
    Info<< nl << "Verdict: " << verdictNames[f.verdict.kind] << nl
        << describe(f).c_str() << nl
        << "Confidence " << f.verdict.confidence << nl;
    for (const place& p : f.verdict.located)
    {
        Info<< "    " << describe(p, f.detection.data).c_str() << nl;
    }
    if (f.verdict.state)
    {
        Info<< nl << "The case with it: " << (folder/correctedCase).c_str();
    }
    Info<< nl << "To read: " << (folder/"report.html").c_str() << nl
        << "The record: " << (folder/"verdict.json").c_str() << endl;
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

} // End namespace Foam::misfit


int main(int argc, char* argv[])
{
    using namespace Foam;
    using namespace Foam::misfit;

    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Compare a case with recordings and say which physics is missing."
        " See README.md beside the source."
    );
    argList::noParallel();
    argList::addOption("dict", "file", "Instead of system/misfitDict");
    argList::addBoolOption("dry-run", "List the runs and their cost only");

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

    const fileName folder(runTime.path()/"misfit");
    if (!args.found("dry-run"))
    {
        // Not the answer of an earlier time while this one is not finished
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

    const settings set(readSettings(dict));
    warnOf(set);
    const recordings recorded(dict, runTime.path());
    recorded.checkEnough(dict, set.parameters.size() + 2);

    solverPredictor solver(recorded, runTime.path(), dict);
    predictedSampler sampler(recorded, solver);
    if (args.found("dry-run"))
    {
        printPlan(sampler, solver, recorded, set);
        return 0;
    }

    const finding result(diagnose(sampler, set));
    const fileName above(runTime.path().path());
    writeReport
    (
        result, folder,
        originOf(above.name()/runTime.path().name(), recorded, set.candidates)
    );
    printFinding(result, folder);
    if (result.verdict.state)
    {
        const runState corrected(runsOf(recorded, {*result.verdict.state}).first());
        solver.makeCase(corrected, folder/correctedCase);
    }
    return 0;
}
