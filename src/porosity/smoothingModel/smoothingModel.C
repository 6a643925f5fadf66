// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the smoothing.

#include "smoothingModel.H"

namespace Foam
{
    defineTypeNameAndDebug(smoothingModel, 0);
    defineRunTimeSelectionTable(smoothingModel, dictionary);
}


Foam::autoPtr<Foam::smoothingModel> Foam::smoothingModel::New
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const word modelType(dict.lookupOrDefault<word>("model", "diffusion"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(modelType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << typeName << " model " << modelType << nl << nl
            << "Valid choices: "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter()(mesh, dict);
}
