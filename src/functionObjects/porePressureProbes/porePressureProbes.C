// SPDX-License-Identifier: GPL-3.0-or-later
// Pore pressure at points of the base.

#include "porePressureProbes.H"

#include "IOdictionary.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(porePressureProbes, 0);
    addToRunTimeSelectionTable(functionObject, porePressureProbes, dictionary);
}
}

const Foam::Enum<Foam::functionObjects::porePressureProbes::levelType>
Foam::functionObjects::porePressureProbes::levelNames
({
    {levelType::vertical, "vertical"},
    {levelType::normal, "normal"},
    {levelType::layer, "layer"}
});


Foam::functionObjects::porePressureProbes::porePressureProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    pressure_.setSize(probes_.size());
    forAll(pressure_, i)
    {
        keep(seriesName(i), pressure_[i]);
    }

    if (writes())
    {
        writeHeaders();
    }
}


bool Foam::functionObjects::porePressureProbes::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "probes", "patch", "p", "hydrostatic", "radius", "highShare",
            "lowShare", "excessPressure", "average"
        }
    );

    probes_ = dict.get<pointField>("probes");
    patchName_ = dict.get<word>("patch");
    pName_ = dict.getOrDefault<word>("p", "p");
    level_ =
        levelNames.getOrDefault("hydrostatic", dict, levelType::vertical);
    radius_ = dict.getOrDefault<scalar>("radius", 0.1);
    highShare_ = dict.getOrDefault<scalar>("highShare", 0.5);
    lowShare_ = dict.getOrDefault<scalar>("lowShare", 0.05);

    average_ = dict.getOrDefault<Switch>("average", false);
    lineDone_ = true;

    excessShown_ = dict.getOrDefault<scalar>("excessPressure", -1);

    findPlaces(dict);
    pressure_.setSize(probes_.size());

    return true;
}


void Foam::functionObjects::porePressureProbes::findPlaces
(
    const dictionary& dict
)
{
    const label patchi = mesh_.boundaryMesh().findPatchID(patchName_);

    if (patchi < 0)
    {
        FatalIOErrorInFunction(dict)
            << "No patch " << patchName_ << ". Valid choices: "
            << mesh_.boundaryMesh().names() << exit(FatalIOError);
    }

    if (level_ == levelType::vertical && magSqr(gravity()) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "hydrostatic vertical in " << dict.name() << " takes the water"
            << " level along gravity, and constant/g is zero." << nl
            << "    Correct constant/g, or set hydrostatic normal."
            << exit(FatalIOError);
    }

    columns_.clear();
    discs_.clear();

    forAll(probes_, i)
    {
        addProbe(i, mesh_.boundary()[patchi], dict);
    }
}


void Foam::functionObjects::porePressureProbes::addProbe
(
    const label i,
    const fvPatch& patch,
    const dictionary& dict
)
{
    discs_.append(new patchDisc(patch, probes_[i], radius_));

    if (discs_[i].distance() > radius_ || discs_[i].area() <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Probe " << i << " at " << probes_[i] << " lies "
            << discs_[i].distance() << " m from patch " << patchName_
            << ": put it on the patch, or make radius (" << radius_
            << " m) larger." << exit(FatalIOError);
    }

    if (level_ == levelType::layer && perMetre(i) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "hydrostatic layer in " << dict.name() << " is for a base that"
            << " the layer lies on, and gravity does not press what is at"
            << " probe " << i << ", " << probes_[i] << ", against patch "
            << patchName_ << "." << nl
            << "    Correct constant/g or the patch, or set hydrostatic normal."
            << exit(FatalIOError);
    }

    const vector up
    (
        level_ == levelType::vertical ? -gravity() : -discs_[i].normal()
    );

    // A probe on the edge of cells would lie in several: the column begins in
    // the one whose pressure is taken
    columns_.append(new column(mesh_, discs_[i].inside(), up, probes_[i]));

    if
    (
        returnReduce(columns_[i].length(), sumOp<scalar>())
     <= 1e-3*discs_[i].cellSide()
    )
    {
        FatalIOErrorInFunction(dict)
            << "No cell lies above probe " << i << " at " << probes_[i]
            << ", as beneath a wall that overhangs." << nl
            << "    Is gravity " << gravity() << " right for this mesh? Else"
            << " move the probe, or give hydrostatic normal."
            << exit(FatalIOError);
    }
}


