// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the smoothing.

#include "smoothingModel.H"

#include "keywords.H"

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
    const auto& table = *dictionaryConstructorTablePtr_;
    const word modelType
    (
        keywords::choice
        (
            dict, "model", "smoothing", table.sortedToc(), defaultModel
        )
    );

    return table.cfind(modelType).val()(mesh, dict);
}
