// SPDX-License-Identifier: GPL-3.0-or-later
// Which one more channel would help most to distinguish mechanisms.

#include "channelRanking.H"

#include <algorithm>
#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Standard error of a mean
scalar standardErrorOf(const std::vector<scalar>& values)
{
    const scalar n = values.size();
    if (n < 2)
    {
        return GREAT;
    }
    const vec v = Eigen::Map<const vec>(values.data(), values.size());
    return std::sqrt((v.array() - v.mean()).square().sum()/(n - 1)/n);
}


//- Marks the options that are behind the first by no more than twice the standard error
//  of the difference: the draws are the same with each channel
void markTied(List<designOption>& options)
{
    for (designOption& o : options)
    {
        std::vector<scalar> behind(o.gains);
        for (size_t k = 0; k < behind.size(); ++k)
        {
            behind[k] = options.first().gains[k] - o.gains[k];
        }
        const scalar mean = options.first().gain() - o.gain();
        o.isTied = mean <= 2*standardErrorOf(behind);
    }
    const label tied = std::count_if
    (
        options.begin(), options.end(), [](const designOption& o) { return o.isTied; }
    );
    if (tied == 1)
    {
        options.first().isTied = false;
    }
}


//- Of the rows of a mechanism with so many repeats the one nearest to one half
const designRow& leastCertain
(
    const List<designRow>& rows,
    const word& mechanism,
    const label repeats
)
{
    const designRow* best = nullptr;
    const auto distance = [](const designRow& r) { return mag(r.share(r.named) - 0.5); };

    // Of those that are never named the strongest: there a channel may help
    const auto isNearer = [&](const designRow& r)
    {
        return
            distance(r) < distance(*best)
         || (distance(r) == distance(*best) && r.share(r.named) < 0.5);
    };
    for (const designRow& r : rows)
    {
        const bool its = r.mechanism == mechanism && r.repeats == repeats;
        if (its && (!best || isNearer(r)))
        {
            best = &r;
        }
    }
    return *best;
}


//- What a channel adds where names are least certain
designOption withChannel
(
    designDraws& draws,
    const simulatedRecordings& recordings,
    const experimentDesign& known,
    const word& channel,
    const label repeats
)
{
    designOption option;
    option.channel = channel;
    wordList channels(known.channels);
    channels.append(channel);
    const scalar n = draws.running().size();
    for (const label m : draws.running())
    {
        const designRow& without =
            leastCertain(known.rows, draws.set().candidates[m].name, repeats);
        const designRow with
        (
            draws.row(recordings, {m, without.strength}, channels, repeats)
        );
        option.gains.resize(with.namedIn.size());
        for (size_t k = 0; k < with.namedIn.size(); ++k)
        {
            option.gains[k] += with.namedIn[k] - without.namedIn[k];
        }
        option.before += without.share(without.named);
        option.after += with.share(with.named);
        option.rows.append(with);
    }

    // At the end: all of them are 1, and none of them 0, to the last bit
    for (scalar& gain : option.gains)
    {
        gain /= n;
    }
    option.before /= n;
    option.after /= n;
    return option;
}

} // End anonymous namespace


Foam::scalar Foam::misfit::designOption::standardError() const
{
    return standardErrorOf(gains);
}


Foam::List<Foam::misfit::designOption> Foam::misfit::rankedChannels
(
    designDraws& draws,
    const simulatedRecordings& recordings,
    const experimentDesign& known,
    const label repeats
)
{
    List<designOption> options;
    for (const word& channel : possibleChannels(recordings.all(), known.channels))
    {
        options.append(withChannel(draws, recordings, known, channel, repeats));
    }
    std::stable_sort
    (
        options.begin(), options.end(),
        [](const designOption& a, const designOption& b)
        {
            return a.gain() > b.gain();
        }
    );
    markTied(options);
    return options;
}
