// SPDX-License-Identifier: GPL-3.0-or-later
// Some channels of the experiment that is fitted, as if only these were recorded.

#include "channelSelection.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

constexpr purpose eachUse[] = {purpose::calibration, purpose::validation, purpose::test};

} // End anonymous namespace


Foam::misfit::allChannels::allChannels(const observation& fitted, const label repeats)
{
    label n = 0;
    for (const purpose use : eachUse)
    {
        for (segment s : fitted.of(use).segments)
        {
            s.readings *= scalar(repeats)/s.repeats;
            s.repeats = repeats;
            s.first = n;
            n += s.size;
            data_.segments.push_back(s);
            uses_.append(use);
        }
    }
    data_.y = join({fitted.calibration.y, fitted.validation.y, fitted.test.y});
}


Foam::misfit::vec Foam::misfit::allChannels::join(const byUse<vec>& run)
{
    vec all(run.calibration.size() + run.validation.size() + run.test.size());
    all << run.calibration, run.validation, run.test;
    return all;
}


void Foam::misfit::channelSelection::add
(
    const allChannels& all,
    const label channel,
    const purpose use
)
{
    segment s(all.data().segments[channel]);
    std::vector<int>& rows = rows_.of(use);
    const label first = s.first;
    s.first = rows.size();
    for (label k = 0; k < s.size; ++k)
    {
        rows.push_back(first + k);
    }
    data_.first().of(use).segments.push_back(s);
}


Foam::misfit::channelSelection::channelSelection
(
    sampler& simulation,
    const allChannels& all,
    const vec& y,
    const wordList& toFit,
    const bool validates
)
:
    simulation_(simulation),
    data_(1),
    isSelection_(validates || toFit.size() < all.uses().size())
{
    data_.first().experiment = simulation.data().first().experiment;
    data_.first().use = purpose::calibration;
    forAll(all.uses(), i)
    {
        if (toFit.found(word(all.data().segments[i].name, false)))
        {
            add(all, i, purpose::calibration);
        }
        else if (validates && all.uses()[i] == purpose::validation)
        {
            add(all, i, purpose::validation);
        }
    }
    for (const purpose use : eachUse)
    {
        data_.first().of(use).y = y(rows_.of(use));
    }
    data_.first().possible.y.resize(0);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::channelSelection::operator()(const List<runState>& states)
{
    List<samples> some(simulation_(states));
    for (samples& s : some)
    {
        if (s.ok())
        {
            const vec all = allChannels::join(s);
            for (const purpose use : eachUse)
            {
                s.of(use) = all(rows_.of(use));
            }
            s.possible.resize(0);
        }
    }
    return some;
}
