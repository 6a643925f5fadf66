// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of packing, chosen by the entry "type".

#include "packingModel.H"
#include "clumpRelaxation.H"
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


//- Every orientation as often as any other
List<quaternion> randomOrientations(const label n, Random& random)
{
    List<quaternion> result(n);
    for (quaternion& q : result)
    {
        do
        {
            q.w() = random.GaussNormal<scalar>();
            q.v() = random.GaussNormal<vector>();
        }
        while (mag(q) < 1e-3);
        q.normalize();
    }
    return result;
}


//- Relax, and shake while grains overlap. Returns the least overlap on the
//  way, which is the last one where the tolerance is met
template<class Relaxation>
scalar pushApart(Relaxation& grains, Random& random)
{
    scalar least = grains.relax(0);

    for (label k = 0; k < mostShakes && least > tolerance; ++k)
    {
        grains.shake(shakeAmplitude*(1 - scalar(k)/mostShakes), random);
        least = min(least, grains.relax(0));
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
    seed_(dict.getOrDefault<label>("seed", 1)),
    clump_(readClump())
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
        "periodic", "clump", "spheres"
    });
    valid.append(modelKeywords);
    keywords::check(dict, valid);

    return dict;
}


Foam::autoPtr<Foam::clumpShape> Foam::packingModel::readClump() const
{
    if (!dict_.found("clump"))
    {
        if (dict_.found("spheres"))
        {
            FatalIOErrorInFunction(dict_)
                << "spheres without clump" << nl
                << "    Write clump cobble; beside them, or leave them out."
                << exit(FatalIOError);
        }
        return nullptr;
    }
    if (!dict_.found("diameter"))
    {
        FatalIOErrorInFunction(dict_)
            << "Clumps have one size only." << nl
            << "    Write diameter, that of the sphere of the clump's volume, in place"
            << " of diameters." << exit(FatalIOError);
    }
    return autoPtr<clumpShape>::New(dict_, sizes_.largest());
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
    const scalar size = clump_ ? clump_->length() : sizes_.largest();

    if (cmptMin(box.span()) < size)
    {
        FatalIOErrorInFunction(dict_)
            << "The box " << box.bounds() << " with sides " << box.span()
            << " m is too small for a grain of " << size
            << " m. Enlarge the box, or take smaller grains" << exit(FatalIOError);
    }
}


void Foam::packingModel::checkFraction(const scalar solidFraction) const
{
    if (solidFraction <= 0 || solidFraction > randomClosePacking)
    {
        FatalIOErrorInFunction(dict_)
            << "A solid fraction of " << solidFraction << " is out of range:"
            << " it must be above 0, and grains packed at random reach "
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

    if (clump_)
    {
        return arrangeClumps(box, diameters);
    }

    Random random(seed_);
    overlapRelaxation spheres
    (
        box,
        randomPoints(box, diameters, random),
        diameters
    );
    checkApart(box, diameters, pushApart(spheres, random));

    packedGrains grains;
    grains.position = spheres.positions();
    grains.diameter = diameters;
    grains.setMaterial(density_, material_);
    return grains;
}


Foam::packedGrains Foam::packingModel::arrangeClumps
(
    const packingBox& box,
    const scalarField& diameters
) const
{
    Random random(seed_);
    const pointField start(randomPoints(box, diameters, random));
    clumpRelaxation clumps
    (
        box,
        *clump_,
        start,
        randomOrientations(start.size(), random)
    );
    checkApart(box, diameters, pushApart(clumps, random));

    packedGrains grains;
    grains.position = clumps.positions();
    grains.orientation = clumps.orientations();
    grains.diameter = diameters;
    grains.setMaterial(density_, material_);
    return grains;
}


void Foam::packingModel::checkApart
(
    const packingBox& box,
    const scalarField& diameters,
    const scalar least
) const
{
    if (least > tolerance)
    {
        const scalar solidFraction = sphereVolume(diameters)/box.volume();

        // Smaller by the overlap, the grains would have fitted
        FatalIOErrorInFunction(dict_)
            << diameters.size() << " grains do not fit into the box "
            << box.bounds() << " at a solid fraction of " << solidFraction
            << "; the largest one reached between these walls is "
            << solidFraction*pow3(1 - least)
            << ". Ask for less, or for a wider box" << exit(FatalIOError);
    }
}


Foam::pointField Foam::packingModel::sphereCentres
(
    const packedGrains& grains
) const
{
    return
        clump_
      ? clump_->placed(grains.position, grains.orientation)
      : grains.position;
}


Foam::scalarField Foam::packingModel::sphereDiameters
(
    const packedGrains& grains
) const
{
    return clump_ ? clump_->diameters(grains.size()) : grains.diameter;
}


Foam::labelList Foam::packingModel::sphereGrains
(
    const packedGrains& grains
) const
{
    const label nEach = clump_ ? clump_->size() : 1;
    labelList result(grains.size()*nEach);
    forAll(result, i)
    {
        result[i] = i/nEach;
    }
    return result;
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
    const pointField spheres(sphereCentres(grains));
    const scalarField diameters(sphereDiameters(grains));
    const scalar overlap = largestOverlap
    (
        space,
        spheres,
        diameters,
        pairsOfBodies(space, spheres, diameters, sphereGrains(grains), 0)
    );
    scalar top = space.bounds().min().z();
    forAll(spheres, i)
    {
        top = max(top, spheres[i].z() + 0.5*diameters[i]);
    }

    dictionary reached;
    reached.add("type", type());
    if (clump_)
    {
        reached.add("clump", clump_->name());
        reached.add("nSpheres", spheres.size());
        reached.add("sphericity", clump_->sphericity());
    }
    reached.add("material", material_);
    reached.add("nGrains", grains.size());
    reached.add("grainMass", grains.mass());
    reached.add("solidFraction", grains.solidVolume()/space.volume());
    reached.add("min", space.bounds().min());
    reached.add("max", space.bounds().max());
    reached.add("height", space.span().z());
    reached.add("highestGrain", top);
    reached.add("largestOverlap", max(scalar(0), overlap));
    reached.add("seed", seed_);
    return reached;
}
