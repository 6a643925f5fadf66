// SPDX-License-Identifier: GPL-3.0-or-later
// The plane walls of a mesh, known to all ranks.

#include "plateWalls.H"

#include "ListListOps.H"
#include "Pstream.H"
#include "SubField.H"
#include "foamCompatibility.H"
#include "wallPolyPatch.H"

void Foam::plateWalls::add(const plate& face, const scalar tolerance)
{
    for (plate& p : plates_)
    {
        if
        (
            (p.normal & face.normal) > 1 - 1e-6
         && mag(p.offset - face.offset) < tolerance
        )
        {
            p.bounds.add(face.bounds);
            return;
        }
    }

    plates_.append(face);

    if (plates_.size() > most)
    {
        FatalErrorInFunction
            << "The walls have more than " << most << " planes: they are"
            << " curved, and lubrication knows plane walls only." << nl
            << "    Name those patches that are plane in"
            << " interphaseForces/lubrication/patches."
            << exit(FatalError);
    }
}


Foam::plateWalls::plateWalls(const polyMesh& mesh, const wordRes& patches)
{
    const scalar tolerance = 1e-6*mag(mesh.bounds().span());

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool isChosen =
            isA<wallPolyPatch>(patch)
         && (patches.empty() || patches.match(patch.name()));

        for (label i = 0; isChosen && i < patch.size(); ++i)
        {
            const vector normal(patch.faceAreas()[i]/mag(patch.faceAreas()[i]));
            add
            (
                {
                    normal,
                    normal & patch.faceCentres()[i],
                    boundBox(patch[i].points(mesh.points()), false)
                },
                tolerance
            );
        }
    }

    gather(tolerance);
}


void Foam::plateWalls::gather(const scalar tolerance)
{
    // Vectors and numbers travel
    List<List<vector>> normals(Pstream::nProcs());
    List<List<vector>> lowest(Pstream::nProcs());
    List<List<vector>> highest(Pstream::nProcs());
    List<List<scalar>> offsets(Pstream::nProcs());
    const label me = Pstream::myProcNo();
    for (const plate& p : plates_)
    {
        normals[me].append(p.normal);
        offsets[me].append(p.offset);
        lowest[me].append(p.bounds.min());
        highest[me].append(p.bounds.max());
    }
    Pstream::gatherList(normals);
    compatibility::broadcast(normals);
    Pstream::gatherList(offsets);
    compatibility::broadcast(offsets);
    Pstream::gatherList(lowest);
    compatibility::broadcast(lowest);
    Pstream::gatherList(highest);
    compatibility::broadcast(highest);

    plates_.clear();
    forAll(normals, rank)
    {
        forAll(normals[rank], i)
        {
            add
            (
                {
                    normals[rank][i],
                    offsets[rank][i],
                    boundBox(lowest[rank][i], highest[rank][i])
                },
                tolerance
            );
        }
    }
}


Foam::scalar Foam::plateWalls::distance
(
    const plate& p,
    const point& at,
    const scalar reach
)
{
    const scalar d = p.offset - (at & p.normal);
    const point foot(at + d*p.normal);
    const vector margin(vector::uniform(reach));

    return
        d > 0 && boundBox(p.bounds.min() - margin, p.bounds.max() + margin)
       .contains(foot)
      ? d : GREAT;
}
