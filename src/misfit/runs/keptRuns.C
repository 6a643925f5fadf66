// SPDX-License-Identifier: GPL-3.0-or-later
// A file of runs that grows while they are made.

#include "keptRuns.H"
#include "shortNumber.H"
#include "textFile.H"

#include "clockTime.H"
#include "OSspecific.H"
#include "SubList.H"

#include <cmath>
#include <fstream>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::misfit::keptRuns::lines
(
    const label run,
    const prediction& p
) const
{
    std::ostringstream os;
    os << names[run] << '\n';
    if (!p.ok())
    {
        os << "failed\n";
    }
    forAll(p.channels, c)
    {
        const series& s = p.channels[c];
        if (p.ok() && s.x.size())
        {
            os << recorded.channels()[c].name << ' ' << s.x.first() << ' ' << step;
            for (const scalar y : s.y)
            {
                os << ' ' << y;
            }
            os << '\n';
        }
    }
    return os.str();
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::prediction
Foam::misfit::keptRuns::reduced(const prediction& p, const scalar step)
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
            few.y.append(rounded(s(i*step)));
        }
        r.channels.append(few);
    }
    return r;
}


Foam::List<Foam::misfit::prediction> Foam::misfit::keptRuns::read() const
{
    List<prediction> runs;
    if (!isFile(file, false))
    {
        return runs;
    }
    std::ifstream is(file);
    std::string line;
    const auto stop = [this](const std::string& why)
    {
        FatalErrorInFunction
            << "The ensemble " << file << ' ' << why.c_str() << ". Delete it to have it"
            << " computed anew" << exit(FatalError);
    };
    const auto nextLine = [&]
    {
        // A line without an end may have lost values
        if (!std::getline(is, line) || is.eof())
        {
            stop("ends within a run");
        }
    };
    nextLine();
    if (line != head)
    {
        stop
        (
            "is of runs with other formulas, files, numbers or channels than the"
            " dictionary of its side has now"
        );
    }
    while (runs.size() < states.size() && is.peek() != EOF)
    {
        const label i = runs.size();
        nextLine();
        if (line != names[i])
        {
            stop
            (
                "is of another design: run " + std::to_string(i + 1) + " should be "
              + names[i]
            );
        }
        prediction p;
        for (const channel& c : recorded.channels())
        {
            p.channels.append(series());
            if (c.experiment == states[i].experiment && p.ok())
            {
                nextLine();
                p.channels.last() = readSeries(line);
                if (line == "failed")
                {
                    p.failure = "failed when the ensemble was made";
                }
            }
        }
        runs.append(p);
    }
    return runs;
}


Foam::List<Foam::misfit::prediction> Foam::misfit::keptRuns::grown
(
    solverPredictor& ask,
    const label most,
    const label batch
) const
{
    List<prediction> runs(read());
    const label before = runs.size();
    const label end = before + min(most, states.size() - before);
    string text(before ? contentOf(file) : head + '\n');
    const clockTime timer;
    mkDir(file.path());
    while (runs.size() < end)
    {
        const label first = runs.size();
        const label n = min(batch, end - first);
        Info<< file.name() << " has " << first << " of " << states.size() << " runs";
        if (first > before)
        {
            const scalar each = timer.elapsedTime()/(first - before);
            Info<< ", about " << std::ceil(each*(end - first)/60) << " min for the "
                << end - first << " to do";
        }
        Info<< endl;

        const List<runState> some(SubList<runState>(states, n, first));
        const List<prediction> more(ask.predict(some));
        for (label i = 0; i < n && !ask.wasKilled(some[i]); ++i)
        {
            runs.append(reduced(more[i], step));
            text += lines(first + i, runs.last());
        }
        writeWhole(file, text);
        if (runs.size() < first + n)
        {
            FatalErrorInFunction
                << "A run was killed by somebody else, perhaps by a machine without room: "
                << names[runs.size()].c_str() << ". Start this again: " << file
                << " has the " << runs.size() << " before it" << exit(FatalError);
        }
    }
    Info<< file.name() << " has " << end << " of " << states.size() << " runs" << endl;
    return runs;
}
