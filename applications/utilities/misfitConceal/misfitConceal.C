// SPDX-License-Identifier: GPL-3.0-or-later
// Makes, diagnoses and scores cases whose cause is concealed.

#include "concealedSide.H"
#include "confidenceFit.H"
#include "keywords.H"
#include "textFile.H"

#include "projectVersion.H"
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
    const char* const options[][3] =
    {
        {"folder", "dir", "Folder of the cases"},
        {"key", "file", "The key; folder/key.json if not given"},
        {"ensemble", "dir", "Training ensembles; ensemble of the slice if not given"},
        {"compute", "n", "Compute up to n of the runs that the training"
            " ensembles lack, and print how many exist"},
        {"make", "n", "Make cases 1 to n and their key"},
        {"from", "n", "With -make: leave out the cases before this number"},
        {"seed", "number", "With -make; secret if not given"},
        {"keep", "file", "With -make and -solver: keep the runs there, and go on with"
            " those that are there"},
        {"diagnose", "", "Diagnose all cases in the folder"},
        {"score", "", "Score the verdicts against the key"},
        {"calibrate", "cases.csv", "Fit the table of confidences to scored cases"},
        {"table", "file", "With -calibrate: write the table there"},
        {"check", "", "Compute a run of each ensemble in use again, and print the"
            " difference"},
        {"write", "dir", "Write the case of the library at the mean there"},
        {"with", "name", "With -write: this mechanism in full, or this parameter"
            " one deviation higher"},
        {"replicate", "n", "With -write: its number; 0 if not given"},
        {"solver", "", "Each state by the solver, not the ensemble"}
    };
    for (const auto& option : options)
    {
        argList::addOption(option[0], option[1], option[2]);
    }
}


//- The whole number of an option
label number(const argList& args, const word& option)
{
    label n = 0;
    if (!read(args[option], n))
    {
        FatalErrorInFunction
            << '-' << option << " needs a whole number, not " << args[option].c_str()
            << exit(FatalError);
    }
    return n;
}


//- The cases that are to be made, counted from 0; fatal if -from is none of them
labelRange casesOf(const argList& args)
{
    const label last = number(args, "make");
    const label first = args.found("from") ? number(args, "from") : 1;
    if (first < 1 || first > last)
    {
        FatalErrorInFunction
            << "-from " << first << ": the cases are numbered from 1 to " << last
            << ". Begin at one of these, or make more with -make" << exit(FatalError);
    }
    return labelRange(first - 1, last - first + 1);
}


//- Fatal if there is nothing to do, or not all that it takes
void checkAction(const argList& args)
{
    const bool computes = args.found("compute");
    const bool writes = args.found("write");
    bool others = computes && writes;
    for
    (
        const char* what :
        {"make", "diagnose", "score", "calibrate", "check"}
    )
    {
        others = others || args.found(what);
    }
    const char* missing =
        !(computes || writes || others)
     || (args.found("make") && number(args, "make") < 1)
     || (computes && number(args, "compute") < 0)
      ? "Nothing to do: give -make with a number above 0, -compute with its"
        " number, -diagnose, -score, -calibrate, -check or -write"
      : (computes || writes) && others
      ? "-write writes one case, -compute computes an ensemble, and each does nothing"
        " else: give it alone"
      : !writes && (args.found("with") || args.found("replicate"))
      ? "-with and -replicate choose which case -write writes: give it, too"
      : args.found("from") && !args.found("make")
      ? "-from chooses which of the cases -make makes: give both"
      : args.found("keep") && !(args.found("make") && args.found("solver"))
      ? "-keep keeps the runs of -make with -solver: give both"
      : args.found("calibrate") && !args.found("table")
      ? "-calibrate needs -table too: the file that the table of confidences"
        " is written to"
      : !(args.found("calibrate") || computes || writes || args.found("folder"))
      ? "Give -folder with the folder of the cases"
      : nullptr;
    if (missing)
    {
        FatalErrorInFunction << missing << exit(FatalError);
    }
    if (args.found("make"))
    {
        casesOf(args);
    }
}


//- Of an option, from where the program was started
fileName path(const argList& args, const word& option, const fileName& byDefault)
{
    fileName path(args.getOrDefault<fileName>(option, byDefault));
    return path.toAbsolute();
}


