// SPDX-License-Identifier: GPL-3.0-or-later
// Where a recording is from, as messages name it.

#include "recordedSource.H"

//- No column has it, since commas part the columns
static const char* const beforeColumn = ", column ";


Foam::string Foam::misfit::sourceOf(const fileName& file, const string& column)
{
    return file + beforeColumn + column;
}


Foam::fileName Foam::misfit::fileOfSource(const string& source)
{
    const size_t end = source.rfind(beforeColumn);
    return end == string::npos ? fileName() : fileName(source.substr(0, end));
}
