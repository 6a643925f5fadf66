// SPDX-License-Identifier: GPL-3.0-or-later
// Erosion of a bed grain by grain, each rolling over the next one.

#include "progressiveScouring.H"

#include "keywords.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

#include <boost/math/quadrature/gauss.hpp>

Foam::progressiveScouring::progressiveScouring
(
    const dictionary& dict,
    const scalar slope,
    const scalar g
)
:
    R_(dict.get<scalar>("radius")),
    rho_(dict.get<scalar>("density")),
    slope_(degToRad(slope)),
    mean_(degToRad(dict.getOrDefault<scalar>("pivotMean", 33))),
    deviation_(degToRad(dict.getOrDefault<scalar>("pivotDeviation", 5.73))),
    divisions_(dict.getOrDefault<label>("divisions", 91)),
    g_(g)
{
    keywords::check
    (
        dict,
        {"radius", "density", "pivotMean", "pivotDeviation", "divisions"}
    );

    if (R_ <= 0 || rho_ <= 0 || deviation_ <= 0 || divisions_ < 2)
    {
        FatalIOErrorInFunction(dict)
            << "radius is " << R_ << " m, density " << rho_
            << " kg/m3, pivotDeviation " << radToDeg(deviation_)
            << " degrees, divisions " << divisions_ << nl
            << "    Give numbers above zero, and two divisions or more."
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::progressiveScouring::timeToRoll
(
    const scalar alpha0,
    const scalar tau
) const
{
    const scalar above = constant::mathematical::piByTwo - slope_;

    if (alpha0 >= above)
    {
        return 0;
    }

    // Eq 1: alpha'' = a sin(alpha) - b cos(alpha + slope), I + m R2 = 1.5 m R2
    const scalar m = constant::mathematical::pi*sqr(R_)*rho_;
    const scalar a = 2*R_*tau/(1.5*m*R_);
    const scalar b = g_/(1.5*R_);
    const scalar start = a*std::sin(alpha0) - b*std::cos(alpha0 + slope_);

    // The shear's moment grows with the angle and the weight's falls: what does not
    // move at first never does
    if (start <= 0)
    {
        return GREAT;
    }

    // alpha'^2/2 is the integral of Eq 1. The speed at the start is zero: with
    // alpha = alpha0 + s^2 the integrand stays finite
    const auto slowness = [&](const scalar s)
    {
        const scalar alpha = alpha0 + sqr(s);
        const scalar half =
            a*(std::cos(alpha0) - std::cos(alpha))
          - b*(std::sin(alpha + slope_) - std::sin(alpha0 + slope_));
        return 2*s/std::sqrt(2*half);
    };

    return boost::math::quadrature::gauss<scalar, 30>::integrate
    (
        slowness, scalar(0), std::sqrt(above - alpha0)
    );
}


Foam::scalar Foam::progressiveScouring::rate
(
    const scalar alpha0,
    const scalar tau
) const
{
    const scalar t = timeToRoll(alpha0, tau);

    return t > 0 && t < GREAT ? 2*R_*std::sin(alpha0)/t : 0;
}


Foam::scalar Foam::progressiveScouring::rate(const scalar tau) const
{
    scalar sum = 0;
    scalar weights = 0;

    for (label i = 0; i < divisions_; ++i)
    {
        const scalar alpha0 =
            constant::mathematical::piByTwo*i/(divisions_ - 1);
        const scalar P = std::exp(-0.5*sqr((alpha0 - mean_)/deviation_));

        sum += P*rate(alpha0, tau);
        weights += P;
    }

    return sum/weights;
}
