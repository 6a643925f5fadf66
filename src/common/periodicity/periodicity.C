// SPDX-License-Identifier: GPL-3.0-or-later
// In which directions a mesh repeats itself.

#include "periodicity.H"

#include "SubField.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"

Foam::periodicity::periodicity(const polyMesh& mesh)
:
    along_(false, false, false),
    anywhere_(false),
    box_(mesh.bounds())
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            for (direction k = 0; k < 3; ++k)
            {
                along_[k] = along_[k] || mesh.solutionD()[k] == -1;
            }
        }
        else if
        (
            patch.size()
         && (isA<cyclicPolyPatch>(patch) || isA<processorCyclicPolyPatch>(patch))
        )
        {
            const vector n(patch.faceAreas()[0]/mag(patch.faceAreas()[0]));

            for (direction k = 0; k < 3; ++k)
            {
                along_[k] = along_[k] || mag(n[k]) > 0.99;
            }
        }
    }

    for (direction k = 0; k < 3; ++k)
    {
        reduce(along_[k], orOp<bool>());
        anywhere_ = anywhere_ || along_[k];
    }
}


Foam::point Foam::periodicity::wrapped(const point& p) const
{
    point result(p);

    for (direction k = 0; k < 3; ++k)
    {
        if (along_[k])
        {
            const scalar span = box_.max()[k] - box_.min()[k];
            result[k] -= span*std::floor((p[k] - box_.min()[k])/span);
        }
    }

    return result;
}


Foam::vector Foam::periodicity::shortest(const vector& difference) const
{
    vector result(difference);

    for (direction k = 0; k < 3; ++k)
    {
        if (along_[k])
        {
            const scalar span = box_.max()[k] - box_.min()[k];
            result[k] -= span*std::round(difference[k]/span);
        }
    }

    return result;
}


Foam::List<Foam::vector> Foam::periodicity::shifts() const
{
    List<vector> result(1, Zero);

    for (direction k = 0; k < 3; ++k)
    {
        if (along_[k])
        {
            const label n = result.size();
            result.setSize(3*n);

            for (label i = 0; i < n; ++i)
            {
                result[n + i] = result[2*n + i] = result[i];
                result[n + i][k] += box_.max()[k] - box_.min()[k];
                result[2*n + i][k] -= box_.max()[k] - box_.min()[k];
            }
        }
    }

    return result;
}
