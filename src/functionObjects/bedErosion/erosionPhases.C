// SPDX-License-Identifier: GPL-3.0-or-later
// Extent of a scar along the flume, and the phases of erosion in time.

#include "erosionPhases.H"

#include "DynamicList.H"

Foam::erosionExtent::erosionExtent
(
    const strips& depth,
    const scalar start,
    const scalar threshold,
    const scalar height
)
:
    length(0),
    end(start),
    raisedEnd(start),
    eroded(0),
    deposited(0)
{
    DynamicList<scalar> x;
    DynamicList<scalar> h;

    forAll(depth.values(), i)
    {
        const scalar right = depth.start() + (i + 1)*depth.width();
        const scalar width = min(depth.width(), right - start);

        if (width > 0)
        {
            h.append(depth.values()[i]);
            x.append(max(depth.centre(i), start));

            eroded += max(h.last(), scalar(0))*width;
            deposited += max(-h.last(), scalar(0))*width;
            raisedEnd = -h.last() > height ? right : raisedEnd;
        }
    }

    length = sampleSeries(x, h).durationAbove(threshold);

    // The first crossing from above to below
    for (label i = 1; i < x.size(); ++i)
    {
        if (h[i - 1] > threshold)
        {
            end = x[i];

            if (h[i] <= threshold)
            {
                const scalar share = (h[i - 1] - threshold)/(h[i - 1] - h[i]);
                end = x[i - 1] + share*(x[i] - x[i - 1]);
                break;
            }
        }
    }
}


Foam::erosionPhases::erosionPhases
(
    const sampleSeries& depth,
    const sampleSeries& rate,
    const scalar onset,
    const scalar share
)
:
    netStart(GREAT),
    netEnd(GREAT),
    peakRate(0),
    peakTime(GREAT)
{
    const scalarList& h = depth.values();

    for (label i = 0; i < h.size(); ++i)
    {
        if
        (
            mag(h[i]) > onset
         && (i + 1 == h.size() || mag(h[i + 1]) > onset)
        )
        {
            netStart = depth.times()[i];
            break;
        }
    }

    const label peak = rate.peak();

    if (peak >= 0 && rate.values()[peak] > 0 && netStart < GREAT)
    {
        peakRate = rate.values()[peak];
        peakTime = rate.times()[peak];
        if (rate.values().last() <= share*peakRate)
        {
            netEnd = rate.lastAbove(share*peakRate);
        }
    }
}
