// SPDX-License-Identifier: GPL-3.0-or-later
// The case that all runs are copies of.

#include "templateCase.H"
#include "textFile.H"

#include "OSspecific.H"
#include "SHA1.H"
#include "stringOps.H"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>

namespace
{

using namespace Foam;

//- True if one of the commands calls a program, also through another as mpirun
bool anyCalls(const stringList& commands, const string& program)
{
    for (const string& c : commands)
    {
        for (const auto& word : stringOps::splitSpace(c))
        {
            if (fileName(word.str()).name() == program)
            {
                return true;
            }
        }
    }
    return false;
}


//- All regular files below a folder, sorted
void filesBelow(const fileName& folder, fileNameList& files)
{
    for (const fileName& f : readDir(folder, fileName::FILE, false))
    {
        files.append(folder/f);
    }
    for (const fileName& d : readDir(folder, fileName::DIRECTORY))
    {
        filesBelow(folder/d, files);
    }
}


//- With the right to be run, which Foam::cp takes from scripts; programs of a run
//  may write into it
void copyFile(const fileName& from, const fileName& to)
{
    namespace fs = std::filesystem;
    const std::string copied(to);
    std::error_code failed;
    fs::copy_file
    (
        std::string(from), copied, fs::copy_options::overwrite_existing, failed
    );
    if (!failed)
    {
        fs::permissions
        (
            copied, fs::perms::owner_write, fs::perm_options::add, failed
        );
    }
    if (failed)
    {
        FatalErrorInFunction
            << "Could not copy " << from << " to " << to << ": "
            << failed.message().c_str() << exit(FatalError);
    }
}


string digest(const string& text)
{
    return SHA1(text).digest().str();
}


//- True of a dictionary of misfitFoam beside the one in use, by its name and its header:
//  a header alone may be a copy in a file that a program reads
bool isMisfitDict(const fileName& file)
{
    static const std::regex header(R"(FoamFile\s*\{[^}]*\bobject\s+misfitDict\s*;)");
    return
        file.name().find("misfitDict") == 0
     && std::regex_search(misfit::contentOf(file), header);
}


//- True if a command or a script works on the folder system, or on files there by a
//  pattern
bool worksOnSystem(const string& text)
{
    static const std::regex folder
    (
        R"((^|[\s"'=/(])system(/?($|[\s"';)&|])|/[^\s"';]*[*?\[$]))"
    );
    return std::regex_search(text, folder);
}


//- True if an include has a variable in the name of its file
bool includesVariable(const string& text)
{
    static const std::regex include(R"(#\s*include\w*\s+"[^"]*\$[^"/]*")");
    return std::regex_search(text, include);
}


//- True if a text may read a dictionary of misfitFoam. A word is sought before a pattern,
//  which takes long in a large file
bool mayReadMisfitDict(const string& text)
{
    const auto has = [&text](const char* word)
    {
        return text.find(word) != string::npos;
    };
    return
        has("misfitDict")
     || (has("include") && includesVariable(text))
     || (has("system") && !has("FoamFile") && worksOnSystem(text));
}


//- Fields of a template before a run
const string original("0.orig");


//- Folder or file of a run's case that a part of the template is in: what is in 0.orig
//  here is in 0 there
fileName inCase(const fileName& part)
{
    return
        part == original || part.find(original + '/') == 0
      ? fileName("0" + part.substr(original.size()))
      : part;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileNameList Foam::misfit::templateCase::parts() const
{
    fileNameList result;
    result.append(isDir(folder/original) ? original : string("0"));
    result.append("constant");
    result.append("system");
    result.append(files_);
    return result;
}


Foam::fileNameList Foam::misfit::templateCase::files() const
{
    fileNameList files;
    for (const fileName& part : parts())
    {
        if (isDir(folder/part))
        {
            filesBelow(folder/part, files);
        }
        else
        {
            files.append(folder/part);
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}


bool Foam::misfit::templateCase::isOwn(const fileName& file) const
{
    return file.name() == "misfitDict" || file.name() == dictionaryName_;
}


std::set<Foam::fileName> Foam::misfit::templateCase::spareDictionaries
(
    const fileNameList& files
) const
{
    std::set<fileName> spare;
    bool read = std::any_of(commands_.cbegin(), commands_.cend(), mayReadMisfitDict);
    for (const fileName& f : files)
    {
        if (f.find(folder/"system/") == 0 && !isOwn(f) && isMisfitDict(f))
        {
            spare.insert(f);
        }
        else if (!isOwn(f) && f.find("/polyMesh/") == string::npos)
        {
            read = read || mayReadMisfitDict(contentOf(f));
        }
    }
    return read ? std::set<fileName>() : spare;
}


std::map<Foam::fileName, Foam::string>
Foam::misfit::templateCase::digests() const
{
    const fileNameList those(files());
    const std::set<fileName> spare(spareDictionaries(those));
    std::map<fileName, string> all;
    for (const fileName& f : those)
    {
        const bool ofMesh = f.find("/polyMesh/") != string::npos;
        if (!isOwn(f) && !spare.count(f) && !(ofMesh && meshIsMade_))
        {
            all[f.substr(folder.size())] = digest(contentOf(f));
        }
    }
    return all;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::templateCase::templateCase
(
    const fileName& caseFolder,
    const fileNameList& files,
    const word& dictionaryName,
    const stringList& commands
)
:
    files_(files),
    dictionaryName_(dictionaryName),
    commands_(commands),
    meshIsMade_(anyCalls(commands, "blockMesh")),
    folder(caseFolder)
{
    for (const fileName& part : parts())
    {
        if (!exists(folder/part))
        {
            FatalErrorInFunction
                << "The case " << folder << " has no " << part.c_str()
                << ", which its runs are made of. Start misfitFoam in the folder of a"
                << " case, or correct files in its dictionary" << exit(FatalError);
        }
    }
    digests_ = digests();

    string all;
    for (const auto& file : digests_)
    {
        all += file.first + file.second + '\n';
    }
    hash = digest(all);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void Foam::misfit::templateCase::checkUnchanged() const
{
    const auto now(digests());
    std::map<fileName, string> changed;
    std::set_symmetric_difference
    (
        now.begin(), now.end(), digests_.begin(), digests_.end(),
        std::inserter(changed, changed.end())
    );
    if (changed.empty())
    {
        return;
    }

    string names;
    for (const auto& file : changed)
    {
        names += "\n        " + folder + file.first;
    }
    FatalErrorInFunction
        << "The case was changed while misfitFoam worked with it. Changed, added or"
        << " removed:" << names.c_str() << nl
        << "    Runs of two cases cannot be compared, so no more are done. Put this"
        << " back as it was and start misfitFoam again: it goes on. Or start it with"
        << " the case as it is now: its runs are done from the first" << exit(FatalError);
}


void Foam::misfit::templateCase::copy
(
    const fileName& target,
    const bool byLinks
) const
{
    if (isDir(target))
    {
        rmDir(target);
    }
    for (const fileName& f : files())
    {
        const fileName to(target/inCase(f.substr(folder.size() + 1)));
        mkDir(to.path());

        // Some file systems have no links. Through one that is there nothing is written
        if (!byLinks || !(exists(to) || ln(f, to)))
        {
            copyFile(f, to);
        }
    }
}


Foam::string Foam::misfit::templateCase::message
(
    const string& words,
    const fileName& copy
) const
{
    string text(words);
    if (isDir(folder/original))
    {
        text.replaceAll(copy/"0/", folder/(original + '/'));
    }
    text.replaceAll(copy, folder);
    return text;
}
