// SPDX-License-Identifier: GPL-3.0-or-later
// Which mechanisms an experiment could distinguish, before it is done.

#include "channelRanking.H"
#include "designDraws.H"
#include "experimentDesign.H"

const Foam::misfit::designRow& Foam::misfit::experimentDesign::row
(
    const word& mechanism,
    const scalar strength,
    const label repeats
) const
{
    for (const designRow& r : rows)
    {
        if (r.mechanism == mechanism && r.strength == strength && r.repeats == repeats)
        {
            return r;
        }
    }
    FatalErrorInFunction
        << "The design has no row of " << mechanism << ' ' << strength << " with "
        << repeats << " repeats" << exit(FatalError);
    return rows.first();
}


Foam::label Foam::misfit::experimentDesign::repeatsNeeded
(
    const word& mechanism,
    const scalar strength
) const
{
    label least = 0;
    for (const designRow& r : rows)
    {
        const bool its = r.mechanism == mechanism && r.strength == strength;
        if (its && r.share(r.named) >= probability && (!least || r.repeats < least))
        {
            least = r.repeats;
        }
    }
    return least;
}


void Foam::misfit::checkStrengths
(
    const dictionary& dict,
    const designSettings& design,
    const settings& set
)
{
    for (const candidate& c : set.candidates)
    {
        for (const scalar strength : design.strengths)
        {
            if (strength*c.strong > c.upper*(1 + SMALL))
            {
                FatalIOErrorInFunction(dict)
                    << "In design, the strength " << strength << " is "
                    << strength*c.strong << " of the candidate " << c.name
                    << ", and no fit goes beyond its upper, " << c.upper
                    << ". Take " << strength << " out of strengths; where the"
                    << " case takes such a strength, set upper " << strength*c.strong
                    << "; in the candidate" << exit(FatalIOError);
            }
        }
    }
}


Foam::misfit::experimentDesign Foam::misfit::designExperiment
(
    sampler& simulation,
    const settings& set,
    const designSettings& design,
    const label jobs
)
{
    designDraws draws(simulation, set, design, jobs);
    experimentDesign all;
    all.channels = design.channels;
    all.probability = design.probability;
    forAll(set.candidates, m)
    {
        if (!draws.running().found(m))
        {
            all.failing.append(set.candidates[m].name);
        }
    }
    for (const label repeats : design.repeats)
    {
        const simulatedRecordings recordings(simulation, draws.set(), repeats);
        for (const simulatedCause& c : draws.causes())
        {
            all.rows.append(draws.row(recordings, c, design.channels, repeats));
        }
    }

    const label repeats = design.repeats.first();
    const simulatedRecordings recordings(simulation, draws.set(), repeats);
    all.options = rankedChannels(draws, recordings, all, repeats);
    return all;
}