Foam::scalar
Foam::functionObjects::porePressureProbes::excessShown() const
{
    if (excessShown_ < 0)
    {
        const IOdictionary grains
        (
            IOobject
            (
                "granularProperties",
                mesh_.time().constant(),
                mesh_,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );

        excessShown_ =
            grains.subOrEmptyDict("interphaseForces")
           .subOrEmptyDict("excessPressure")
           .getOrDefault<scalar>("strength", 1);
    }

    return excessShown_;
}


Foam::scalar Foam::functionObjects::porePressureProbes::perMetre
(
    const label i
) const
{
    return rhoWater()
       *(
            level_ == levelType::layer
          ? gravity() & discs_[i].normal()
          : mag(gravity())
        );
}


Foam::vector Foam::functionObjects::porePressureProbes::alongWall
(
    const label i
) const
{
    const bool isBase =
        (discs_[i].normal() & gravity()) > 0.5*mag(gravity());

    return
        level_ == levelType::vertical && !isBase
      ? rhoWater()*gravity() : vector(Zero);
}


Foam::word Foam::functionObjects::porePressureProbes::seriesName
(
    const label i
)
{
    return word("p" + Foam::name(i));
}


void Foam::functionObjects::porePressureProbes::writeHeaders()
{
    wordList columns;

    forAll(probes_, i)
    {
        writeHeader
        (
            file(),
            "Probe " + Foam::name(i) + " at (" + Foam::name(probes_[i].x())
          + ' ' + Foam::name(probes_[i].y()) + ' '
          + Foam::name(probes_[i].z()) + ')'
        );

        for
        (
            const char* what
          : {"p", "hydrostatic", "excess", "level", "sigma", "lambda"}
        )
        {
            columns.append(word(Foam::name(i) + ":" + what));
        }
    }

    writeColumns
    (
        file(),
        "Pressures and stresses in Pa, water level over the probe in m ("
      + levelNames[level_] + ")",
        columns
    );

    wordList summary;
    forAll(probes_, i)
    {
        for
        (
            const char* what
          : {"peak", "tPeak", "durationHigh", "dissipation"}
        )
        {
            summary.append(word(Foam::name(i) + ":" + what));
        }
    }

    writeColumns
    (
        extraFile("summary"),
        "So far: peak pressure in Pa and its time; time above "
      + Foam::name(highShare_) + " of the peak; time from the peak until "
      + Foam::name(lowShare_) + " of it is left; times in s",
        summary
    );
}


void Foam::functionObjects::porePressureProbes::writeSummary()
{
    scalarList summary;

    for (const sampleSeries& p : pressure_)
    {
        const label peak = p.peak();
        const scalar most = p.values()[peak];
        const scalar when = p.times()[peak];

        summary.append
        (
            scalarList
            ({
                most,
                when,
                p.durationAbove(highShare_*most),
                max(p.lastAbove(lowShare_*most) - when, scalar(0))
            })
        );
    }

    writeLine(extraFile("summary"), summary);
}


Foam::scalarList
Foam::functionObjects::porePressureProbes::grainStress() const
{
    const grainSnapshot& all = grains();
    scalarList stress(probes_.size(), Zero);

    const auto addToProbes = [&](const label i, const vector& force)
    {
        forAll(discs_, probei)
        {
            const patchDisc& disc = discs_[probei];

            if (disc.contains(all.position[i]))
            {
                stress[probei] -= (force & disc.normal());
            }
        }
    };

    forEachWallForce(all, patchName_, addToProbes);

    reduce(stress, sumOp<scalarList>());

    forAll(discs_, i)
    {
        stress[i] /= discs_[i].area();
    }

    return stress;
}


bool Foam::functionObjects::porePressureProbes::sample()
{
    if (passOver({pName_, alphaName_}))
    {
        return false;
    }

    // Grains alone press on the base where there is no fluid
    const tmp<volScalarField> tp(fluidField(pName_));
    const tmp<volScalarField> talpha(fluidField(alphaName_));
    const label patchi = mesh_.boundaryMesh().findPatchID(patchName_);
    const fvPatchScalarField& pWall = tp().boundaryField()[patchi];

    const scalarList fromGrains(grainStress());

    if (!average_ || lineDone_)
    {
        sums_ = List<sums>(probes_.size());
        nSamples_ = 0;
        lineDone_ = false;
    }
    ++nSamples_;

    forAll(probes_, i)
    {
        const scalar level = columns_[i].integral(talpha());
        const scalar rest = perMetre(i)*level;
        const scalar hidden = 1 - excessShown();
        const auto shown = [&](const scalar pressure)
        {
            return pressure - hidden*(pressure - rest);
        };
        const scalar p = shown(discs_[i].atPoint(pWall, alongWall(i), talpha()));
        const scalar onBase = shown(discs_[i].mean(pWall));

        sums& sum = sums_[i];
        sum.p += p;
        sum.rest += rest;
        sum.level += level;
        sum.sigma += fromGrains[i] + onBase;
        sum.onBase += onBase;

        if (!average_)
        {
            pressure_[i].append(now(), p);
        }
    }

    return true;
}


Foam::scalarList Foam::functionObjects::porePressureProbes::meansOf
(
    const label i
) const
{
    const sums& sum = sums_[i];
    const scalar p = sum.p/nSamples_;
    const scalar rest = sum.rest/nSamples_;
    const scalar sigma = sum.sigma/nSamples_;

    // Next to nothing lies on a base with less than 1 Pa
    const scalar lambda = sigma > 1 ? sum.onBase/nSamples_/sigma : 0;

    return scalarList
    ({
        p, rest, p - rest, sum.level/nSamples_, sigma, lambda
    });
}


void Foam::functionObjects::porePressureProbes::report()
{
    scalarList line;
    forAll(probes_, i)
    {
        line.append(meansOf(i));
        if (average_)
        {
            pressure_[i].append(now(), sums_[i].p/nSamples_);
        }
    }
    lineDone_ = true;

    if (writes())
    {
        writeLine(file(), line);
        writeSummary();
    }
}
