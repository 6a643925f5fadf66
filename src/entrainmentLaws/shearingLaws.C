// SPDX-License-Identifier: GPL-3.0-or-later
// Shear of a flow on its bed, and erosion by the bed's shear failure.

#include "shearingLaws.H"

#include "keywords.H"
#include "unitConversion.H"

Foam::shearingLaws::shearingLaws
(
    const dictionary& dict,
    const scalar slope,
    const scalar g
)
:
    slope_(degToRad(slope)),
    friction_(keywords::frictionAngle(dict, "frictionAngle")),
    residual_
    (
        dict.found("residualFrictionAngle")
      ? keywords::frictionAngle(dict, "residualFrictionAngle")
      : friction_
    ),
    rho_(dict.get<scalar>("bulkDensity")),
    xi_(dict.getOrDefault<scalar>("turbulenceCoefficient", 100)),
    g_(g)
{
    if (friction_ <= slope_)
    {
        FatalIOErrorInFunction(dict)
            << "frictionAngle is " << radToDeg(friction_)
            << " degrees and slope " << slope << nl
            << "    A bed that is no steeper in friction than in slope does not"
            << " rest: give a greater frictionAngle." << exit(FatalIOError);
    }

    if (rho_ <= 0 || xi_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "bulkDensity is " << rho_ << " kg/m3, turbulenceCoefficient "
            << xi_ << " m/s2: both must be above zero." << exit(FatalIOError);
    }
}


Foam::scalar Foam::shearingLaws::Coulomb(const scalar sigma) const
{
    return sigma*std::tan(friction_);
}


Foam::scalar Foam::shearingLaws::Voellmy
(
    const scalar sigma,
    const scalar v
) const
{
    return Coulomb(sigma) + rho_*g_*sqr(v)/xi_;
}


Foam::scalar Foam::shearingLaws::resistance(const scalar sigma) const
{
    return sigma*std::tan(residual_);
}


Foam::scalar Foam::shearingLaws::staticDepth
(
    const scalar tau,
    const scalar sigma
) const
{
    return
        (tau - resistance(sigma))
       /(rho_*g_*(std::cos(slope_)*std::tan(friction_) - std::sin(slope_)));
}


Foam::scalar Foam::shearingLaws::dynamicRate
(
    const scalar tau,
    const scalar sigma,
    const scalar v
) const
{
    return v > SMALL ? (tau - resistance(sigma))/(rho_*v) : 0;
}
