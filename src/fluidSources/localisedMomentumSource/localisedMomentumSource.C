// SPDX-License-Identifier: GPL-3.0-or-later
// A force on the water at a station and a time, as an fvOption.

#include "localisedMomentumSource.H"

#include "OSspecific.H"
#include "activePhysics.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "keywords.H"
#include "uniformDimensionedFields.H"

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(localisedMomentumSource, 0);
    addToRunTimeSelectionTable(option, localisedMomentumSource, dictionary);
}
}

Foam::scalar Foam::fv::localisedMomentumSource::hat
(
    const scalar x,
    const scalar centre,
    const Pair<scalar>& reach
)
{
    const scalar d = x - centre;
    return max(1 - mag(d)/(d < 0 ? reach.first() : reach.second()), scalar(0));
}


Foam::tmp<Foam::scalarField> Foam::fv::localisedMomentumSource::water() const
{
    tmp<scalarField> share
    (
        new scalarField
        (
            mesh_.lookupObject<volScalarField>(phase_).primitiveField()
        )
    );
    if (mesh_.foundObject<volScalarField>("voidFraction"))
    {
        share.ref() *=
            mesh_.lookupObject<volScalarField>("voidFraction")
           .primitiveField();
    }
    return share;
}


void Foam::fv::localisedMomentumSource::findCells(const vector& up)
{
    share_.setSize(mesh_.nCells());
    forAll(share_, cell)
    {
        share_[cell] = hat(mesh_.C()[cell] & direction_, place_, reach_);
    }

    scalar low = GREAT;
    scalar high = -GREAT;
    for (const point& p : mesh_.points())
    {
        low = min(low, p & up);
        high = max(high, p & up);
    }
    height_ =
        returnReduce(high, maxOp<scalar>()) - returnReduce(low, minOp<scalar>());

    if (gSum(share_) <= 0)
    {
        FatalIOErrorInFunction(coeffs_)
            << "The momentum source " << name_ << " at " << place_ << " m along "
            << direction_ << " reaches no cell centre." << nl
            << "    The mesh is in " << mesh_.bounds() << " m; put place inside,"
            << " or make reach larger than a cell." << exit(FatalIOError);
    }
}


void Foam::fv::localisedMomentumSource::checkSettings() const
{
    keywords::check
    (
        coeffs_,
        {
            "type", "libs", "active", "direction", "force", "place", "reach",
            "time", "lasting", "strength", "phase", "up"
        }
    );
    if
    (
        !(reach_.first() > 0 && reach_.second() > 0)
     || !(lasting_.first() > 0 && lasting_.second() > 0)
    )
    {
        FatalIOErrorInFunction(coeffs_)
            << "reach " << reach_ << " m and lasting " << lasting_
            << " s of the source " << name_ << " must be above zero on both sides"
            << exit(FatalIOError);
    }
}


void Foam::fv::localisedMomentumSource::openFile()
{
    if (!Pstream::master())
    {
        return;
    }
    const fileName folder
    (
        mesh_.time().globalPath()/"postProcessing"/name_
       /mesh_.time().timeName()
    );
    mkDir(folder);
    file_.reset(new OFstream(folder/"localisedMomentumSource.dat"));
    *file_
        << "# Water where the source " << name_ << " acts, at the start of each"
        << " time step: share of the force in time [-], velocity along "
        << direction_ << " [m/s], depth [m], void fraction [-]; density [kg/m3]"
        << " and viscosity [m2/s] of the water, gravity [m/s2], 0 where not known"
        << nl << "# Time share U depth voidFraction rho nu g" << endl;
}


Foam::scalar Foam::fv::localisedMomentumSource::density() const
{
    const auto* properties =
        mesh_.findObject<IOdictionary>("transportProperties");
    const dictionary* water =
        properties ? properties->findDict(IOobject::group(phase_)) : nullptr;
    return
        water && water->found("rho")
      ? dimensionedScalar("rho", dimDensity, *water).value() : 0;
}


Foam::scalar Foam::fv::localisedMomentumSource::viscosity
(
    const scalarField& weight
) const
{
    const auto* nu = mesh_.findObject<volScalarField>("nu");
    return
        nu ? gSum(weight*nu->primitiveField())/max(gSum(weight), VSMALL) : 0;
}


Foam::scalar Foam::fv::localisedMomentumSource::gravity() const
{
    const auto* g = mesh_.time().findObject<uniformDimensionedVectorField>("g");
    return g ? mag(g->value()) : 0;
}


void Foam::fv::localisedMomentumSource::writeConditions()
{
    if (written_ == mesh_.time().timeIndex())
    {
        return;
    }
    written_ = mesh_.time().timeIndex();

    const scalarField weight(share_*mesh_.V());
    const scalarField ofWater(weight*water());
    const scalarField& alpha =
        mesh_.lookupObject<volScalarField>(phase_).primitiveField();
    const vectorField& U =
        mesh_.lookupObject<volVectorField>(fieldNames_.first())
       .primitiveField();

    const scalar filled = gSum(weight*alpha);
    const scalar volume = gSum(ofWater);
    const scalar velocity =
        gSum(ofWater*(U & direction_))/max(volume, VSMALL);
    const scalar depth = height_*filled/gSum(weight);
    const scalar nu = viscosity(ofWater);

    if (file_.valid())
    {
        *file_
            << mesh_.time().value() << ' ' << share() << ' ' << velocity << ' '
            << depth << ' ' << (filled > 0 ? volume/filled : 1) << ' '
            << density() << ' ' << nu << ' ' << gravity() << endl;
    }
}


Foam::fv::localisedMomentumSource::localisedMomentumSource
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    direction_(keywords::unitVector(coeffs_, "direction")),
    force_
    (
        coeffs_.get<scalar>("force")
       *coeffs_.getOrDefault<scalar>("strength", 1)
    ),
    place_(coeffs_.get<scalar>("place")),
    reach_(coeffs_.get<Pair<scalar>>("reach")),
    time_(coeffs_.get<scalar>("time")),
    lasting_(coeffs_.get<Pair<scalar>>("lasting")),
    phase_(coeffs_.getOrDefault<word>("phase", "alpha.water")),
    height_(0),
    written_(-1)
{
    checkSettings();
    fieldNames_ = {"U"};
    applied_.setSize(1, false);
    findCells(keywords::unitVector(coeffs_, "up", vector(0, 0, 1)));
    openFile();
    writeActivePhysics(mesh, name, coeffs_);
}


Foam::scalar Foam::fv::localisedMomentumSource::share() const
{
    return hat(mesh_.time().value(), time_, lasting_);
}


Foam::tmp<Foam::vectorField> Foam::fv::localisedMomentumSource::force() const
{
    return (force_*share())*share_*water()*direction_;
}


void Foam::fv::localisedMomentumSource::addSup
(
    const volScalarField&,
    fvMatrix<vector>& eqn,
    const label
)
{
    writeConditions();

    const scalar now = share();
    if (force_ != 0 && now > 0)
    {
        eqn += volVectorField::Internal
        (
            IOobject(name_ + ":force", mesh_.time().timeName(), mesh_),
            mesh_,
            dimForce/dimVolume,
            force()
        );
    }
}


bool Foam::fv::localisedMomentumSource::read(const dictionary&)
{
    return false;
}
