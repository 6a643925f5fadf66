// SPDX-License-Identifier: GPL-3.0-or-later
// The list of active physics: what of these closures a run has.

#include "inUse.H"

#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"

void Foam::writeInUse
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
    dict.write(os, false);
}
