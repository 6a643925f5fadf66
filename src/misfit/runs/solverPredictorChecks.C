// SPDX-License-Identifier: GPL-3.0-or-later
// What a run would show to be wrong with a case, reported before it or after the
// first.

#include "solverPredictor.H"

#include "OSspecific.H"
#include "polyMesh.H"
#include "Time.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- A case that is read sets the precision of all new streams. With another one a
//  second predictor of this program would give the same runs other names
class keptPrecision
{
    const unsigned before_ = IOstream::defaultPrecision();

public:

    ~keptPrecision()
    {
        IOstream::defaultPrecision(before_);
    }
};


//- Fraction of the mesh that water filled in the first step, by the log of interFoam or
//  interDEMFoam in the folder of a run [-]; -1 if no log has it
scalar waterAtFirst(const fileName& caseFolder)
{
    const std::string words("Phase-1 volume fraction = ");
    for (const fileName& log : readDir(caseFolder, fileName::FILE))
    {
        if (log.compare(0, 4, "log.") != 0)
        {
            continue;
        }
        std::ifstream is(caseFolder/log);
        for (std::string line; std::getline(is, line);)
        {
            if (line.compare(0, words.size(), words) == 0)
            {
                return std::atof(line.c_str() + words.size());
            }
        }
    }
    return -1;
}


//- The time until which a channel must be simulated [s]
scalar needed(const channel& c)
{
    return
        c.isRecorded() && c.overTime()
      ? c.recorded.x.last() - 0.5*c.samples.span
      : max(c.at, 0.0);
}


//- Empty, or which end of what was recorded a series does not reach
string partNotCovered(const channel& c, const series& s)
{
    // A cell centre is up to half a cell from the wall, and the first reading over
    // time stands after the first step. Single readings stand for as much as lies
    // between them
    const scalarList& x = c.recorded.x;
    const label n = s.x.size();
    const scalar lastStep = n > 1 ? s.x[n-1] - s.x[n-2] : 0;
    const scalar firstStep = n > 1 ? s.x[1] - s.x[0] : 0;
    const scalar firstSample =
        c.overTime() && c.samples.span == 0 ? x[1] - x[0] : c.samples.span;

    const scalar late = x.first() + max(0.5*firstSample, firstStep);
    const scalar enough =
        c.overTime() ? needed(c) : x.last() - max(0.5*c.samples.span, lastStep);

    const string whatToDo(", or give the channel an interval");
    if (s.x.first() > late)
    {
        return
            "it begins at " + Foam::name(s.x.first()) + " and the channel "
          + c.name + " was recorded from " + Foam::name(x.first())
          + ": have it begin earlier" + whatToDo;
    }
    if (s.x.last() < enough)
    {
        return
            "it ends at " + Foam::name(s.x.last()) + " and the channel "
          + c.name + " was recorded until " + Foam::name(x.last())
          + ": run longer" + whatToDo;
    }
    return "";
}

} // End anonymous namespace


void Foam::misfit::solverPredictor::checkPlacesIn
(
    const fileName& caseFolder,
    const word& experiment
)
{
    if
    (
        !isFile(caseFolder/"constant/polyMesh/faces")
     || !once_.insert("places" + experiment)
    )
    {
        return;
    }

    const keptPrecision after;
    Time runTime
    (
        Time::controlDictName, caseFolder.path(), caseFolder.name(),
        "system", "constant", false, false
    );
    const polyMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion, runTime.timeName(), runTime,
            IOobject::MUST_READ
        )
    );
    checkPlaces(mesh, observers_, experiment);
}


