// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, each kept under the hash of its case: what can be wrong before they are made.

#include "runStore.H"
#include "failureOf.H"
#include "programFiles.H"
#include "temporaryFolder.H"
#include "textFile.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "stringOps.H"

void Foam::misfit::runStore::checkPrograms() const
{
    for (const string& c : commands_)
    {
        const auto words(stringOps::splitSpace(c));
        const string program(words.empty() ? string() : words[0].str());

        // What has a path may be made by an earlier command
        if
        (
            program.find('/') == string::npos
         && Foam::system("command -v '" + program + "' >/dev/null")
        )
        {
            FatalErrorInFunction
                << "There is no program '" << program.c_str() << "', which"
                << " commands in " << dictName_ << " begins with. Correct the"
                << " name, or build it" << exit(FatalError);
        }
    }
}


void Foam::misfit::runStore::checkSamePrograms(const List<runRequest>& runs)
{
    const string now(programFiles(commands_, folder_/"run"/"case"));
    wordHashSet others;
    for (const runRequest& run : runs)
    {
        const string then(contentOf(folder_/name(run)/"programs"));
        if (isFinished(run) && then.size() && then != now)
        {
            others.insert(name(run));
        }
    }

    if (others.size() && !warnedOfPrograms_)
    {
        warnedOfPrograms_ = true;
        WarningInFunction
            << "Finished runs in " << folder_ << " are used, although programs or"
            << " libraries changed since, " << others.sortedToc().first()
            << " for instance (reported once)." << nl
            << "    Remove their folders if the programs compute something else now."
            << endl;
    }
}


void Foam::misfit::runStore::checkCut() const
{
    const fileName file(template_.folder/"system"/"decomposeParDict");
    if (ranks_ == 1 || !isFile(file, false))
    {
        return;
    }

    // That of etc/cutAlong is written again for each number of ranks
    IFstream is(file);
    const dictionary cut(is);
    const label n = cut.get<label>("numberOfSubdomains");
    if (n != ranks_ && cut.getOrDefault<word>("cutBy", "") != "cutAlong")
    {
        FatalErrorInFunction
            << file << " cuts the case into " << n << " parts, and ranks in "
            << dictName_ << " is " << ranks_ << ". Let them be the same, or"
            << " remove the file: it is cut along x then" << exit(FatalError);
    }
}


void Foam::misfit::runStore::rehearse(const List<runRequest>& runs) const
{
    checkPrograms();
    fileName here;
    const string wrong
    (
        failureOf
        (
            [&]()
            {
                for (const runRequest& run : runs)
                {
                    const temporaryFolder scratch;
                    here = fileName(scratch)/"case";
                    template_.copy(here, true);
                    run.change(here);
                }
            }
        )
    );
    if (wrong.size())
    {
        FatalErrorInFunction
            << template_.message(wrong, here).c_str() << exit(FatalError);
    }
}
