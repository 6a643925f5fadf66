// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of packing, chosen by the entry "type".

#include "packingModel.H"
#include "keywords.H"
#include "overlapRelaxation.H"

namespace Foam
{
    defineTypeNameAndDebug(packingModel, 0);
    defineRunTimeSelectionTable(packingModel, dictionary);

namespace
{

//- Above it, equal spheres do not pack at random (Scott & Kilgour 1969)
constexpr scalar randomClosePacking = 0.64;

//- Overlap over diameter that counts as none
constexpr scalar tolerance = 5e-4;

//- Where overlaps remain, the spheres are shaken this often, by this fraction
//  of their diameter, ever less. Found by trial: smaller shakes get stuck, and
//  these reach 0.62 between walls that are 7.5 diameters apart.
constexpr label mostShakes = 200;
constexpr scalar shakeAmplitude = 0.45;


pointField randomPoints
(
    const packingBox& box,
    const scalarField& diameters,
    Random& random
)
{
    pointField points(diameters.size());
    forAll(points, i)
    {
        points[i] =
            box.bounds().min()
          + cmptMultiply(random.sample01<vector>(), box.span());
        box.clipToWalls(points[i], 0.5*diameters[i]);
    }
    return points;
}


//- Relax, and shake while spheres overlap. Returns the least overlap on the
//  way, which is the last one where the tolerance is met
scalar pushApart(overlapRelaxation& spheres, Random& random)
{
    scalar least = spheres.relax(0);

    for (label k = 0; k < mostShakes && least > tolerance; ++k)
    {
        spheres.shake(shakeAmplitude*(1 - scalar(k)/mostShakes), random);
        least = min(least, spheres.relax(0));
    }
    return least;
}

} // End anonymous namespace
} // End namespace Foam


Foam::packingModel::packingModel
(
    const dictionary& dict,
    const wordList& modelKeywords
)
:
    dict_(checked(dict, modelKeywords)),
    sizes_(dict),
    density_(positive("density")),
    material_(dict.getOrDefault<label>("material", 1)),
    seed_(dict.getOrDefault<label>("seed", 1))
{
    if (material_ < 1)
    {
        FatalIOErrorInFunction(dict_)
            << "material is " << material_ << ", but LIGGGHTS counts its"
            << " materials (atom types) from 1" << exit(FatalIOError);
    }
}


const Foam::dictionary& Foam::packingModel::checked
(
    const dictionary& dict,
    const wordList& modelKeywords
)
{
    wordList valid
    ({
        "type", "diameter", "diameters", "density", "material", "seed",
        "periodic"
    });
    valid.append(modelKeywords);
    keywords::check(dict, valid);

    return dict;
}


Foam::autoPtr<Foam::packingModel> Foam::packingModel::New
(
    const dictionary& dict,
    const vector& gravity
)
{
    const word type(dict.get<word>("type"));
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);

    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown type " << type << " of packing; valid types are "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    return constructor.val()(dict, gravity);
}


Foam::scalar Foam::packingModel::positive(const word& key) const
{
    const scalar value = dict_.get<scalar>(key);
    if (value <= 0)
    {
        FatalIOErrorInFunction(dict_)
            << key << " is " << value << ", but must be above zero"
            << exit(FatalIOError);
    }
    return value;
}


void Foam::packingModel::checkGrainVolume(const packingBox& box) const
{
    if (cmptMin(box.span()) < sizes_.largest())
    {
        FatalIOErrorInFunction(dict_)
            << "The box " << box.bounds() << " with sides " << box.span()
            << " m is too small for a grain of " << sizes_.largest()
            << " m" << exit(FatalIOError);
    }
}


void Foam::packingModel::checkFraction(const scalar solidFraction) const
{
    if (solidFraction <= 0 || solidFraction > randomClosePacking)
    {
        FatalIOErrorInFunction(dict_)
            << "A solid fraction of " << solidFraction << " is out of range:"
            << " it must be above 0, and spheres packed at random reach "
            << randomClosePacking << ". Between 0.40 and 0.62 is what"
            << " preparePacking is made for" << exit(FatalIOError);
    }
}


Foam::packedGrains Foam::packingModel::arrange
(
    const packingBox& box,
    const scalarField& diameters
) const
{
    const scalar solidFraction = sphereVolume(diameters)/box.volume();
    checkFraction(solidFraction);

    Random random(seed_);
    overlapRelaxation spheres
    (
        box,
        randomPoints(box, diameters, random),
        diameters
    );
    const scalar least = pushApart(spheres, random);

    if (least > tolerance)
    {
        // Smaller by the overlap, the spheres would have fitted
        FatalIOErrorInFunction(dict_)
            << diameters.size() << " grains do not fit into the box "
            << box.bounds() << " at a solid fraction of " << solidFraction
            << "; the largest one reached between these walls is "
            << solidFraction*pow3(1 - least)
            << ". Ask for less, or for a wider box" << exit(FatalIOError);
    }

    packedGrains grains;
    grains.position = spheres.positions();
    grains.diameter = diameters;
    grains.setMaterial(density_, material_);
    return grains;
}


void Foam::packingModel::writeKey(Ostream& os) const
{
    dict_.write(os, false);
}


Foam::dictionary Foam::packingModel::properties
(
    const packedGrains& grains
) const
{
    const packingBox space(box());
    scalar top = space.bounds().min().z();
    forAll(grains.position, i)
    {
        top = max(top, grains.position[i].z() + 0.5*grains.diameter[i]);
    }

    dictionary reached;
    reached.add("type", type());
    reached.add("material", material_);
    reached.add("nGrains", grains.size());
    reached.add("grainMass", grains.mass());
    reached.add("solidFraction", grains.solidVolume()/space.volume());
    reached.add("min", space.bounds().min());
    reached.add("max", space.bounds().max());
    reached.add("height", space.span().z());
    reached.add("highestGrain", top);
    reached.add
    (
        "largestOverlap",
        max
        (
            scalar(0),
            largestOverlap(space, grains.position, grains.diameter)
        )
    );
    reached.add("seed", seed_);
    return reached;
}