void Foam::misfit::solverPredictor::checkWater
(
    const runState& state,
    const runRequest& run
)
{
    runState withBase(state);
    withBase.resolution = "base";
    const runRequest base(request(withBase));
    if (state.isBase() || !store_.isFinished(base))
    {
        return;
    }
    const scalar here = waterAtFirst(store_.caseOf(run));
    const scalar there = waterAtFirst(store_.caseOf(base));

    // A level would be off by as much of its depth
    const scalar most = 0.005;
    if
    (
        here > 0 && there > 0 && mag(here/there - 1) > most
     && once_.insert("water" + state.resolution + state.experiment)
    )
    {
        WarningInFunction
            << "With other " << state.resolution << " the experiment "
            << state.experiment << " begins with " << 100*mag(here/there - 1)
            << " % " << (here > there ? "more" : "less")
            << " water. That counts as an error of numerics, in which"
            << " physics may hide." << nl << "    What setFields fills cell by cell"
            << " is the same where the water's surface lies on faces of both meshes"
            << endl;
    }
}


void Foam::misfit::solverPredictor::checkEnd
(
    const dictionary& control,
    const word& experiment
) const
{
    // Of a word a command may make a number before the run
    const entry* end = control.findEntry("endTime");
    const bool isNumber =
        end && end->isStream() && end->stream().size() == 1
     && end->stream()[0].isNumber();
    if (!isNumber)
    {
        return;
    }
    const scalar endTime = end->stream()[0].number();
    for (const channel& c : recordings_.channels())
    {
        if
        (
            c.experiment == experiment && endTime < needed(c)
         && once_.insert("end" + experiment)
        )
        {
            WarningInFunction
                << "endTime of the experiment " << experiment << " is "
                << endTime << " s, and its channel " << c.name
                << (c.overTime() ? " was recorded until " : " is wanted at ")
                << (c.overTime() ? c.recorded.x.last() : c.at)
                << " s: run longer (system/controlDict, or changes of the"
                << " experiment), or "
                << (c.overTime() ? "give the channel an interval" : "correct its at")
                << endl;
        }
    }
}


void Foam::misfit::solverPredictor::checkTables
(
    const dictionary& control,
    const word& experiment
) const
{
    if (!once_.insert("tables" + experiment))
    {
        return;
    }
    for (const observer& o : observers_)
    {
        const string doubt
        (
            o.of.experiment == experiment ? o.doubtOfTable(control) : string()
        );
        if (doubt.size())
        {
            WarningInFunction
                << "The channel " << o.of.name << ' ' << doubt.c_str() << endl;
        }
    }
}


Foam::string Foam::misfit::solverPredictor::fault
(
    const channel& c,
    const series& s
)
{
    if (s.x.empty())
    {
        return "it wrote nothing for the channel " + c.name;
    }
    const auto isNumber = [](const scalar value)
    {
        return std::isfinite(value) && mag(value) <= 1e100;
    };
    for (const scalarList* numbers : {&s.x, &s.y})
    {
        if (!std::all_of(numbers->begin(), numbers->end(), isNumber))
        {
            return "it gave no finite numbers for the channel " + c.name;
        }
    }
    if (!c.isRecorded())
    {
        return "";
    }

    return c.isNumber() ? string() : partNotCovered(c, s);
}


Foam::List<Foam::misfit::runState>
Foam::misfit::solverPredictor::statesWithAllChanges
(
    const word& experiment
) const
{
    runState base;
    base.experiment = experiment;
    for (const parameter& p : parameters_)
    {
        base.parameters.set(p.name, p.mean);
    }
    List<runState> states(1, base);

    for (const word& finer : resolutions_.sortedToc())
    {
        states.append(base);
        states.last().resolution = finer;
    }
    if (replicateChanges_.size())
    {
        states.append(base);
        states.last().replicate = 2;
    }
    for (const candidate& c : candidates_)
    {
        states.append(base);
        states.last().strengths.set(c.name, c.strong);
    }
    if (correction_.elements().size())
    {
        states.append(base);
        states.last().noting = true;
        for (const correctionElement& e : correction_.elements())
        {
            states.last().strengths.set(e.name, e.size);
        }
    }
    return states;
}


void Foam::misfit::solverPredictor::rehearse()
{
    if (!once_.insert("rehearsal"))
    {
        return;
    }

    List<runRequest> runs;
    for (const word& experiment : recordings_.experiments())
    {
        for (const runState& state : statesWithAllChanges(experiment))
        {
            runs.append(request(state));
        }
    }
    store_.rehearse(runs);
}
