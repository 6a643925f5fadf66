// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the void fraction model.

#include "voidFractionModel.H"

#include "keywords.H"

namespace Foam
{
    defineTypeNameAndDebug(voidFractionModel, 0);
    defineRunTimeSelectionTable(voidFractionModel, dictionary);
}


Foam::autoPtr<Foam::voidFractionModel> Foam::voidFractionModel::New
(
    const dictionary& dict
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word modelType
    (
        keywords::choice
        (
            dict,
            "model",
            "void fraction model",
            table.sortedToc(),
            "sphereCaps",
            {
                {"caps", "sphereCaps"},
                {"divided", "satellitePoints"},
                {"centre", "centroid"}
            }
        )
    );

    return table.cfind(modelType).val()(dict);
}
