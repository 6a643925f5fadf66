// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a whole wall: checked against what LIGGGHTS takes, and written.

#include "wallTriangles.H"

#include "OSspecific.H"
#include "unitConversion.H"

#include <fstream>
#include <map>

namespace
{
    using namespace Foam;

    //- What to do about a wall that LIGGGHTS does not take
    const char* const remedy =
        "leave the patch\n    out of LIGGGHTS/walls/patches in"
        " constant/granularProperties and give the wall as an STL surface\n"
        "    of the LIGGGHTS script that LIGGGHTS/walls/surfaces names.";

    //- Stop where a triangle has more neighbours over its edges than LIGGGHTS
    //  takes: where plates meet, or blocks touch in an edge
    void checkNeighbours(const word& wall, const UList<point>& triangles)
    {
        const auto edge = [&](label triangle, label i)
        {
            wallTriangles::corners ends
            {
                triangles[triangle + i], triangles[triangle + (i + 1) % 3]
            };
            if (wallTriangles::isBefore(ends[1], ends[0]))
            {
                Swap(ends[0], ends[1]);
            }
            return ends;
        };

        std::map<wallTriangles::corners, label, wallTriangles::before> sharing;
        for (label t = 0; t < triangles.size(); t += 3)
        {
            for (label i = 0; i < 3; ++i)
            {
                ++sharing[edge(t, i)];
            }
        }

        for (label t = 0; t < triangles.size(); t += 3)
        {
            label n = 0;
            for (label i = 0; i < 3; ++i)
            {
                n += sharing[edge(t, i)] - 1;
            }

            if (n > wallTriangles::mostNeighbours)
            {
                FatalErrorInFunction
                    << "Plates or blocks of the wall " << wall << " meet at "
                    << (triangles[t] + triangles[t + 1] + triangles[t + 2])/3
                    << " m, where a triangle of it has " << n
                    << " neighbours; LIGGGHTS takes "
                    << wallTriangles::mostNeighbours << '.' << nl
                    << "    Give the plates patches of their own, or " << remedy
                    << exit(FatalError);
            }
        }
    }

    //- Stop, naming wall and face, whose triangles have too small an angle
    void stopForThin
    (
        const word& wall,
        const wallTriangles::corners& face,
        const scalar angle
    )
    {
        FatalErrorInFunction
            << "A face of the wall " << wall << ", at " << average(face)
            << " m, cannot be a wall of the grains: ";
        if (angle > 0)
        {
            FatalError
                << "one of its triangles has an angle of " << radToDeg(angle)
                << " degrees, and LIGGGHTS takes none below "
                << radToDeg(wallTriangles::smallestTaken) << '.';
        }
        else
        {
            FatalError << "it has no area, or folds over itself.";
        }
        FatalError
            << nl << "    Make the cells there less elongated (a face at most"
            << " some 900 times as long as wide), or " << remedy
            << exit(FatalError);
    }
}


Foam::DynamicList<Foam::point> Foam::wallTriangles::of
(
    const word& wall,
    const UList<corners>& faces,
    scalar& angle
)
{
    DynamicList<point> result(6*faces.size());
    angle = GREAT;

    for (const corners& at : faces)
    {
        scalar here;
        for (const triFace& t : best(at, here))
        {
            for (const label corner : t)
            {
                result.append(at[corner]);
            }
        }

        if (here < smallestTaken)
        {
            stopForThin(wall, at, here);
        }
        angle = min(angle, here);
    }
    checkNeighbours(wall, result);

    return result;
}


void Foam::wallTriangles::write
(
    const fileName& path,
    const UList<point>& triangles
)
{
    mkDir(path.path());
    std::ofstream os(path);
    os.precision(12);
    os << "solid " << path.nameLessExt() << '\n';

    for (label i = 0; i + 2 < triangles.size(); i += 3)
    {
        os << "facet normal 0 0 0\nouter loop\n";
        for (label k = i; k < i + 3; ++k)
        {
            os  << "vertex " << triangles[k].x() << ' ' << triangles[k].y() << ' '
                << triangles[k].z() << '\n';
        }
        os << "endloop\nendfacet\n";
    }

    os << "endsolid\n";
    os.close();

    if (!os)
    {
        FatalErrorInFunction
            << "Cannot write the wall of the grains to " << path << nl
            << "    Is the disk full, or the folder read-only?"
            << exit(FatalError);
    }
}
