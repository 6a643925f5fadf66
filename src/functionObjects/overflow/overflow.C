// SPDX-License-Identifier: GPL-3.0-or-later
// How a flow runs up a barrier, leaps over its crest and lands.

#include "overflow.H"

#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"
#include "sphereParts.H"
#include "strips.H"
#include "unitConversion.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(overflow, 0);
    addToRunTimeSelectionTable(functionObject, overflow, dictionary);
}
}


namespace
{

//- Share of a box that lies in another
Foam::scalar shareOf(const Foam::boundBox& of, const Foam::boundBox& in)
{
    using namespace Foam;
    scalar share = 1;

    for (direction d = 0; d < 3; ++d)
    {
        const scalar common =
            min(of.max()[d], in.max()[d]) - max(of.min()[d], in.min()[d]);
        share *=
            max(common, scalar(0))/max(of.max()[d] - of.min()[d], VSMALL);
    }
    return share;
}

} // End anonymous namespace


Foam::functionObjects::overflow::overflow
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    keep("runUp", runUp_);
    keep("rate", rate_);
    keep("launchX", launchX_);
    keep("launchZ", launchZ_);
    keep("landingRate", landingRate_);
    keep("landingAt", landingAt_);
    keep("landingX", landingX_);
    keep("landingZ", landingZ_);

    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::overflow::writeHeaders()
{
    writeColumns
    (
        file(),
        "Run-up over the bed in m, volume over the crest in m3/s, speed there in"
        " m/s and angle to the bed in degrees, where it would land unhindered in m;"
        " landing: kg/s, place in m, speed in m/s along the bed and towards it",
        {
            "runUpGrains", "runUpLiquid", "runUp", "fluxGrains", "fluxLiquid",
            "speed", "angle", "ballistic", "landingRate", "landing",
            "landingAlong", "landingDown"
        }
    );
    writeColumns
    (
        extraFile("summary"),
        "So far: highest run-up in m and its time in s, mass over the crest in kg;"
        " means over that mass: speed in m/s, angle in degrees; over the mass that"
        " landed: place in m, speed along the bed and towards it in m/s",
        {
            "runUp", "tRunUp", "mass", "speed", "angle", "landing",
            "landingAlong", "landingDown"
        }
    );
}


bool Foam::functionObjects::overflow::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {"crest", "range", "width", "layer", "threshold", "landing", "U"}
    );

    crest_ = frame_.local(dict.get<point>("crest"));
    range_ = flumeSettings::range
    (
        dict,
        "range",
        dict.get<Tuple2<scalar, scalar>>("range"),
        box()
    );
    width_ = dict.getOrDefault<scalar>("width", box().span().y());
    layer_ = dict.getOrDefault<scalar>
    (
        "layer", 2*cbrt(gSum(mesh_.V())/mesh_.globalData().nTotalCells())
    );
    threshold_ = dict.getOrDefault<scalar>("threshold", 0.1);
    landing_ = dict.getOrDefault<scalar>("landing", crest_.z()/2);
    UName_ = dict.getOrDefault<word>("U", "U");

    boundBox wide(box());
    wide.inflate(1e-6);
    if (crest_.x() < wide.min().x() || crest_.x() > wide.max().x())
    {
        flumeSettings::stopBeside(dict, "crest", crest_, box());
    }

    if (layer_ <= 0 || width_ <= 0 || landing_ >= crest_.z())
    {
        FatalIOErrorInFunction(dict)
            << "layer " << layer_ << " m and width " << width_
            << " m must be above zero, landing " << landing_
            << " m below the crest's height " << crest_.z() << " m."
            << exit(FatalIOError);
    }

    cells_.setSize(mesh_.nCells());
    forAll(cells_, cell)
    {
        cells_[cell] = boundBox();
        for (const label p : mesh_.cellPoints()[cell])
        {
            cells_[cell].add(frame_.local(mesh_.points()[p]));
        }
    }

    return true;
}


Foam::boundBox Foam::functionObjects::overflow::slab
(
    const scalar x1,
    const scalar x2,
    const scalar z1,
    const scalar z2
) const
{
    // Grains at a wall reach beyond it
    const scalar beyond = box().span().y();
    return boundBox
    (
        point(x1, box().min().y() - beyond, z1),
        point(x2, box().max().y() + beyond, z2)
    );
}


Foam::flowThrough Foam::functionObjects::overflow::within
(
    const boundBox& slab,
    const bool falling
) const
{
    flowThrough result;
    const auto add = [&]
    (
        const bool solid,
        const scalar volume,
        const scalar rho,
        const scalar x,
        const vector& u
    )
    {
        const scalar weight = falling ? max(-u.z(), scalar(0)) : 1;
        result.add(solid, weight*volume, rho, x, u);
    };

    const grainSnapshot& all = grains();
    forAll(all.position, i)
    {
        const point p(frame_.local(all.position[i]));
        const scalar share = sphereParts::inBox(p, all.d[i]/2, slab);

        if (share > 0)
        {
            const scalar V = all.volume(i);
            add(true, share*V, all.mass[i]/V, p.x(), frame_.components(all.U[i]));
        }
    }

    if (!fluid_)
    {
        result.reduceAll();
        return result;
    }

    const tmp<volVectorField> U(field<volVectorField>(UName_));
    const tmp<scalarField> water(waterVolume());
    forAll(cells_, cell)
    {
        const scalar V = water()[cell]*shareOf(cells_[cell], slab);

        if (V > 0)
        {
            add
            (
                false,
                V,
                rhoWater(),
                cells_[cell].midpoint().x(),
                frame_.components(U()[cell])
            );
        }
    }

    result.reduceAll();
    return result;
}


