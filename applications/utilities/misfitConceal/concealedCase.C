// SPDX-License-Identifier: GPL-3.0-or-later
// What is the matter with a case, drawn at random, and what it makes of a record.

#include "concealedCase.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;

//- Time between two readings [s]
const scalar step = 0.005;

} // End anonymous namespace


Foam::misfit::series Foam::misfit::concealedCase::recorded
(
    const series& truth,
    const word& channel
) const
{
    series s;
    const word how = channel == faulty ? fault : word();
    const scalar end = truth.x.last();
    const auto extremes = std::minmax_element(truth.y.cbegin(), truth.y.cend());
    const scalar range = *extremes.second - *extremes.first;
    const scalar late = jitter + (how == "clock" ? faultSize : 0);
    scalar shown = truth(0);
    for (label i = 2; i*step < end - 0.02; ++i)
    {
        const scalar t = i*step;
        scalar y = truth(max(t - late, 0.0));
        if (how == "gain")
        {
            y *= 1 + faultSize;
        }
        else if (how == "zero")
        {
            y += faultSize*range;
        }
        else if (how == "drift")
        {
            y += faultSize*range*t/end;
        }
        else if (how == "lag")
        {
            shown += (y - shown)*(1 - std::exp(-step/faultSize));
            y = shown;
        }
        s.x.append(t);
        s.y.append(y);
    }
    return s;
}


Foam::misfit::drawing::drawing
(
    const dictionary& dict,
    const wordList& outside,
    const wordList& channels,
    const label seed
)
:
    generator_(seed),
    parameters_(readParameters(dict.subDict("parameters"))),
    outside_(outside),
    channels_(channels)
{
    for (const candidate& c : readCandidates(dict.subDict("candidates")))
    {
        candidates_.insert(c.name, c);
        if (!outside.found(c.name))
        {
            library_.append(c.name);
        }
    }
    if (library_.size() < 2 || outside_.empty() || channels_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The truth needs two candidates of the library, one that"
            << " the entry outside names, and a channel to fit"
            << exit(FatalIOError);
    }
}


void Foam::misfit::drawing::add(concealedCase& c, const word& name)
{
    c.mechanisms.append(name);
    c.state.strengths.insert
    (
        name, uniform(candidates_[name].weak, candidates_[name].strong)
    );
}


void Foam::misfit::drawing::addFault(concealedCase& c)
{
    c.faulty = channels_[pick(channels_.size())];
    c.fault = wordList({"gain", "zero", "lag", "drift", "clock"})[pick(5)];
    const scalar side = pick(2) ? 1 : -1;
    c.faultSize =
        c.fault == "gain" ? side*uniform(0.1, 0.3)
      : c.fault == "lag" ? uniform(0.03, 0.12)
      : c.fault == "clock" ? side*uniform(0.03, 0.1)
      : side*uniform(0.05, 0.2);
}


Foam::misfit::concealedCase Foam::misfit::drawing::draw()
{
    concealedCase c;
    const scalar lot = any_(generator_);
    for (const parameter& p : parameters_)
    {
        // As far as an ensemble reaches
        const scalar z = min(max(normal_(generator_), -2.0), 2.0);
        const scalar x = p.mean + p.deviation*z;
        c.state.parameters.insert(p.name, min(max(x, p.lower), p.upper));
    }
    c.jitter = 0.005*normal_(generator_);
    c.level = pick(2) ? 2 : 1;
    if (lot < 0.3)
    {
        c.kind = "null";
    }
    else if (lot < 0.55)
    {
        c.kind = "single";
        add(c, library_[pick(library_.size())]);
    }
    else if (lot < 0.67)
    {
        c.kind = "pair";
        const label i = pick(library_.size());
        const label j = (i + 1 + pick(library_.size() - 1)) % library_.size();
        add(c, library_[i]);
        add(c, library_[j]);
    }
    else if (lot < 0.82)
    {
        c.kind = "outside";
        add(c, outside_[pick(outside_.size())]);
    }
    else
    {
        c.kind = "sensor";
        addFault(c);
    }
    return c;
}


void Foam::misfit::drawing::addNoise(series& s, const scalar deviation)
{
    scalar slow = normal_(generator_);
    const scalar keep = std::exp(-step/0.02);
    for (scalar& y : s.y)
    {
        slow = keep*slow + Foam::sqrt(1 - keep*keep)*normal_(generator_);
        y +=
            deviation
           *(Foam::sqrt(0.8)*normal_(generator_) + Foam::sqrt(0.2)*slow);
    }
}
