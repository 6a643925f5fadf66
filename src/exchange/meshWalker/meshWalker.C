// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cell of a point by walking through faces, across ranks.

#include "meshWalker.H"

#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

Foam::meshWalker::meshWalker(const polyMesh& mesh)
:
    mesh_(mesh),
    tolerance_(1e-10*mesh.bounds().mag()),
    start_(mesh.nCells() + 1, Zero),
    neighbourRank_(mesh.nFaces() - mesh.nInternalFaces(), -1),
    neighbourCell_(neighbourRank_.size(), -1),
    shift_(neighbourRank_.size(), Zero)
{
    setNeighbours();
    setSides();
}


void Foam::meshWalker::setNeighbours()
{
    labelList cells(neighbourRank_.size());
    labelList ranks(neighbourRank_.size(), Pstream::myProcNo());
    pointField centres(neighbourRank_.size());

    forAll(cells, i)
    {
        cells[i] = mesh_.faceOwner()[mesh_.nInternalFaces() + i];
        centres[i] = mesh_.faceCentres()[mesh_.nInternalFaces() + i];
    }
    const pointField here(centres);

    syncTools::swapBoundaryFaceList(mesh_, cells);
    syncTools::swapBoundaryFaceList(mesh_, ranks);
    syncTools::swapBoundaryFaceList(mesh_, centres);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            continue;
        }

        const bool periodic =
            isA<cyclicPolyPatch>(patch)
         || isA<processorCyclicPolyPatch>(patch);

        forAll(patch, i)
        {
            const label at = patch.start() + i - mesh_.nInternalFaces();
            neighbourRank_[at] = ranks[at];
            neighbourCell_[at] = cells[at];

            if (periodic)
            {
                shift_[at] = centres[at] - here[at];
            }
        }
    }
}


void Foam::meshWalker::setSides()
{
    forAll(mesh_.cells(), cell)
    {
        start_[cell + 1] = start_[cell] + mesh_.cells()[cell].size();
    }

    sides_.setSize(start_.last());

    forAll(mesh_.cells(), cell)
    {
        label at = start_[cell];

        for (const label f : mesh_.cells()[cell])
        {
            const bool owner = mesh_.faceOwner()[f] == cell;
            const vector area(owner ? mesh_.faceAreas()[f] : -mesh_.faceAreas()[f]);

            side& s = sides_[at++];
            s.normal = area/(mag(area) + VSMALL);
            s.offset = s.normal & mesh_.faceCentres()[f];
            s.warp = 0;
            s.face = owner ? f : -1 - f;

            for (const label p : mesh_.faces()[f])
            {
                s.warp = max
                (
                    s.warp,
                    mag((mesh_.points()[p] & s.normal) - s.offset)
                );
            }

            if (mesh_.isInternalFace(f))
            {
                s.next = owner ? mesh_.faceNeighbour()[f] : mesh_.faceOwner()[f];
            }
            else
            {
                const label i = f - mesh_.nInternalFaces();
                s.next = neighbourRank_[i] < 0 ? -1 : -2 - i;
            }
        }
    }
}


Foam::meshWalker::place Foam::meshWalker::walk
(
    point& p,
    const label from
) const
{
    place here{Pstream::myProcNo(), from};

    // Some irregular cells could send the walk round in circles
    const label most = 1000;

    for (label step = 0; step < most; ++step)
    {
        scalar furthest = tolerance_;
        label next = -1;

        for (label i = start_[here.cell]; i < start_[here.cell + 1]; ++i)
        {
            const side& s = sides_[i];
            const scalar distance = (p & s.normal) - s.offset;

            // Within the warp two cells may send a point to and fro
            if (distance - s.warp > furthest && s.next != -1)
            {
                furthest = distance - s.warp;
                next = s.next;
            }
        }

        if (next == -1)
        {
            return here;
        }

        if (next >= 0)
        {
            here.cell = next;
            continue;
        }

        const label i = -2 - next;
        p += shift_[i];
        here = place{neighbourRank_[i], neighbourCell_[i]};

        if (here.rank != Pstream::myProcNo())
        {
            return here;
        }
    }

    return here;
}
