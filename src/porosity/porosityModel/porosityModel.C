// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the porosity model.

#include "porosityModel.H"

#include "keywords.H"

namespace Foam
{
    defineTypeNameAndDebug(porosityModel, 0);
    defineRunTimeSelectionTable(porosityModel, dictionary);
}


Foam::autoPtr<Foam::porosityModel> Foam::porosityModel::New
(
    const dictionary& dict
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word modelType
    (
        keywords::choice
        (
            dict, "model", "porosity model", table.sortedToc(), "caps"
        )
    );

    return table.cfind(modelType).val()(dict);
}