//- Makes cases and their key, or goes on with the key that is there
void make
(
    const argList& args,
    const fileName& ensembles,
    const fileName& folder,
    const fileName& keyFile
)
{
    const bool isGiven = args.found("seed");
    const label seed =
        isGiven ? number(args, "seed") : label(std::random_device()() >> 1);
    mkDir(folder);

    // Before an ensemble is computed
    if (!isFile(keyFile, false))
    {
        const json key = {{"seed", seed}, {"cases", json::array()}};
        writeWhole(keyFile, key.dump(1) + '\n');
    }
    else if (isGiven && readJson(keyFile)["seed"] != seed)
    {
        FatalErrorInFunction
            << "The key " << keyFile << " has another seed than " << seed
            << ". Leave -seed out to go on with it, or remove it and its cases"
            << exit(FatalError);
    }
    concealedSide truth(args.path(), ensembles, "truth", args.found("solver"));
    const fileName kept(args.found("keep") ? path(args, "keep", "") : fileName());
    makeCases(truth, folder, keyFile, casesOf(args), kept);
}


//- Computes a run of each of these ensembles again. Prints the largest difference, in
//  multiples of the uncertainty of a reading
void check(const fileName& slice, const fileName& ensembles, const wordList& sides)
{
    scalar largest = 0;
    for (const word& side : sides)
    {
        const fileName file(ensembles/side + ".txt");
        checkThere
        (
            file, "-make, -diagnose and -score without -solver compute that ensemble"
        );
        largest =
            max(largest, concealedSide(slice, ensembles, side, false).difference(1));
    }
    // A run of some seconds prints its progress before this
    Info<< "check " << largest << endl;
}


//- Writes the case of the library at the mean, with a mechanism in full or a parameter
//  one deviation higher
void writeCase
(
    const argList& args,
    const fileName& slice,
    const fileName& ensembles
)
{
    const fileName target(path(args, "write", ""));
    if (exists(target))
    {
        FatalErrorInFunction
            << target << " is there already: name a folder that is not, or remove it"
            << exit(FatalError);
    }
    concealedSide library(slice, ensembles, "library", true);
    const word with(args.getOrDefault("with", word()));
    runState state;
    for (const parameter& p : readParameters(library.dict().subDict("parameters")))
    {
        state.parameters.insert(p.name, p.mean + (p.name == with ? p.deviation : 0));
    }
    wordList names(state.parameters.sortedToc());
    for (const candidate& c : readCandidates(library.dict().subDict("candidates")))
    {
        names.append(c.name);
        state.strengths.insert(c.name, c.name == with ? 1 : 0);
    }
    if (with.size() && !names.found(with))
    {
        FatalErrorInFunction
            << "The library has no " << with << ". It has:"
            << keywords::listed(names).c_str() << exit(FatalError);
    }
    state.replicate = args.found("replicate") ? number(args, "replicate") : 0;
    library.makeCase(state, target);
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    Foam::answerVersion(argc, argv);
    addOptions();
    startSerialTool();
    const argList args(argc, argv);
    checkAction(args);
    if (args.found("calibrate"))
    {
        const fileName cases(args.get<fileName>("calibrate"));
        writeWhole(path(args, "table", ""), fittedTable(readKnownCases(cases)));
        return 0;
    }
    const fileName slice(args.path());
    const fileName folder(path(args, "folder", ""));
    const fileName key(path(args, "key", folder/"key.json"));
    const fileName ensembles(path(args, "ensemble", slice/"ensemble"));
    if (args.found("write"))
    {
        writeCase(args, slice, ensembles);
        return 0;
    }
    const bool solver = args.found("solver");
    // The solver's truth has no ensemble
    const wordList sides
    (
        solver ? wordList({"library"}) : wordList({"library", "truth"})
    );
    if (args.found("compute"))
    {
        for (const word& side : sides)
        {
            concealedSide(slice, ensembles, side, false, number(args, "compute"));
        }
        return 0;
    }
    const bool diagnoses = args.found("diagnose");

    if (args.found("make"))
    {
        make(args, ensembles, folder, key);
    }
    if (diagnoses || args.found("score"))
    {
        concealedSide library(slice, ensembles, "library", solver && diagnoses);
        if (diagnoses)
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
        check(slice, ensembles, sides);
    }
    return 0;
}
