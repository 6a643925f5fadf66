// SPDX-License-Identifier: GPL-3.0-or-later
// S8 in a diagnosis: a free correction where the verdict is unknown.

#include "diagnosis.H"
#include "unknownPath.H"

#include <cmath>

void Foam::misfit::diagnosis::correct()
{
    // Where the fitted channels agree there is nothing to fit it to
    if
    (
        found_.verdict != "unknown" || settings_.correction.empty()
     || !passed("detection")
    )
    {
        return;
    }

    const weighed base(baseline());
    unknownPath path
    (
        sampler_, settings_, bounds_, width_, *fit_, *gate_, base, elsewhere_
    );
    found_.correction = path(parameterDesign());

    const correctionFound& c = found_.correction;
    found_.nRuns += c.nRuns;
    found_.told += ' ' + c.told;
    if (c.after.size())
    {
        found_.after = c.after;
        found_.held = c.held;
    }
    if (!c.named)
    {
        return;
    }

    // A law of dimensionless numbers is a name, as sure as its lead
    const correctionFound::law& l = c.laws.first();
    word name(l.family);
    for (const word& group : l.groups)
    {
        name += ':' + group;
    }
    found_.verdict = "named";
    found_.names = wordList(1, name);
    found_.confidence = min
    (
        1/(1 + std::exp(-0.5*l.lead/settings_.temperature)), settings_.ceiling
    );
    found_.told = "Left out, and in no candidate: " + c.told;
}


Foam::List<Foam::Tuple2<Foam::string, Foam::List<Foam::misfit::runState>>>
Foam::misfit::diagnosis::correctionPlan() const
{
    List<Tuple2<string, List<runState>>> stages;
    if (settings_.correction.empty())
    {
        return stages;
    }
    List<runState> states;
    for (const correctionElement& e : settings_.correction)
    {
        for (label packing = 0; packing < settings_.common; ++packing)
        {
            states.append(state(bounds_.mean, packing));
            states.last().strengths.insert(e.name, e.size);
        }
    }
    states.append(state(bounds_.mean));
    states.last().noting = true;
    stages.append
    (
        Tuple2<string, List<runState>>
        (
            "S8 free correction, only where the verdict would be unknown"
            " (around the calibrated state, not the one shown)",
            states
        )
    );
    return stages;
}
