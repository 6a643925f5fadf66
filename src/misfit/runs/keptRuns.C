// SPDX-License-Identifier: GPL-3.0-or-later
// A file of runs that grows while they are made.

#include "keptRuns.H"
#include "shortNumber.H"
#include "textFile.H"

#include "clockTime.H"
#include "OSspecific.H"
#include "HashSet.H"
#include "IndirectList.H"
#include "SubList.H"

#include <algorithm>
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


//- Stop for what a file of runs has
void refuse(const fileName& file, const char* why)
{
    FatalErrorInFunction
        << "The file of runs " << file << ' ' << why << ". Delete it to"
        << " compute them again" << exit(FatalError);
}


//- Read the next line of a file of runs; false where there is none
bool hasLine(std::istream& is, std::string& line, const fileName& file)
{
    const bool any = bool(std::getline(is, line));
    if (any && is.eof())
    {
        // Without its end it may have lost values
        refuse(file, "ends within a run");
    }
    return any;
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


bool Foam::misfit::keptRuns::isWhole(const runState& state, const prediction& p) const
{
    bool whole = true;
    forAll(recorded.channels(), c)
    {
        const bool its = recorded.channels()[c].experiment == state.experiment;
        whole = whole && (!its || p.channels[c].x.size());
    }
    return whole || !p.ok();
}


Foam::List<Foam::misfit::prediction> Foam::misfit::keptRuns::predictionsIn
(
    const table& runs
) const
{
    List<prediction> those;
    for (const string& name : names)
    {
        if (runs.found(name))
        {
            those.append(runs[name]);
        }
    }
    return those;
}


Foam::labelList Foam::misfit::keptRuns::missingRuns(const table& runs) const
{
    labelList some;
    HashSet<string, string::hash> seen;
    forAll(names, i)
    {
        if (!runs.found(names[i]) && seen.insert(names[i]))
        {
            some.append(i);
        }
    }
    return some;
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


Foam::misfit::keptRuns::table Foam::misfit::keptRuns::read() const
{
    table runs;
    if (!isFile(file, false))
    {
        return runs;
    }
    std::ifstream is(file);
    std::string line;
    if (!hasLine(is, line, file) || line != head)
    {
        refuse
        (
            file,
            "is of runs with other formulas, files, numbers or channels than the"
            " dictionary of its side has now"
        );
    }

    HashTable<label> numbers;
    forAll(recorded.channels(), c)
    {
        numbers.insert(recorded.channels()[c].name, c);
    }
    prediction* run = nullptr;
    while (hasLine(is, line, file))
    {
        const word first(line.substr(0, line.find(' ')), false);
        if (run && numbers.found(first))
        {
            run->channels[numbers[first]] = readSeries(line);
        }
        else if (run && first == "failed")
        {
            run->failure = "failed when the file was made";
        }
        else
        {
            run = &runs(line);
            *run = prediction();
            run->channels.setSize(numbers.size());
        }
    }
    forAll(names, i)
    {
        if (runs.found(names[i]) && !isWhole(states[i], runs[names[i]]))
        {
            refuse(file, "ends within a run");
        }
    }
    return runs;
}


void Foam::misfit::keptRuns::printPlan
(
    const table& runs,
    const scalar each,
    const label left
) const
{
    const label here =
        std::count_if(names.begin(), names.end(), [&](const string& name)
        {
            return runs.found(name);
        });
    Info<< file.name() << " has " << here << " of " << states.size() << " runs";
    if (left)
    {
        Info<< ", about " << std::ceil(each*left/60) << " min for the " << left
            << " to do";
    }
    Info<< endl;
}


void Foam::misfit::keptRuns::checkStopped(const stringList& stopped) const
{
    if (stopped.size())
    {
        FatalErrorInFunction
            << stopped.size() << " runs have no end, the first of them "
            << stopped[0].c_str() << ": they were killed by somebody else, perhaps by a"
            << " machine without room, or took longer than timeLimit, perhaps beside"
            << " others. Start this again, with a longer timeLimit in that case: "
            << file << " has those that ended" << exit(FatalError);
    }
}


Foam::List<Foam::misfit::prediction> Foam::misfit::keptRuns::predictions
(
    solverPredictor& solver,
    const label most,
    const label batch
) const
{
    table runs(read());
    const labelList todo(missingRuns(runs));
    const label end = min(most, todo.size());
    string text(isFile(file, false) ? contentOf(file) : head + '\n');
    const clockTime timer;
    mkDir(file.path());
    stringList stopped;
    for (label first = 0; first < end; first += batch)
    {
        const scalar perRun = timer.elapsedTime()/max(first, label(1));
        printPlan(runs, perRun, first ? end - first : 0);
        const labelList some(SubList<label>(todo, min(batch, end - first), first));
        const List<runState> missing(UIndirectList<runState>(states, some));
        const List<prediction> more(solver.predict(missing));
        forAll(some, i)
        {
            const string& name = names[some[i]];
            if (solver.wasStopped(missing[i]))
            {
                stopped.append(name);
                continue;
            }
            runs.set(name, reduced(more[i], step));
            text += lines(some[i], runs[name]);
        }
        writeWhole(file, text);
    }
    checkStopped(stopped);
    printPlan(runs, 0, 0);
    return predictionsIn(runs);
}
