// SPDX-License-Identifier: GPL-3.0-or-later
// How hard the grains of a surge hit, and what energy its head brings.

#include "collisionLoad.H"

#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(collisionLoad, 0);
    addToRunTimeSelectionTable(functionObject, collisionLoad, dictionary);
}
}


Foam::functionObjects::collisionLoad::collisionLoad
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    keep("force", force_);
    keep("velocity", velocity_);
    keep("height", height_);
    keep("number", number_);

    if (mass_ <= 0)
    {
        restore("mass", mass_);
    }

    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::collisionLoad::writeHeaders()
{
    writeColumns
    (
        file(),
        "Contact forces of grains in the range: mean and greatest magnitude"
        " in N, number of grains; their mean velocity downslope in m/s, the"
        " height that they take in m",
        {"Fc", "FcMax", "n", "Upassing", "hPassing"}
    );

    writeColumns
    (
        extraFile("summary"),
        "So far: point load Fc in N (Eq 14), mass M in kg, thickness h in m,"
        " Fr, impact energy E in J (Eq 15; 0: not known), velocity in m/s and"
        " height in m of the grains that pass",
        {"Fc", "M", "h", "Fr", "E", "Upassing", "hPassing"}
    );
}


void Foam::functionObjects::collisionLoad::writeSummary()
{
    scalar h = 0;
    scalar Fr = 0;

    if
    (
        surgeFront_.size()
     && !(
            getObjectResult(surgeFront_, "h", h)
         && getObjectResult(surgeFront_, "Fr", Fr)
        )
    )
    {
        WarningInFunction
            << type() << " " << name() << ": no results of surgeFront "
            << surgeFront_ << ", so no impact energy. Give the name of a"
            << " surgeFront that stands before this in the functions." << endl;
    }

    const scalar E = mass_*mag(gravity())*h*(1 + sqr(Fr)/2);

    writeLine
    (
        extraFile("summary"),
        scalarList
        ({
            meanOverGrains(force_), mass_, h, Fr, E,
            meanOverGrains(velocity_), meanOverGrains(height_)
        })
    );
}


bool Foam::functionObjects::collisionLoad::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "types", "range", "window", "surgeFront", "mass"
        }
    );

    types_ = labelHashSet(dict.get<labelList>("types"));
    range_ = flumeSettings::range(dict, "range", {1.1, 1.3}, box());
    window_ = flumeSettings::range(dict, "window", {0.5, 0.7});
    surgeFront_ = dict.getOrDefault<word>("surgeFront", "");
    mass_ = dict.getOrDefault<scalar>("mass", 0);

    return true;
}


Foam::scalar Foam::functionObjects::collisionLoad::measuredMass() const
{
    const grainSnapshot& all = grains();
    scalar mass = 0;

    for (const label i : ofTypes(all, types_))
    {
        mass += all.mass[i];
    }

    return
        returnReduce(mass, sumOp<scalar>())
      + rhoWater()*gSum(waterVolume()());
}


bool Foam::functionObjects::collisionLoad::inWindow(const scalar t) const
{
    return t >= window_.first() - SMALL && t <= window_.second() + SMALL;
}


Foam::scalar Foam::functionObjects::collisionLoad::meanOverGrains
(
    const sampleSeries& sums
) const
{
    scalar sum = 0;
    scalar number = 0;

    forAll(sums.times(), i)
    {
        if (inWindow(sums.times()[i]))
        {
            sum += sums.values()[i];
            number += number_.values()[i];
        }
    }

    return number > 0 ? sum/number : 0;
}


bool Foam::functionObjects::collisionLoad::sample()
{
    if (mass_ <= 0 && surgeFront_.size())
    {
        mass_ = measuredMass();
        setProperty("mass", mass_);
    }

    const grainSnapshot& all = bodies();
    scalar force = 0;
    scalar velocity = 0;
    scalar greatest = 0;
    label n = 0;

    for (const label i : ofTypes(all, types_))
    {
        const scalar x = frame_.x(all.position[i]);

        if (x >= range_.first() && x <= range_.second())
        {
            const scalar F = mag(all.contactForce[i]);
            force += F;
            velocity += all.U[i] & frame_.downslope();
            greatest = max(greatest, F);
            ++n;
        }
    }

    reduce(force, sumOp<scalar>());
    reduce(velocity, sumOp<scalar>());
    reduce(greatest, maxOp<scalar>());
    reduce(n, sumOp<label>());

    const scalar height =
        extent(ofTypes(grains(), types_), range_.first(), range_.second());

    force_.append(now(), force);
    velocity_.append(now(), velocity);
    height_.append(now(), n*height);
    number_.append(now(), n);
    line_ =
    {
        force/max(n, 1), greatest, scalar(n), velocity/max(n, 1), height
    };

    setResult("Fc", meanOverGrains(force_));

    return true;
}


void Foam::functionObjects::collisionLoad::report()
{
    if (writes())
    {
        writeLine(file(), line_);
        writeSummary();
    }
}
