// SPDX-License-Identifier: GPL-3.0-or-later
// A fault between a channel and another of its quantity.

#include "twoChannelFault.H"

Foam::labelList Foam::misfit::twoChannelFault::alike
(
    const stacked& data,
    const label i
)
{
    const segment& a = data.segments[i];
    labelList all;
    forAll(data.segments, j)
    {
        const segment& b = data.segments[j];
        if
        (
            i != j && a.quantity == b.quantity && a.overTime == b.overTime
         && !a.isNumber() && !b.isNumber()
        )
        {
            all.append(j);
        }
    }
    return all;
}
