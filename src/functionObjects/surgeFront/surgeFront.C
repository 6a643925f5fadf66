// SPDX-License-Identifier: GPL-3.0-or-later
// Where the front of a surge is, how fast, how thick.

#include "surgeFront.H"

#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(surgeFront, 0);
    addToRunTimeSelectionTable(functionObject, surgeFront, dictionary);
}
}

const Foam::Enum<Foam::functionObjects::surgeFront::frontType>
Foam::functionObjects::surgeFront::frontNames
({
    {frontType::grains, "grains"},
    {frontType::quantile, "quantile"},
    {frontType::water, "water"}
});

const Foam::Enum<Foam::functionObjects::surgeFront::thicknessType>
Foam::functionObjects::surgeFront::thicknessNames
({
    {thicknessType::extent, "extent"},
    {thicknessType::water, "water"},
    {thicknessType::mixture, "mixture"}
});


Foam::functionObjects::surgeFront::surgeFront
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    keep("position", position_);
    keep("depth", depth_);

    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::surgeFront::writeHeaders()
{
    writeColumns
    (
        file(),
        "Front of the surge; lengths in m, U in m/s",
        {
            "xGrains", "xQuantile", "xFarthest", "xWater", "xFront", "U",
            "hExtent", "hWater", "hMixture", "h", "Fr"
        }
    );

    writeColumns
    (
        extraFile("summary"),
        "Means, so far, while the front is within the reach "
      + Foam::name(reach_.first()) + " to " + Foam::name(reach_.second())
      + " m: times in s, U in m/s, h in m",
        {"tBegin", "tEnd", "U", "h", "Fr"}
    );
}


void Foam::functionObjects::surgeFront::writeSummary()
{
    const Tuple2<scalar, scalar> t(period());

    if (t.first() < t.second())
    {
        const FixedList<scalar, 3> v(overReach());

        writeLine
        (
            extraFile("summary"),
            scalarList({t.first(), t.second(), v[0], v[1], v[2]})
        );
    }
}


bool Foam::functionObjects::surgeFront::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "types", "front", "thickness", "stripWidth", "width",
            "grainThreshold", "waterThreshold", "headLength", "window",
            "reach"
        }
    );

    types_ = labelHashSet(dict.getOrDefault("types", labelList()));
    front_ = frontNames.getOrDefault("front", dict, frontType::grains);
    thickness_ = thicknessNames.getOrDefault
    (
        "thickness",
        dict,
        front_ == frontType::water
      ? thicknessType::water
      : thicknessType::extent
    );
    stripWidth_ = dict.getOrDefault<scalar>("stripWidth", 0.05);
    width_ = dict.getOrDefault<scalar>("width", box().span().y());
    grainThreshold_ = dict.getOrDefault<scalar>("grainThreshold", 0);
    waterThreshold_ = dict.getOrDefault<scalar>("waterThreshold", 0.005);
    headLength_ = dict.getOrDefault<scalar>("headLength", 0.3);
    window_ = dict.getOrDefault<scalar>("window", 0.2);
    reach_ = flumeSettings::range(dict, "reach", {-GREAT, GREAT}, box());

    if (min(min(stripWidth_, width_), min(headLength_, window_)) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "stripWidth, width, headLength and window must be above zero,"
            << " and are " << stripWidth_ << ", " << width_ << ", "
            << headLength_ << ", " << window_ << exit(FatalIOError);
    }

    return true;
}


Foam::strips Foam::functionObjects::surgeFront::solidThickness
(
    const labelList& chosen
) const
{
    const grainSnapshot& all = grains();
    strips result(box().min().x(), box().max().x(), stripWidth_);

    for (const label i : chosen)
    {
        result.addSphere
        (
            frame_.x(all.position[i]),
            all.d[i]/2,
            all.volume(i)
        );
    }

    result.reduce();
    result.values() /= stripWidth_*width_;
    return result;
}


Foam::strips Foam::functionObjects::surgeFront::waterThickness() const
{
    const scalarField volume(waterVolume());
    const pointField& points = mesh_.points();
    strips result(box().min().x(), box().max().x(), stripWidth_);

    forAll(volume, celli)
    {
        scalar low = GREAT;
        scalar high = -GREAT;

        for (const label pointi : mesh_.cellPoints()[celli])
        {
            const scalar x = frame_.x(points[pointi]);
            low = min(low, x);
            high = max(high, x);
        }

        result.addRange(low, high, volume[celli]);
    }

    result.reduce();
    result.values() /= stripWidth_*width_;
    return result;
}


