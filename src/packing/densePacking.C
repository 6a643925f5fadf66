// SPDX-License-Identifier: GPL-3.0-or-later
// Grains without contacts that fill a box to a given solid fraction.

#include "densePacking.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "point2D.H"

namespace Foam
{
    defineTypeNameAndDebug(densePacking, 0);
    addToRunTimeSelectionTable(packingModel, densePacking, dictionary);
} // End namespace Foam


Foam::densePacking::densePacking(const dictionary& dict, const vector&)
:
    packingModel
    (
        dict,
        {
            "box", "foot", "base", "solidFraction", "mass", "grainMass",
            "fluidDensity"
        }
    ),
    periodic_(packingBox::readPeriodic(dict)),
    diameters_(),
    bounds_()
{
    checkEntries();

    if (dict_.found("box"))
    {
        fillBox();
    }
    else
    {
        fillFoot();
    }

    checkGrainVolume(box());
    if (diameters_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "The requested packing holds less than half a grain."
            << " Give more mass, a larger box or smaller diameters"
            << exit(FatalIOError);
    }
}


void Foam::densePacking::checkEntries() const
{
    if (dict_.found("box") == dict_.found("foot"))
    {
        FatalIOErrorInFunction(dict_)
            << "Give either box (min) (max); or, for a height that follows"
            << " from the mass, foot (xMin yMin) (xMax yMax); and base z;"
            << exit(FatalIOError);
    }
    if (dict_.found("mass") && dict_.found("grainMass"))
    {
        FatalIOErrorInFunction(dict_)
            << "Give either mass (grains and fluid) or grainMass, not both"
            << exit(FatalIOError);
    }

    const bool fraction = dict_.found("solidFraction");
    const bool enough =
        dict_.found("box") ? fraction || hasMass() : fraction && hasMass();
    if (!enough)
    {
        FatalIOErrorInFunction(dict_)
            << "Too little is given: a box needs solidFraction, mass or"
            << " grainMass; a foot needs solidFraction and one of the masses"
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::densePacking::solidFraction() const
{
    const scalar fraction = dict_.get<scalar>("solidFraction");
    checkFraction(fraction);
    return fraction;
}


Foam::scalar Foam::densePacking::requiredMass() const
{
    return positive(dict_.found("mass") ? "mass" : "grainMass");
}


Foam::scalar Foam::densePacking::massPerSolid(const scalar fraction) const
{
    return
        dict_.found("mass")
      ? density_ + positive("fluidDensity")*(1 - fraction)/fraction
      : density_;
}


Foam::scalar Foam::densePacking::solidInBox(const scalar volume) const
{
    const scalar fluid =
        dict_.found("mass") ? positive("fluidDensity") : scalar(0);

    return (requiredMass() - fluid*volume)/(density_ - fluid);
}


void Foam::densePacking::fillBox()
{
    ITstream& is = dict_.lookup("box");
    is >> bounds_;
    const scalar volume = box().volume();

    const scalar solid =
        hasMass() ? solidInBox(volume) : solidFraction()*volume;
    const scalar grain =
        constant::mathematical::pi/6*pow3(sizes_.largest());
    if
    (
        hasMass() && dict_.found("solidFraction")
     && mag(solid - solidFraction()*volume) > grain
    )
    {
        const scalar needed =
            requiredMass()/(massPerSolid(solidFraction())*solidFraction());
        FatalIOErrorInFunction(dict_)
            << "Mass and box contradict each other: " << requiredMass()
            << " kg in the box of " << volume << " m3 is a solid fraction of "
            << solid/volume << ", not " << solidFraction() << ", which would"
            << " take a box of " << needed << " m3, "
            << needed/(bounds_.span().x()*bounds_.span().y())
            << " m high on this foot. Leave one of box, mass and"
            << " solidFraction out (a foot instead of the box gets its height"
            << " from the other two)" << exit(FatalIOError);
    }

    checkFraction(solid/volume);
    diameters_ = sizes_.forVolume(solid);
}


void Foam::densePacking::fillFoot()
{
    ITstream& is = dict_.lookup("foot");
    point2D low, high;
    is >> low >> high;
    const scalar area = (high.x() - low.x())*(high.y() - low.y());
    const scalar base = dict_.get<scalar>("base");
    if (high.x() <= low.x() || high.y() <= low.y())
    {
        FatalIOErrorInFunction(dict_)
            << "The foot " << low << ' ' << high << " has no area:"
            << " give (xMin yMin) (xMax yMax) in m"
            << exit(FatalIOError);
    }

    const scalar fraction = solidFraction();
    diameters_ = sizes_.forVolume(requiredMass()/massPerSolid(fraction));

    const scalar solid = sphereVolume(diameters_);
    const scalar volume =
        dict_.found("mass")
      ? solid + (requiredMass() - density_*solid)/positive("fluidDensity")
      : solid/fraction;

    bounds_ = boundBox
    (
        point(low.x(), low.y(), base),
        point(high.x(), high.y(), base + max(volume, VSMALL)/area)
    );
}


Foam::packedGrains Foam::densePacking::make(const fileName&) const
{
    return arrange(box(), diameters_);
}


Foam::dictionary Foam::densePacking::properties
(
    const packedGrains& grains
) const
{
    dictionary reached(packingModel::properties(grains));

    if (dict_.found("fluidDensity"))
    {
        const scalar fluid =
            positive("fluidDensity")
           *(box().volume() - grains.solidVolume());
        reached.add("fluidMass", fluid);
        reached.add("mass", fluid + grains.mass());
    }
    return reached;
}
