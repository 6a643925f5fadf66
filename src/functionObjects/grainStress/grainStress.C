// SPDX-License-Identifier: GPL-3.0-or-later
// Mean stress among the grains in spheres, circles and boxes.

#include "grainStress.H"

#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"
#include "keywords.H"
#include "mathematicalConstants.H"
#include "movingLayer.H"
#include "periodicity.H"
#include "sphereParts.H"
#include "symmTransform.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(grainStress, 0);
    addToRunTimeSelectionTable(functionObject, grainStress, dictionary);
}
}

using Foam::constant::mathematical::pi;


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
        writeHeaders();
    }
}


void Foam::functionObjects::grainStress::writeHeaders()
{
    wordList names
    ({
        "n", "solidFraction", "xx", "xy", "xz", "yy", "yz", "zz", "p", "q"
    });
    if (follow_)
    {
        names.append("surface");
    }

    wordList columns;
    for (label i = 0; i < nRegions(); ++i)
    {
        for (const word& what : names)
        {
            columns.append(word(Foam::name(i) + ":" + what));
        }
    }

    writeColumns
    (
        file(),
        "Mean stress of the grains in Pa, tension positive; p mean pressure, q"
        " deviator. Regions: first spheres, then circles, then boxes",
        columns
    );
}


bool Foam::functionObjects::grainStress::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "types", "kinetic", "spheres", "circles", "boxes", "axes",
            "follow", "speed"
        }
    );

    types_ = labelHashSet(dict.getOrDefault("types", labelList()));
    kinetic_ = dict.getOrDefault("kinetic", false);
    turned_ =
        keywords::choice(dict, "axes", "axes", {"mesh", "flume"}, "mesh")
     == "flume";
    follow_ =
        keywords::choice(dict, "follow", "follow", {"none", "surface"}, "none")
     == "surface";
    speed_ = dict.getOrDefault<scalar>("speed", 0.01);
    spheres_ = dict.getOrDefault("spheres", rounds());
    circles_ = dict.getOrDefault("circles", rounds());
    boxes_ = dict.getOrDefault("boxes", List<Tuple2<point, point>>());

    if (!nRegions())
    {
        FatalIOErrorInFunction(dict)
            << "No regions. Give spheres or circles ( ((x y z) radius) ... ), or"
            << " boxes ( ((x y z) (x y z)) ... ), in m." << exit(FatalIOError);
    }

    const List<vector> shifts(frame_.components(shifts_));
    for (label i = 0; i < nRegions(); ++i)
    {
        if (volume(i) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Region " << i << " (spheres first, then circles, then boxes)"
                << " has no volume: give a radius above zero, and for a box the"
                << " lower corner first." << exit(FatalIOError);
        }
        flumeSettings::checkMeets
        (
            dict,
            "Region " + Foam::name(i) + " (spheres first, then circles, then boxes)",
            boxOf(i),
            shifts,
            box()
        );
    }

    return true;
}


bool Foam::functionObjects::grainStress::hasDiscs(const label region) const
{
    const label i = region - spheres_.size();

    return i >= 0 && i < circles_.size();
}


Foam::Tuple2<Foam::point, Foam::scalar>
Foam::functionObjects::grainStress::place(const label region) const
{
    if (region < spheres_.size())
    {
        return spheres_[region];
    }

    if (hasDiscs(region))
    {
        return circles_[region - spheres_.size()];
    }

    const Tuple2<point, point>& b =
        boxes_[region - spheres_.size() - circles_.size()];

    return Tuple2<point, scalar>
    (
        0.5*(b.first() + b.second()),
        0.5*mag((b.second() - b.first()) & frame_.downslope())
    );
}


Foam::boundBox Foam::functionObjects::grainStress::boxOf
(
    const label region
) const
{
    const label i = region - spheres_.size() - circles_.size();
    boundBox result;

    if (i >= 0)
    {
        result = frame_.bounds
        (
            boundBox(boxes_[i].first(), boxes_[i].second()).points()()
        );
    }
    else
    {
        const point centre(frame_.local(place(region).first()));
        const vector reach(vector::one*place(region).second());
        result = boundBox(centre - reach, centre + reach);
    }

    if (hasDiscs(region))
    {
        result.min().y() = box().min().y();
        result.max().y() = box().max().y();
    }
    if (follow_)
    {
        result.min().z() = box().min().z();
        result.max().z() = box().max().z();
    }

    return result;
}


