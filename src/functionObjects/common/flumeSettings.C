// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that several function objects read alike: patches and ranges along the flume.

#include "flumeSettings.H"

#include "keywords.H"

Foam::labelList Foam::flumeSettings::patches
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const polyBoundaryMesh& all = mesh.boundaryMesh();

    wordList valid(all.names());
    valid.append(all.groupPatchIDs().sortedToc());

    const wordRes chosen(keywords::patterns(dict, "patches", valid));

    if (chosen.empty())
    {
        FatalIOErrorInFunction(dict)
            << "patches in " << dict.name() << " names none." << nl
            << "Valid names:" << keywords::listed(valid).c_str()
            << exit(FatalIOError);
    }

    const labelList patches(all.patchSet(chosen).sortedToc());
    label faces = 0;
    wordList names;
    for (const label patchi : patches)
    {
        faces += all[patchi].size();
        names.append(all[patchi].name());
    }
    if (!returnReduce(faces, sumOp<label>()))
    {
        FatalIOErrorInFunction(dict)
            << "patches in " << dict.name() << " is" << keywords::listed(names).c_str()
            << ", which have no face." << nl
            << "    Is a barrier beyond the mesh, or its box in system/topoSetDict"
            << " between faces?" << exit(FatalIOError);
    }
    return patches;
}


Foam::Tuple2<Foam::scalar, Foam::scalar> Foam::flumeSettings::range
(
    const dictionary& dict,
    const word& keyword,
    const Tuple2<scalar, scalar>& byDefault
)
{
    const Tuple2<scalar, scalar> result(dict.getOrDefault(keyword, byDefault));

    if (result.first() >= result.second())
    {
        FatalIOErrorInFunction(dict)
            << keyword << " in " << dict.name() << " is " << result << nl
            << "    It must go from a lower to a higher value."
            << exit(FatalIOError);
    }

    return result;
}


Foam::Tuple2<Foam::scalar, Foam::scalar> Foam::flumeSettings::range
(
    const dictionary& dict,
    const word& keyword,
    const Tuple2<scalar, scalar>& byDefault,
    const boundBox& box
)
{
    const Tuple2<scalar, scalar> result(range(dict, keyword, byDefault));

    if
    (
        dict.found(keyword)
     && (
            result.second() <= box.min().x()
         || result.first() >= box.max().x()
        )
    )
    {
        stopBeside(dict, keyword, result, box);
    }

    return result;
}


void Foam::flumeSettings::checkMeets
(
    const dictionary& dict,
    const string& what,
    const boundBox& region,
    const UList<vector>& shifts,
    const boundBox& mesh
)
{
    // A place on a side may be off by round-off
    boundBox wide(mesh);
    wide.inflate(1e-6);
    boundBox withImages(wide);
    for (const vector& shift : shifts)
    {
        withImages.add(wide.min() + shift);
        withImages.add(wide.max() + shift);
    }
    const bool fits = cmptMin(withImages.span() - region.span()) >= 0;
    for (const vector& shift : shifts)
    {
        if (fits && wide.overlaps(boundBox(region.min() + shift, region.max() + shift)))
        {
            return;
        }
    }
    FatalIOErrorInFunction(dict)
        << what.c_str() << " of " << dict.name()
        << (fits ? " lies outside the mesh." : " is longer than the mesh.") << nl
        << "    That goes from " << mesh.min() << " to " << mesh.max()
        << " m (along the flume, across, up). Is the place given in mm?"
        << exit(FatalIOError);
}
