// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, each kept under the hash of its case, so that none is done twice.

#include "runStore.H"
#include "programFiles.H"
#include "textFile.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "Time.H"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <sstream>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- In the folder of a run that is tried again: how it failed before
const word failedBefore("failedBefore");


//- How a run ended, by the file that etc/misfitRun writes then. Its first line is "ok
//  <seconds>", "failed <seconds> exit <status>" or "failed <seconds> limit <seconds>";
//  the reason and the solver's words follow. No file, an empty one, or a failure without
//  exit or limit (versions before 0.4): it has not ended, or nobody knows how
struct runEnd
{
    const fileName file;

    //- All of the file
    const string content;

    //- ok or failed
    std::string how;

    //- Time that it took [s]
    scalar seconds = 0;

    //- Exit status of the command that failed; 0: none did, or it was out of time
    label exitStatus = 0;

    //- The limit that it did not keep [s]; -1: it did
    scalar limit = -1;


    explicit runEnd(const fileName& run)
    :
        file(run/"finished"),
        content(contentOf(file))
    {
        std::istringstream line(content.substr(0, content.find('\n')));
        std::string key;
        scalar value = 0;

        line >> how >> seconds;
        if (line >> key >> value)
        {
            if (key == "limit")
            {
                limit = value;
            }
            else if (key == "exit")
            {
                exitStatus = label(value);
            }
        }
    }

    bool isKnown() const
    {
        return isWell() || (how == "failed" && (exitStatus || limit >= 0));
    }

    bool isWell() const
    {
        return how == "ok";
    }

    //- It did not fail by itself: out of time, killed (SIGKILL), or ended (SIGTERM)
    bool isStopped() const
    {
        return limit >= 0 || exitStatus == 128 + SIGKILL || exitStatus == 128 + SIGTERM;
    }

    //- The reason and the solver's words
    string words() const
    {
        return content.substr(std::min(content.find('\n'), content.size()));
    }
};


string inQuotes(const fileName& path)
{
    return "'" + path + "'";
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::misfit::runStore::name(const runRequest& run) const
{
    string all(template_.hash + '\n' + run.description);
    for (const string& c : commands_)
    {
        all += '\n' + c;
    }
    return word(SHA1(all).digest().str().substr(0, 12), false);
}


Foam::string Foam::misfit::runStore::commandLines() const
{
    string lines;
    for (const string& c : commands_)
    {
        lines += c + '\n';
    }
    return lines;
}


bool Foam::misfit::runStore::canContinue(const word& name) const
{
    const fileName target(folder_/name);
    if
    (
        isFile(target/"finished", false)
     || !isFile(target/"ranks", false)
     || contentOf(target/"commands") != commandLines()
     || contentOf(target/"programs") != programFiles(commands_, folder_/"run"/"case")
    )
    {
        return false;
    }
    IFstream is(target/"case"/"system"/Time::controlDictName);
    return dictionary(is).getOrDefault<word>("startFrom", "latestTime") == "latestTime";
}


void Foam::misfit::runStore::prepare
(
    const word& name,
    const runRequest& run
) const
{
    const fileName target(folder_/name);
    const runEnd end(target);
    const string failed
    (
        end.isKnown() && !end.isStopped()
      ? end.content : contentOf(target/failedBefore)
    );
    if (isDir(target))
    {
        rmDir(target);
    }
    template_.copy(target/"case");
    run.change(target/"case");
    if (failed.size())
    {
        writeWhole(target/failedBefore, failed);
    }

    writeWhole(target/"about", run.description + '\n');
    writeWhole(target/"programs", programFiles(commands_, folder_/"run"/"case"));
    writeWhole(target/"commands", commandLines());
}


void Foam::misfit::runStore::takeLock()
{
    lock_ = ::open((folder_/"lock").c_str(), O_CREAT | O_RDWR, 0644);
    if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB))
    {
        Info<< "Another misfitFoam works in " << folder_
            << ", or runs that it had begun do: waiting for them" << endl;
        ::flock(lock_, LOCK_EX);
    }
}


