// SPDX-License-Identifier: GPL-3.0-or-later
// How deep, how far and how fast a bed of grains is eroded.

#include "bedErosion.H"

#include "addToRunTimeSelectionTable.H"
#include "erosionPhases.H"
#include "flumeSettings.H"
#include "granularPhase.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(bedErosion, 0);
    addToRunTimeSelectionTable(functionObject, bedErosion, dictionary);
}
}


Foam::functionObjects::bedErosion::bedErosion
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    keep("depth", depth_);
    keep("rate", rate_);
    keep("UEroded", UEroded_);
    keep("UBed", UBed_);

    if (writes())
    {
        writeHeaders();
    }

    // On a running case this is before the first step
    if (mesh_.foundObject<granularPhase>(granularPhase::typeName))
    {
        refer(bed());
    }
}


bool Foam::functionObjects::bedErosion::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "bedTypes", "stripWidth", "planWidth", "width", "packing",
            "depthRange", "rateRange", "layerRange", "rateWindow", "xStart",
            "smoothing", "threshold", "onset", "attenuation",
            "bouncingSpeed", "creepingSpeed", "nFarthest"
        }
    );

    types_ = labelHashSet(dict.get<labelList>("bedTypes"));
    stripWidth_ = dict.getOrDefault<scalar>("stripWidth", 0.01);
    planWidth_ = dict.getOrDefault<scalar>("planWidth", 0.02);
    width_ = dict.getOrDefault<scalar>("width", box().span().y());
    packing_ = dict.getOrDefault<scalar>("packing", 0);
    depthRange_ =
        flumeSettings::range(dict, "depthRange", {1.2, 1.4}, box());
    rateRange_ = flumeSettings::range(dict, "rateRange", {1.1, 1.3}, box());
    layerRange_ =
        flumeSettings::range(dict, "layerRange", depthRange_, box());
    rateWindow_ = dict.getOrDefault<scalar>("rateWindow", 0.1);
    xStart_ = dict.getOrDefault<scalar>("xStart", 0.6);
    smoothing_ = dict.getOrDefault<scalar>("smoothing", 0.05);
    threshold_ = dict.getOrDefault<scalar>("threshold", 0.001);
    onset_ = dict.getOrDefault<scalar>("onset", 0.001);
    attenuation_ = dict.getOrDefault<scalar>("attenuation", 0.05);
    bouncingSpeed_ = dict.getOrDefault<scalar>("bouncingSpeed", 0);
    creepingSpeed_ = dict.getOrDefault<scalar>("creepingSpeed", 0);
    nFarthest_ = dict.getOrDefault<label>("nFarthest", 10);

    if (types_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "bedTypes is empty: give the types of the bed's grains, for"
            << " instance (1)." << exit(FatalIOError);
    }

    if (stripWidth_ <= 0 || planWidth_ <= 0 || width_ <= 0 || nFarthest_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "stripWidth, planWidth, width and nFarthest must be above zero,"
            << " and are " << stripWidth_ << ", " << planWidth_ << ", "
            << width_ << ", " << nFarthest_ << exit(FatalIOError);
    }

    return true;
}


Foam::bedGrains Foam::functionObjects::bedErosion::bed() const
{
    return bedGrains(frame_, grains(), ofTypes(grains(), types_));
}


Foam::fileName Foam::functionObjects::bedErosion::referenceFile() const
{
    return baseFileDir()/name()/"reference";
}


void Foam::functionObjects::bedErosion::refer(const bedGrains& bed)
{
    if (reference_.time < GREAT)
    {
        return;
    }

    const planGrid grid(box(), planWidth_);
    const strips along(box().min().x(), box().max().x(), stripWidth_);

    // A reference of now or later is one of an earlier run of this case
    if
    (
        reference_.read(referenceFile())
     && reference_.time < now() - SMALL
     && reference_.volume.size() == along.size()
     && reference_.highest.size() == grid.size()
    )
    {
        return;
    }

    if (!returnReduce(bed.size(), sumOp<label>()))
    {
        FatalErrorInFunction
            << type() << " " << name() << ": no grains of bedTypes "
            << types_.sortedToc() << " at time " << now() << "." << nl
            << "    Check the types of the bed's grains, and that the cloud "
            << grainSnapshot::cloudName << " was written at this time."
            << exit(FatalError);
    }

    reference_.take
    (
        now(), bed, box(), stripWidth_, width_, grid, packing_
    );

    if (!(reference_.packing > 0))
    {
        FatalErrorInFunction
            << type() << " " << name() << ": the solid fraction of the bed at"
            << " time " << now() << " is " << reference_.packing << "." << nl
            << "    Its grains lie beside the mesh, or in a layer too thin to"
            << " measure it: then give packing." << exit(FatalError);
    }

    if (Pstream::master())
    {
        reference_.write(referenceFile());
    }

    Info<< type() << " " << name() << ": bed at time " << now()
        << " is the reference; solid fraction " << reference_.packing
        << ", diameter " << reference_.d << " m" << endl;
}


