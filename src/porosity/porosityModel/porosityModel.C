// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of the porosity model.

#include "porosityModel.H"

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
    const word modelType(dict.lookupOrDefault<word>("model", "caps"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(modelType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << typeName << " model " << modelType << nl << nl
            << "Valid choices: "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return cstrIter()(dict);
}