Foam::FixedList<Foam::scalar, 3>
Foam::functionObjects::overflow::heights() const
{
    strips solid(0, box().max().z(), layer_);
    strips liquid(solid);
    const grainSnapshot& all = grains();
    const boundBox over
    (
        slab(range_.first(), range_.second(), -GREAT, GREAT)
    );

    forAll(all.position, i)
    {
        const point p(frame_.local(all.position[i]));
        const scalar share = sphereParts::inBox(p, all.d[i]/2, over);

        if (share > 0)
        {
            solid.addSphere
            (
                p.z(),
                all.d[i]/2,
                share*all.volume(i)
            );
        }
    }

    const tmp<scalarField> water(waterVolume());
    forAll(cells_, cell)
    {
        const boundBox& c = cells_[cell];
        const scalar V = water()[cell]*shareOf(c, over);

        if (V > 0)
        {
            liquid.addRange(c.min().z(), c.max().z(), V);
        }
    }

    solid.reduce();
    liquid.reduce();
    strips both(solid);
    both.values() += liquid.values();

    const scalar filled =
        threshold_*layer_*width_*(range_.second() - range_.first());
    FixedList<scalar, 3> result;
    result[0] = solid.farthest(filled);
    result[1] = liquid.farthest(filled);
    result[2] = both.farthest(filled);

    return result;
}


Foam::scalar Foam::functionObjects::overflow::ballistic
(
    const vector& launch
) const
{
    const vector g(frame_.components(gravity()));
    const scalar fall = crest_.z() - landing_;
    const scalar root = sqr(launch.z()) - 2*g.z()*fall;

    if (magSqr(launch) < VSMALL || g.z() >= 0 || root < 0)
    {
        return 0;
    }

    const scalar t = (launch.z() + std::sqrt(root))/(-g.z());
    return crest_.x() + t*launch.x() + 0.5*g.x()*sqr(t);
}


Foam::scalar Foam::functionObjects::overflow::meanBy
(
    const sampleSeries& rate,
    const sampleSeries& y
)
{
    scalarList products(rate.values());
    forAll(products, i)
    {
        products[i] *= y.values()[i];
    }

    const scalar t1 = rate.times().first();
    const scalar t2 = rate.times().last();
    const scalar mean = rate.mean(t1, t2);

    return
        mean > VSMALL
      ? sampleSeries(rate.times(), products).mean(t1, t2)/mean : 0;
}


Foam::scalar Foam::functionObjects::overflow::angle
(
    const scalar x,
    const scalar z
)
{
    return radToDeg(std::atan2(z, x));
}


bool Foam::functionObjects::overflow::sample()
{
    if (passOver({UName_, alphaName_, voidFractionName_}))
    {
        return false;
    }

    const scalar half = layer_/2;
    const FixedList<scalar, 3> height(heights());
    const flowThrough over
    (
        within
        (
            slab(crest_.x() - half, crest_.x() + half, crest_.z(), GREAT),
            false
        )
    );
    const flowThrough down
    (
        within
        (
            slab(crest_.x() + half, GREAT, landing_ - half, landing_ + half),
            true
        )
    );

    // What is in a slab over its thickness passes it in a second for each m/s
    const scalar rate = max(over.momentum.x(), scalar(0))/layer_;
    const scalar landingRate = down.mass/layer_;
    const vector launch(over.velocity());
    const vector landing(down.velocity());

    runUp_.append(now(), height[2]);
    rate_.append(now(), rate);
    launchX_.append(now(), launch.x());
    launchZ_.append(now(), launch.z());
    landingRate_.append(now(), landingRate);
    landingAt_.append(now(), down.x());
    landingX_.append(now(), landing.x());
    landingZ_.append(now(), landing.z());

    line_ =
    {
        height[0], height[1], height[2],
        over.solidFlow.x()/layer_, over.liquidFlow.x()/layer_,
        mag(launch), angle(launch.x(), launch.z()), ballistic(launch),
        landingRate, down.x(), landing.x(), -landing.z()
    };

    setResult("runUp", runUp_.values()[runUp_.peak()]);

    return true;
}


void Foam::functionObjects::overflow::writeSummary()
{
    const label peak = runUp_.peak();
    const scalar t1 = rate_.times().first();
    const scalar t2 = rate_.times().last();
    const scalar x = meanBy(rate_, launchX_);
    const scalar z = meanBy(rate_, launchZ_);

    writeLine
    (
        extraFile("summary"),
        scalarList
        ({
            runUp_.values()[peak], runUp_.times()[peak],
            rate_.mean(t1, t2)*(t2 - t1), std::hypot(x, z), angle(x, z),
            meanBy(landingRate_, landingAt_), meanBy(landingRate_, landingX_),
           -meanBy(landingRate_, landingZ_)
        })
    );
}


void Foam::functionObjects::overflow::report()
{
    if (writes())
    {
        writeLine(file(), line_);
        writeSummary();
    }
}
