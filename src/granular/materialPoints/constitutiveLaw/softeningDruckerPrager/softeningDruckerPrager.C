// SPDX-License-Identifier: GPL-3.0-or-later
// Drucker-Prager plasticity whose friction falls with the strain.

#include "softeningDruckerPrager.H"

#include "addToRunTimeSelectionTable.H"
#include "keywords.H"

namespace Foam
{
    defineTypeNameAndDebug(softeningDruckerPrager, 0);
    addToRunTimeSelectionTable
    (
        constitutiveLaw, softeningDruckerPrager, dictionary
    );
}


Foam::softeningDruckerPrager::softeningDruckerPrager(const dictionary& dict)
:
    constitutiveLaw
    (
        checked
        (
            dict,
            {
                "frictionAngle", "residualFrictionAngle", "softeningStrains",
                "cohesion", "criticalDensity", "measure", "matching"
            }
        )
    ),
    peak_(tan(keywords::frictionAngle(dict, "frictionAngle"))),
    residual_
    (
        dict.found("residualFrictionAngle")
      ? tan(keywords::frictionAngle(dict, "residualFrictionAngle"))
      : peak_
    ),
    softening_
    (
        dict.getOrDefault("softeningStrains", Tuple2<scalar, scalar>(0, 0))
    ),
    cohesion_(dict.getOrDefault<scalar>("cohesion", 0)),
    critical_(dict.getOrDefault<scalar>("criticalDensity", density())),
    net_
    (
        keywords::choice
        (
            dict, "measure", "measure of strain", {"path", "net"}, "path"
        ) == "net"
    ),
    slope_
    (
        keywords::choice
        (
            dict,
            "matching",
            "meaning of the angle of friction",
            {"planeStrain", "slope"},
            "planeStrain"
        ) == "slope"
    )
{
    const scalar begin = softening_.first();
    const scalar end = softening_.second();
    if (!(begin >= 0 && end >= begin))
    {
        FatalIOErrorInFunction(dict)
            << "softeningStrains are " << begin << " and " << end
            << "; give the strains at which softening begins and ends, the"
            << " second not below the first." << exit(FatalIOError);
    }
    if (!(cohesion_ >= 0 && critical_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "cohesion is " << cohesion_ << " Pa and criticalDensity "
            << critical_ << " kg/m3; the first may not be below zero, the"
            << " second must be above." << exit(FatalIOError);
    }
}


Foam::scalar Foam::softeningDruckerPrager::friction(const scalar strain) const
{
    const scalar begin = softening_.first();
    const scalar end = softening_.second();
    if (strain <= begin)
    {
        return peak_;
    }

    return
        strain >= end
      ? residual_
      : peak_ + (residual_ - peak_)*(strain - begin)/(end - begin);
}


Foam::scalar Foam::softeningDruckerPrager::strength
(
    const scalar p,
    const scalar strain
) const
{
    const scalar tangent = friction(strain);
    const scalar alongSlope = p*tangent + cohesion_;

    // Sine and cosine are the tangent and 1 over the root of 1 + tangent^2
    return slope_ ? alongSlope : alongSlope/sqrt(1 + sqr(tangent));
}


void Foam::softeningDruckerPrager::addStrain
(
    pointSet& points,
    const label i,
    const scalar dt
) const
{
    const symmTensor step(dt*dev(symm(points.gradient[i])));

    if (net_)
    {
        symmTensor& net = points.netStrain[i];
        net += step + dt*turning(points.gradient[i], net);
        points.strain[i] = sqrt(2.0/3.0*magSqr(dev(net)));
    }
    else
    {
        points.strain[i] += sqrt(2.0/3.0*magSqr(step));
    }
}


void Foam::softeningDruckerPrager::update
(
    pointSet& points,
    const label body,
    const UList<scalar>&,
    const scalar dt
) const
{
    const scalar K = bulkModulus();
    const scalar G = shearModulus();

    for (label i = 0; i < points.size(); ++i)
    {
        if (points.body[i] != body)
        {
            continue;
        }

        addStrain(points, i, dt);

        const scalar density = points.mass[i]/points.volume[i];
        symmTensor& stress = points.stress[i];

        if (density <= critical_)
        {
            stress = Zero;
            continue;
        }

        const scalar p = K*log(density/critical_);
        const tensor& L = points.gradient[i];
        symmTensor s(dev(stress));
        s += dt*(turning(L, s) + 2*G*dev(symm(L)));

        const scalar rootJ2 = sqrt(0.5*magSqr(s));
        const scalar most = strength(p, points.strain[i]);

        stress = (rootJ2 > most ? most/rootJ2 : 1)*s - p*symmTensor::I;
    }
}
