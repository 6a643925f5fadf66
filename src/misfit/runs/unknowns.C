// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnosis may set: the parameters that the base model has, and the
// mechanisms that it may lack.

#include "unknowns.H"
#include "ListOps.H"
#include "keywords.H"
#include "scalarList.H"

namespace
{

using namespace Foam;

//- One change beside the other keys, or a list of them
List<misfit::caseChange> changesOf(const dictionary& dict)
{
    List<misfit::caseChange> changes(misfit::readChanges(dict, "changes"));
    bool follows = false;
    for (const misfit::caseChange& c : changes)
    {
        follows = follows || !c.isFixed();
    }
    if (!follows)
    {
        FatalIOErrorInFunction(dict)
            << dict.dictName() << " changes nothing: its list  changes  needs"
            << " an entry without value, which then takes the number"
            << exit(FatalIOError);
    }
    return changes;
}


List<misfit::expectedSign> signsOf(const dictionary& dict)
{
    List<misfit::expectedSign> signs;
    if (dict.found("signs"))
    {
        for (const wordList& s : dict.get<List<wordList>>("signs"))
        {
            if (s.size() != 3 || (s[2] != "up" && s[2] != "down"))
            {
                FatalIOErrorInFunction(dict)
                    << "A sign is (quantity feature up|down), for instance"
                    << " (pressure peak up); this is"
                    << keywords::listed(s).c_str()
                    << exit(FatalIOError);
            }
            if (!misfit::featureNames.found(s[1]))
            {
                FatalIOErrorInFunction(dict)
                    << "The feature " << s[1] << " of a sign is not known."
                    << " Valid names:"
                    << keywords::listed(misfit::featureNames).c_str()
                    << exit(FatalIOError);
            }
            signs.append({s[0], s[1], s[2] == "up" ? 1.0 : -1.0});
        }
    }
    return signs;
}


//- Fatal where runs do not reach what was measured, or are nearer together than that is
//  known
void checkMeasured(const dictionary& dict, const misfit::parameter& p)
{
    const bool isCovered = mag(p.measured - p.mean) <= 2*p.deviation;
    const bool isInBounds = p.measured >= p.lower && p.measured <= p.upper;
    const bool isBetter = p.measuredDeviation > 0 && p.measuredDeviation <= p.deviation;
    if (!isCovered || !isInBounds || !isBetter)
    {
        FatalIOErrorInFunction(dict)
            << "The parameter " << p.name << " is measured (" << p.measured << ' '
            << p.measuredDeviation << "): give the value, within the bounds (" << p.lower
            << ' ' << p.upper << ") and two deviations of the mean " << p.mean
            << ", as runs reach no further, and its standard deviation, above zero and at"
            << " most that of the runs, " << p.deviation << exit(FatalIOError);
    }
}


misfit::parameter readParameter(const word& name, const dictionary& dict)
{
    keywords::check(dict, {"changes", "mean", "deviation", "measured", "bounds"});
    const Tuple2<scalar, scalar> bounds
    (
        dict.get<Tuple2<scalar, scalar>>("bounds")
    );
    const scalar mean = dict.get<scalar>("mean");
    const scalar deviation = dict.get<scalar>("deviation");
    const Tuple2<scalar, scalar> measured
    (
        dict.getOrDefault("measured", Tuple2<scalar, scalar>(mean, deviation))
    );
    const misfit::parameter p
    {
        name,
        changesOf(dict),
        mean,
        deviation,
        bounds.first(),
        bounds.second(),
        measured.first(),
        measured.second(),
        dict.found("measured")
    };
    if (p.deviation <= 0 || p.mean < p.lower || p.mean > p.upper)
    {
        FatalIOErrorInFunction(dict)
            << "The parameter " << name << " has the mean " << p.mean
            << ", the deviation " << p.deviation << " and the bounds "
            << bounds << ". The deviation must be above zero, and the mean"
            << " within the bounds" << exit(FatalIOError);
    }
    checkMeasured(dict, p);
    return p;
}


misfit::candidate readCandidate(const word& name, const dictionary& dict)
{
    keywords::check
    (
        dict, {"title", "changes", "strengths", "upper", "bound", "signs"}
    );
    const scalarList strengths
    (
        dict.getOrDefault("strengths", scalarList({0.5, 1}))
    );
    if (strengths.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "The candidate " << name << " has " << strengths.size()
            << " strengths. Give two, a weak and a strong one, as"
            << "  strengths (0.5 1);" << exit(FatalIOError);
    }
    const misfit::candidate c
    {
        name,
        dict.getOrDefault<string>("title", name),
        changesOf(dict),
        strengths[0],
        strengths[1],
        dict.getOrDefault<scalar>("upper", strengths[1]),
        dict.getOrDefault<scalar>("bound", GREAT),
        signsOf(dict)
    };
    if (c.weak <= 0 || c.strong <= c.weak || c.upper < c.strong)
    {
        FatalIOErrorInFunction(dict)
            << "The candidate " << name << " has the strengths " << flatOutput(strengths)
            << " and the upper bound " << c.upper << ": the first strength must be"
            << " above zero, the second larger, and upper no smaller than that"
            << exit(FatalIOError);
    }
    return c;
}

} // End anonymous namespace


Foam::List<Foam::misfit::parameter>
Foam::misfit::readParameters(const dictionary& dict)
{
    List<parameter> list;
    for (const entry& e : dict)
    {
        list.append(readParameter(e.keyword(), e.dict()));
    }
    return list;
}


Foam::List<Foam::misfit::candidate>
Foam::misfit::readCandidates(const dictionary& dict)
{
    List<candidate> list;
    for (const entry& e : dict)
    {
        list.append(readCandidate(e.keyword(), e.dict()));
    }
    return list;
}
