// SPDX-License-Identifier: GPL-3.0-or-later
// Makes, diagnoses and scores cases whose cause is concealed.

#include "concealedSet.H"
#include "confidenceFit.H"
#include "textFile.H"

#include "argList.H"
#include "OSspecific.H"
#include "serialTool.H"

#include <random>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

void addOptions()
{
    argList::addNote
    (
        "Make, diagnose and score cases whose cause is concealed. Started in"
        " the folder of the slice. See its README.md."
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption("folder", "dir", "Of the cases");
    argList::addOption("key", "file", "The key; folder/key.json if not given");
    argList::addOption
    (
        "ensemble", "dir", "Of the training ensembles; ensemble of the slice if not given"
    );
    argList::addOption("make", "n", "Make so many cases and their key");
    argList::addOption("seed", "number", "For make; secret if not given");
    argList::addBoolOption("diagnose", "Diagnose all cases in the folder");
    argList::addBoolOption("score", "Score the verdicts against the key");
    argList::addOption
    (
        "calibrate", "cases.csv", "Fit the table of confidences to scored cases"
    );
    argList::addOption("table", "file", "For calibrate: that table");
    argList::addBoolOption
    (
        "check",
        "Compute a run of each ensemble that is used anew and tell the difference"
    );
    argList::addBoolOption("solver", "Each state by the solver, not the ensemble");
}


//- Largest difference of a run of these ensembles, computed anew, over the
//  uncertainty of a reading
scalar difference
(
    const fileName& slice,
    const fileName& ensembles,
    const wordList& sides
)
{
    scalar largest = 0;
    for (const word& side : sides)
    {
        if (!isFile(ensembles/side + ".txt", false))
        {
            FatalErrorInFunction
                << "There is no ensemble " << ensembles/side + ".txt"
                << " to check: -make, -diagnose and -score without -solver compute it" << exit(FatalError);
        }
        largest =
            max(largest, concealedSide(slice, ensembles, side, false).difference(1));
    }
    return largest;
}


//- Of a path as it is given: from where the program was started
fileName absolute(fileName path)
{
    return path.toAbsolute();
}


//- Fatal if there is nothing to do, or not all that it takes
void checkAction(const argList& args)
{
    bool any = false;
    for (const char* what : {"make", "diagnose", "score", "calibrate", "check"})
    {
        any = any || args.found(what);
    }
    if (!any || (args.found("make") && args.get<label>("make") < 1))
    {
        FatalErrorInFunction
            << "Nothing to do: give -make with a number above 0, -diagnose, -score,"
            << " -calibrate or -check" << exit(FatalError);
    }
    if (args.found("calibrate") && !args.found("table"))
    {
        FatalErrorInFunction
            << "-calibrate needs -table too: the file that the table of confidences"
            << " is written to" << exit(FatalError);
    }
    if (!args.found("calibrate") && !args.found("folder"))
    {
        FatalErrorInFunction
            << "Give -folder with the folder of the cases" << exit(FatalError);
    }
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    addOptions();
    startSerialTool();
    const argList args(argc, argv);
    checkAction(args);
    if (args.found("calibrate"))
    {
        const fileName table(absolute(args.get<fileName>("table")));
        writeWhole
        (
            table, fittedTable(readKnownCases(args.get<fileName>("calibrate")))
        );
        return 0;
    }
    const fileName slice(args.path());
    const fileName folder(absolute(args.get<fileName>("folder")));
    const fileName key
    (
        absolute(args.lookupOrDefault<fileName>("key", folder/"key.json"))
    );
    const fileName ensembles
    (
        absolute(args.lookupOrDefault<fileName>("ensemble", slice/"ensemble"))
    );
    const bool solver = args.found("solver");

    if (args.found("make"))
    {
        // Before an ensemble is computed
        const label secret = label(std::random_device()() >> 1);
        const label seed = args.lookupOrDefault<label>("seed", secret);
        mkDir(folder);
        beginKey(key, seed, args.found("seed"));
        concealedSide truth(slice, ensembles, "truth", solver);
        makeCases(truth, folder, key, args.get<label>("make"));
    }
    if (args.found("diagnose") || args.found("score"))
    {
        concealedSide library
        (
            slice, ensembles, "library", solver && args.found("diagnose")
        );
        if (args.found("diagnose"))
        {
            diagnoseCases(library, folder);
        }
        if (args.found("score"))
        {
            scoreCases(library, folder, key);
        }
    }
    if (args.found("check"))
    {
        // The solver's truth has no ensemble
        wordList sides(1, "library");
        if (!solver)
        {
            sides.append("truth");
        }
        // Found first: a run of some seconds tells how far it is meanwhile
        const scalar largest = difference(slice, ensembles, sides);
        Info<< "check " << largest << endl;
    }
    return 0;
}
