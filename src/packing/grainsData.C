// SPDX-License-Identifier: GPL-3.0-or-later
// Grains as a LIGGGHTS data file, for its command read_data.

#include "grainsData.H"
#include "OSspecific.H"
#include "error.H"
#include "ListOps.H"

#include <fstream>
#include <limits>

namespace Foam
{
namespace
{

void writeHeader
(
    std::ostream& os,
    const packedGrains& grains,
    const boundBox& domain,
    const string& title,
    const label materials
)
{
    const label types =
        grains.size() ? max(materials, max(grains.material)) : materials;

    os  << title << "\n\n"
        << grains.size() << " atoms\n"
        << types << " atom types\n";

    for (direction d = 0; d < 3; ++d)
    {
        const char axis = char('x' + d);
        os  << domain.min()[d] << ' ' << domain.max()[d] << ' '
            << axis << "lo " << axis << "hi\n";
    }
    os  << '\n';
}


void writeAtoms(std::ostream& os, const packedGrains& grains)
{
    if (!grains.size())
    {
        return;
    }

    os  << "Atoms\n\n";
    forAll(grains.position, i)
    {
        const point& p = grains.position[i];
        os  << i + 1 << ' ' << grains.material[i] << ' '
            << grains.diameter[i] << ' ' << grains.density[i] << ' '
            << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
}


//- Number of grains announced in the header; stops behind its last line
label readHeader(std::istream& is)
{
    label n = -1;
    std::string line;

    while (std::getline(is, line) && line != "Atoms")
    {
        const auto words = line.find(" atoms");
        if (words != std::string::npos && words + 6 == line.size())
        {
            n = label(std::atol(line.c_str()));
        }
    }
    return n;
}

} // End anonymous namespace
} // End namespace Foam


void Foam::writeGrainsData
(
    const fileName& file,
    const packedGrains& grains,
    const boundBox& domain,
    const string& title,
    const label materials
)
{
    const fileName aside(file + ".incomplete");
    {
        std::ofstream os(aside);
        os.precision(std::numeric_limits<scalar>::max_digits10);
        writeHeader(os, grains, domain, title, materials);
        writeAtoms(os, grains);
        os.close();

        if (!os)
        {
            FatalErrorInFunction
                << "Could not write " << grains.size() << " grains to "
                << aside << ": is the disk full, may the folder be written to?"
                << exit(FatalError);
        }
    }

    if (!mv(aside, file))
    {
        FatalErrorInFunction
            << "Could not rename " << aside << " to " << file
            << ". Is the folder yours to write?" << exit(FatalError);
    }
}


bool Foam::readGrainsData(const fileName& file, packedGrains& grains)
{
    std::ifstream is(file);
    const label n = readHeader(is);
    if (!is || n < 0)
    {
        return false;
    }

    grains.position.resize(n);
    grains.diameter.resize(n);
    grains.density.resize(n);
    grains.material.resize(n);

    for (label i = 0; i < n; ++i)
    {
        label id;
        point& p = grains.position[i];
        is  >> id >> grains.material[i]
            >> grains.diameter[i] >> grains.density[i]
            >> p.x() >> p.y() >> p.z();
    }
    return bool(is);
}
