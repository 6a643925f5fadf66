// SPDX-License-Identifier: GPL-3.0-or-later
// A wall that lets water out under pressure: condition for U.

#include "leakyWallFvPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "fvPatchFieldMapper.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField(fvPatchVectorField, leakyWallFvPatchVectorField);
}

Foam::leakyWallFvPatchVectorField::leakyWallFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    conductance_(0),
    outside_(0),
    strength_(1)
{}


Foam::leakyWallFvPatchVectorField::leakyWallFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    conductance_(dict.get<scalar>("conductance")),
    outside_(dict.lookupOrDefault<scalar>("outside", 0)),
    strength_(dict.lookupOrDefault<scalar>("strength", 1))
{
    if (!(conductance_ >= 0 && strength_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "conductance " << conductance_ << " m/s/Pa and strength "
            << strength_ << " of the leaky wall " << p.name()
            << " must not be negative." << exit(FatalIOError);
    }
    if (dict.found("value"))
    {
        fvPatchVectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        fvPatchVectorField::operator=(vector::zero);
    }
}


Foam::leakyWallFvPatchVectorField::leakyWallFvPatchVectorField
(
    const leakyWallFvPatchVectorField& other,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(other, p, iF, mapper),
    conductance_(other.conductance_),
    outside_(other.outside_),
    strength_(other.strength_)
{}


Foam::leakyWallFvPatchVectorField::leakyWallFvPatchVectorField
(
    const leakyWallFvPatchVectorField& other,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(other, iF),
    conductance_(other.conductance_),
    outside_(other.outside_),
    strength_(other.strength_)
{}


void Foam::leakyWallFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    // The fields are made one after the other: at first there is no pressure
    if (db().foundObject<volScalarField>("p"))
    {
        const scalarField& p =
            patch().lookupPatchField<volScalarField, scalar>("p");
        const bool grains = db().foundObject<volScalarField>("voidFraction");
        const scalarField pores
        (
            grains
          ? scalarField
            (
                patch().lookupPatchField<volScalarField, scalar>
                (
                    "voidFraction"
                )
            )
          : scalarField(p.size(), 1)
        );
        scalarField normal(*this & patch().nf());

        // Half of the way at a time: the pressure answers to the outflow
        forAll(normal, face)
        {
            normal[face] =
                0.5*normal[face] + 0.5*outflow(p[face])/pores[face];
        }
        fvPatchVectorField::operator=(normal*patch().nf());
    }

    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::leakyWallFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    os.writeEntry("conductance", conductance_);
    os.writeEntry("outside", outside_);
    os.writeEntry("strength", strength_);
    writeEntry("value", os);
}
