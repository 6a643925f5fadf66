// SPDX-License-Identifier: GPL-3.0-or-later
// Extent of a scar along the flume, and the phases of erosion in time.

#include "erosionPhases.H"

Foam::erosionExtent::erosionExtent
(
    const strips& depth,
    const scalar start,
    const scalar threshold
)
:
    length(0),
    end(start),
    eroded(0),
    deposited(0)
{
    bool inside = false;
    bool ended = false;

    forAll(depth.values(), i)
    {
        const scalar right = depth.start() + (i + 1)*depth.width();
        const scalar width = min(depth.width(), right - start);

        if (width <= SMALL*depth.width())
        {
            continue;
        }

        const scalar h = depth.values()[i];
        const bool deep = h > threshold;

        eroded += max(h, scalar(0))*width;
        deposited += max(-h, scalar(0))*width;
        length += deep ? width : 0;

        if (deep && !ended)
        {
            inside = true;
            end = right;
        }
        ended = ended || (inside && !deep);
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
        netEnd = rate.lastAbove(share*peakRate);
    }
}
