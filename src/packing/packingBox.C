// SPDX-License-Identifier: GPL-3.0-or-later
// The box a packing fills: each direction has either two walls or is periodic.

#include "packingBox.H"
#include "error.H"
#include "wordList.H"

Foam::packingBox::packingBox
(
    const boundBox& bounds,
    const FixedList<bool, 3>& periodic
)
:
    bounds_(bounds),
    periodic_(periodic)
{
    if (cmptMin(bounds_.span()) <= 0)
    {
        FatalErrorInFunction
            << "The box " << bounds_ << " has no volume: each coordinate of"
            << " its first corner must be below that of its second"
            << exit(FatalError);
    }
}


Foam::FixedList<bool, 3> Foam::packingBox::readPeriodic(const dictionary& dict)
{
    FixedList<bool, 3> periodic(false);

    for (const word& name : dict.getOrDefault("periodic", wordList()))
    {
        if (name != "x" && name != "y" && name != "z")
        {
            FatalIOErrorInFunction(dict)
                << "Unknown direction " << name << " in the entry periodic;"
                << " valid directions are x, y and z, for instance"
                << " periodic (y);" << exit(FatalIOError);
        }
        periodic[name[0] - 'x'] = true;
    }

    return periodic;
}


void Foam::packingBox::wrap(point& p) const
{
    for (direction d = 0; d < 3; ++d)
    {
        if (periodic_[d])
        {
            const scalar length = bounds_.max()[d] - bounds_.min()[d];
            p[d] -= length*std::floor((p[d] - bounds_.min()[d])/length);

            // floor() of a tiny negative distance leaves p on the far side
            if (p[d] >= bounds_.max()[d])
            {
                p[d] = bounds_.min()[d];
            }
        }
    }
}


void Foam::packingBox::clipToWalls(point& p, const scalar radius) const
{
    for (direction d = 0; d < 3; ++d)
    {
        if (!periodic_[d])
        {
            p[d] = max(p[d], bounds_.min()[d] + radius);
            p[d] = min(p[d], bounds_.max()[d] - radius);
        }
    }
}


Foam::vector Foam::packingBox::nearest(vector r) const
{
    for (direction d = 0; d < 3; ++d)
    {
        if (periodic_[d])
        {
            const scalar length = bounds_.max()[d] - bounds_.min()[d];
            r[d] -= length*std::round(r[d]/length);
        }
    }
    return r;
}