Foam::scalar Foam::functionObjects::surgeFront::meanDiameter
(
    const labelList& chosen
) const
{
    scalar d3 = 0;
    scalar d4 = 0;

    for (const label i : chosen)
    {
        const scalar d = grains().bodyDiameter(i);
        const scalar part = grains().partOfBody(i);
        d3 += part*pow3(d);
        d4 += part*pow4(d);
    }

    reduce(d3, sumOp<scalar>());
    reduce(d4, sumOp<scalar>());

    return d3 > 0 ? d4/d3 : 0;
}


Foam::scalar Foam::functionObjects::surgeFront::froude
(
    const scalar U,
    const scalar h
) const
{
    // Nothing presses a flow to a base along which gravity points
    const scalar g = mag(gravity())*cosSlope();

    return h > SMALL && g > SMALL ? U/sqrt(g*h) : 0;
}


Foam::Tuple2<Foam::scalar, Foam::scalar>
Foam::functionObjects::surgeFront::period() const
{
    Tuple2<scalar, scalar> result(GREAT, -GREAT);

    // Until it first leaves: where a head dissolves, its front leaps back
    forAll(position_.times(), i)
    {
        const scalar x = position_.values()[i];
        if (x > reach_.second())
        {
            break;
        }
        if (x >= reach_.first())
        {
            result.first() = min(result.first(), position_.times()[i]);
            result.second() = max(result.second(), position_.times()[i]);
        }
    }

    return result;
}


Foam::FixedList<Foam::scalar, 3>
Foam::functionObjects::surgeFront::overReach() const
{
    const Tuple2<scalar, scalar> t(period());

    FixedList<scalar, 3> result;
    result[0] = position_.slope(t.first(), t.second());
    result[1] = depth_.mean(t.first(), t.second());
    result[2] = froude(result[0], result[1]);

    return result;
}


Foam::scalar Foam::functionObjects::surgeFront::farthest
(
    const labelList& chosen
) const
{
    scalar x = box().min().x();
    for (const label i : chosen)
    {
        x = max(x, frame_.x(grains().position[i]));
    }
    return returnReduce(x, maxOp<scalar>());
}


void Foam::functionObjects::surgeFront::follow(const scalar x, const scalar h)
{
    position_.append(now(), x);
    depth_.append(now(), h);

    const FixedList<scalar, 3> reached(overReach());
    setResult("x", x);
    setResult("U", reached[0]);
    setResult("h", reached[1]);
    setResult("Fr", reached[2]);
}


bool Foam::functionObjects::surgeFront::sample()
{
    if (passOver({alphaName_, voidFractionName_}))
    {
        return false;
    }

    const labelList chosen(ofTypes(grains(), types_));
    const scalar d = meanDiameter(chosen);
    const strips solid(solidThickness(chosen));
    const strips water(waterThickness());

    const scalar xGrains = solid.farthest
    (
        grainThreshold_ > 0 ? grainThreshold_ : max(d/10, SMALL)
    );
    const scalar xQuantile = solid.quantile(0.99);
    const scalar xWater = water.farthest(waterThreshold_);

    // Water alone can make a surge
    const frontType front = d > 0 ? front_ : frontType::water;
    const thicknessType thickness = d > 0 ? thickness_ : thicknessType::water;

    const scalar x =
        front == frontType::grains ? xGrains
      : front == frontType::quantile ? xQuantile
      : xWater;

    const scalar hExtent = extent(chosen, x - headLength_, x);
    const scalar hWater = water.mean(x - headLength_, x);
    const scalar hMixture = hWater + solid.mean(x - headLength_, x);

    const scalar h =
        thickness == thicknessType::extent ? hExtent
      : thickness == thicknessType::water ? hWater
      : hMixture;

    follow(x, h);
    const scalar U = position_.lastSlope(window_);

    line_ =
    {
        xGrains, xQuantile, farthest(chosen), xWater, x, U,
        hExtent, hWater, hMixture, h, froude(U, h)
    };

    Log << type() << " " << name() << ": x " << x << " m, U " << U
        << " m/s, h " << h << " m, Fr " << line_.last() << nl << endl;

    return true;
}


void Foam::functionObjects::surgeFront::report()
{
    if (writes())
    {
        writeLine(file(), line_);
        writeSummary();
    }
}
