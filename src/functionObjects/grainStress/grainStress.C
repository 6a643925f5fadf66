// SPDX-License-Identifier: GPL-3.0-or-later
// Mean stress among the grains in spheres and boxes.

#include "grainStress.H"

#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "periodicity.H"
#include "sphereParts.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(grainStress, 0);
    addToRunTimeSelectionTable(functionObject, grainStress, dictionary);
}
}


Foam::functionObjects::grainStress::grainStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName),
    shifts_(periodicity(mesh_).shifts())
{
    read(dict);

    if (writes())
    {
        wordList columns;

        for (label i = 0; i < nRegions(); ++i)
        {
            for
            (
                const char* what
              : {
                    "n", "solidFraction", "xx", "xy", "xz", "yy", "yz", "zz",
                    "p", "q"
                }
            )
            {
                columns.append(word(Foam::name(i) + ":" + what));
            }
        }

        writeColumns
        (
            file(),
            "Mean stress of the grains in Pa, tension positive; p mean"
            " pressure, q deviator. Regions: first spheres, then boxes",
            columns
        );
    }
}


bool Foam::functionObjects::grainStress::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "types", "kinetic", "spheres", "boxes"
        }
    );

    types_ = labelHashSet(dict.lookupOrDefault("types", labelList()));
    kinetic_ = dict.lookupOrDefault("kinetic", false);
    spheres_ = dict.lookupOrDefault("spheres", List<Tuple2<point, scalar>>());
    boxes_ = dict.lookupOrDefault("boxes", List<Tuple2<point, point>>());

    if (!nRegions())
    {
        FatalIOErrorInFunction(dict)
            << "No regions. Give spheres ( ((x y z) radius) ... ) or boxes"
            << " ( ((x y z) (x y z)) ... ), in m." << exit(FatalIOError);
    }

    for (label i = 0; i < nRegions(); ++i)
    {
        if (volume(i) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Region " << i << " (spheres first, then boxes) has no"
                << " volume: give a radius above zero, and for a box the lower"
                << " corner first." << exit(FatalIOError);
        }
    }

    return true;
}


Foam::scalar Foam::functionObjects::grainStress::share
(
    const label region,
    const point& p,
    const scalar r
) const
{
    scalar result = 0;

    for (const vector& shift : shifts_)
    {
        if (region < spheres_.size())
        {
            const Tuple2<point, scalar>& s = spheres_[region];
            result +=
                sphereParts::inSphere(p + shift, r, s.first(), s.second());
        }
        else
        {
            const Tuple2<point, point>& b = boxes_[region - spheres_.size()];
            const boundBox box(b.first(), b.second());
            result += sphereParts::inBox(p + shift, r, box);
        }
    }

    return result;
}


Foam::scalar Foam::functionObjects::grainStress::volume
(
    const label region
) const
{
    if (region < spheres_.size())
    {
        const scalar r = spheres_[region].second();
        return 4*constant::mathematical::pi*pow3(max(r, scalar(0)))/3;
    }

    const Tuple2<point, point>& b = boxes_[region - spheres_.size()];
    const vector span(b.second() - b.first());
    return cmptMin(span) > 0 ? cmptProduct(span) : 0;
}


Foam::scalarList Foam::functionObjects::grainStress::values
(
    const label region
) const
{
    const grainSnapshot& all = grains();
    scalar n = 0;
    scalar solid = 0;
    scalar mass = 0;
    vector momentum(Zero);
    symmTensor motion(Zero);
    symmTensor contacts(Zero);

    for (const label i : ofTypes(all, types_))
    {
        const scalar part = share(region, all.position[i], all.d[i]/2);

        if (part > 0)
        {
            n += part;
            solid += part*constant::mathematical::pi*pow3(all.d[i])/6;
            mass += part*all.mass[i];
            momentum += part*all.mass[i]*all.U[i];
            motion += part*all.mass[i]*sqr(all.U[i]);
            contacts += part*all.stressMoment[i];
        }
    }

    reduce(n, sumOp<scalar>());
    reduce(solid, sumOp<scalar>());
    reduce(mass, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
    reduce(motion, sumOp<symmTensor>());
    reduce(contacts, sumOp<symmTensor>());

    symmTensor stress(contacts/volume(region));

    if (kinetic_ && mass > 0)
    {
        stress -= (motion - sqr(momentum)/mass)/volume(region);
    }

    return scalarList
    ({
        n, solid/volume(region),
        stress.xx(), stress.xy(), stress.xz(),
        stress.yy(), stress.yz(), stress.zz(),
        -tr(stress)/3, sqrt(1.5)*mag(dev(stress))
    });
}


void Foam::functionObjects::grainStress::report()
{
    scalarList line;

    for (label i = 0; i < nRegions(); ++i)
    {
        line.append(values(i));
    }

    if (writes())
    {
        writeLine(file(), line);
    }
}
