// SPDX-License-Identifier: GPL-3.0-or-later
// Files that OpenFOAM began and did not end.

#include "truncatedFiles.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <cctype>

namespace
{

using namespace Foam;

//- True where a file holds the parts of all ranks
bool collated(const fileName& file)
{
    // processors4, or processors4_0-1; not a folder of the user's
    const std::string name("/processors");
    const auto at = file.rfind(name);

    return
        at != std::string::npos && at + name.size() < file.size()
     && std::isdigit(file[at + name.size()]);
}


//- True where a file ends as OpenFOAM ends its files. OpenFOAM's own streams do
//  not report what is lost when the last part of a file is flushed
bool ended(const fileName& file)
{
    IFstream is(file.hasExt("gz") ? fileName(file.lessExt()) : file);

    if (is.stdStream().peek() == EOF)
    {
        return false;
    }

    std::string line;
    std::getline(is.stdStream(), line);
    if (line.substr(0, 4) != "/*--")
    {
        return true;
    }
    if (is.compression() == IOstream::UNCOMPRESSED)
    {
        is.stdStream().seekg(-16, std::ios::end);
    }

    std::string lastLine;
    while (std::getline(is.stdStream(), line))
    {
        lastLine = line.empty() ? lastLine : line;
    }

    const std::string ending("** //");

    // A collated file ends with the list of bytes of the last rank
    const bool endsWithBytes =
        lastLine == "0" || (lastLine.size() && lastLine.back() == ')');

    return
        (collated(file) && endsWithBytes)
     || (
            lastLine.size() >= ending.size()
         && lastLine.substr(lastLine.size() - ending.size()) == ending
        );
}

} // End anonymous namespace


Foam::fileName Foam::truncatedFile(const fileName& folder, const fileName& but)
{
    for (const fileName& file : readDir(folder, fileName::FILE, false))
    {
        if (folder/file != but && !ended(folder/file))
        {
            return folder/file;
        }
    }
    for (const fileName& sub : readDir(folder, fileName::DIRECTORY))
    {
        const fileName file(truncatedFile(folder/sub, but));

        if (file.size())
        {
            return file;
        }
    }

    return fileName();
}