Foam::scalar Foam::functionObjects::grainStress::share
(
    const label region,
    const point& p,
    const scalar r
) const
{
    scalar result = 0;

    // The images across the flume are the same disc
    if (hasDiscs(region))
    {
        const Tuple2<point, scalar>& c = circles_[region - spheres_.size()];
        vector to(GREAT, GREAT, GREAT);

        for (const vector& shift : shifts_)
        {
            const vector d(p + shift - c.first());
            const vector inPlane(d - (d & frame_.across())*frame_.across());
            to = magSqr(inPlane) < magSqr(to) ? inPlane : to;
        }
        return sphereParts::inDisc(mag(to), r, c.second());
    }

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
            const Tuple2<point, point>& b =
                boxes_[region - spheres_.size() - circles_.size()];
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
        return 4*pi*pow3(max(spheres_[region].second(), scalar(0)))/3;
    }

    if (hasDiscs(region))
    {
        const scalar R = circles_[region - spheres_.size()].second();
        return pi*sqr(max(R, scalar(0)))*box().span().y();
    }

    const Tuple2<point, point>& b =
        boxes_[region - spheres_.size() - circles_.size()];
    const vector span(b.second() - b.first());
    return cmptMin(span) > 0 ? cmptProduct(span) : 0;
}


Foam::scalar Foam::functionObjects::grainStress::grainVolume
(
    const label region,
    const scalar d
) const
{
    return hasDiscs(region) ? pi*sqr(d)/4*box().span().y() : pi*pow3(d)/6;
}


Foam::scalar Foam::functionObjects::grainStress::surface
(
    const label region
) const
{
    const grainSnapshot& all = bodies();
    const labelList chosen(ofTypes(all, types_));
    const Tuple2<point, scalar> here(place(region));
    const scalar x = frame_.x(here.first());
    scalar d = 0;

    for (const label i : chosen)
    {
        d = max(d, all.d[i]);
    }
    d = returnReduce(d, maxOp<scalar>());

    movingLayer layer
    (
        box().min().z(), box().max().z(), d > 0 ? d/4 : box().span().z()
    );
    for (const label i : chosen)
    {
        const point p(frame_.local(all.position[i]));

        if (mag(p.x() - x) <= here.second())
        {
            layer.add
            (
                p.z(),
                all.d[i]/2,
                grainVolume(region, all.d[i]),
                mag(all.U[i]) > speed_
            );
        }
    }
    layer.reduce();

    return layer.surface();
}


Foam::functionObjects::grainStress::sums
Foam::functionObjects::grainStress::sumsOver
(
    const label region,
    const vector& down
) const
{
    const grainSnapshot& all = bodies();
    sums s;

    for (const label i : ofTypes(all, types_))
    {
        const scalar part =
            share(region, all.position[i] - down, all.d[i]/2);

        if (part > 0)
        {
            s.n += part;
            s.solid += part*grainVolume(region, all.d[i]);
            s.mass += part*all.mass[i];
            s.momentum += part*all.mass[i]*all.U[i];
            s.motion += part*all.mass[i]*sqr(all.U[i]);
            s.contacts += part*all.stressMoment[i];
        }
    }

    reduce(s.n, sumOp<scalar>());
    reduce(s.solid, sumOp<scalar>());
    reduce(s.mass, sumOp<scalar>());
    reduce(s.momentum, sumOp<vector>());
    reduce(s.motion, sumOp<symmTensor>());
    reduce(s.contacts, sumOp<symmTensor>());

    return s;
}


Foam::scalarList Foam::functionObjects::grainStress::values
(
    const label region
) const
{
    // Where a region follows the surface, heights are counted from there
    const scalar height = follow_ ? surface(region) : 0;
    const sums s(sumsOver(region, height*frame_.normal()));
    symmTensor stress(s.contacts/volume(region));

    if (kinetic_ && s.mass > 0)
    {
        stress -= (s.motion - sqr(s.momentum)/s.mass)/volume(region);
    }

    if (turned_)
    {
        stress = transform
        (
            tensor(frame_.downslope(), frame_.across(), frame_.normal()), stress
        );
    }

    scalarList result
    ({
        s.n, s.solid/volume(region),
        stress.xx(), stress.xy(), stress.xz(),
        stress.yy(), stress.yz(), stress.zz(),
        -tr(stress)/3, sqrt(1.5)*mag(dev(stress))
    });
    if (follow_)
    {
        result.append(height);
    }

    return result;
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
