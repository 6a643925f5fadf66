// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnoses concealed cases, without a look at the key.

#include "concealedSet.H"
#include "diagnosis.H"
#include "report.H"

#include "IFstream.H"
#include "OSspecific.H"

void Foam::misfit::diagnoseCases(concealedSide& library, const fileName& folder)
{
    const settings set(readSettings(library.dict()));
    const fileNameList cases(caseFolders(folder));
    label n = 0;
    for (const fileName& c : cases)
    {
        Info<< ++n << " of " << cases.size() << ": " << c.name() << endl;
        if (isFile(c/"verdict.json"))
        {
            continue;
        }
        IFstream is(c/"level");
        const recordings recorded
        (
            withFiles(library.dict(), c, readScalar(is)), c
        );
        predictedSampler sampler
        (
            recorded, library.predict(), library.bank("A")
        );
        diagnosis diagnose(sampler, set);
        const finding found(diagnose());
        writeWhole(c/"verdict.json", verdictJson(found, c.name()));
        Info<< "    " << found.verdict << ": " << found.told.c_str() << endl;
    }
}
