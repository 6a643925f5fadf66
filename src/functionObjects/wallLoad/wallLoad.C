// SPDX-License-Identifier: GPL-3.0-or-later
// Force and moment of liquid and grains on walls, over time.

#include "wallLoad.H"

#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"
#include "keywords.H"
#include "wallShear.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(wallLoad, 0);
    addToRunTimeSelectionTable(functionObject, wallLoad, dictionary);
}
}


void Foam::functionObjects::wallLoad::load::reduceAll()
{
    reduce(force, sumOp<vector>());
    reduce(moment, sumOp<vector>());
}


Foam::functionObjects::wallLoad::wallLoad
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);
    keep("liquid", liquid_);
    keep("grains", grains_);
    sample_ = liquid_.size() ? sampleOf(liquid_.times().last()) : -1;

    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::wallLoad::writeHeaders()
{
    wordList names;
    wordList sums;

    for (const char* what : {"liquid", "grains", "both"})
    {
        for (const char* c : {"F", "Fx", "Fy", "Fz", "Mx", "My", "Mz"})
        {
            names.append(word(string(what) + ":" + c, false));
        }
        for (const char* c : {"peak", "tPeak", "impulse", "mean"})
        {
            sums.append(word(string(what) + ":" + c, false));
        }
    }

    writeColumns
    (
        file(),
        "Load on the walls: force along the direction, force in N and moment in"
        " N m in coordinates of the flume",
        names
    );
    writeColumns
    (
        extraFile("summary"),
        "So far, of the force along the direction: peak in N, its time in s,"
        " impulse in N s, mean in N",
        sums
    );
}


void Foam::functionObjects::wallLoad::readDirections(const dictionary& dict)
{
    vector area(Zero);
    scalar magArea = 0;

    for (const label patchi : patches_)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        area += sum(patch.Sf());
        magArea += sum(patch.magSf());
    }
    reduce(area, sumOp<vector>());
    reduce(magArea, sumOp<scalar>());

    const bool oneSided = mag(area) > 1e-3*magArea;

    if (!dict.found("direction") && !oneSided)
    {
        FatalIOErrorInFunction(dict)
            << "The patches have faces to all sides, so that no direction of the"
            << " load follows from them." << nl
            << "    Give direction (x y z)." << exit(FatalIOError);
    }

    normal_ = oneSided ? area/mag(area) : vector::zero;
    direction_ = keywords::unitVector(dict, "direction", normal_);
    normal_ = oneSided ? normal_ : direction_;

    scalar flat = 1;
    for (const label patchi : patches_)
    {
        for (const vector& n : vectorField(mesh_.boundary()[patchi].nf()))
        {
            flat = min(flat, mag(n & normal_));
        }
    }
    if (returnReduce(flat, minOp<scalar>()) < 1 - 1e-6)
    {
        normal_ = Zero;
    }
}


bool Foam::functionObjects::wallLoad::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {"patches", "direction", "CofR", "samplingRate", "p", "U"}
    );

    patches_ = flumeSettings::patches(dict, mesh_);
    centre_ = dict.getOrDefault<point>("CofR", Zero);
    samplingRate_ = dict.getOrDefault<scalar>("samplingRate", 0);
    pName_ = dict.getOrDefault<word>("p", "p");
    UName_ = dict.getOrDefault<word>("U", "U");

    readDirections(dict);

    return true;
}


Foam::label Foam::functionObjects::wallLoad::sampleOf(const scalar t) const
{
    return label(std::floor(t*samplingRate_ + 1e-6));
}


Foam::functionObjects::wallLoad::load
Foam::functionObjects::wallLoad::ofFluid() const
{
    if (!fluid_)
    {
        return load();
    }

    const tmp<volScalarField> p(field<volScalarField>(pName_));
    const tmp<volVectorField> U(field<volVectorField>(UName_));
    const tmp<volScalarField> alpha(field<volScalarField>(alphaName_));
    const tmp<volScalarField> epsilon(voidFraction());

    tmp<volScalarField> nut;
    if (hasField<volScalarField>("nut"))
    {
        nut = field<volScalarField>("nut");
    }

    load result;
    for (const label patchi : patches_)
    {
        const fluidOnPatch force
        (
            p(),
            U(),
            alpha(),
            epsilon(),
            nut.valid() ? &nut() : nullptr,
            patchi
        );
        const vectorField& Cf = mesh_.boundary()[patchi].Cf();

        forAll(Cf, face)
        {
            result.add
            (
                Cf[face] - centre_, force.pressure[face] + force.viscous[face]
            );
        }
    }

    result.reduceAll();
    return result;
}


