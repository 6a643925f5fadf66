// SPDX-License-Identifier: GPL-3.0-or-later
// The space that a body of material points fills at the start.

#include "pointRegion.H"

#include "Pair.H"
#include "keywords.H"

Foam::pointRegion::pointRegion(const dictionary& dict, const pointGrid& grid)
:
    box_(point::uniform(-GREAT), point::uniform(GREAT)),
    polygon_(dict.getOrDefault("polygon", List<vector2D>())),
    u_(0),
    v_(1)
{
    keywords::check(dict, {"box", "polygon", "plane"});

    if (!dict.found("box") && polygon_.size() < 3)
    {
        FatalIOErrorInFunction(dict)
            << "A region of points needs a box ((x y z) (x y z)) or a polygon"
            << " of three or more corners." << exit(FatalIOError);
    }

    if (dict.found("box"))
    {
        const Pair<point> corners(dict.get<Pair<point>>("box"));
        box_ = boundBox(corners.first(), corners.second());
        if (cmptMin(box_.span()) < 0)
        {
            FatalIOErrorInFunction(dict)
                << "The box " << box_.min() << ' ' << box_.max() << " is none: its"
                << " first corner is the lower one in x, y and z."
                << exit(FatalIOError);
        }
    }

    word plane("xz");
    if (grid.nDims() == 2)
    {
        const direction a = grid.axes()[0];
        const direction b = grid.axes()[1];
        plane = word(string(1, "xyz"[min(a, b)]) + "xyz"[max(a, b)]);
    }
    plane = keywords::choice
    (
        dict, "plane", "plane of the polygon", {"xy", "xz", "yz"}, plane
    );
    u_ = plane[0] - 'x';
    v_ = plane[1] - 'x';
}


bool Foam::pointRegion::contains(const point& p) const
{
    if (!box_.contains(p))
    {
        return false;
    }
    if (polygon_.empty())
    {
        return true;
    }

    // A ray from the point crosses the sides an odd number of times
    bool inside = false;
    forAll(polygon_, i)
    {
        const vector2D& a = polygon_[i];
        const vector2D& b = polygon_[polygon_.fcIndex(i)];

        if ((a.y() > p[v_]) != (b.y() > p[v_]))
        {
            const scalar at =
                a.x() + (b.x() - a.x())*(p[v_] - a.y())/(b.y() - a.y());
            inside = inside != (p[u_] < at);
        }
    }

    return inside;
}
