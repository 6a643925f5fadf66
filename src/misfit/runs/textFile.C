// SPDX-License-Identifier: GPL-3.0-or-later
// A file of text, read and written as a whole.

#include "textFile.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <fstream>
#include <iterator>

Foam::string Foam::misfit::contentOf(const fileName& file)
{
    IFstream is(file);
    return string
    (
        std::string
        (
            std::istreambuf_iterator<char>(is.stdStream()),
            std::istreambuf_iterator<char>()
        )
    );
}


void Foam::misfit::writeWhole(const fileName& file, const std::string& text)
{
    const fileName half(file + ".new");
    std::ofstream os(half);
    os << text;

    // What is in its buffer may not fit onto the disk either
    os.close();
    if (!os || !mv(half, file))
    {
        FatalErrorInFunction
            << "Could not write " << file << ": is the disk full, or the folder"
            << " not yours to write?" << exit(FatalError);
    }
}
