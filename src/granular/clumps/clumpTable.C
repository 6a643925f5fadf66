// SPDX-License-Identifier: GPL-3.0-or-later
// Places and orientations of clumps in a file, for the LIGGGHTS fix insert/clumps.

#include "clumpTable.H"

#include "OSspecific.H"
#include "Pstream.H"
#include "error.H"
#include "foamCompatibility.H"

#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

namespace
{

using namespace Foam;

//- The text of a file on all ranks: the first one alone reads it
string textOf(const fileName& file)
{
    string text;
    if (Pstream::master())
    {
        std::ifstream is(file);
        text = std::string(std::istreambuf_iterator<char>(is), {});
    }
    compatibility::broadcast(text);

    if (text.empty())
    {
        FatalErrorInFunction
            << "No clumps in " << file << ": it is absent or empty." << nl
            << "    Run preparePacking before, with clump in system/packingDict."
            << exit(FatalError);
    }
    return text;
}


//- A line of the table; false where it is none
bool readLine(const std::string& line, placedClump& clump)
{
    std::istringstream is(line);
    point& c = clump.centre;
    quaternion& q = clump.orientation;
    std::string more;

    is  >> clump.kind >> c.x() >> c.y() >> c.z()
        >> q.w() >> q.v().x() >> q.v().y() >> q.v().z();

    return is && !(is >> more) && Foam::mag(magSqr(q) - 1) < 1e-9;
}

} // End anonymous namespace


void Foam::writeClumpTable
(
    const fileName& file,
    const UList<placedClump>& clumps
)
{
    const fileName aside(file + ".incomplete");
    std::ofstream os(aside);
    os.precision(std::numeric_limits<scalar>::max_digits10);
    os  << clumps.size() << " clumps: template, centre [m], quaternion (w x y z)\n";

    for (const placedClump& clump : clumps)
    {
        const point& c = clump.centre;
        const quaternion& q = clump.orientation;
        os  << clump.kind << ' ' << c.x() << ' ' << c.y() << ' ' << c.z() << ' '
            << q.w() << ' ' << q.v().x() << ' ' << q.v().y() << ' ' << q.v().z()
            << '\n';
    }
    os.close();

    if (!os || !mv(aside, file))
    {
        FatalErrorInFunction
            << "Could not write " << clumps.size() << " clumps to " << file
            << ": is the disk full, may the folder be written to?"
            << exit(FatalError);
    }
}


Foam::DynamicList<Foam::placedClump> Foam::readClumpTable(const fileName& file)
{
    std::istringstream is(textOf(file));
    std::string line;
    label n = -1;
    std::getline(is, line);
    if (!(std::istringstream(line) >> n))
    {
        n = -1;
    }

    DynamicList<placedClump> result(max(n, 0));
    placedClump next;
    while (result.size() < n && std::getline(is, line) && readLine(line, next))
    {
        result.append(next);
    }
    bool more = false;
    while (result.size() == n && std::getline(is, line))
    {
        more = more || line.find_first_not_of(" \t\r") != std::string::npos;
    }
    if (more)
    {
        FatalErrorInFunction
            << file << " has more lines than the " << n << " clumps of its first line."
            << nl << "    Correct that number, or run preparePacking again to write the"
            << " file." << exit(FatalError);
    }
    if (result.size() != n)
    {
        FatalErrorInFunction
            << "Line " << result.size() + 2 << " of " << file << " is no clump: "
            << line.c_str() << nl
            << "    The first line is the number of clumps, here " << n
            << "; each other has a template, x y z and a quaternion (w x y z) of"
            << " length 1." << nl
            << "    Run preparePacking again to write the file." << exit(FatalError);
    }
    return result;
}
