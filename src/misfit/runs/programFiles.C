// SPDX-License-Identifier: GPL-3.0-or-later
// Which programs make the runs, to tell when they are others.

#include "programFiles.H"

#include "OSspecific.H"
#include "fileNameList.H"
#include "stringOps.H"

#include <set>

namespace
{

using namespace Foam;

//- Where the shell finds a program; itself, if it has a path
fileName onPath(const string& program)
{
    const string path(getEnv("PATH"));
    for (const auto& folder : stringOps::split(path, ':'))
    {
        const fileName file(fileName(folder.str())/program);
        if (program.find('/') == string::npos && isFile(file, false))
        {
            return file;
        }
    }
    return program;
}

//- True of misfitFoam itself and of tests, which no run calls
bool isNoPartOfRuns(const fileName& name)
{
    return
        name.find("misfit") != string::npos || name.find("Test-") == 0;
}

} // End anonymous namespace


Foam::string Foam::misfit::programFiles(const stringList& commands)
{
    std::set<fileName> files;
    for (const string& c : commands)
    {
        const auto words(stringOps::splitSpace(c));
        if (words.size())
        {
            files.insert(onPath(words[0].str()));
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

    string told;
    for (const fileName& f : files)
    {
        told +=
            f + ' ' + std::to_string(fileSize(f)) + ' '
          + std::to_string(highResLastModified(f)) + '\n';
    }
    return told;
}