Foam::scalar Foam::functionObjects::bedErosion::bouncingSpeed() const
{
    return
        bouncingSpeed_ > 0
      ? bouncingSpeed_
      : sqrt(2*mag(gravity())*cosSlope()*reference_.d);
}


Foam::scalar Foam::functionObjects::bedErosion::creepingSpeed() const
{
    return
        creepingSpeed_ > 0
      ? creepingSpeed_
      : 0.05*sqrt(mag(gravity())*cosSlope()*reference_.d);
}


Foam::strips Foam::functionObjects::bedErosion::erosionDepth
(
    const bedGrains& bed
) const
{
    strips depth(bed.alongFlume(box(), stripWidth_));

    depth.values() =
        (scalarField(reference_.volume) - depth.values())
       /(reference_.packing*width_*stripWidth_);

    return depth;
}


Foam::Tuple2<Foam::strips, Foam::scalar>
Foam::functionObjects::bedErosion::carried(const bedGrains& bed) const
{
    const planGrid grid(box(), planWidth_);
    strips number(box().min().x(), box().max().x(), stripWidth_);
    scalar farthest = box().min().x();
    scalar volume = 0;

    forAll(bed.d, i)
    {
        volume += bed.volume[i];
        const vector& c = bed.centre[i];
        const scalar top = reference_.highest[grid.find(c.x(), c.y())];

        if (c.x() > reference_.end + bed.d[i] || c.z() > top + bed.d[i]/2)
        {
            number.add(c.x(), bed.partOfBody[i]);
            farthest = max(farthest, c.x());
        }
    }

    number.reduce();
    reduce(volume, sumOp<scalar>());

    // Those that left are as far as the flume goes
    const scalar left =
        (sum(reference_.volume) - volume)
       /(constant::mathematical::pi*pow3(reference_.d)/6);
    if (left > 0.5)
    {
        number.values().last() += left;
    }

    return Tuple2<strips, scalar>
    (
        number,
        returnReduce(farthest, maxOp<scalar>())
    );
}


bool Foam::functionObjects::bedErosion::passOverWithoutBed(const bedGrains& bed) const
{
    const bool passed =
        functionObject::postProcess
     && !returnReduce(bed.size(), sumOp<label>());
    if (passed)
    {
        Info<< type() << " " << name() << ": time " << mesh_.time().timeName()
            << " is passed over, it has no grains of the bed" << endl;
    }
    return passed;
}


Foam::bedLayers Foam::functionObjects::bedErosion::layers
(
    const bedGrains& bed,
    const scalar x1,
    const scalar x2
) const
{
    return bedLayers(bed, x1, x2, bouncingSpeed(), creepingSpeed());
}


Foam::scalarList
Foam::functionObjects::bedErosion::layerLine(const bedGrains& bed) const
{
    const scalar x1 = layerRange_.first();
    const scalar x2 = layerRange_.second();
    const bedLayers in(layers(bed, x1, x2));
    scalarList line;
    for (const bedLayer& l : {in.bouncing, in.creeping, in.stationary})
    {
        const scalar thickness = l.volume/(reference_.packing*width_*(x2 - x1));
        line.append(scalarList({thickness, l.U, l.n}));
    }
    return line;
}


void Foam::functionObjects::bedErosion::follow
(
    const scalar depth,
    const scalar UMoving,
    const scalar UBed
)
{
    depth_.append(now(), depth);
    rate_.append(now(), depth_.lastSlope(rateWindow_));
    UEroded_.append(now(), UMoving);
    UBed_.append(now(), UBed);
}


bool Foam::functionObjects::bedErosion::sample()
{
    const bedGrains grains(bed());
    if (passOverWithoutBed(grains))
    {
        return false;
    }
    refer(grains);

    const strips depth(erosionDepth(grains));
    strips smooth(depth);
    smooth.values() = depth.smoothed(smoothing_);
    const erosionExtent extent
    (
        smooth, xStart_, threshold_, reference_.d/2
    );
    const scalar H = depth.mean(depthRange_.first(), depthRange_.second());
    const scalar atX0 = depth.mean(rateRange_.first(), rateRange_.second());
    const Tuple2<strips, scalar> far(carried(grains));
    const scalar Lc = far.first().beyond(nFarthest_);
    const bedLayers moving(layers(grains, xStart_, GREAT));
    const scalar UBed = grains.meanVelocity();
    follow(atX0, moving.UMoving, UBed);

    const scalar solid = reference_.packing*width_;
    line_ =
    {
        H, atX0, rate_.values().last(), extent.length, extent.end,
        Lc, far.second(), grains.farthest(),
        moving.UMoving, moving.bouncing.U,
        extent.eroded*solid, extent.deposited*solid,
        gSum(grains.volume),
        extent.raisedEnd, UBed
    };
    layerLine_ = layerLine(grains);

    setResult("H", H);
    setResult("L", extent.length);
    setResult("Lc", Lc);
    setResult("Ue", moving.UMoving);
    setResult("Ubed", UBed);

    Log << type() << " " << name() << ": H " << H << " m, L "
        << extent.length << " m, Lc " << Lc << " m, Ue "
        << moving.UMoving << " m/s, Ubed " << UBed << " m/s" << nl << endl;

    return true;
}
