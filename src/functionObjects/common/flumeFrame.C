// SPDX-License-Identifier: GPL-3.0-or-later
// The directions of a flume.

#include "flumeFrame.H"

#include "PstreamReduceOps.H"
#include "keywords.H"

Foam::flumeFrame::flumeFrame()
:
    flumeFrame(dictionary::null)
{}


Foam::flumeFrame::flumeFrame(const dictionary& dict)
:
    origin_(dict.getOrDefault<vector>("origin", vector::zero)),
    x_(keywords::unitVector(dict, "downslope", vector(1, 0, 0))),
    z_(keywords::unitVector(dict, "normal", vector(0, 0, 1)))
{
    if (mag(x_ & z_) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "downslope " << x_ << " and normal " << z_
            << " are not at right angles: downslope runs along the base,"
            << " normal away from it." << exit(FatalIOError);
    }

    y_ = z_ ^ x_;
}


Foam::boundBox Foam::flumeFrame::bounds(const UList<vector>& points) const
{
    boundBox box;

    for (const vector& p : points)
    {
        box.add(local(p));
    }

    reduce(box.min(), minOp<vector>());
    reduce(box.max(), maxOp<vector>());

    return box;
}


Foam::List<Foam::vector> Foam::flumeFrame::components(const UList<vector>& v) const
{
    List<vector> all(v.size());
    forAll(v, i)
    {
        all[i] = components(v[i]);
    }
    return all;
}
