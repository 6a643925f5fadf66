// SPDX-License-Identifier: GPL-3.0-or-later
// The grains of a packing: place, size, density and material of each.

#include "packedGrains.H"
#include "mathematicalConstants.H"

namespace
{

//- Volume of a sphere of radius r below the height h over its centre
Foam::scalar volumeBelow(const Foam::scalar r, const Foam::scalar h)
{
    const Foam::scalar cap = Foam::min(Foam::max(h + r, 0.0), 2*r);
    return Foam::constant::mathematical::pi*cap*cap*(r - cap/3);
}

} // End anonymous namespace


Foam::scalar Foam::sphereVolume(const scalarField& diameters)
{
    return constant::mathematical::pi/6*sum(pow3(diameters));
}


Foam::scalar Foam::packedGrains::solidVolume() const
{
    return sphereVolume(diameter);
}


Foam::scalar Foam::packedGrains::solidVolume
(
    const scalar zMin,
    const scalar zMax
) const
{
    scalar volume = 0;
    forAll(position, i)
    {
        const scalar r = 0.5*diameter[i];
        const scalar z = position[i].z();
        volume += volumeBelow(r, zMax - z) - volumeBelow(r, zMin - z);
    }
    return volume;
}


Foam::scalar Foam::packedGrains::mass() const
{
    return constant::mathematical::pi/6*sum(density*pow3(diameter));
}


void Foam::packedGrains::setMaterial(const scalar rho, const label type)
{
    density = scalarField(size(), rho);
    material = labelList(size(), type);
}


void Foam::packedGrains::append(const packedGrains& others)
{
    position.append(others.position);
    diameter.append(others.diameter);
    density.append(others.density);
    material.append(others.material);
}


Foam::packedGrains Foam::packedGrains::subset(const labelUList& ids) const
{
    packedGrains chosen;
    chosen.position = pointField(position, ids);
    chosen.diameter = scalarField(diameter, ids);
    chosen.density = scalarField(density, ids);
    chosen.material = labelList(material, ids);
    return chosen;
}


Foam::DynamicList<Foam::placedClump> Foam::placedClumps
(
    const std::string& kind,
    const packedGrains& clumps
)
{
    DynamicList<placedClump> result(clumps.size());
    forAll(clumps.position, i)
    {
        result.append
        (
            placedClump{kind, clumps.position[i], clumps.orientation[i]}
        );
    }
    return result;
}