Foam::functionObjects::wallLoad::load
Foam::functionObjects::wallLoad::ofGrains() const
{
    const grainSnapshot& all = grains();
    load result;

    const auto addReaction = [&](const label i, const vector& onGrain)
    {
        // A flat wall is touched a radius from the centre, on the side from which it
        // pushes
        const scalar away = sign(onGrain & normal_)*all.d[i]/2;
        const point touched(all.position[i] - away*normal_);
        result.add(touched - centre_, -onGrain);
    };

    for (const label patchi : patches_)
    {
        forEachWallForce(all, mesh_.boundary()[patchi].name(), addReaction);
    }

    result.reduceAll();
    return result;
}


Foam::scalarList Foam::functionObjects::wallLoad::columns(const load& l) const
{
    const vector F(frame_.components(l.force));
    const vector M(frame_.components(l.moment));

    return scalarList
    ({
        l.force & direction_, F.x(), F.y(), F.z(), M.x(), M.y(), M.z()
    });
}


Foam::sampleSeries Foam::functionObjects::wallLoad::both() const
{
    scalarList sums(liquid_.values());
    forAll(sums, i)
    {
        sums[i] += grains_.values()[i];
    }
    return sampleSeries(liquid_.times(), sums);
}


bool Foam::functionObjects::wallLoad::sample()
{
    if (samplingRate_ > 0)
    {
        const label sample = sampleOf(now());
        if (sample == sample_)
        {
            return liquid_.size();
        }
        sample_ = sample;
    }

    if (passOver({pName_, alphaName_, voidFractionName_}))
    {
        return false;
    }

    const load fluid(ofFluid());
    const load solid(ofGrains());
    load sum;
    sum.force = fluid.force + solid.force;
    sum.moment = fluid.moment + solid.moment;

    liquid_.append(now(), fluid.force & direction_);
    grains_.append(now(), solid.force & direction_);

    if (writes())
    {
        scalarList line(columns(fluid));
        line.append(columns(solid));
        line.append(columns(sum));
        writeLine(file(), line);
    }

    return true;
}


void Foam::functionObjects::wallLoad::writeDistribution() const
{
    FixedList<scalarList, 3> sorted;
    sorted[0] = liquid_.values();
    sorted[1] = grains_.values();
    sorted[2] = both().values();
    for (scalarList& values : sorted)
    {
        Foam::sort(values);
    }

    autoPtr<OFstream> os(presentFile("distribution"));
    writeColumns
    (
        *os,
        "Cumulative distribution: share of the samples that does not exceed a force"
        " along the direction, in N",
        {"share", "liquid", "grains", "both"},
        false
    );

    const label n = sorted[0].size();
    for (label i = 0; i < n; ++i)
    {
        writeRow
        (
            *os,
            scalarList
            ({
                scalar(i + 1)/n, sorted[0][i], sorted[1][i], sorted[2][i]
            })
        );
    }
}


void Foam::functionObjects::wallLoad::report()
{
    if (!writes())
    {
        return;
    }

    sampleSeries sum(both());
    scalarList line;
    for (const sampleSeries* of : {&liquid_, &grains_, &sum})
    {
        const sampleSeries& s = *of;
        const label peak = s.peak();
        const scalar t1 = s.times().first();
        const scalar t2 = s.times().last();
        const scalar mean = s.mean(t1, t2);
        line.append
        (
            scalarList({s.values()[peak], s.times()[peak], mean*(t2 - t1), mean})
        );
    }
    writeLine(extraFile("summary"), line);

    if (mesh_.time().writeTime() || functionObject::postProcess)
    {
        writeDistribution();
    }
}
