// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of side walls in a case that does not resolve its width, as an
// fvOption.

#include "sideWallFriction.H"

#include "activePhysics.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "fvmSup.H"
#include "keywords.H"
#include "volFields.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(sideWallFriction, 0);
    addToRunTimeSelectionTable(option, sideWallFriction, dictionary);
}
}

Foam::fv::sideWallFriction::sideWallFriction
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    width_(coeffs_.get<scalar>("width")),
    friction_(coeffs_.getOrDefault<scalar>("friction", 0.02)),
    strength_(coeffs_.getOrDefault<scalar>("strength", 1))
{
    keywords::check
    (
        coeffs_, {"type", "libs", "active", "width", "friction", "strength"}
    );
    if (!(width_ > 0 && friction_ >= 0 && strength_ >= 0))
    {
        FatalIOErrorInFunction(coeffs_)
            << "width " << width_ << " m, friction " << friction_
            << " and strength " << strength_ << " of side walls: the width must"
            << " be above zero, the others not below." << exit(FatalIOError);
    }
    fieldNames_ = {"U"};
    applied_.setSize(1, false);
    writeActivePhysics(mesh, name, coeffs_);
}


Foam::scalar Foam::fv::sideWallFriction::rate
(
    const scalar nu,
    const scalar speed
) const
{
    return
        strength_*(12*nu/sqr(width_) + friction_*speed/(4*width_));
}


void Foam::fv::sideWallFriction::addSup
(
    const volScalarField& rho,
    fvMatrix<vector>& eqn,
    const label
)
{
    if (strength_ == 0)
    {
        return;
    }

    const vectorField& U = eqn.psi().primitiveField();
    const scalarField& nu =
        mesh_.lookupObject<volScalarField>("nu").primitiveField();
    scalarField coefficient(rho.primitiveField());
    forAll(coefficient, cell)
    {
        coefficient[cell] *= rate(nu[cell], mag(U[cell]));
    }

    eqn -= fvm::Sp
    (
        volScalarField::Internal
        (
            IOobject(name_ + ":rate", mesh_.time().timeName(), mesh_),
            mesh_,
            dimDensity/dimTime,
            coefficient
        ),
        eqn.psi()
    );
}


bool Foam::fv::sideWallFriction::read(const dictionary&)
{
    return false;
}
