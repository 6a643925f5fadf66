// SPDX-License-Identifier: GPL-3.0-or-later
// The film between a grain and a wall that it approaches or leaves.

#include "wallLubrication.H"

#include "closure.H"
#include "mathematicalConstants.H"

Foam::wallLubrication::wallLubrication
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    strength_(closure::strength(dict)),
    range_(dict.getOrDefault<scalar>("range", 1)),
    roughness_(dict.getOrDefault<scalar>("roughness", 1e-3))
{
    keywords::check(dict, {"strength", "range", "roughness", "patches"});

    if (!(roughness_ > 0 && range_ > roughness_))
    {
        FatalIOErrorInFunction(dict)
            << "range " << range_ << " and roughness " << roughness_
            << " of lubrication are gaps in grain radii: range must be the"
            << " larger, and both above zero." << exit(FatalIOError);
    }
    if (strength_ > 0)
    {
        walls_.reset
        (
            new plateWalls
            (
                mesh,
                keywords::patterns(dict, "patches", mesh.boundaryMesh().names())
            )
        );
    }
}


Foam::scalar Foam::wallLubrication::coefficient
(
    const scalar distance,
    const scalar radius,
    const scalar mu
) const
{
    const scalar gap = max(distance/radius - 1, roughness_);

    return
        gap < range_
      ? strength_*6*constant::mathematical::pi*mu*radius*(1/gap - 1/range_)
      : 0;
}


Foam::vector Foam::wallLubrication::force
(
    const point& position,
    const scalar radius,
    const scalar mu,
    const vector& momentum,
    const scalar inertia,
    const scalar interval
) const
{
    vector sum(Zero);

    if (!walls_.valid())
    {
        return sum;
    }
    for (const plateWalls::plate& wall : walls_->plates())
    {
        const scalar c =
            coefficient
            (
                plateWalls::distance(wall, position, radius), radius, mu
            );
        if (c > 0)
        {
            sum -=
                c/(inertia + c*interval)*(momentum & wall.normal)*wall.normal;
        }
    }

    return sum;
}


Foam::dictionary Foam::wallLubrication::activePhysics() const
{
    dictionary dict;
    dict.add("strength", strength_);
    if (strength_ > 0)
    {
        dict.add("range", range_);
        dict.add("roughness", roughness_);
    }
    return dict;
}