void Foam::misfit::runStore::make(const wordHashSet& todo) const
{
    rm(folder_/"progress");
    string command
    (
        "RANKS=" + Foam::name(ranks_)
      + " TIME_LIMIT=" + Foam::name(timeLimit_)
      + " RUNS=" + Foam::name(todo.size())
      + " STARTED=$(date +%s)"
      + " make --no-print-directory -s -C " + inQuotes(folder_)
      + " -f \"$INTERDEMFOAM_DIR/etc/misfitRuns.mk\" -j " + Foam::name(jobs_)
    );
    for (const word& run : todo.sortedToc())
    {
        command += ' ' + run + "/finished";
    }

    if (Foam::system(command))
    {
        FatalErrorInFunction
            << "The runs in " << folder_ << " were stopped. Those that are"
            << " finished are kept: start misfitFoam again to go on"
            << exit(FatalError);
    }
    for (const word& run : todo)
    {
        if (!runEnd(folder_/run).isKnown())
        {
            FatalErrorInFunction
                << "It is not known how the run " << folder_/run << " ended: it"
                << " has no file 'finished', or an empty one. Is the disk full, or"
                << " the folder not yours to write? Correct that and start misfitFoam"
                << " again to go on" << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::runStore::runStore
(
    const fileName& folder,
    const dictionary& dict
)
:
    folder_(folder/"misfit"/"runs"),
    commands_(dict.get<stringList>("commands")),
    dictName_(dict.name()),
    template_
    (
        folder,
        dict.getOrDefault("files", fileNameList()),
        dictName_.name(),
        commands_
    ),
    ranks_(dict.getOrDefault<label>("ranks", 1)),
    jobs_
    (
        dict.getOrDefault<label>
        (
            "jobs",
            max
            (
                label(std::thread::hardware_concurrency())/max(ranks_, 1),
                label(1)
            )
        )
    ),
    timeLimit_(dict.getOrDefault<label>("timeLimit", 86400)),
    lock_(-1),
    warnedOfPrograms_(false)
{
    if (commands_.empty() || ranks_ < 1 || jobs_ < 1 || timeLimit_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "commands must name the programs of a run, the solver last;"
            << " ranks, jobs and timeLimit must be 1 or more"
            << exit(FatalIOError);
    }
    checkCut();
    mkDir(folder_);
}


Foam::misfit::runStore::~runStore()
{
    if (lock_ >= 0)
    {
        ::close(lock_);
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::fileName Foam::misfit::runStore::caseOf(const runRequest& run) const
{
    return folder_/name(run)/"case";
}


bool Foam::misfit::runStore::isFinished(const runRequest& run) const
{
    const word runName(name(run));
    const runEnd end(folder_/runName);
    if (!end.isKnown() || end.isWell() || attempts_.found(runName))
    {
        return end.isKnown();
    }
    if (end.limit >= 0)
    {
        return timeLimit_ <= end.limit;
    }

    // That it failed need not be its own fault: the disk may have been full. But
    // what fails twice is not to cost a run in each call
    return isFile(folder_/runName/failedBefore, false) && !end.isStopped();
}


Foam::string Foam::misfit::runStore::failure(const runRequest& run) const
{
    const runEnd end(folder_/name(run));
    if (end.isWell())
    {
        return string();
    }
    return
        end.words().size()
      ? end.words()
      : string("how it ended is not known: no reason stands in " + end.file);
}


bool Foam::misfit::runStore::wasStopped(const runRequest& run) const
{
    return runEnd(folder_/name(run)).isStopped();
}


Foam::scalar Foam::misfit::runStore::seconds(const runRequest& run) const
{
    return runEnd(folder_/name(run)).seconds;
}


void Foam::misfit::runStore::makeCase
(
    const fileName& target,
    const runRequest& run
) const
{
    template_.copy(target);
    run.change(target);
    template_.checkUnchanged();
}


void Foam::misfit::runStore::finish(const List<runRequest>& runs)
{
    if (lock_ < 0)
    {
        takeLock();
    }
    checkSamePrograms(runs);

    wordHashSet todo;
    label failed = 0;
    label continued = 0;
    for (const runRequest& run : runs)
    {
        const word runName(name(run));
        if (isFinished(run) || !todo.insert(runName))
        {
            continue;
        }
        if (canContinue(runName))
        {
            ++continued;
            continue;
        }
        failed += isFile(folder_/runName/"finished", false);
        prepare(runName, run);
    }
    if (todo.empty())
    {
        return;
    }

    template_.checkUnchanged();
    attempts_ |= todo;
    if (failed)
    {
        Info<< "    Of these runs, " << failed << " failed in an earlier call and"
            << " are tried again" << endl;
    }
    if (continued)
    {
        Info<< "    Of these runs, " << continued << " were cut short in an earlier"
            << " call and go on" << endl;
    }
    make(todo);
}
