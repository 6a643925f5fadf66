// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded and what a state gives for it, as samples.

#include "sampler.H"

#include "Pair.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

void addTo(vec& sum, const vec& v)
{
    sum = sum.size() ? vec(sum + v) : v;
}


constexpr purpose uses[] = {purpose::calibration, purpose::validation, purpose::test};


vec toVec(const scalarList& list)
{
    return Eigen::Map<const vec>(list.cdata(), list.size());
}


segment segmentOf(const channel& c, const label first)
{
    segment s(c.samples);
    s.first = first;
    return s;
}


//- The samples of those recorded channels
stacked stack(const recordings& all, const labelList& channels)
{
    stacked data;
    label n = 0;
    for (const label i : channels)
    {
        data.segments.push_back(segmentOf(all.channels()[i], n));
        n += all.channels()[i].samples.size;
    }
    data.y.resize(n);
    forAll(channels, i)
    {
        const channel& c = all.channels()[channels[i]];
        data.segments[i].of(data.y) = toVec(c.sampled(c.recorded));
    }
    return data;
}


//- The samples that a prediction gives for them
vec stack(const recordings& all, const labelList& channels, const prediction& p)
{
    scalarList values;
    for (const label i : channels)
    {
        values.append(all.channels()[i].sampled(p.channels[i]));
    }
    return toVec(values);
}


//- First and last time of what was recorded of an experiment [s]
Pair<scalar> timesOf(const recordings& all, const word& experiment)
{
    Pair<scalar> times(GREAT, -GREAT);
    for (const channel& c : all.channels())
    {
        if (c.isRecorded() && c.overTime() && c.experiment == experiment)
        {
            times.first() = min(times.first(), c.samples.x[0]);
            times.second() = max(times.second(), c.samples.x.tail(1)[0]);
        }
    }
    return times;
}


//- Channels of an experiment that were not recorded, at 40 times of their
//  interval, or else of those that were
stacked possible(const recordings& all, const word& experiment)
{
    const wordList parts(all.parts(experiment));
    stacked data;
    label n = 0;
    for (const channel& c : all.channels())
    {
        const bool isPossible =
            !c.isRecorded() && c.overTime() && parts.found(c.experiment);
        const Pair<scalar> recorded(timesOf(all, c.experiment));
        const bool isLimited = c.interval.first() > -GREAT;
        const scalar from = isLimited ? c.interval.first() : recorded.first();
        const scalar to = isLimited ? c.interval.second() : recorded.second();
        if (isPossible && to > from)
        {
            segment s(segmentOf(c, n));
            s.size = 40;
            s.x = vec::LinSpaced(s.size, from, to);
            data.segments.push_back(s);
            n += s.size;
        }
    }
    data.y = vec::Zero(n);
    return data;
}


//- What a prediction gives for them
vec possibleStack
(
    const recordings& all,
    const List<observation>& observations,
    const word& experiment,
    const prediction& p
)
{
    scalarList values;
    for (const observation& o : observations)
    {
        for (const segment& s : o.possible.segments)
        {
            forAll(all.channels(), i)
            {
                const bool here =
                    o.experiment == experiment
                 && all.channels()[i].name == s.name;
                for (label k = 0; here && k < s.size; ++k)
                {
                    values.append(p.channels[i](s.x[k]));
                }
            }
        }
    }
    return toVec(values);
}


//- The predictions of the parts of an experiment as one, or the first failure
prediction joined
(
    const recordings& all,
    const UList<prediction>& parts,
    const word& experiment
)
{
    const wordList names(all.parts(experiment));
    prediction one(parts[0]);
    forAll(parts, k)
    {
        if (!parts[k].ok())
        {
            one.failure =
                (names.size() > 1 ? names[k] + ": " : string()) + parts[k].failure;
            return one;
        }
        forAll(parts[k].channels, i)
        {
            if (all.channels()[i].experiment == names[k])
            {
                one.channels[i] = parts[k].channels[i];
            }
        }
    }
    return one;
}

} // End anonymous namespace


void Foam::misfit::samples::add(const samples& other)
{
    if (!other.ok())
    {
        failure = other.failure;
        return;
    }
    for (const purpose use : uses)
    {
        addTo(of(use), other.of(use));
    }
    addTo(possible, other.possible);
    water = other.water;
}


void Foam::misfit::samples::divide(const scalar n)
{
    for (const purpose use : uses)
    {
        of(use) /= n;
    }
    possible /= n;
}


Foam::misfit::predictedSampler::predictedSampler
(
    const recordings& all,
    predictor& p,
    const List<runState>& trainingEnsemble
)
:
    recordings_(all),
    predictor_(p),
    trainingEnsemble_(trainingEnsemble)
{
    wordList names(1, all.calibrated());
    names.append(all.experiments(purpose::validation));
    names.append(all.experiments(purpose::test));
    for (const word& e : names)
    {
        observation o;
        o.experiment = e;
        o.use = all.use(all.parts(e).first());
        for (const purpose use : uses)
        {
            o.of(use) = stack(all, all.select(e, use));
        }
        o.possible = possible(all, e);
        data_.append(o);
    }
}


Foam::List<Foam::misfit::samples>
Foam::misfit::sampler::means(const List<runState>& states, const label n)
{
    List<runState> replicated;
    for (const runState& s : states)
    {
        for (label replicate = 0; replicate < n; ++replicate)
        {
            replicated.append(s);
            replicated.last().replicate = replicate;
        }
    }
    const List<samples> all((*this)(replicated));

    List<samples> mean(states.size());
    forAll(mean, i)
    {
        for (label replicate = 0; replicate < n; ++replicate)
        {
            mean[i].add(all[i*n + replicate]);
        }
        mean[i].divide(n);
    }
    return mean;
}


Foam::List<Foam::misfit::runState>
Foam::misfit::runsOf(const recordings& all, const List<runState>& states)
{
    List<runState> runs;
    for (const runState& s : states)
    {
        for (const word& part : all.parts(s.experiment))
        {
            runs.append(s);
            runs.last().experiment = part;
        }
    }
    return runs;
}


Foam::List<Foam::misfit::samples>
Foam::misfit::predictedSampler::operator()(const List<runState>& states)
{
    const List<prediction> predicted(predictor_.predict(runsOf(recordings_, states)));
    List<samples> all(states.size());
    label run = 0;
    forAll(states, i)
    {
        const word& e = states[i].experiment;
        const label n = recordings_.parts(e).size();
        const prediction p
        (
            joined(recordings_, SubList<prediction>(predicted, n, run), e)
        );
        run += n;
        all[i].failure = p.failure;
        if (p.ok())
        {
            for (const purpose use : uses)
            {
                all[i].of(use) = stack(recordings_, recordings_.select(e, use), p);
            }
            all[i].possible = possibleStack(recordings_, data_, e, p);
            all[i].water = p.water;
        }
    }
    return all;
}
