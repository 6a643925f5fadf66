// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosity of a liquid with a yield stress where a grain's own slip shears it.

#include "grainShear.H"

#include "IOdictionary.H"
#include "Time.H"
#include "closure.H"
#include "fvMesh.H"

#include <cmath>

namespace
{

//- Force at which a sphere begins to move, over Stokes's with the yield stress for the
//  shear stress mu slip/d: 3.5 pi over 3 pi
constexpr Foam::scalar atYield = 3.5/3;

//- Shear rate below which a grain is at rest [1/s]: the viscosity is finite there
constexpr Foam::scalar restingRate = 1e-9;

//- Viscosity over its limit from which on the liquid counts as at rest
constexpr Foam::scalar limited = 1 - 1e-6;

} // End anonymous namespace


Foam::grainShear::grainShear(const fvMesh& mesh, const dictionary& dict)
:
    strength_(closure::strength(dict)),
    yieldStress_(0),
    k_(0),
    n_(1),
    muAtRest_(0),
    rho_(1),
    otherRho_(1),
    otherMu_(0)
{
    keywords::check(dict, {"strength"});
    if (!isOn())
    {
        return;
    }

    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const wordList phases(transport.lookup("phases"));
    const dictionary& liquid = transport.subDict(phases[0]);
    const dictionary& other = transport.subDict(phases[1]);

    const word model(liquid.get<word>("transportModel"));
    if (model != "HerschelBulkley")
    {
        FatalIOErrorInFunction(liquid)
            << "interphaseForces/grainShear in constant/granularProperties is written"
            << " for a liquid of transportModel HerschelBulkley, and " << phases[0]
            << " is " << model << "." << nl
            << "    Give it that model, or take grainShear out."
            << exit(FatalIOError);
    }

    const word otherModel(other.getOrDefault<word>("transportModel", "Newtonian"));
    if (otherModel != "Newtonian")
    {
        FatalIOErrorInFunction(other)
            << "interphaseForces/grainShear in constant/granularProperties is written"
            << " for a Newtonian second phase, and " << phases[1] << " is "
            << otherModel << "." << nl
            << "    Give it that model, or take grainShear out." << exit(FatalIOError);
    }

    const dictionary& law = liquid.optionalSubDict("HerschelBulkleyCoeffs");
    rho_ = dimensionedScalar("rho", dimDensity, liquid).value();
    otherRho_ = dimensionedScalar("rho", dimDensity, other).value();
    otherMu_ = otherRho_*dimensionedScalar("nu", dimViscosity, other).value();
    n_ = dimensionedScalar("n", dimless, law).value();
    k_ = rho_*dimensionedScalar("k", dimViscosity, law).value();
    muAtRest_ = rho_*dimensionedScalar("nu0", dimViscosity, law).value();
    yieldStress_ =
        atYield*rho_
       *dimensionedScalar("tau0", dimViscosity/dimTime, law).value();
    check(law);
}


void Foam::grainShear::check(const dictionary& law) const
{
    if (n_ <= 0 || n_ > 1)
    {
        FatalIOErrorInFunction(law)
            << "n is " << n_ << ", and interphaseForces/grainShear is written for"
            << " liquids that thin as they are sheared." << nl
            << "    Give an n above 0 and up to 1, or take grainShear out of"
            << " constant/granularProperties." << exit(FatalIOError);
    }
    if (yieldStress_ <= 0 || k_ < 0 || muAtRest_ <= 0)
    {
        FatalIOErrorInFunction(law)
            << "A yield stress tau0 and a viscosity at rest nu0 above 0, and a k of 0 or"
            << " more, are what interphaseForces/grainShear is written for." << nl
            << "    Correct them, or take grainShear out of constant/granularProperties."
            << exit(FatalIOError);
    }
    if (rho_ == otherRho_)
    {
        FatalIOErrorInFunction(law)
            << "Both phases have the density " << rho_ << " kg/m3: which of them is at"
            << " a grain cannot be seen." << nl
            << "    Give them different densities, or take interphaseForces/grainShear"
            << " out of constant/granularProperties." << exit(FatalIOError);
    }
}


Foam::scalar Foam::grainShear::mu
(
    const scalar mu,
    const scalar rho,
    const scalar d,
    const scalar slip
) const
{
    // Fluids are mixed by volume, as the solver mixes them
    const scalar share =
        min(max((rho - otherRho_)/(rho_ - otherRho_), scalar(0)), scalar(1));
    const scalar fromOther = (1 - share)*otherMu_;

    const scalar rate = max(slip/d, restingRate);
    const scalar own =
        fromOther + share*(yieldStress_ + k_*std::pow(rate, n_))/rate;
    const bool isLimited = mu >= fromOther + limited*share*muAtRest_;

    return mu + strength_*((isLimited ? own : min(own, mu)) - mu);
}


Foam::scalar Foam::grainShear::slipAtRest(const scalar d) const
{
    return restingRate*d;
}


Foam::dictionary Foam::grainShear::activePhysics() const
{
    dictionary result;
    result.add("strength", strength_);
    return result;
}
