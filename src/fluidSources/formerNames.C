// SPDX-License-Identifier: GPL-3.0-or-later
// Former names of what is here: each is an error that gives the present one.

#include "addToRunTimeSelectionTable.H"
#include "fvOption.H"
#include "fvPatchFields.H"
#include "keywords.H"
#include "volFields.H"

namespace Foam
{
namespace fv
{

//- The former name of localisedMomentumSource
class locatedPush
:
    public option
{
public:

    locatedPush
    (
        const word& name,
        const word& modelType,
        const dictionary& dict,
        const fvMesh& mesh
    )
    :
        option(name, modelType, dict, mesh)
    {
        keywords::stopRenamed(dict, modelType, "localisedMomentumSource");
    }
};

addNamedToRunTimeSelectionTable(option, locatedPush, dictionary, locatedPush);

} // End namespace fv


//- The former name of permeableWall
class leakyWall
:
    public fvPatchVectorField
{
public:

    leakyWall
    (
        const fvPatch& p,
        const DimensionedField<vector, volMesh>& iF,
        const dictionary& dict
    )
    :
        fvPatchVectorField(p, iF)
    {
        keywords::stopRenamed(dict, "leakyWall", "permeableWall");
    }
};

addNamedToRunTimeSelectionTable
(
    fvPatchVectorField,
    leakyWall,
    dictionary,
    leakyWall
);

} // End namespace Foam
