// SPDX-License-Identifier: GPL-3.0-or-later
// Which programs make the runs, to detect when they change.

#include "programFiles.H"

#include "OSspecific.H"
#include "fileNameList.H"
#include "stringOps.H"

#include <set>

namespace
{

using namespace Foam;

//- Where the shell finds a program; empty: nowhere
fileName onPath(const string& program)
{
    const string path(getEnv("PATH"));
    for (const auto& folder : stringOps::split(path, ':'))
    {
        const fileName file(fileName(folder.str())/program);
        if (isFile(file, false))
        {
            return file;
        }
    }
    return fileName();
}

//- The file that a word of a command names, where it is no part of the case: that
//  is known by its content. Empty: none
fileName fileOf(const string& word, const bool isProgram, const fileName& folder)
{
    if (word.find('/') == string::npos)
    {
        return isProgram ? onPath(word) : fileName();
    }
    fileName file(word[0] == '/' ? fileName(word) : folder/word);
    file.clean();
    return isFile(file, false) && file.find(folder + '/') != 0 ? file : fileName();
}

//- True of misfitFoam itself and of tests, which no run calls
bool isNoPartOfRuns(const fileName& name)
{
    return
        name.find("misfit") != string::npos || name.find("Test-") == 0;
}

} // End anonymous namespace


Foam::string Foam::misfit::programFiles
(
    const stringList& commands,
    const fileName& folder
)
{
    std::set<fileName> files;
    for (const string& c : commands)
    {
        bool first = true;
        for (const auto& word : stringOps::splitSpace(c))
        {
            const fileName file(fileOf(word.str(), first, folder));
            if (file.size())
            {
                files.insert(file);
            }
            first = false;
        }
    }
    for (const char* name : {"FOAM_USER_LIBBIN", "FOAM_USER_APPBIN"})
    {
        const fileName folder(getEnv(name));
        for (const fileName& f : readDir(folder, fileName::FILE, false))
        {
            if (!isNoPartOfRuns(f))
            {
                files.insert(folder/f);
            }
        }
    }

    string lines;
    for (const fileName& f : files)
    {
        lines +=
            f + ' ' + std::to_string(fileSize(f)) + ' '
          + std::to_string(highResLastModified(f)) + '\n';
    }
    return lines;
}
