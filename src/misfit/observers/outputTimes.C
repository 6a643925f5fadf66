// SPDX-License-Identifier: GPL-3.0-or-later
// What a case will write for its channels, as far as its controlDict shows.

#include "observer.H"
#include "keywords.H"
#include "numberTable.H"
#include "StringStream.H"

#include <cmath>

namespace
{

using namespace Foam;

//- Times at which a table is written: every so often, and how much later at most [s]
struct rhythm
{
    //- Nought: each step, or not known
    scalar every = 0;

    scalar late = 0;
};


//- By writeControl and writeInterval of a controlDict or of a function object
rhythm ownRhythm(const dictionary& dict, const scalar step)
{
    const word control(dict.getOrDefault<word>("writeControl", "timeStep"));
    const bool adjusts = control == "adjustableRunTime" || control == "adjustable";
    rhythm r;
    if (adjusts || control == "runTime")
    {
        r.every = dict.getOrDefault<scalar>("writeInterval", 0);
        r.late = adjusts ? 0 : step;
    }
    return r;
}


rhythm rhythmOf(const dictionary& function, const dictionary& control)
{
    // A run may take longer steps than its first one
    const scalar step =
        max
        (
            control.getOrDefault<scalar>("deltaT", 0),
            control.getOrDefault<scalar>("maxDeltaT", 0)
        );
    const word by(function.getOrDefault<word>("writeControl", word()));
    if (by != "writeTime" && by != "outputTime")
    {
        return ownRhythm(function, step);
    }
    rhythm r(ownRhythm(control, step));
    r.every *= max(1, function.getOrDefault<label>("writeInterval", 1));
    return r;
}

} // End anonymous namespace


Foam::string Foam::misfit::observer::doubtOfTable(const dictionary& control) const
{
    const channel& c = of;
    const word name(c.simulated.getOrDefault<word>("function", word()));
    const dictionary functions(keywords::sub(control, "functions"));
    if (name.empty() || functions.empty())
    {
        return "";
    }

    OStringStream os;
    if (!functions.isDict(name))
    {
        os  << "reads what the function object " << name << " writes, and"
            << " system/controlDict has none of that name:"
            << keywords::listed(functions.toc()).c_str() << ". Correct function, or add"
            << " it, unless something else writes postProcessing/" << name;
        return os.str();
    }

    const rhythm r(rhythmOf(functions.subDict(name), control));
    if (c.at <= 0 || r.every <= 0)
    {
        return "";
    }
    const scalar start = control.getOrDefault<scalar>("startTime", 0);
    const scalar nearest = start + r.every*std::round((c.at - start)/r.every);

    if (mag(nearest - c.at) > nearEnough(c.at) + r.late)
    {
        os  << "is at " << c.at << " s, and the function object " << name
            << " writes every " << r.every << " s: the nearest is " << nearest
            << " s. Correct at, or let it write at that time (system/controlDict)";
    }
    return os.str();
}
