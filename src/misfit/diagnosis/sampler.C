// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded and what a state gives for it, as samples.

#include "sampler.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

vec toVec(const scalarList& list)
{
    return Eigen::Map<const vec>(list.cdata(), list.size());
}


segment describe(const channel& c, const label first)
{
    segment s;
    s.name = c.name();
    s.quantity = c.quantity();
    s.first = first;
    s.size = c.size();
    s.x = toVec(c.centre());
    s.span = c.span();
    s.overTime = c.overTime();
    s.hasPlace = c.hasPlace();
    s.place = c.place();
    s.uncertainty = c.uncertainty();
    s.memory = c.memory();
    s.gainUncertainty = c.gainUncertainty();
    s.zeroUncertainty = c.zeroUncertainty();

    const labelList n(c.readings());
    s.readings.resize(n.size());
    forAll(n, i)
    {
        s.readings[i] = n[i];
    }
    return s;
}

} // End anonymous namespace


Foam::misfit::stacked Foam::misfit::stack
(
    const recordings& all,
    const labelList& channels
)
{
    stacked data;
    label n = 0;
    for (const label i : channels)
    {
        data.segments.append(describe(all.channels()[i], n));
        n += all.channels()[i].size();
    }
    data.y.resize(n);
    forAll(channels, i)
    {
        data.segments[i].of(data.y) =
            toVec(all.channels()[channels[i]].sampled());
    }
    return data;
}


Foam::misfit::vec Foam::misfit::stack
(
    const recordings& all,
    const labelList& channels,
    const prediction& p
)
{
    scalarList values;
    for (const label i : channels)
    {
        values.append(all.channels()[i].sampled(p.channels[i]));
    }
    return toVec(values);
}


Foam::misfit::predictedSampler::predictedSampler
(
    const recordings& all,
    predictor& p
)
:
    recordings_(all),
    predictor_(p)
{
    wordList names(all.experiments(purpose::fit));
    names.append(all.experiments(purpose::gate));
    names.append(all.experiments(purpose::score));
    for (const word& e : names)
    {
        data_.append
        ({
            e,
            all.use(e),
            stack(all, channels(e, purpose::fit)),
            stack(all, channels(e, purpose::gate)),
            stack(all, channels(e, purpose::score))
        });
    }
}


Foam::labelList Foam::misfit::predictedSampler::channels
(
    const word& experiment,
    const purpose use
) const
{
    return recordings_.select(experiment, use);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::predictedSampler::operator()(const List<runState>& states)
{
    const List<prediction> predicted(predictor_.predict(states));
    List<samples> all(states.size());
    forAll(states, i)
    {
        const prediction& p = predicted[i];
        const word& e = states[i].experiment;
        all[i].failure = p.failure;
        if (p.ok())
        {
            all[i].fit = stack(recordings_, channels(e, purpose::fit), p);
            all[i].gate = stack(recordings_, channels(e, purpose::gate), p);
            all[i].score = stack(recordings_, channels(e, purpose::score), p);
        }
    }
    return all;
}
