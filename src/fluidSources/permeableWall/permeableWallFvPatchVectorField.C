// SPDX-License-Identifier: GPL-3.0-or-later
// A wall that lets water out under pressure: condition for U.

#include "permeableWallFvPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "fvPatchFieldMapper.H"
#include "gravityMeshObject.H"
#include "keywords.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField(fvPatchVectorField, permeableWallFvPatchVectorField);
}

Foam::permeableWallFvPatchVectorField::permeableWallFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    conductance_(0),
    outside_(0),
    strength_(1),
    lastUpdate_(-1)
{}


Foam::permeableWallFvPatchVectorField::permeableWallFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    conductance_(dict.get<scalar>("conductance")),
    outside_(dict.getOrDefault<scalar>("outside", 0)),
    strength_(dict.getOrDefault<scalar>("strength", 1)),
    lastUpdate_(-1)
{
    keywords::check
    (
        dict, {"type", "conductance", "outside", "strength", "value", "patchType"}
    );
    if (!(conductance_ >= 0 && strength_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "conductance " << conductance_ << " m/s/Pa and strength "
            << strength_ << " of the permeable wall " << p.name()
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


Foam::permeableWallFvPatchVectorField::permeableWallFvPatchVectorField
(
    const permeableWallFvPatchVectorField& other,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(other, p, iF, mapper),
    conductance_(other.conductance_),
    outside_(other.outside_),
    strength_(other.strength_),
    lastUpdate_(other.lastUpdate_)
{}


Foam::permeableWallFvPatchVectorField::permeableWallFvPatchVectorField
(
    const permeableWallFvPatchVectorField& other,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(other, iF),
    conductance_(other.conductance_),
    outside_(other.outside_),
    strength_(other.strength_),
    lastUpdate_(other.lastUpdate_)
{}


void Foam::permeableWallFvPatchVectorField::follow(const scalarField& p)
{
    scalarField pores(p.size(), scalar(1));
    if (db().foundObject<volScalarField>("voidFraction"))
    {
        pores =
            patch().lookupPatchField<volScalarField, scalar>("voidFraction");
    }

    scalarField normal(*this & patch().nf());
    const scalar fall =
        mag(meshObjects::gravity::New(db().time()).value())
       *db().time().deltaTValue();
    forAll(normal, face)
    {
        const scalar q = outflow(p[face]);

        // Pressure follows the outflow: half of the way, and less where the flow
        // is faster than what falls in a step, or they swing
        const scalar share = 0.5*fall/max(fall + q, VSMALL);
        normal[face] += share*(q/pores[face] - normal[face]);
    }
    fvPatchVectorField::operator=(normal*patch().nf());
}


void Foam::permeableWallFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    // The fields are made one after the other: at first there is no pressure
    const label now = db().time().timeIndex();
    if (lastUpdate_ != now && db().foundObject<volScalarField>("p"))
    {
        lastUpdate_ = now;
        follow(patch().lookupPatchField<volScalarField, scalar>("p"));
    }

    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::permeableWallFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    os.writeEntry("conductance", conductance_);
    os.writeEntry("outside", outside_);
    os.writeEntry("strength", strength_);
    writeEntry("value", os);
}
