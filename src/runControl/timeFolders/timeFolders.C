// SPDX-License-Identifier: GPL-3.0-or-later
// Which time folders are complete, and from which one a run goes on.

#include "timeFolders.H"

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "foamCompatibility.H"
#include "truncatedFiles.H"
#include "timeOnDisk.H"

#include <fcntl.h>
#include <unistd.h>

namespace
{

using namespace Foam;

//- The file that marks a time folder as complete
fileName markOf(const fileName& folder)
{
    return folder/"uniform"/"complete";
}


//- A file or folder; one that cannot be opened is cut off or absent, which is
//  looked for later
void bringOneToDisk(const fileName& path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);

    if (file >= 0)
    {
        ::fsync(file);
        ::close(file);
    }
}


//- Have the system put all that is written below a folder on its disk: file by
//  file, and last the folder, so that the names are there too. Of the machine's
//  other files nothing is waited for
void bringToDisk(const fileName& folder)
{
    for (const fileName& file : readDir(folder, fileName::FILE, false))
    {
        bringOneToDisk(folder/file);
    }
    for (const fileName& sub : readDir(folder, fileName::DIRECTORY))
    {
        bringToDisk(folder/sub);
    }
    bringOneToDisk(folder);
}


//- The greatest time with a mark, that of any time without; less than any
//  time where there is none
scalar last(const fileName& root, const bool marked)
{
    scalar result = -VGREAT;

    for (const instant& time : Time::findTimes(root))
    {
        if (isFile(markOf(root/time.name())) == marked)
        {
            result = max(result, time.value());
        }
    }

    return result;
}


//- Mark the present time as complete where it is whole on all ranks; else
//  stop. broken is a file that is cut off, if any
void mark
(
    const Time& runTime,
    bool whole,
    fileName broken = fileName()
)
{
    const fileName path(markOf(timeOnDisk(runTime)));

    if (returnReduce(whole, andOp<bool>()))
    {
        mkDir(path.path());
        OFstream os(path);
        os << "// Every file of this time was written" << nl;
        os.flush();
        whole = os.good();
        broken = whole ? fileName() : path;
    }

    if (!returnReduce(whole, andOp<bool>()))
    {
        timeFolders::unmark(runTime);

        // No mark is left where a rank ends all of them
        compatibility::barrier();

        if (!whole)
        {
            timeFolders::stopIncomplete
            (
                runTime,
                broken.size()
              ? broken + " is cut off"
              : "a file is absent or cut off"
            );
        }
        compatibility::barrier();
    }
}

} // End anonymous namespace


void Foam::timeFolders::putIncompleteAside(const argList& args)
{
    const fileName control
    (
        args.globalPath()/"system"/Time::controlDictName
    );

    if
    (
        !isFile(control)
     || dictionary(IFstream(control)()).getOrDefault<word>
        (
            "startFrom",
            ""
        ) != "latestTime"
    )
    {
        return;
    }

    // With collated files, ranks share their folders
    const fileName root(fileHandler().filePath(args.path()));
    const bool mine = Pstream::master() || root == args.path();

    // One rank may have written what another had not
    const scalar complete = returnReduce(last(root, true), minOp<scalar>());
    const scalar latest = returnReduce
    (
        max(last(root, true), last(root, false)),
        maxOp<scalar>()
    );

    if (complete == -VGREAT || latest <= complete)
    {
        return;
    }

    for (const instant& time : Time::findTimes(root))
    {
        if (mine && time.value() > complete)
        {
            const fileName folder(root/time.name());
            const fileName aside(folder + ".incomplete");

            if (isDir(aside))
            {
                rmDir(aside);
            }
            mv(folder, aside);
        }
    }

    // Before any rank looks for times
    compatibility::barrier();

    Info<< "Time " << latest << " was not written completely (killed, a"
        << " full disk, or a flow that diverged?): it is now " << latest
        << ".incomplete," << nl
        << "    and this run goes on from " << complete << nl << endl;
}


void Foam::timeFolders::unmark(const Time& runTime)
{
    rm(markOf(timeOnDisk(runTime)));
}


void Foam::timeFolders::markStopRequested(const Time& runTime)
{
    const fileName folder(timeOnDisk(runTime)/"uniform");
    mkDir(folder);
    OFstream(folder/"stopRequested")() << "// The run ended here on request" << nl;
}


void Foam::timeFolders::stopIncomplete(const Time& runTime, const string& why)
{
    FatalErrorInFunction
        << "Time " << runTime.timeName() << " could not be written"
        << " completely: " << why.c_str() << nl
        << "    Is the disk full? Look with:  df -h "
        << runTime.globalPath() << nl
        << "    Make room and start again: with startFrom latestTime"
        << " the run goes on from the last complete time."
        << exit(FatalError);
}


void Foam::timeFolders::markWritten(const Time& runTime, const bool complete)
{
    // Everything must be on the disk before the mark is
    fileHandler().flush();
    // Collated files are the first rank's: the others wait for it
    compatibility::barrier();
    const fileName folder(timeOnDisk(runTime));
    bringToDisk(folder);
    bringOneToDisk(folder.path());
    const fileName broken(truncatedFile(folder, markOf(folder)));
    mark(runTime, complete && broken.empty(), broken);
}


bool Foam::timeFolders::marked(const Time& runTime)
{
    return returnReduce(isFile(markOf(timeOnDisk(runTime))), andOp<bool>());
}


void Foam::timeFolders::markStart(const Time& runTime)
{
    if (!marked(runTime))
    {
        mark(runTime, true);
    }
}
