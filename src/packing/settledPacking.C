// SPDX-License-Identifier: GPL-3.0-or-later
// A bed that settled under its weight and was levelled.

#include "settledPacking.H"
#include "settlingBox.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(settledPacking, 0);
    addToRunTimeSelectionTable(packingModel, settledPacking, dictionary);

namespace
{

//- Default solid fraction of a bed that is poured and levelled
constexpr scalar pouredFraction = 0.58;

//- Height above the level before levelling, in diameters
constexpr scalar surplus = 1.5;

//- Length of a tile, and of each half of what is held between two, in diameters
constexpr scalar tileDiameters = 50;
constexpr scalar heldDiameters = 3;

//- Shortest time to fall, and to react to a change [s]
constexpr scalar fallTime = 0.1;
constexpr scalar reactionTime = 0.04;

} // End anonymous namespace
} // End namespace Foam


Foam::settledPacking::settledPacking
(
    const dictionary& dict,
    const vector& gravity
)
:
    packingModel
    (
        dict,
        {"box", "solidFraction", "tileLength", "timeStep", "contact"}
    ),
    box_(readBox(), packingBox::readPeriodic(dict)),
    gravity_(gravity),
    contact_(dict),
    step_
    (
        dict.getOrDefault
        (
            "timeStep",
            contact_.timeStep(sizes_.smallest(), density_)
        )
    ),
    fraction_(dict.getOrDefault("solidFraction", pouredFraction)),
    nTiles_(readTiles())
{
    if (clump_)
    {
        FatalIOErrorInFunction(dict_)
            << "A bed that settles is one of spheres, not of clumps "
            << clump_->name() << "." << nl
            << "    Write type dense, and let the grains settle in the run; or leave"
            << " clump out." << exit(FatalIOError);
    }
    checkGrainVolume(box_);
    checkGravity();
}


Foam::boundBox Foam::settledPacking::readBox() const
{
    ITstream& is = dict_.lookup("box");
    return boundBox(is);
}


Foam::label Foam::settledPacking::readTiles() const
{
    const scalar length = dict_.getOrDefault
    (
        "tileLength",
        tileDiameters*sizes_.largest()
    );
    if (length < 4*heldDiameters*sizes_.largest())
    {
        FatalIOErrorInFunction(dict_)
            << "tileLength is " << length << " m, but must be at least "
            << 4*heldDiameters << " diameters, "
            << 4*heldDiameters*sizes_.largest() << " m" << exit(FatalIOError);
    }

    // Fewer than three save nothing
    const label n = label(box_.span().x()/length);
    return n < 3 ? 1 : n;
}


void Foam::settledPacking::checkGravity() const
{
    if (gravity_.z() >= 0 || box_.periodic(2))
    {
        FatalIOErrorInFunction(dict_)
            << "A bed settles towards lower z onto a floor: gravity is "
            << gravity_ << " m/s2 (constant/g) and must have a negative z"
            << " component, and the bed must not be periodic in z"
            << exit(FatalIOError);
    }
}


Foam::boundBox Foam::settledPacking::tiles(const label n) const
{
    point high(box_.bounds().max());
    high.x() = box_.bounds().min().x() + n*tileLength();
    high.z() += box_.span().z() + 4*sizes_.largest();
    return boundBox(box_.bounds().min(), high);
}


Foam::packedGrains Foam::settledPacking::levelled
(
    const packedGrains& grains
) const
{
    DynamicList<label> below(grains.size());
    forAll(grains.position, i)
    {
        const scalar top = grains.position[i].z() + 0.5*grains.diameter[i];
        if (top <= box_.bounds().max().z())
        {
            below.append(i);
        }
    }
    return grains.subset(below);
}


Foam::packedGrains Foam::settledPacking::settle
(
    const label n,
    const FixedList<bool, 3>& periodic,
    const fileName& folder
) const
{
    const packingBox open(tiles(n), periodic);
    point top(open.bounds().max());
    top.z() = box_.bounds().max().z() + surplus*sizes_.largest();
    const packingBox filled(boundBox(open.bounds().min(), top), periodic);

    settlingBox bed
    (
        open,
        arrange(filled, sizes_.forVolume(fraction_*filled.volume())),
        contact_, step_, folder
    );

    // Straight down first: grains without contacts gather speed downhill
    bed.setGravity(vector(0, 0, gravity_.z()));
    bed.settle(fallTime);
    bed.setGravity(gravity_);
    const packedGrains atRest(levelled(bed.settle(reactionTime)));

    settlingBox rest(open, atRest, contact_, step_, folder);
    rest.setGravity(gravity_);
    return levelled(rest.settle(reactionTime));
}


Foam::packedGrains Foam::settledPacking::repeated
(
    const packedGrains& tile,
    const label first,
    const label n
) const
{
    packedGrains all;
    for (label k = first; k < first + n; ++k)
    {
        packedGrains next(tile);
        next.position += k*tileLength()*vector(1, 0, 0);
        all.append(next);
    }
    return all;
}


Foam::packedGrains Foam::settledPacking::withEnds
(
    const packedGrains& tile,
    const fileName& folder
) const
{
    FixedList<bool, 3> periodic(box_.periodic());
    periodic[0] = false;
    const packingBox two(tiles(2), periodic);

    packedGrains grains(repeated(tile, 0, 2));
    DynamicList<label> inside;
    forAll(grains.position, i)
    {
        const scalar x = grains.position[i].x();
        const scalar radius = 0.5*grains.diameter[i];
        if
        (
            x - radius >= two.bounds().min().x()
         && x + radius <= two.bounds().max().x()
        )
        {
            inside.append(i);
        }
    }

    settlingBox bed(two, grains.subset(inside), contact_, step_, folder);
    const scalar middle = two.bounds().min().x() + tileLength();
    const scalar held = heldDiameters*sizes_.largest();
    bed.freeze(middle - held, middle + held);
    bed.setGravity(gravity_);
    return levelled(bed.settle(reactionTime));
}


Foam::packedGrains Foam::settledPacking::make(const fileName& folder) const
{
    if (nTiles_ == 1)
    {
        return settle(1, box_.periodic(), folder);
    }

    FixedList<bool, 3> periodic(box_.periodic());
    periodic[0] = true;
    const packedGrains tile(settle(1, periodic, folder));
    if (box_.periodic(0))
    {
        return repeated(tile, 0, nTiles_);
    }

    const packedGrains ends(withEnds(tile, folder));
    const scalar middle = box_.bounds().min().x() + tileLength();
    DynamicList<label> upper, lower;
    forAll(ends.position, i)
    {
        (ends.position[i].x() < middle ? upper : lower).append(i);
    }

    packedGrains bed(ends.subset(upper));
    bed.append(repeated(tile, 1, nTiles_ - 2));
    bed.append(repeated(ends.subset(lower), nTiles_ - 2, 1));
    return bed;
}


void Foam::settledPacking::writeKey(Ostream& os) const
{
    packingModel::writeKey(os);
    os << "gravity " << gravity_ << nl;
}


Foam::dictionary Foam::settledPacking::properties
(
    const packedGrains& grains
) const
{
    const scalar z = box_.bounds().min().z();
    const scalar depth = box_.span().z();
    const scalar solid =
        grains.solidVolume(z + 0.25*depth, z + 0.75*depth);

    dictionary reached(packingModel::properties(grains));
    reached.add("innerSolidFraction", solid/(0.5*box_.volume()));
    return reached;
}
