// SPDX-License-Identifier: GPL-3.0-or-later
// The list of active physics: what a run computes, with its settings.

#include "activePhysics.H"

#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"

void Foam::writeActivePhysics
(
    const fvMesh& mesh,
    const word& name,
    const dictionary& dict
)
{
    if (!Pstream::master())
    {
        return;
    }

    const fileName folder
    (
        mesh.time().globalPath()/"postProcessing"/"activePhysics"
       /mesh.time().timeName()
    );
    mkDir(folder);

    OFstream os(folder/name);
    os  << "// " << name << " in this run, with its settings" << nl;

    dictionary written(dict);
    written.remove("FoamFile");
    written.write(os, false);
}
