// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of an ensemble in one text file, so that a proof needs no solver.

#include "ensembleFile.H"
#include "textFile.H"

#include "error.H"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Time between two values [s]
const scalar step = 0.02;

scalar fourDigits(const scalar value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    return std::atof(text);
}


//- The next line; fatal if there is none
std::string nextLine(std::istream& is, const fileName& file)
{
    std::string line;
    if (!std::getline(is, line))
    {
        FatalErrorInFunction
            << "The ensemble " << file << " ends too early. Delete it to have it"
            << " computed anew" << exit(FatalError);
    }
    return line;
}


series readSeries(const std::string& line)
{
    std::istringstream is(line);
    std::string name;
    scalar first;
    scalar between;
    is >> name >> first >> between;
    series s;
    for (scalar y; is >> y;)
    {
        s.x.append(first + between*s.x.size());
        s.y.append(y);
    }
    return s;
}

} // End anonymous namespace


Foam::misfit::prediction
Foam::misfit::ensembleFile::reduced(const prediction& p)
{
    prediction r;
    r.failure = p.failure;
    for (const series& s : p.channels)
    {
        series few;
        const scalar end = s.x.empty() ? -1 : s.x.last();
        for (label i = 0; i*step <= end + 1e-9; ++i)
        {
            few.x.append(i*step);
            few.y.append(fourDigits(s(i*step)));
        }
        r.channels.append(few);
    }
    return r;
}


void Foam::misfit::ensembleFile::write
(
    const fileName& file,
    const recordings& channels,
    const string& digest,
    const List<runState>& states,
    const List<prediction>& runs
)
{
    std::ostringstream os;
    os << digest << '\n';
    forAll(states, i)
    {
        os << describe(states[i]) << '\n';
        if (!runs[i].ok())
        {
            os << "failed\n";
            continue;
        }
        forAll(runs[i].channels, c)
        {
            const series& s = runs[i].channels[c];
            if (s.x.size())
            {
                os << channels.channels()[c].name << ' ' << s.x.first()
                    << ' ' << step;
                for (const scalar y : s.y)
                {
                    os << ' ' << y;
                }
                os << '\n';
            }
        }
    }
    writeWhole(file, os.str());
}


Foam::List<Foam::misfit::prediction> Foam::misfit::ensembleFile::read
(
    const fileName& file,
    const recordings& channels,
    const string& digest,
    const List<runState>& states
)
{
    std::ifstream is(file);
    if (nextLine(is, file) != digest)
    {
        FatalErrorInFunction
            << "The ensemble " << file << " is of runs with other formulas, numbers or"
            << " channels than the dictionary of its side has now. Delete it to have"
            << " it computed anew" << exit(FatalError);
    }
    List<prediction> runs(states.size());
    forAll(states, i)
    {
        if (nextLine(is, file) != describe(states[i]))
        {
            FatalErrorInFunction
                << "The ensemble " << file << " is of another design: run "
                << i + 1 << " should be " << describe(states[i]).c_str()
                << ". Delete it to have it computed anew" << exit(FatalError);
        }
        for (const channel& c : channels.channels())
        {
            if (c.experiment == states[i].experiment && runs[i].ok())
            {
                const std::string line(nextLine(is, file));
                runs[i].channels.append(readSeries(line));
                if (line == "failed")
                {
                    runs[i].failure = "failed when the ensemble was made";
                }
            }
            else
            {
                runs[i].channels.append(series());
            }
        }
    }
    return runs;
}
